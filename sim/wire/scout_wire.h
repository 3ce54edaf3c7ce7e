// A simulated Scout's end of its serial line, in front of any body that gives
// and takes what <frob/scout.h> says.
//
// Written from the protocol's description (Nomadics' Ndirect) and not from the
// driver, so that each can judge the other. Every command gets one answer, and
// nothing is sent unasked; commands of other models are refused. The watchdog
// gives up a motion after the seconds that CONF_TM set without any command.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include <frob/scout.h>

namespace frob::sim
{

class ScoutWire
{
  public:
    // Bytes from the client.
    void receive(const std::uint8_t *bytes, std::size_t count);

    // Forgets a packet that is not complete.
    void forget() { pending_.clear(); }

    // What the body senses from `now_ns` on. An echo stays its transducer's
    // reading until the next; after a round without one the reading is 255.
    void sense(const frob_scout_input &input, std::int64_t now_ns);

    // Lets the watchdog, and a client's wait, look at the time.
    void advance(std::int64_t now_ns);

    // What goes to the client and has not been cleared.
    std::vector<std::uint8_t> to_client;

    // Told each command: its name and its numbers, and when the watchdog acts.
    std::function<void(const std::string &)> log;

    // Wheel speeds, 0.1 inch/s.
    int left() const { return left_; }
    int right() const { return right_; }
    // The same for the body.
    frob_scout_output output() const;

  private:
    // Where the robot says that it is: 0.1 inch, 0.1 degree.
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
    std::int64_t now_ns_ = 0, commanded_ns_ = 0;
    unsigned watchdog_s_ = 0;
    int left_ = 0, right_ = 0;
    int speed_left_ = 100, speed_right_ = 100; // of PR, as SP set them
    bool moving_ = false;                      // by PR, until the ways below are made
    double left_way_ = 0, right_way_ = 0;      // all the way of the wheels, 0.1 inch
    double left_goal_ = 0, right_goal_ = 0;
    // Where the body's odometry was when the place was defined, and as what.
    frob_pose origin_{};
    Place defined_{ 0, 0, 0 };
    bool waits_ = false; // WS is not answered yet
    std::int64_t waits_until_ns_ = 0;
    std::array<bool, 16> on_{}; // sonars in the order of CONF_SN
    std::array<std::uint8_t, 16> sonar_in_{};
    std::array<std::int64_t, 16> echo_ns_{};
    std::int64_t round_ns_ = 0; // of the transducers that are on
    std::vector<std::uint8_t> pending_;
};

} // namespace frob::sim
