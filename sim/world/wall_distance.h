// How well the robot keeps its distance from the wall, by geometry.
#pragma once

#include <cstdint>
#include <vector>

#include "chassis.h"
#include "scene.h"

namespace frob::sim
{

// Distance from a point to the nearest wall, polygon or circle: 0 inside one,
// infinite where there is none. Boxes, which can be pushed away, do not count.
double clearance(const Scene &scene, Vec point);

// The errors of a run.
class WallDistance
{
  public:
    // Scene and robot's description must outlive it.
    WallDistance(const Scene &scene, const Chassis &chassis, const MeasureSettings &settings)
        : scene_(scene), chassis_(chassis), settings_(settings)
    {
    }

    // Takes the robot's pose at a controller's instant. Returns the distance
    // from the robot's measured side.
    double observe(std::int64_t time_ns, const Pose &robot);

    // Since the robot settled; NaN if it has not.
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
