// What a robot's own computer does: bytes come in over the line, bytes go out,
// and the robot moves. No I/O and no clock: time is what the caller says, in
// nanoseconds since the start, so tests run it as fast as they like.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace frob::serve
{

using Bytes = std::vector<std::uint8_t>;

class Firmware
{
  public:
    virtual ~Firmware() = default;

    // Runs the robot up to this time, which does not go back.
    virtual void advance(std::int64_t time_ns) = 0;

    // A byte has arrived; `advance` has been called with this time.
    virtual void receive(std::uint8_t byte) = 0;

    // The client has left, or paused: what it has begun and not completed is no
    // command any more.
    virtual void forget() {}

    // When the firmware wants to be advanced next.
    virtual std::int64_t next_ns() const = 0;

    // The line's rate now, bits per second.
    virtual std::uint32_t rate() const = 0;

    // What is to be sent.
    Bytes take_output() { return std::exchange(output_, {}); }

    // Called for each command with the time, its name and its argument.
    using Log = std::function<void(std::int64_t time_ns, const std::string &text)>;
    void set_log(Log log) { log_ = std::move(log); }

  protected:
    void send(const Bytes &bytes) { output_.insert(output_.end(), bytes.begin(), bytes.end()); }
    void log(std::int64_t time_ns, const std::string &text) const
    {
        if (log_)
            log_(time_ns, text);
    }
    std::size_t waiting_output() const { return output_.size(); }

  private:
    Bytes output_;
    Log log_;
};

} // namespace frob::serve
