// Seeded noise that is the same on every machine: the standard library fixes
// its generators, but not what its distributions do with them.
#pragma once

#include <cstdint>

namespace frob::sim
{

// One stream of noise. Each sensor has a stream of its own, so that a setting
// of one does not change what another sees.
class Noise
{
  public:
    Noise(std::uint64_t seed, std::uint64_t stream);

    // The seed of one of several robots in a world: of the first it is the run's
    // own, so that more robots do not change what it draws.
    static std::uint64_t seed_of_robot(std::uint64_t seed, std::uint64_t robot);

    // Uniform in [0, 1), in steps of 2^-53.
    double uniform();

    // Mean 0, standard deviation 1, never beyond 4.9. Made by additions alone,
    // since libraries differ in the last bit of `log` and `cos`.
    double normal();

    // 64 of them.
    std::uint64_t bits() { return next(); }

  private:
    // splitmix64: a counter, and a mixing of its bits.
    // Steele, Lea and Flood, Fast splittable pseudorandom number generators, 2014.
    std::uint64_t next()
    {
        state_ += 0x9e3779b97f4a7c15u;
        std::uint64_t z = state_;
        z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
        z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
        return z ^ (z >> 31);
    }

    std::uint64_t state_;
};

} // namespace frob::sim
