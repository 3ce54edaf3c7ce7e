// A ball's motion along its path at constant speed. At the end it rolls back, or starts over if the
// path is closed.
#pragma once

#include "scene.h"

namespace frob::sim {

class Rolling {
  public:
    explicit Rolling(const Ball &ball);

    void advance(double dt_s);
    Vec place() const;

  private:
    std::vector<Vec> corners_; // the path there and back; the last corner is joined to the first
    double speed_;
    std::size_t behind_ = 0; // the last corner it passed
    double gone_ = 0.0;      // m travelled since then
};

} // namespace frob::sim
