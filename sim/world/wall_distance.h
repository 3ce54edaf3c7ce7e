// Measures how well the robot keeps its distance from the wall, based on its true position.
#pragma once

#include <cstdint>
#include <vector>

#include "chassis.h"
#include "scene.h"

namespace frob::sim {

// Distance from a point to the nearest wall, polygon, circle or cone. It is 0 inside an object, and
// infinite if there are no objects. Boxes do not count, because they can be pushed away.
double clearance(const Scene &scene, Vec point);

// Accumulates the distance errors of a run.
class WallDistance {
  public:
    // The scene and the chassis must outlive this object.
    WallDistance(const Scene &scene, const Chassis &chassis, const MeasureSettings &settings)
        : scene_(scene), chassis_(chassis), settings_(settings) {}

    // Records the robot's pose at a step of the controller. Returns the distance from the
    // measured side of the robot to the nearest wall or other solid.
    double observe(std::int64_t time_ns, const Pose &robot);

    // Errors since the robot settled; NaN if it has not settled.
    double mean_error() const;
    double largest_error() const;

  private:
    const Scene &scene_;
    const Chassis &chassis_;
    MeasureSettings settings_;
    double sum_ = 0.0, largest_ = 0.0;
    std::int64_t count_ = 0;
};

} // namespace frob::sim
