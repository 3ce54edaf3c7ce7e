// Patterns on surfaces.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "look.h"

namespace frob::sim
{

// Where the pixels of a run along a row are on a surface: u along it and v across, in metres, and
// how many pixels see a metre of it.
struct Run {
    int count;
    const float *u, *v, *per_metre;
};

// How bright a surface is at a place on it, about 1. What is finer than a pixel sees is seen as
// its mean. All is IEEE arithmetic in single precision, in the same order on every machine.
class Patterns
{
  public:
    // Of runs of so many pixels at most.
    explicit Patterns(int longest);

    // Of each pixel of a run.
    void brightness(Texture texture, const Run &run, float *to);

  private:
    void plaster(const Run &run, float *to);

    std::vector<std::int32_t> cells_; // of a run: which cell,
    std::vector<float> right_, high_; // how far from its middle to the next one's
};

} // namespace frob::sim
