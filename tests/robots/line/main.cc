// frob-line -- a compiled program drives the simulated robot through its driver and its serial
// line, in virtual time: it does what `frobc serve` and `frobc run --device` do together, as fast
// as the processor can, and the same each time.
//
//   frob-line PROGRAM.so ROBOT WORLD.toml SEED SECONDS [NAME=VALUE]...
//
// The robot, its firmware, the line, the driver and the safety logic are those of the two hosts;
// only the separate processes and the operating system are missing. These numbers, in milliseconds,
// replace their delays:
//
//   adapter=N   extra delay of a byte from the robot to the driver (0);
//               a USB adapter holds bytes back for up to 16 ms
//   step=N      delay from reading the sensors to the command (0)
//   rate=HZ     rate of the program (50)
//
// Any other name is a setting of the driver. The run ends when the program's task does. Prints a
// summary as the hosts do, and with `log=FILE` writes a line for each instant: time, pose by
// odometry, forward, turn, collisions, and the true pose relative to the start.
#include <algorithm>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <map>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include <frob/result.h>

#include "core/robot.h"
#include "hal/fake/fake.h"
#include "robots.h"
#include "server.h"
#include "summary.h"

extern "C" {
#include "hosts/common/load.h"
#include "hosts/robot/drivers.h"

// Only the robots that come with frobc are simulated here.
extern const frob_driver *const frob_own_driver;
const frob_driver *const frob_own_driver = nullptr;
}

using namespace frob::serve;

namespace
{

constexpr std::int64_t ms = 1'000'000;
constexpr std::int64_t patience_ns = 200 * ms;

struct WrongUse : std::runtime_error {
    using std::runtime_error::runtime_error;
};

// The simulated robot's end of an in-memory line.
class MemoryConnection : public Connection
{
  public:
    MemoryConnection(frob_fake_line &line, std::int64_t adapter_ns)
        : line_(line), adapter_ns_(adapter_ns)
    {
    }

    std::string device() const override { return "memory"; }
    int descriptor() const override { return -1; }
    bool connected() const override { return true; }
    std::uint32_t rate() const override { return line_.rate; }
    Bytes read() override
    {
        Bytes bytes(FROB_FAKE_ROOM);
        bytes.resize(frob_fake_receive(&line_, bytes.data(), bytes.size()));
        return bytes;
    }
    void write(const Bytes &bytes) override
    {
        frob_fake_send(&line_, bytes.data(), bytes.size(), adapter_ns_);
    }

  private:
    frob_fake_line &line_;
    std::int64_t adapter_ns_;
};

struct SimulationCloser {
    void operator()(frob_sim *sim) const { frob_sim_close(sim); }
};

struct Options {
    std::string robot, world;
    std::uint64_t seed = 1;
    double duration_s = 60;
    double adapter_ms = 0, step_ms = 0, rate_hz = 50;
    std::string log;
};

class Run
{
  public:
    Run(const frob_program &program, const frob_driver &driver, const Options &options,
        const std::vector<double> &settings)
        : program_(program), driver_(driver), options_(options), settings_(settings),
          sim_(open(options)),
          firmware_(make_firmware(options.robot, "p3dx-sh", usual_rate(options.robot), sim_.get())),
          server_(*firmware_, true), device_(blocks(driver.device_size)),
          state_(blocks(program.state_size)), input_(blocks(program.input_size)),
          output_(blocks(program.output_size))
    {
        frob_fake_line_open(&line_, &time_);
        line_.rate = driver.rate;
        server_.plug(std::make_unique<MemoryConnection>(
            line_, static_cast<std::int64_t>(options.adapter_ms * 1e6)));
    }

    void drive()
    {
        const frob_serial serial = frob_fake_serial(&line_);
        const frob_clock clock = frob_fake_time(&time_);
        const std::unique_ptr<std::FILE, int (*)(std::FILE *)> log(
            options_.log.empty() ? nullptr : std::fopen(options_.log.c_str(), "w"),
            [](std::FILE *f) { return f ? std::fclose(f) : 0; });
        log_ = log.get();
        program_.reset(state_.data(), program_.default_params);
        frob_robot_start(&robot_, &driver_, device_.data(), settings_.data(), &serial, &clock,
                         patience_ns);
        while (!over()) {
            server_.advance(time_.now_ns);
            if (frob_robot_poll(&robot_) == FROB_ROBOT_FAILED)
                throw WrongUse("the robot is lost");
            command();
            instant();
            server_.advance(time_.now_ns);
            time_.now_ns = next();
        }
        frob_robot_halt(&robot_);
    }

    void print() const
    {
        print_summary(sim_.get());
        std::printf("stale readings: %lu\nconnections: %lu\n",
                    static_cast<unsigned long>(robot_.stale),
                    static_cast<unsigned long>(robot_.connections));
        if (ended_ns_ == 0)
            return;
        std::vector<char> buffer(frob_result_room(&program_));
        frob_text text = frob_text_in(buffer.data(), buffer.size());
        frob_result_write(&text, &program_, output_.data());
        std::printf("finished after: %.3f s\nresult: %s\n", static_cast<double>(ended_ns_) * 1e-9,
                    text.data);
    }

  private:
    static std::vector<std::max_align_t> blocks(std::size_t size)
    {
        return std::vector<std::max_align_t>(size / sizeof(std::max_align_t) + 1);
    }

    static frob_sim *open(const Options &options)
    {
        char message[8192];
        frob_sim_settings settings{};
        settings.robot = options.robot.c_str();
        settings.seed = options.seed;
        settings.served = 1;
        frob_sim *sim = frob_sim_open(options.world.c_str(), &settings, message, sizeof message);
        if (!sim)
            throw WrongUse(message);
        return sim;
    }

