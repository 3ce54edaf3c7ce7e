// A ball's way over the floor, at an even speed: from point to point, and at the end back, or
// round and round.
#pragma once

#include "scene.h"

namespace frob::sim
{

class Rolling
{
  public:
    explicit Rolling(const Ball &ball);

    void advance(double dt_s);
    Vec place() const;

  private:
    std::vector<Vec> corners_; // there and back; the last is joined to the first
    double speed_;
    std::size_t behind_ = 0; // the corner that was passed last
    double gone_ = 0.0;      // m since then
};

} // namespace frob::sim
