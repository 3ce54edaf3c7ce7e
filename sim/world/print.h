// A printed picture, read from a PGM or PPM file, or an AprilTag.
#pragma once

#include <array>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

#include "look.h"

namespace frob::sim {

class Print {
  public:
    Print() = default;
    // Rows start at the top, with three bytes per pixel.
    Print(int width, int height, const std::vector<std::uint8_t> &pixels);

    // Reads a picture. Throws std::runtime_error with a message that describes the problem.
    static Print of_file(const std::string &path);

    // Tag `id` of the family 36h11. With its white margin, it is ten cells wide; its black frame is
    // eight cells wide. The simulator contains the first `tags` of the family.
    static Print tag(int id);
    static constexpr int tags = 30;

    // Computes the colours at `count` places, multiplied by `light`. x runs from 0 at the left to 1
    // at the right, and y from 0 at the top to 1 at the bottom. `per_width` is the number of camera
    // pixels that the picture's width would cover at the scale of each place. Writes three numbers
    // for each place, computed in single precision.
    void colours(int count, const float *x, const float *y, const float *per_width, float light,
                 float *to) const;

  private:
    // A mipmap level: the picture at full size, or a smaller version in which each pixel is the
    // mean of four.
    struct Level {
        int width, height;
        std::vector<std::array<float, 3>> pixels;
    };

    std::vector<Level> levels_;
};

} // namespace frob::sim
