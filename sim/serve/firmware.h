// Simulates a robot's onboard computer, which receives and sends bytes over the line, and moves
// the robot. It does not perform I/O or read a clock. The caller passes the time in nanoseconds
// since the start, so that tests can run it at any speed.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace frob::serve {

using Bytes = std::vector<std::uint8_t>;

class Firmware {
  public:
    virtual ~Firmware() = default;

    // Runs the robot up to this time, which must not be earlier than in the previous call.
    virtual void advance(std::int64_t time_ns) = 0;

    // Receives a byte. The caller must first call `advance` with the byte's arrival time.
    virtual void receive(std::uint8_t byte) = 0;

    // Drops a partially received command, because the client has left or paused.
    virtual void forget() {}

    // The time at which to call `advance` next.
    virtual std::int64_t next_ns() const = 0;

    // The line's current rate, in bits per second.
    virtual std::uint32_t rate() const = 0;

    // Removes and returns the bytes to send.
    Bytes take_output() { return std::exchange(output_, {}); }

    // Called for each command with the time, and the command's name and argument as text.
    using Log = std::function<void(std::int64_t time_ns, const std::string &text)>;
    void set_log(Log log) { log_ = std::move(log); }

  protected:
    void send(const Bytes &bytes) { output_.insert(output_.end(), bytes.begin(), bytes.end()); }
    void log(std::int64_t time_ns, const std::string &text) const {
        if (log_) log_(time_ns, text);
    }
    std::size_t waiting_output() const { return output_.size(); }

  private:
    Bytes output_;
    Log log_;
};

} // namespace frob::serve
