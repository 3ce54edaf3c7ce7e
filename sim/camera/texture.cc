#include "texture.h"

#include <algorithm>
#include <cmath>

#include "noise.h"
#include "wide.h"

namespace frob::sim {
namespace {

// Noise in cells of one centimetre, and its means over cells of 2, 4, … cm. Each word packs the
// bytes of a cell and of its neighbours to the right, above, and both, so that interpolating
// between four cells needs only one memory access.
class Grains {
  public:
    static constexpr int levels = 6;
    static constexpr float cell = 0.01f; // m

    struct Level {
        int side;
        float scale; // noise per unit of a byte
        std::vector<std::uint32_t> cells;
    };

    static const Grains &all() {
        static const Grains grains;
        return grains;
    }

    const Level &level(int number) const { return levels_[static_cast<std::size_t>(number)]; }

  private:
    Grains() {
        constexpr std::uint64_t seed = 20, stream = 1;
        Noise noise(seed, stream);
        int n = 256;
        std::vector<double> means(static_cast<std::size_t>(n * n));
        for (double &mean : means) mean = noise.uniform() - 0.5;
        // A mean over n x n cells has a standard deviation of 0.29 / n; a byte covers four standard
        // deviations in both directions.
        double step = 1.0 / 250.0;
        for (Level &level : levels_) {
            level.side = n;
            level.scale = static_cast<float>(step);
            const auto byte = [&](int x, int y) {
                const double mean =
                    means[static_cast<std::size_t>((y & (n - 1)) * n + (x & (n - 1)))];
                const double whole = std::clamp(mean / step, -127.0, 127.0) + 128.5;
                return (static_cast<std::uint32_t>(whole) - 128u) & 255u;
            };
            for (int y = 0; y < n; ++y)
                for (int x = 0; x < n; ++x)
                    level.cells.push_back(byte(x, y) | byte(x + 1, y) << 8 | byte(x, y + 1) << 16 |
                                          byte(x + 1, y + 1) << 24);
            std::vector<double> coarser;
            for (int y = 0; y < n; y += 2)
                for (int x = 0; x < n; x += 2) {
                    const auto at = [&](int i, int j) {
                        return means[static_cast<std::size_t>((y + j) * n + x + i)];
                    };
                    coarser.push_back(0.25 * (at(0, 0) + at(1, 0) + at(0, 1) + at(1, 1)));
                }
            means = std::move(coarser);
            n /= 2;
            step = 1.0 / 110.0 / (256 / n);
        }
    }

