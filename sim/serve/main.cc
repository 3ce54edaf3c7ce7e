// frob-serve -- simulates a robot at the other end of a serial line.
//
// Exit status: 0 if it ended after its duration or on SIGINT or SIGTERM (it then prints a summary
// like that of frob-sim); 2 for usage errors.
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <exception>
#include <filesystem>
#include <fstream>
#include <functional>
#include <memory>
#include <string>

#include <unistd.h>

#include "camera_port.h"
#include "options.h"
#include "own_firmware.h"
#include "robots.h"
#include "ros_robot.h"
#include "server.h"
#include "sim.h"
#include "summary.h"
#include "tcp_port.h"
#include "terminal.h"

extern "C" {
#include <hosts/common/streams.h>
}

using namespace frob::serve;

namespace {

volatile std::sig_atomic_t ended = 0, pulled = 0, plugged = 0;

void on_signal(int number) {
    if (number == SIGUSR1)
        pulled = 1;
    else if (number == SIGUSR2)
        plugged = 1;
    else
        ended = 1;
}

void catch_signals() {
    struct sigaction action{};
    action.sa_handler = on_signal;
    for (const int number : {SIGINT, SIGTERM, SIGUSR1, SIGUSR2})
        sigaction(number, &action, nullptr);
    action.sa_handler = SIG_IGN;
    sigaction(SIGPIPE, &action, nullptr);
}

std::int64_t clock_ns() {
    timespec now{};
    clock_gettime(CLOCK_MONOTONIC, &now);
    return static_cast<std::int64_t>(now.tv_sec) * 1'000'000'000 + now.tv_nsec;
}

struct SimulationCloser {
    void operator()(frob_sim *sim) const { frob_sim_close(sim); }
};
using Simulation = std::unique_ptr<frob_sim, SimulationCloser>;

// Returns null after reporting an error.
Simulation open_simulation(const Options &options, const OwnRobot &own) {
    char message[8192];
    frob_sim_settings settings{};
    settings.robot = options.robot.c_str();
    settings.seed = options.seed;
    settings.wall_distance_m = options.wall_distance_m;
    settings.body = own.body;
    settings.served = 1;
    Simulation sim(frob_sim_open(options.world.c_str(), &settings, message, sizeof message));
    if (!sim)
        for (char *line = std::strtok(message, "\n"); line; line = std::strtok(nullptr, "\n"))
            std::fprintf(stderr, "error: %s\n", line);
    return sim;
}

using Log = std::function<void(const std::string &)>;

std::unique_ptr<Connection> make_connection(const Options &options, const Log &tell) {
    if (options.tcp_port >= 0) return std::make_unique<TcpPort>(options.tcp_port, tell);
    return std::make_unique<Terminal>();
}

// Removes the symbolic link if it still points to our device: another process may have replaced it.
void unlink_own(const Options &options, const Server &server) {
    if (options.link.empty() || server.connection() == nullptr) return;
    std::error_code error;
    if (std::filesystem::read_symlink(options.link, error) == server.connection()->device())
        unlink(options.link.c_str());
}

// Connects a new line and prints the name of its device. Returns false if printing fails.
bool plug(Server &server, const Options &options, const Log &tell) {
    server.plug(make_connection(options, tell));
    const std::string device = server.connection()->device();
    if (!options.link.empty()) {
        const std::string next = options.link + ".next";
        unlink(next.c_str());
        if (symlink(device.c_str(), next.c_str()) != 0 ||
            std::rename(next.c_str(), options.link.c_str()) != 0)
            std::fprintf(stderr, "error: cannot create the link %s: %s\n", options.link.c_str(),
                         std::strerror(errno));
    }
    std::printf("device: %s\n", device.c_str());
    return std::fflush(stdout) == 0;
}

void run(Server &server, CameraPort *cameras, const Options &options, std::int64_t started_ns,
         const Log &tell) {
    const auto end_ns = static_cast<std::int64_t>(options.duration_s * 1e9);
    // Without a link, the printed name is the only way to find the device.
    if (!plug(server, options, tell) && options.link.empty())
        throw WrongUse(std::string("cannot write to standard output: ") + std::strerror(errno));
    if (cameras != nullptr)
        for (const std::string &address : cameras->addresses())
            std::printf("camera: %s\n", address.c_str());
    std::fflush(stdout);
    while (!ended) {
        const std::int64_t time_ns = clock_ns() - started_ns;
        if (end_ns > 0 && time_ns >= end_ns) break;
        if (pulled) {
            pulled = 0;
            unlink_own(options, server);
            server.plug(nullptr);
        }
        if (plugged) {
            plugged = 0;
            plug(server, options, tell);
        }
        server.advance(time_ns);
        if (cameras != nullptr) cameras->advance(time_ns);
        server.wait(time_ns);
    }
    unlink_own(options, server);
    server.plug(nullptr);
}

void run_in_ros(frob_sim *sim, CameraPort *cameras, const Options &options,
                const RosRobot::Log &write_log) {
    RosRobot robot(sim, options.node, options.stamped, options.ros_arguments);
    const std::int64_t started_ns = clock_ns();
    const auto end_ns = static_cast<std::int64_t>(options.duration_s * 1e9);
    if (write_log) robot.set_log(write_log);
    for (const std::string &line : robot.description()) std::printf("%s\n", line.c_str());
    if (cameras != nullptr)
        for (const std::string &address : cameras->addresses())
            std::printf("camera: %s\n", address.c_str());
    std::fflush(stdout);
    while (!ended) {
        const std::int64_t time_ns = clock_ns() - started_ns;
        if (end_ns > 0 && time_ns >= end_ns) break;
        if (!robot.advance(time_ns)) throw WrongUse("the ROS 2 node has ended");
        if (cameras != nullptr) cameras->advance(time_ns);
        robot.wait(time_ns);
    }
}

int serve(const Options &options) {
    const OwnRobot own =
        options.own.empty() ? OwnRobot{} : load_own_robot(options.own, options.robot);
    const Simulation sim = open_simulation(options, own);
    if (!sim) return 2;
    const std::unique_ptr<CameraPort> cameras =
        options.camera_port < 0 ? nullptr
                                : std::make_unique<CameraPort>(sim.get(), options.camera_port);
    std::ofstream log;
    const std::int64_t started_ns = clock_ns();
    const auto write_log = [&](std::int64_t time_ns, const std::string &text) {
        char time[32];
        std::snprintf(time, sizeof time, "%.6f", static_cast<double>(started_ns + time_ns) * 1e-9);
        log << time << ' ' << text << std::endl;
    };
    if (!options.log.empty()) {
        log.open(options.log, std::ios::app);
        if (!log) throw WrongUse("cannot write " + options.log);
    }
    if (!options.node.empty()) {
        catch_signals();
        run_in_ros(sim.get(), cameras.get(), options,
                   log.is_open() ? RosRobot::Log(write_log) : RosRobot::Log());
        print_summary(sim.get());
        return 0;
    }
    const std::unique_ptr<Firmware> firmware =
        own.board ? std::make_unique<OwnFirmware>(
                        *own.board, sim.get(), options.rate != 0 ? options.rate : own.board->rate)
                  : make_firmware(options.robot, options.model, options.rate, sim.get());
    if (!firmware)
        throw WrongUse("there is no model `" + options.model + "`; use p3dx-sh, p3dx or p2dx");
    if (log.is_open()) firmware->set_log(write_log);
    Server server(*firmware, options.paced);
    catch_signals();
    run(server, cameras.get(), options, started_ns, [&](const std::string &text) {
        std::fprintf(stderr, "%s\n", text.c_str());
        if (log.is_open()) write_log(clock_ns() - started_ns, text);
    });
    print_summary(sim.get());
    return 0;
}

} // namespace

int main(int argc, char **argv) {
    streams_keep_plain();
    if (argc == 2 && std::string(argv[1]) == "--help") {
        std::fputs(usage, stdout);
        return 0;
    }
    try {
        return serve(read_options(argc, argv));
    } catch (const std::exception &error) {
        std::fprintf(stderr, "error: %s\n", error.what());
        return 2;
    }
}
