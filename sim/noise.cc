#include "noise.h"

namespace frob::sim {

Noise::Noise(std::uint64_t seed, std::uint64_t stream)
    : state_(seed) {
    // Mixed apart, so that no stream is another one of a neighbouring seed,
    // shifted.
    state_ = next() + stream;
    state_ = next();
}

// splitmix64: a counter, and a mixing of its bits.
// Steele, Lea and Flood, Fast splittable pseudorandom number generators, 2014.
std::uint64_t Noise::next() {
    state_ += 0x9e3779b97f4a7c15u;
    std::uint64_t z = state_;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
}

double Noise::uniform() { return static_cast<double>(next() >> 11) * 0x1.0p-53; }

// The sum of twelve uniform numbers has variance 12 / 12 = 1 and mean 6
// (Irwin-Hall): close to a normal distribution out to 3 standard deviations.
double Noise::normal() {
    double sum = -6.0;
    for (int i = 0; i < 12; ++i) sum += uniform();
    return sum;
}

} // namespace frob::sim
