// Casts many rays from one point into one sector. It queries the world once for the objects in the
// sector, and skips most of them for each ray without calling Box2D.
#pragma once

#include <optional>
#include <vector>

#include "body.h"

namespace frob::sim {

class RayFan {
  public:
    // Prepares the rays of a body's sensor that start at `origin`, deviate from `heading` by at
    // most `half_angle` (less than a right angle), and are at most `reach` long. Valid until the
    // world's next step.
    RayFan(const Body &body, Vec origin, double heading, double half_angle, double reach);

    // Returns the same result as Body::ray, to the last bit.
    std::optional<double> ray(double angle, double reach) const;

  private:
    // A fixture, and a disc that contains it.
    struct Obstacle {
        const b2Fixture *fixture;
        Vec center; // relative to the origin
        double radius;
    };

    class Gather;

    Vec origin_;
    std::vector<Obstacle> obstacles_;
};

} // namespace frob::sim
