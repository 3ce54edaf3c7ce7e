// The robot's end of the serial line of a simulated Scout, for any body that uses the structs of
// <frob/scout.h>.
//
// This code was written from the protocol's description (Nomadics' Ndirect), independently of the
// driver, so that the two test each other. The robot sends one answer to each command, and
// nothing else. It refuses the commands of other models. The watchdog stops the motion if no
// command arrives for the number of seconds that CONF_TM sets.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include <frob/scout.h>

namespace frob::sim {

class ScoutWire {
  public:
    // Receives bytes from the client.
    void receive(const std::uint8_t *bytes, std::size_t count);

    // Drops an incomplete packet.
    void forget() { pending_.clear(); }

    // Sets the body's sensor readings at `now_ns`. An echo remains its transducer's reading until
    // the next echo; after a round without an echo the reading is 255.
    void sense(const frob_scout_input &input, std::int64_t now_ns);

    // Updates the time for the watchdog and for a pending WS command.
    void advance(std::int64_t now_ns);

    // Bytes for the client. The caller clears them after sending.
    std::vector<std::uint8_t> to_client;

    // Called for each command with its name and arguments, as text, and when the watchdog trips.
    std::function<void(const std::string &)> log;

    // Wheel speeds, in 0.1 inch/s.
    int left() const { return left_; }
    int right() const { return right_; }
    // The wheel speeds as a command for the body.
    frob_scout_output output() const;

  private:
    // The pose that the robot reports, in units of 0.1 inch and 0.1 degree.
    struct Place {
        double x, y, heading;
    };

    Place place() const;
    void define(const Place &here);
    void put_bumpers(std::vector<std::uint8_t> &to) const;
    void end_waiting();
    void find_packets();
    void tell(unsigned type, const std::uint8_t *data, std::size_t count) const;
    void command(unsigned type, const std::uint8_t *data, std::size_t count);
    void answer(unsigned type, const std::vector<std::uint8_t> &data);
    void answer_with_state(unsigned type);
    void move_towards_goal();

    frob_scout_input senses_{};
    std::int64_t now_ns_ = 0, sensed_ns_ = 0, commanded_ns_ = 0;
    unsigned watchdog_s_ = 0;
    int left_ = 0, right_ = 0;
    int speed_left_ = 100, speed_right_ = 100; // speeds for PR, set by SP
    bool moving_ = false;                      // whether PR is moving the wheels to the goals below
    double left_way_ = 0, right_way_ = 0;      // total distances that the wheels have travelled, in
                                               // 0.1 inch
    double left_goal_ = 0, right_goal_ = 0;
    // The body's odometry when the client last defined the robot's pose, and that pose.
    frob_pose origin_{};
    Place defined_{0, 0, 0};
    bool waits_ = false; // whether the answer to WS is pending
    std::int64_t waits_until_ns_ = 0;
    std::array<bool, 16> on_{}; // which sonars are on, numbered as in CONF_SN
    std::array<std::uint8_t, 16> sonar_in_{};
    std::array<std::int64_t, 16> echo_ns_{};
    std::int64_t round_ns_ = 0; // duration of a round of the transducers that are on
    std::vector<std::uint8_t> pending_;
};

} // namespace frob::sim
