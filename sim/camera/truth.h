// What a frame really shows: of each pixel how far it is to what it sees, and what that is.
#pragma once

#include <cstddef>
#include <vector>

namespace frob::sim
{

// Something that a camera sees: which one, from 0, of those of its kind in the world's file.
// Posters and tags are numbered together, posters first. Robots are in the order of their starts.
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

constexpr bool operator==(Thing a, Thing b)
{
    return a.kind == b.kind && a.number == b.number;
}
constexpr bool operator!=(Thing a, Thing b)
{
    return !(a == b);
}

class Truth
{
  public:
    Truth(int width, int height)
        : width_(static_cast<std::size_t>(width)), seen_(width_ * static_cast<std::size_t>(height))
    {
    }

    // Along the axis of the camera, in metres; infinity where there is only the sky.
    double depth_at(int x, int y) const { return seen_[index(x, y)].depth; }

    // Whose surface it is.
    Thing thing_at(int x, int y) const { return seen_[index(x, y)].thing; }

    void set(int x, int y, double depth, Thing thing) { seen_[index(x, y)] = { depth, thing }; }

  private:
    struct Seen {
        double depth;
        Thing thing;
    };

    std::size_t index(int x, int y) const
    {
        return static_cast<std::size_t>(y) * width_ + static_cast<std::size_t>(x);
    }

    std::size_t width_;
    std::vector<Seen> seen_;
};

} // namespace frob::sim
