// Patterns on surfaces.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include "look.h"

namespace frob::sim {

namespace pattern {

// The next whole number below; std::floor is a call on processors without an instruction for it.
inline int whole(double x) {
    const int n = static_cast<int>(x);
    return n - (x < n ? 1 : 0);
}

// The share of an interval of this length around x that is beyond an edge at 0.
inline double beyond(double x, double grain) {
    if (x >= grain) return 1.0;
    if (x <= -grain) return 0.0;
    const double share = x / grain + 0.5;
    return share < 0.0 ? 0.0 : share > 1.0 ? 1.0 : share;
}

// Where x is in a row of things of size 1, -0.5 to 0.5 from the middle of one.
inline double within(double x) { return x - whole(x) - 0.5; }

// A wave of light and dark stripes, -1 to 1, each so wide; its edges are as wide as a pixel.
inline double wave(double x, double width, double grain) {
    if (grain >= 2.0 * width) return 0.0;
    const double phase = 2.0 * width * within(x / (2.0 * width)); // -width … width
    const double inside = width / 2 - std::abs(phase);
    return 2.0 * beyond(inside, grain) - 1.0;
}

} // namespace pattern

// How bright a surface is at a place on it, about 1: u along it and v across, in metres.
// `grain` is how much of it a pixel sees: what is finer is seen as its mean.
class Patterns {
  public:
    static const Patterns &all();

    // `f` of the pattern: a function of u, v and grain, of a type of its own for each texture.
    template <typename F> void with(Texture texture, const F &f) const {
        switch (texture) {
        case Texture::plain: return f([](double, double, double) { return 1.0; });
        case Texture::plaster:
            return f([this](double u, double v, double grain) { return plaster(u, v, grain); });
        case Texture::bricks:
            return f([this](double u, double v, double grain) { return bricks(u, v, grain); });
        case Texture::stripes:
            return f([](double, double v, double grain) {
                return 1.0 + 0.35 * pattern::wave(v, 0.1, grain);
            });
        case Texture::checks:
            return f([](double u, double v, double grain) {
                return 1.0 + 0.35 * pattern::wave(u, 0.1, grain) * pattern::wave(v, 0.1, grain);
            });
        }
    }

  private:
    Patterns();

    // Between the middles of four cells.
    double plaster(double u, double v, double grain) const {
        int level = 0;
        double size = cell, cells_per_metre = 1.0 / cell;
        while (level + 1 < levels && grain > size) {
            size *= 2.0;
            cells_per_metre *= 0.5;
            ++level;
        }
        const std::vector<float> &cells = noise_[static_cast<std::size_t>(level)];
        const int n = side >> level;
        const double x = u * cells_per_metre, y = v * cells_per_metre;
        const int left = pattern::whole(x), low = pattern::whole(y);
        const float right_share = static_cast<float>(x - left), high_share = static_cast<float>(y - low);
        const int i = left & (n - 1), next_i = (left + 1) & (n - 1);
        const float *row = cells.data() + (low & (n - 1)) * n;
        const float *next = cells.data() + ((low + 1) & (n - 1)) * n;
        const float below = row[i] + right_share * (row[next_i] - row[i]);
        const float above = next[i] + right_share * (next[next_i] - next[i]);
        return 1.0 + 0.36 * static_cast<double>(below + high_share * (above - below));
    }

    // 25 cm by 8 cm, every second row by half a brick aside; joints of 1 cm are lighter.
    double bricks(double u, double v, double grain) const {
        const double rows = v * (1.0 / 0.08), along_rows = u * (1.0 / 0.25);
        const double shift = 0.5 * (pattern::whole(rows) & 1);
        const double along = 0.25 * (0.5 - std::abs(pattern::within(along_rows + shift)));
        const double across = 0.08 * (0.5 - std::abs(pattern::within(rows)));
        const double inside = 0.005 - std::min(along, across); // of a joint
        if (inside <= -0.5 * grain) return 0.8 * plaster(u, v, grain);
        return plaster(u, v, grain) * (0.8 + 0.5 * pattern::beyond(inside, grain));
    }

    static constexpr double cell = 0.01; // m

    // Noise in cells of a centimetre, and its means over 2, 4, … cells.
    static constexpr int side = 256, levels = 6;
    std::array<std::vector<float>, levels> noise_;
};

} // namespace frob::sim
