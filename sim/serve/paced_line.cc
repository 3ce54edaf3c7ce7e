#include "paced_line.h"

#include <algorithm>
#include <limits>

namespace frob::serve {
namespace {

constexpr std::int64_t bits_per_byte = 10; // including the start and stop bits

} // namespace

void PacedLine::push(const Bytes &bytes, std::int64_t time_ns, std::uint32_t rate) {
    const std::int64_t takes = paced_ ? bits_per_byte * 1'000'000'000 / rate : 0;
    free_ns_ = std::max(free_ns_, time_ns);
    for (const std::uint8_t byte : bytes) {
        free_ns_ += takes;
        bytes_.push_back({byte, free_ns_});
    }
}

bool PacedLine::take(std::int64_t time_ns, std::uint8_t &byte, std::int64_t &arrived_ns) {
    if (bytes_.empty() || bytes_.front().arrives_ns > time_ns) return false;
    byte = bytes_.front().byte;
    arrived_ns = bytes_.front().arrives_ns;
    bytes_.pop_front();
    return true;
}

std::int64_t PacedLine::next_ns() const {
    return bytes_.empty() ? std::numeric_limits<std::int64_t>::max() : bytes_.front().arrives_ns;
}

} // namespace frob::serve