    bool over() const
    {
        return ended_ns_ != 0 || (first_ns_ >= 0 && static_cast<double>(time_.now_ns - first_ns_) >
                                                        options_.duration_s * 1e9);
    }

    void instant()
    {
        if (robot_.state != FROB_ROBOT_READY)
            due_ns_ = 0;
        if (robot_.state != FROB_ROBOT_READY || time_.now_ns < due_ns_ || stepping_)
            return;
        const auto period_ns = static_cast<std::int64_t>(1e9 / options_.rate_hz);
        due_ns_ = (due_ns_ == 0 ? time_.now_ns : due_ns_) + period_ns;
        if (first_ns_ < 0)
            first_ns_ = before_ns_ = time_.now_ns;
        frob_robot_sense(&robot_, input_.data());
        std::memset(output_.data(), 0, program_.output_size);
        const std::int64_t dt_ns = time_.now_ns - before_ns_;
        program_.step(state_.data(), program_.default_params, dt_ns,
                      static_cast<double>(dt_ns) / 1e9, input_.data(), output_.data());
        before_ns_ = time_.now_ns;
        stepping_ = true;
        command_ns_ = time_.now_ns + static_cast<std::int64_t>(options_.step_ms * 1e6);
        command();
        if (frob_has_ended(&program_, output_.data()))
            ended_ns_ = time_.now_ns - first_ns_;
        if (log_)
            write_log();
    }

    void command()
    {
        if (!stepping_ || time_.now_ns < command_ns_)
            return;
        stepping_ = false;
        frob_robot_command(&robot_, output_.data());
    }

    // All robots' inputs start with the odometry, and all outputs with the two speeds.
    void write_log() const
    {
        double in[3], out[2];
        std::memcpy(in, input_.data(), sizeof in);
        std::memcpy(out, output_.data(), sizeof out);
        const frob_sim_place at = frob_sim_place_robot(sim_.get(), 0);
        std::fprintf(log_, "%.3f %.4f %.4f %.4f %.3f %.3f %d %.4f %.4f %.4f\n",
                     static_cast<double>(time_.now_ns - first_ns_) * 1e-9, in[0], in[1], in[2],
                     out[0], out[1], frob_sim_summarize(sim_.get()).collisions, at.x_m - start_.x_m,
                     at.y_m - start_.y_m, at.heading_rad - start_.heading_rad);
    }

    std::int64_t next() const
    {
        std::int64_t due = std::min(server_.due_ns(), frob_robot_due_ns(&robot_));
        if (robot_.state == FROB_ROBOT_READY && !stepping_)
            due = std::min(due, due_ns_);
        if (stepping_)
            due = std::min(due, command_ns_);
        if (line_.to_driver.count > 0)
            due = std::min(due, line_.to_driver.arrive_ns[line_.to_driver.first]);
        return std::max(due, time_.now_ns + 1000);
    }

    const frob_program &program_;
    const frob_driver &driver_;
    const Options &options_;
    const std::vector<double> &settings_;
    std::unique_ptr<frob_sim, SimulationCloser> sim_;
    std::unique_ptr<Firmware> firmware_;
    Server server_;
    std::vector<std::max_align_t> device_, state_, input_, output_;
    frob_fake_clock time_{};
    frob_fake_line line_{};
    frob_robot robot_{};
    const frob_sim_place start_ = frob_sim_place_robot(sim_.get(), 0);
    std::FILE *log_ = nullptr;
    std::int64_t first_ns_ = -1, before_ns_ = 0, due_ns_ = 0, command_ns_ = 0, ended_ns_ = 0;
    bool stepping_ = false;
};

void set(const std::string &text, const frob_driver &driver, Options &options,
         std::vector<double> &settings)
{
    const std::size_t equals = text.find('=');
    if (equals == std::string::npos)
        throw WrongUse("write NAME=VALUE, not " + text);
    const std::string name = text.substr(0, equals), value = text.substr(equals + 1);
    const std::map<std::string, double *> numbers = { { "adapter", &options.adapter_ms },
                                                      { "step", &options.step_ms },
                                                      { "rate", &options.rate_hz } };
    const auto known = numbers.find(name);
    if (name == "log")
        options.log = value;
    else if (known != numbers.end())
        *known->second = std::stod(value);
    else {
        for (std::size_t i = 0; i < driver.setting_count; ++i)
            if (name == driver.settings[i].name) {
                settings[i] = std::stod(value);
                return;
            }
        throw WrongUse("there is no setting " + name);
    }
}

int run(int argc, char **argv)
{
    if (argc < 6)
        throw WrongUse("usage: frob-line PROGRAM.so ROBOT WORLD.toml SEED SECONDS [NAME=VALUE]...");
    const frob_program *program = frob_load(argv[1]);
    const frob_driver *driver = find_driver(argv[2]);
    if (!program)
        return 2;
    if (!driver || std::strcmp(program->robot, argv[2]) != 0)
        throw WrongUse(std::string("this is no program for a robot ") + argv[2]);
    Options options;
    options.robot = argv[2];
    options.world = argv[3];
    options.seed = std::stoull(argv[4]);
    options.duration_s = std::stod(argv[5]);
    std::vector<double> settings;
    for (std::size_t i = 0; i < driver->setting_count; ++i)
        settings.push_back(driver->settings[i].initial);
    for (int i = 6; i < argc; ++i)
        set(argv[i], *driver, options, settings);
    Run run(*program, *driver, options, settings);
    run.drive();
    run.print();
    return 0;
}

} // namespace

int main(int argc, char **argv)
{
    try {
        return run(argc, argv);
    } catch (const std::exception &error) {
        std::fprintf(stderr, "error: %s\n", error.what());
        return 2;
    }
}
