// One direction of a serial line. A byte takes the time of ten bits.
#pragma once

#include <cstdint>
#include <deque>

#include "firmware.h"

namespace frob::serve {

class PacedLine {
  public:
    // A line that is not paced delivers bytes immediately.
    explicit PacedLine(bool paced) : paced_(paced) {}

    // Sends bytes at this time, after those in transit.
    void push(const Bytes &bytes, std::int64_t time_ns, std::uint32_t rate);

    // Removes the next byte that has arrived by this time, and stores it with its arrival time.
    // Returns false if there is none.
    bool take(std::int64_t time_ns, std::uint8_t &byte, std::int64_t &arrived_ns);

    // The time at which the next byte arrives; INT64_MAX if none is in transit.
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
    std::int64_t free_ns_ = 0; // time at which the line can carry the next byte
};

} // namespace frob::serve
