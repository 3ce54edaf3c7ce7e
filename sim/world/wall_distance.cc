#include "wall_distance.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace frob::sim {
double clearance(const Scene &scene, Vec point) {
    double nearest = std::numeric_limits<double>::infinity();
    for (const Wall &wall : scene.walls)
        nearest = std::min(nearest, distance_to_polyline(wall.points, wall.closed, point) -
                                        wall.thickness / 2);
    for (const Polygon &polygon : scene.polygons)
        nearest = std::min(nearest, is_inside(polygon.points, point)
                                        ? 0.0
                                        : distance_to_polyline(polygon.points, true, point));
    for (const Circle &circle : scene.circles)
        nearest = std::min(nearest, length(point - circle.center) - circle.radius);
    for (const Cone &cone : scene.cones)
        nearest = std::min(nearest, length(point - cone.center) - cone.radius);
    return std::max(nearest, 0.0);
}

double WallDistance::observe(std::int64_t time_ns, const Pose &robot) {
    const bool left = settings_.side == MeasureSettings::Side::left;
    const double distance =
        clearance(scene_, from_frame(robot, left ? chassis_.left : chassis_.right));
    if (static_cast<double>(time_ns) >= settings_.settle * 1e9) {
        const double error = std::abs(distance - settings_.distance);
        sum_ += error;
        largest_ = std::max(largest_, error);
        ++count_;
    }
    return distance;
}

double WallDistance::mean_error() const {
    return count_ == 0 ? std::numeric_limits<double>::quiet_NaN()
                       : sum_ / static_cast<double>(count_);
}

double WallDistance::largest_error() const {
    return count_ == 0 ? std::numeric_limits<double>::quiet_NaN() : largest_;
}

} // namespace frob::sim
