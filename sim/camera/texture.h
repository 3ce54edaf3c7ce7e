// Patterns on surfaces.
#pragma once

#include <array>
#include <vector>

#include "look.h"

namespace frob::sim {

// How bright a surface is at a place on it, about 1: u along it and v across, in metres.
// `grain` is how much of it a pixel sees: what is finer is seen as its mean.
class Patterns {
  public:
    static const Patterns &all();

    double brightness(Texture texture, double u, double v, double grain) const {
        return texture == Texture::plain ? 1.0 : patterned(texture, u, v, grain);
    }

  private:
    Patterns();
    double patterned(Texture texture, double u, double v, double grain) const;
    double plaster(double u, double v, double grain) const;

    // Noise in cells of a centimetre, and its means over 2, 4, … cells.
    static constexpr int side = 256, levels = 6;
    std::array<std::vector<float>, levels> noise_;
};

} // namespace frob::sim
