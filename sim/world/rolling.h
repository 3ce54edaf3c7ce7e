// A ball's motion along its path at constant speed. At the end of the path, it rolls back or, if
// the path is closed, starts again.
#pragma once

#include "scene.h"

namespace frob::sim {

class Rolling {
  public:
    explicit Rolling(const Ball &ball);

    void advance(double dt_s);
    Vec place() const;

  private:
    std::vector<Vec> corners_; // the whole round trip; the last corner is joined to the first
    double speed_;
    std::size_t behind_ = 0; // the last corner that the ball has passed
    double gone_ = 0.0;      // m, the distance travelled since then
};

} // namespace frob::sim
