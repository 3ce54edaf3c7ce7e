// Ground truth of a frame: for each pixel, the depth and the thing that it shows.
#pragma once

#include <cstddef>
#include <vector>

namespace frob::sim {

// A thing that a camera sees: its kind, and its index (from 0) among the things of this kind in the
// world file. Posters and tags are numbered together, posters first. Robots are in the order of
// their starts.
struct Thing {
    enum class Kind {
        sky,
        floor,
        wall,
        polygon,
        circle,
        box,
        ball,
        cone,
        poster,
        robot,
        hole,
        tape,
        patch
    };

    Kind kind = Kind::sky;
    std::size_t number = 0;
};

constexpr bool operator==(Thing a, Thing b) { return a.kind == b.kind && a.number == b.number; }
constexpr bool operator!=(Thing a, Thing b) { return !(a == b); }

class Truth {
  public:
    Truth(int width, int height)
        : width_(static_cast<std::size_t>(width)),
          seen_(width_ * static_cast<std::size_t>(height)) {}

    // Depth along the camera's axis, in metres; infinity for the sky.
    double depth_at(int x, int y) const { return seen_[index(x, y)].depth; }

    // The thing at this pixel.
    Thing thing_at(int x, int y) const { return seen_[index(x, y)].thing; }

    void set(int x, int y, double depth, Thing thing) { seen_[index(x, y)] = {depth, thing}; }

  private:
    struct Seen {
        double depth;
        Thing thing;
    };

    std::size_t index(int x, int y) const {
        return static_cast<std::size_t>(y) * width_ + static_cast<std::size_t>(x);
    }

    std::size_t width_;
    std::vector<Seen> seen_;
};

} // namespace frob::sim
