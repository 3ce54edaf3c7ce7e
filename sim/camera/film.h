// From the light that falls on a camera to the numbers of its pixels: blur, exposure and noise.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "scene.h"

namespace frob::sim
{

class Film
{
  public:
    Film(const CameraSettings &settings, std::uint64_t seed);

    // A new picture.
    void start(std::uint32_t number);

    // Its next row, from the top: red, green and blue of each pixel, 1 for white.
    void expose(const float *light);

    // When the last row has been exposed: three bytes a pixel, or one in grey. Good until the next
    // picture.
    const std::uint8_t *pixels() const { return pixels_.data(); }

  private:
    void develop(int y);

    const int height_, radius_;     // of the square over which light is spread, without its middle
    const std::size_t row_, parts_; // numbers of a row of light, and of one of pixels
    const float noise_;
    const std::uint64_t seed_;
    std::uint32_t number_ = 0;
    int exposed_ = 0;

    std::vector<float> gains_;  // of each of a row's parts, by how many pixels share its light
    std::vector<float> padded_; // a row of light, with darkness at both ends
    std::vector<float> dark_;
    std::vector<float> spread_; // the last rows, each spread along itself, one behind the other
    std::vector<float> sums_;   // of these
    std::vector<float> grey_;   // of these, one a pixel
    std::vector<std::uint8_t> pixels_;
};

} // namespace frob::sim
