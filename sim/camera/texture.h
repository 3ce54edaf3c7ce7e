// Patterns on surfaces.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "look.h"

namespace frob::sim {

// A run of pixels along a row, projected onto a surface: the coordinates u along the surface and v
// across it, in metres, and the number of pixels per metre of the surface.
struct Run {
    int count;
    const float *u, *v, *per_metre;
};

// Computes the brightness of a textured surface relative to its tint, as a factor around 1.
// Averages details finer than a pixel. All computations use single-precision IEEE arithmetic, in
// the same order on every machine.
class Patterns {
  public:
    // `longest`: maximum number of pixels in a run.
    explicit Patterns(int longest);

    // Computes the brightness of each pixel of a run.
    void brightness(Texture texture, const Run &run, float *to);

  private:
    void plaster(const Run &run, float *to);

    std::vector<std::int32_t> cells_; // the cell of each pixel of a run
    std::vector<float> right_, high_; // distance of each pixel from the centre of its cell towards
                                      // the next cell
};

} // namespace frob::sim
