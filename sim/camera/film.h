// Converts the light that falls on a camera to pixel values: blur, exposure and noise.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "scene.h"

namespace frob::sim {

class Film {
  public:
    Film(const CameraSettings &settings, std::uint64_t seed);

    // Begins a new picture.
    void start(std::uint32_t number);

    // Adds the next row of the picture, from the top: red, green and blue of each pixel, where 1 is
    // white.
    void expose(const float *light);

    // The pixels, after the last row has been exposed: three bytes per pixel, or one if the
    // picture is grey. Valid until the next picture.
    const std::uint8_t *pixels() const { return pixels_.data(); }

  private:
    void develop(int y);

    const int height_, radius_;     // number of pixels by which blur spreads the light in each
                                    // direction
    const std::size_t row_, parts_; // number of values in a row of light, and in a row of pixels
    const float noise_;
    const std::uint64_t seed_;
    std::uint32_t number_ = 0;
    int exposed_ = 0;

    std::vector<float> gains_;  // gain of each value in a row, which depends on the number of
                                // pixels averaged for it
    std::vector<float> padded_; // a row of light, padded with darkness at both ends
    std::vector<float> dark_;
    std::vector<float> spread_; // ring buffer of the last rows, each blurred along the row
    std::vector<float> sums_;   // sums over these rows
    std::vector<float> grey_;   // the sums converted to grey, one per pixel
    std::vector<std::uint8_t> pixels_;
};

} // namespace frob::sim