    std::array<Level, levels> levels_;
};

// Rounds down.
inline int whole(float x) {
    const int n = static_cast<int>(x);
    return n - (x < static_cast<float>(n) ? 1 : 0);
}

// The fraction of the pixel around x that is beyond an edge at 0.
inline float beyond(float x, float per_metre) {
    const float share = x * per_metre + 0.5f, positive = share > 0.0f ? share : 0.0f;
    return positive < 1.0f ? positive : 1.0f;
}

// Distance to the nearest end of the unit interval that x is in: 0 to 0.5.
inline float inside(float x) { return 0.5f - std::abs(x - static_cast<float>(whole(x)) - 0.5f); }

// Light and dark stripes of 10 cm each, from -1 to 1. Their edges are one pixel wide.
inline float wave(float x, float per_metre) {
    constexpr float width = 0.1f;
    const float within = 2.0f * width * inside(x * (0.5f / width)) - width / 2;
    const float light = 2.0f * beyond(within, per_metre) - 1.0f;
    return (2.0f * width * per_metre > 1.0f ? 1.0f : 0.0f) * light;
}

FROB_WIDE void make_stripes(const float *v, const float *per_metre, float *__restrict to,
                            int count) {
    for (int i = 0; i < count; ++i) to[i] = 1.0f + 0.35f * wave(v[i], per_metre[i]);
}

FROB_WIDE void make_checks(const float *u, const float *v, const float *per_metre,
                           float *__restrict to, int count) {
    for (int i = 0; i < count; ++i)
        to[i] = 1.0f + 0.35f * (wave(u[i], per_metre[i]) * wave(v[i], per_metre[i]));
}

// Bricks of 25 cm by 8 cm, with every second row shifted by half a brick. The 1 cm joints are
// lighter.
FROB_WIDE void lay_bricks(const float *u, const float *v, const float *per_metre,
                          float *__restrict to, int count) {
    for (int i = 0; i < count; ++i) {
        const float rows = v[i] * (1.0f / 0.08f);
        const float shift = 0.5f * static_cast<float>(whole(rows) & 1);
        const float along = 0.25f * inside(u[i] * 4.0f + shift), across = 0.08f * inside(rows);
        const float joint = 0.005f - (along < across ? along : across);
        to[i] *= 0.8f + 0.5f * beyond(joint, per_metre[i]);
    }
}

FROB_WIDE void find_cells(const float *u, const float *v, float per_metre, int side,
                          std::int32_t *__restrict cells, float *__restrict right,
                          float *__restrict high, int count) {
    for (int i = 0; i < count; ++i) {
        const float x = u[i] * per_metre, y = v[i] * per_metre;
        const int left = whole(x), low = whole(y);
        right[i] = x - static_cast<float>(left);
        high[i] = y - static_cast<float>(low);
        cells[i] = (low & (side - 1)) * side + (left & (side - 1));
    }
}

FROB_WIDE void mix_cells(const std::int32_t *cells, const float *right, const float *high,
                         float scale, float *__restrict to, int count) {
    for (int i = 0; i < count; ++i) {
        const auto word = static_cast<std::uint32_t>(cells[i]);
        const auto byte = [&](int up) { // the byte that is `up` bits below the top one
            return static_cast<float>(static_cast<std::int32_t>(word << up) >> 24);
        };
        const float below = byte(24) + right[i] * (byte(16) - byte(24));
        const float above = byte(8) + right[i] * (byte(0) - byte(8));
        to[i] = 1.0f + scale * (below + high[i] * (above - below));
    }
}

} // namespace

Patterns::Patterns(int longest)
    : cells_(static_cast<std::size_t>(longest)), right_(cells_.size()), high_(cells_.size()) {}

// Splits the run where the number of pixels per metre crosses a level's limit. Each part uses the
// first level whose cells are no smaller than a pixel, or the last level.
void Patterns::plaster(const Run &run, float *to) {
    for (int from = 0, end; from < run.count; from = end) {
        int number = 0;
        float least = 1.0f / Grains::cell, below = 1e30f; // pixels per metre
        for (; number + 1 < Grains::levels && run.per_metre[from] < least; ++number)
            below = least, least *= 0.5f;
        if (number + 1 == Grains::levels) least = 0.0f;
        const auto is_over = [&](float pixels) { return !(pixels >= least && pixels < below); };
        end = run.count;
        if (is_over(run.per_metre[end - 1]))
            end = static_cast<int>(
                std::find_if(run.per_metre + from + 1, run.per_metre + end, is_over) -
                run.per_metre);
        const Grains::Level &level = Grains::all().level(number);
        const int count = end - from;
        find_cells(run.u + from, run.v + from,
                   1.0f / (Grains::cell * static_cast<float>(1 << number)), level.side,
                   cells_.data(), right_.data(), high_.data(), count);
        const std::uint32_t *all = level.cells.data();
        for (std::int32_t *cell = cells_.data(), *last = cell + count; cell < last; ++cell)
            *cell = static_cast<std::int32_t>(all[*cell]);
        mix_cells(cells_.data(), right_.data(), high_.data(), 0.36f * level.scale, to + from,
                  count);
    }
}

void Patterns::brightness(Texture texture, const Run &run, float *to) {
    switch (texture) {
    case Texture::plain: std::fill(to, to + run.count, 1.0f); break;
    case Texture::plaster: plaster(run, to); break;
    case Texture::bricks:
        plaster(run, to);
        lay_bricks(run.u, run.v, run.per_metre, to, run.count);
        break;
    case Texture::stripes: make_stripes(run.v, run.per_metre, to, run.count); break;
    case Texture::checks: make_checks(run.u, run.v, run.per_metre, to, run.count); break;
    }
}

} // namespace frob::sim
