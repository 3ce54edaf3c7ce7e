// Seeded noise that is the same on every machine. The standard library specifies the output of its
// generators, but not the output of its distributions.
#pragma once

#include <cstdint>

namespace frob::sim {

// One stream of noise. Each sensor has its own stream, so that a setting of one sensor does not
// change the readings of another.
class Noise {
  public:
    Noise(std::uint64_t seed, std::uint64_t stream);

    // The seed for one of several robots in a world. The first robot uses the seed of the run, so
    // that adding robots does not change its noise.
    static std::uint64_t seed_of_robot(std::uint64_t seed, std::uint64_t robot);

    // Uniform in [0, 1), in steps of 2^-53.
    double uniform();

    // A normal distribution with mean 0 and standard deviation 1, limited to ±4.9. It is computed
    // using only additions, because libraries differ in the last bit of `log` and `cos`.
    double normal();

    // 64 random bits.
    std::uint64_t bits() { return next(); }

  private:
    // splitmix64: a counter whose bits are mixed. Steele, Lea and Flood, Fast splittable
    // pseudorandom number generators, 2014.
    std::uint64_t next() {
        state_ += 0x9e3779b97f4a7c15u;
        std::uint64_t z = state_;
        z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
        z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
        return z ^ (z >> 31);
    }

    std::uint64_t state_;
};

} // namespace frob::sim
