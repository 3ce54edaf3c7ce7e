// One direction of a serial line: a byte takes ten bits' time.
#pragma once

#include <cstdint>
#include <deque>

#include "firmware.h"

namespace frob::serve
{

class PacedLine
{
  public:
    // A line that is not paced hands on what it gets at once.
    explicit PacedLine(bool paced) : paced_(paced) {}

    // Bytes begin to travel now, behind those that already do.
    void push(const Bytes &bytes, std::int64_t time_ns, std::uint32_t rate);

    // The next byte that has arrived by this time, with the time at which it
    // did; false if there is none.
    bool take(std::int64_t time_ns, std::uint8_t &byte, std::int64_t &arrived_ns);

    // When the next byte arrives; never is INT64_MAX.
    std::int64_t next_ns() const;

    std::size_t travelling() const { return bytes_.size(); }
    void clear() { bytes_.clear(); }

  private:
    struct Travelling {
        std::uint8_t byte;
        std::int64_t arrives_ns;
    };
    bool paced_;
    std::deque<Travelling> bytes_;
    std::int64_t free_ns_ = 0; // when the line is free for the next byte
};

} // namespace frob::serve
