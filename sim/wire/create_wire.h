// A simulated Create 2's end of its serial line: the Open Interface as clients
// see it, in front of any body that gives and takes what <frob/create.h> says.
//
// Written from the protocol's description and not from the driver, so that each
// can judge the other. It takes every command of that description; lights,
// songs, brushes and schedules have no effect. There is no watchdog: the last
// drive command holds.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include <frob/create.h>

namespace frob::sim
{

class CreateWire
{
  public:
    enum class Mode : std::uint8_t { off, passive, safe, full };

    // Bytes from the client.
    void receive(const std::uint8_t *bytes, std::size_t count);

    // Forgets a command that is not complete.
    void forget() { command_.clear(); }

    // What the body senses from `now_ns` on. Safe mode ends here: at a cliff
    // while moving, a wheel drop, or a charger.
    void sense(const frob_create_input &input, std::int64_t now_ns);

    // Sends what is due by itself until `now_ns`: frames, one every 15 ms. A frame
    // that needs longer than that on the line is not sent.
    void advance(std::int64_t now_ns);

    // What goes to the client and has not been cleared.
    std::vector<std::uint8_t> to_client;

    // Told each command: the opcode's name and its numbers.
    std::function<void(const std::string &)> log;

    Mode mode() const { return mode_; }
    int left_mm_s() const { return left_mm_s_; }
    int right_mm_s() const { return right_mm_s_; }
    // The same for the body.
    frob_create_output output() const;

  private:
    void command();
    void tell() const;
    void enter(Mode mode);
    void drive_wheels(int right_mm_s, int left_mm_s);
    void drive_curve(int speed_mm_s, int radius_mm);
    void query(unsigned id);
    void append(unsigned id, std::vector<std::uint8_t> &to);
    void send_frame();
    std::size_t needed() const;
    int word(std::size_t at) const;

    Mode mode_ = Mode::off;
    frob_create_input senses_{};
    std::int64_t now_ns_ = 0, frame_ns_ = 0;
    double left_way_mm_ = 0, right_way_mm_ = 0;   // all the way of the wheels
    double asked_way_mm_ = 0, asked_turn_mm_ = 0; // when packets 19 and 20 were asked for
    int left_mm_s_ = 0, right_mm_s_ = 0, speed_mm_s_ = 0, radius_mm_ = 0;
    std::vector<std::uint8_t> command_; // bytes of it so far
    std::vector<std::uint8_t> streamed_, frame_;
    bool streaming_ = false;
};

} // namespace frob::sim
