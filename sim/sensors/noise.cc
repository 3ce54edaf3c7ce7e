#include "noise.h"

namespace frob::sim {

Noise::Noise(std::uint64_t seed, std::uint64_t stream) : state_(seed) {
    // Mixes the seed before adding the stream's number, so that the streams of neighbouring seeds
    // are not shifted copies of each other.
    state_ = next() + stream;
    state_ = next();
}

std::uint64_t Noise::seed_of_robot(std::uint64_t seed, std::uint64_t robot) {
    // Larger than any sensor's stream number.
    constexpr std::uint64_t streams_of_robots = 1u << 20;
    return robot == 0 ? seed : Noise(seed, streams_of_robots + robot).next();
}

double Noise::uniform() { return static_cast<double>(next() >> 11) * 0x1.0p-53; }

// The sum of eight uniform numbers is approximately normal up to 3 standard deviations
// (Irwin-Hall). The eight numbers are the 16-bit quarters of two draws: mean 8 * 65535 / 2,
// variance 8 (65536^2 - 1) / 12.
double Noise::normal() {
    std::int64_t sum = 0;
    for (int draw = 0; draw < 2; ++draw)
        for (std::uint64_t bits = next(); bits != 0; bits >>= 16)
            sum += static_cast<std::int64_t>(bits & 0xffff);
    return static_cast<double>(sum - 4 * 65535) * (1.0 / 53509.92);
}

} // namespace frob::sim
