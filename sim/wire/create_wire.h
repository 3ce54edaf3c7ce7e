// The robot's end of the serial line of a simulated Create 2: the Open Interface, for any body that
// uses the structs of <frob/create.h>.
//
// This code was written from the protocol's description, independently of the driver, so that the
// two test each other. It accepts every command in that description; lights, songs,
// brushes and schedules have no effect. There is no watchdog: the last drive command stays in
// effect.
//
// The robot refreshes its sensors every 15 ms. It answers a query at the next refresh, but no
// sooner than a millisecond after the query, because processing the query takes that long.
// Therefore a client never receives an answer immediately after writing a query.
//
// Opcode 7 restarts the robot. This takes 3 s, during which it ignores commands and sends the text
// of its bootloader (the text was printed by a Create 2 and is quoted in issue 1 of pycreate2; the
// times are from a client library for the Roomba 600).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include <frob/create.h>

namespace frob::sim {

class CreateWire {
  public:
    enum class Mode : std::uint8_t { off, passive, safe, full };

    // Receives bytes from the client.
    void receive(const std::uint8_t *bytes, std::size_t count);

    // Drops an incomplete command.
    void forget() { command_.clear(); }

    // Sets the body's sensor readings at `now_ns`. Safe mode ends if the robot detects a cliff
    // while moving (except backwards), if a wheel drops, or if the robot is on a charger.
    void sense(const frob_create_input &input, std::int64_t now_ns);

    // Sends everything that is due by `now_ns`: answers, and a stream frame every 15 ms. Does not
    // send frames that would take longer than 15 ms to transmit.
    void advance(std::int64_t now_ns);

    // Bytes for the client. The caller clears them after sending.
    std::vector<std::uint8_t> to_client;

    // Called for each command with its name and arguments, as text.
    std::function<void(const std::string &)> log;

    Mode mode() const { return mode_; }
    int left_mm_s() const { return left_mm_s_; }
    int right_mm_s() const { return right_mm_s_; }
    // The wheel speeds as a command for the body.
    frob_create_output output() const;

  private:
    void command();
    void tell() const;
    void enter(Mode mode);
    void drive_wheels(int right_mm_s, int left_mm_s);
    void drive_curve(int speed_mm_s, int radius_mm);
    void answer();
    void reset();
    void boot();
    void append(unsigned id, std::vector<std::uint8_t> &to);
    void send_frame();
    std::size_t needed() const;
    int word(std::size_t at) const;

    Mode mode_ = Mode::off;
    frob_create_input senses_{};
    std::int64_t now_ns_ = 0, sensed_ns_ = 0, frame_ns_ = 0;
    double left_way_mm_ = 0, right_way_mm_ = 0;   // total distances that the wheels have travelled
    double asked_way_mm_ = 0, asked_turn_mm_ = 0; // values of these distances when packets 19 and
                                                  // 20 were last requested
    int left_mm_s_ = 0, right_mm_s_ = 0, speed_mm_s_ = 0, radius_mm_ = 0;
    std::vector<std::uint8_t> command_; // bytes received so far
    std::vector<std::uint8_t> streamed_, frame_;
    bool streaming_ = false;
    std::vector<std::uint8_t> asked_; // requested packets that have not been sent
    std::int64_t answer_ns_ = 0;      // time at which the answer with these packets is due
    std::int64_t reset_ns_ = 0;       // time of the last restart
    std::size_t to_boot_ = 0;         // number of remaining steps of the restart
};

} // namespace frob::sim
