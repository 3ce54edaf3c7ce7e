// Random faults of a line, determined by a seed: bytes are dropped, duplicated or flipped; garbage
// appears between them, also in bursts; packets are truncated; bytes are held back and then arrive
// all at once.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

extern "C" {
#include "random.h"
}

class Faults
{
  public:
    // The number of bytes, of 65536, that are dropped, duplicated, flipped, or preceded by garbage;
    // and the number of packets, of 256, that are truncated.
    struct Rates {
        unsigned dropped = 0, doubled = 0, flipped = 0, garbage = 0, cut = 0;
        unsigned storm = 0;       // maximum bytes of garbage per turn
        std::int64_t held_ns = 0; // bytes arrive in batches at multiples of this time
    };

    void seed(std::uint64_t seed) { seed_ = seed; }
    void set(const Rates &rates) { rates_ = rates; }
    bool any() const
    {
        return rates_.dropped || rates_.doubled || rates_.flipped || rates_.garbage || rates_.cut ||
               rates_.storm || rates_.held_ns;
    }

    // Whether the bytes since `begin` passed unchanged, with nothing before or between them.
    bool untouched() const { return untouched_; }

    void begin(std::int64_t room, std::vector<std::uint8_t> &out)
    {
        untouched_ = true;
        cutting_ = false;
        cuts_ = rates_.cut > 0 && random_below(&seed_, 256) < rates_.cut;
        std::int64_t storm = rates_.storm == 0 ? 0 : random_below(&seed_, rates_.storm + 1);
        for (storm = std::min(storm, room); storm > 0; --storm) {
            out.push_back(garbage());
            untouched_ = false;
        }
    }

    void pass(std::uint8_t byte, std::vector<std::uint8_t> &out)
    {
        if (cuts_ && !cutting_)
            cutting_ = random_below(&seed_, 16) == 0;
        if (cutting_ || falls(rates_.dropped)) {
            untouched_ = false;
            return;
        }
        if (falls(rates_.garbage)) {
            out.push_back(garbage());
            untouched_ = false;
        }
        if (falls(rates_.flipped)) {
            byte = static_cast<std::uint8_t>(byte ^ (1u << random_below(&seed_, 8)));
            untouched_ = false;
        }
        out.push_back(byte);
        if (falls(rates_.doubled)) {
            out.push_back(byte);
            untouched_ = false;
        }
    }

    void end() {}

    std::int64_t delay_ns(std::int64_t now_ns) const
    {
        return rates_.held_ns == 0 ? 0 : rates_.held_ns - now_ns % rates_.held_ns;
    }

  private:
    bool falls(unsigned rate) { return rate != 0 && random_below(&seed_, 65536) < rate; }

    // Half of the garbage consists of the first and last bytes of packets.
    std::uint8_t garbage()
    {
        static constexpr std::uint8_t likely[] = { 0x01, 0x2C, 0x00, 0x5C, 0x13, 0x37, 0xFA, 0xFB,
                                                   0x56, 0x91, 0x80, 0x83, 0x07, 0xAD, 0x94, 0x85 };
        const std::uint64_t r = random_next(&seed_);
        return (r & 1) != 0 ? likely[(r >> 1) % sizeof likely] : static_cast<std::uint8_t>(r >> 8);
    }

    Rates rates_;
    std::uint64_t seed_ = 1;
    bool untouched_ = true, cuts_ = false, cutting_ = false;
};
