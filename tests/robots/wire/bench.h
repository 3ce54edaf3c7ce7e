// A minimal robot behind an in-memory serial line, for tests of drivers. It has the simulator's
// protocol, its body moves as commanded, and its bytes take the time that the line's rate requires.
// Time is virtual.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <functional>
#include <vector>

#include "core/robot.h"
#include "create_wire.h"
#include "drivers/create/create.h"
#include "drivers/scout/scout.h"
#include "hal/fake/fake.h"
#include "scout_wire.h"

constexpr std::int64_t ms = 1000000;
constexpr std::int64_t second = 1000 * ms;

// The data about each robot that the bench needs.
struct ScoutKind {
    using Wire = frob::sim::ScoutWire;
    using Input = frob_scout_input;
    using Output = frob_scout_output;
    using Device = frob_scout;
    static const frob_driver &driver() { return frob_scout_driver; }
    static constexpr double separation_m = 0.3452;
};

struct CreateKind {
    using Wire = frob::sim::CreateWire;
    using Input = frob_create_input;
    using Output = frob_create_output;
    using Device = frob_create;
    static const frob_driver &driver() { return frob_create_driver; }
    static constexpr double separation_m = 0.235;
};

// Faults of one direction of the line; this class has none. Tests of faults define their own.
struct NoFaults {
    // Before each turn of both ends, may add up to `room` bytes of its own.
    void begin(std::int64_t /*room*/, std::vector<std::uint8_t> &) {}
    // Appends the bytes that leave the line when `byte` enters it.
    void pass(std::uint8_t byte, std::vector<std::uint8_t> &out) { out.push_back(byte); }
    // All bytes of this turn have entered the line.
    void end() {}
    // Extra delay, in addition to the time that the line's rate requires.
    std::int64_t delay_ns(std::int64_t) { return 0; }
};

template <class Kind, class Faults = NoFaults>
class Bench
{
  public:
    Bench() : device(), robot()
    {
        time.now_ns = second;
        frob_fake_line_open(&line, &time);
        for (std::size_t i = 0; i < Kind::driver().setting_count; ++i)
            settings.push_back(Kind::driver().settings[i].initial);
    }

    void start()
    {
        serial = frob_fake_serial(&line);
        clock = frob_fake_time(&time);
        frob_robot_start(&robot, &Kind::driver(), &device, settings.data(), &serial, &clock,
                         200 * ms);
    }

    // Lets both ends act at the current time. The driver's bytes reach the robot
    // immediately; the robot's bytes take their time.
    void act()
    {
        std::uint8_t bytes[256];
        passed_.clear();
        to_robot.begin((time.now_ns - moved_ns_) / byte_ns(), passed_);
        while (const std::size_t count = frob_fake_receive(&line, bytes, sizeof bytes))
            for (std::size_t i = 0; i < count; ++i)
                to_robot.pass(bytes[i], passed_);
        to_robot.end();
        wire.receive(passed_.data(), passed_.size());
        move();
        wire.advance(time.now_ns);
        send();
        polled_ns = time.now_ns;
        state = frob_robot_poll(&robot);
        if (acted)
            acted();
    }

    // Advances to `until_ns`. Both ends act whenever something is due or all bytes have arrived,
    // and every `tick_ns`.
    void run(std::int64_t until_ns)
    {
        while (time.now_ns < until_ns) {
            act();
            std::int64_t next = std::min(until_ns, time.now_ns + tick_ns);
            const std::int64_t due = frob_robot_due_ns(&robot);
            if (due > time.now_ns)
                next = std::min(next, due);
            if (line.to_driver.count > 0) {
                const std::size_t last = line.to_driver.first + line.to_driver.count - 1;
                const std::int64_t arrival = line.to_driver.arrive_ns[last % FROB_FAKE_ROOM];
                if (arrival > time.now_ns)
                    next = std::min(next, arrival);
            }
            time.now_ns = next;
        }
        act();
    }

    // Drives for a time, commanding 30 times a second.
    void drive(double forward, double turn, std::int64_t for_ns)
    {
        const std::int64_t until_ns = time.now_ns + for_ns;
        while (time.now_ns < until_ns) {
            typename Kind::Output output{};
            output.forward = forward;
            output.turn = turn;
            frob_robot_command(&robot, &output);
            run(std::min(until_ns, time.now_ns + second / 30));
            frob_robot_sense(&robot, &input);
        }
    }

    frob_fake_clock time{};
    frob_fake_line line{};
    frob_serial serial{};
    frob_clock clock{};
    std::vector<double> settings;
    typename Kind::Device device;
    frob_robot robot;
    frob_robot_state state = FROB_ROBOT_CONNECTING;
    typename Kind::Wire wire;
    typename Kind::Input body{};  // the body's sensor readings; tests may change them
    typename Kind::Input input{}; // the program's last input
    double true_heading = 0;
    Faults to_robot, to_driver;
    std::int64_t rate = Kind::driver().rate;
    std::int64_t tick_ns = 5 * ms;
    std::int64_t polled_ns = 0; // time of the last poll; the driver may have waited since
    bool cut = false;           // the cable is cut: all bytes are lost

    // Called after both ends have acted, and when the robot has sent bytes, which are in transit
    // unless faults removed them.
    std::function<void()> acted;
    std::function<void(const std::vector<std::uint8_t> &)> sent;

  private:
    // Moves the body as the wire last commanded.
    void move()
    {
        const double elapsed_s = static_cast<double>(time.now_ns - moved_ns_) * 1e-9;
        const auto output = wire.output();
        if (moved_ns_ != 0 && elapsed_s > 0) {
            const double halfway = true_heading + 0.5 * output.turn * elapsed_s;
            body.odometry.position.x += output.forward * elapsed_s * std::cos(halfway);
            body.odometry.position.y += output.forward * elapsed_s * std::sin(halfway);
            true_heading += output.turn * elapsed_s;
            body.odometry.heading = std::remainder(true_heading, 2 * 3.14159265358979323846);
        }
        moved_ns_ = time.now_ns;
        body.leftWheel = output.forward - 0.5 * output.turn * Kind::separation_m;
        body.rightWheel = output.forward + 0.5 * output.turn * Kind::separation_m;
        wire.sense(body, time.now_ns);
    }

    std::int64_t byte_ns() const { return 10 * second / rate; }

    void send()
    {
        passed_.clear();
        to_driver.begin(std::max<std::int64_t>(0, time.now_ns + ms - busy_ns_) / byte_ns(),
                        passed_);
        for (const std::uint8_t byte : wire.to_client)
            to_driver.pass(byte, passed_);
        to_driver.end();
        sent_.swap(wire.to_client);
        wire.to_client.clear();
        // A robot that cannot send its bytes drops new ones.
        if (cut || busy_ns_ > time.now_ns + 50 * ms)
            return;
        for (const std::uint8_t byte : passed_) {
            busy_ns_ = std::max(busy_ns_, time.now_ns) + byte_ns();
            frob_fake_send(&line, &byte, 1,
                           busy_ns_ - time.now_ns + to_driver.delay_ns(time.now_ns));
        }
        if (sent && !sent_.empty())
            sent(sent_);
    }

    std::int64_t moved_ns_ = 0, busy_ns_ = 0;
    std::vector<std::uint8_t> passed_, sent_;
};
