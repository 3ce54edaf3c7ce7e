#include "texture.h"

#include <cmath>
#include <cstddef>

#include "noise.h"

namespace frob::sim {
namespace {

constexpr double cell = 0.01; // m
constexpr std::uint64_t seed = 20, stream = 1;

// The next whole number below; std::floor is a call on processors without an instruction for it.
int whole(double x) {
    const int n = static_cast<int>(x);
    return n - (x < n ? 1 : 0);
}

// The share of an interval of this length around x that is beyond an edge at 0.
double beyond(double x, double grain) {
    const double share = x / grain + 0.5;
    return share < 0.0 ? 0.0 : share > 1.0 ? 1.0 : share;
}

// Where x is in a row of things of size 1, -0.5 to 0.5 from the middle of one.
double within(double x) { return x - whole(x) - 0.5; }

// A wave of light and dark stripes, -1 to 1, each so wide; its edges are as wide as a pixel.
double wave(double x, double width, double grain) {
    if (grain >= 2.0 * width) return 0.0;
    const double phase = 2.0 * width * within(x / (2.0 * width)); // -width … width
    const double inside = width / 2 - std::abs(phase);
    return 2.0 * beyond(inside, grain) - 1.0;
}

} // namespace

const Patterns &Patterns::all() {
    static const Patterns patterns;
    return patterns;
}

Patterns::Patterns() {
    Noise noise(seed, stream);
    for (int level = 0, n = side; level < levels; ++level, n /= 2) {
        std::vector<float> &cells = noise_[static_cast<std::size_t>(level)];
        cells.resize(static_cast<std::size_t>(n) * static_cast<std::size_t>(n));
        for (int y = 0; y < n; ++y) {
            for (int x = 0; x < n; ++x) {
                const auto finer = [&](int i, int j) {
                    const auto &below = noise_[static_cast<std::size_t>(level - 1)];
                    return below[static_cast<std::size_t>((2 * y + j) * 2 * n + 2 * x + i)];
                };
                const float mean = level == 0 ? static_cast<float>(noise.uniform() - 0.5)
                                              : 0.25f * (finer(0, 0) + finer(1, 0) + finer(0, 1) +
                                                         finer(1, 1));
                cells[static_cast<std::size_t>(y * n + x)] = mean;
            }
        }
    }
}

// Between the middles of four cells.
double Patterns::plaster(double u, double v, double grain) const {
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
    const int left = whole(x), low = whole(y);
    const float right_share = static_cast<float>(x - left), high_share = static_cast<float>(y - low);
    const int i = left & (n - 1), next_i = (left + 1) & (n - 1);
    const float *row = cells.data() + (low & (n - 1)) * n;
    const float *next = cells.data() + ((low + 1) & (n - 1)) * n;
    const float below = row[i] + right_share * (row[next_i] - row[i]);
    const float above = next[i] + right_share * (next[next_i] - next[i]);
    return 1.0 + 0.36 * static_cast<double>(below + high_share * (above - below));
}

double Patterns::patterned(Texture texture, double u, double v, double grain) const {
    switch (texture) {
    case Texture::plain: return 1.0;
    case Texture::plaster: return plaster(u, v, grain);
    case Texture::bricks: {
        // 25 cm by 8 cm, every second row by half a brick aside; joints of 1 cm are lighter.
        const double rows = v * (1.0 / 0.08), along_rows = u * (1.0 / 0.25);
        const double shift = 0.5 * (whole(rows) & 1);
        const double along = 0.25 * (0.5 - std::abs(within(along_rows + shift)));
        const double across = 0.08 * (0.5 - std::abs(within(rows)));
        const double inside = 0.005 - std::min(along, across); // of a joint
        if (inside <= -0.5 * grain) return 0.8 * plaster(u, v, grain);
        return plaster(u, v, grain) * (0.8 + 0.5 * beyond(inside, grain));
    }
    case Texture::stripes: return 1.0 + 0.35 * wave(v, 0.1, grain);
    case Texture::checks: return 1.0 + 0.35 * wave(u, 0.1, grain) * wave(v, 0.1, grain);
    }
    return 1.0;
}

} // namespace frob::sim
