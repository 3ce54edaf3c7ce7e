#include "texture.h"

#include <cmath>
#include <cstddef>

#include "noise.h"

namespace frob::sim {
namespace {

constexpr std::uint64_t seed = 20, stream = 1;

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

} // namespace frob::sim
