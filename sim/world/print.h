// A printed picture: from a PGM or PPM file, or an AprilTag.
#pragma once

#include <array>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

#include "look.h"

namespace frob::sim
{

class Print
{
  public:
    Print() = default;
    // Of rows from the top, three bytes a pixel.
    Print(int width, int height, const std::vector<std::uint8_t> &pixels);

    // Throws std::runtime_error, with what is wrong with the file.
    static Print of_file(const std::string &path);

    // Tag `id` of the family 36h11, with its white margin: ten cells, of which the black frame
    // is eight. There are `tags` of them here.
    static Print tag(int id);
    static constexpr int tags = 30;

    // The colours, under a light, of so many places: x and y from 0 at the left and the top to 1 at
    // the right and the bottom. `per_width` is how many pixels see its width there. Three numbers
    // of each, all computed in single precision.
    void colours(int count, const float *x, const float *y, const float *per_width, float light,
                 float *to) const;

  private:
    // The picture, and smaller ones, each pixel the mean of four.
    struct Level {
        int width, height;
        std::vector<std::array<float, 3>> pixels;
    };

    std::vector<Level> levels_;
};

} // namespace frob::sim
