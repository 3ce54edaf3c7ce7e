// Many rays from one place into one sector: what they can meet is looked up in
// the world once, and most of it is passed over without asking Box2D.
#pragma once

#include <optional>
#include <vector>

#include "body.h"

namespace frob::sim
{

class RayFan
{
  public:
    // For rays of a body's sensor, from `origin`, at most `half_angle` (less
    // than a right angle) off `heading`, and not longer than `reach`. Good until
    // the world's next step.
    RayFan(const Body &body, Vec origin, double heading, double half_angle, double reach);

    // As Body::ray, to the last bit.
    std::optional<double> ray(double angle, double reach) const;

  private:
    // A fixture, and a disc that contains it.
    struct Obstacle {
        const b2Fixture *fixture;
        Vec center; // from the origin
        double radius;
    };

    class Gather;

    Vec origin_;
    std::vector<Obstacle> obstacles_;
};

} // namespace frob::sim
