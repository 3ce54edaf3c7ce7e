#include "photocells.h"

#include <algorithm>
#include <cmath>

namespace frob::sim {
namespace {

constexpr double right_above = 0.01; // m; below this horizontal distance, no object fits between
                                     // cell and lamp

} // namespace

// E = I cos(a) / d^2, where d is the distance to the lamp and a is the angle between the cell's
// direction u and the direction to the lamp. The lamp hangs h above the cell. If r is the
// horizontal vector to the lamp, d^2 = r^2 + h^2 and cos(a) = (u . r) / d. Walls, boxes and robots
// in between block the light completely, as if they were as high as the lamp.
double Photocells::from_lamp(const Lamp &lamp, const Pose &cell, const Body &body) const {
    const Vec way = lamp.position - cell.position;
    const double facing = dot(direction(cell.heading), way);
    if (facing <= 0.0) return 0.0;
    const double flat = length(way);
    // Box2D rejects rays of length zero.
    if (flat > right_above && body.ray(cell.position, std::atan2(way.y, way.x), flat)) return 0.0;
    const double squared = dot(way, way) + lamp.height * lamp.height;
    return lamp.intensity * facing / (squared * std::sqrt(squared));
}

// The noise is relative: seen = E * (1 + noise * n), n normal.
void Photocells::advance(std::int64_t time_ns, const Body &body) {
    if (time_ns % refresh_ns_ != 0) return;
    const Pose pose = body.pose();
    for (std::size_t i = 0; i < seats_.size(); ++i) {
        const Pose cell = from_frame(pose, seats_[i]);
        const double gain = 1.0 + ambient_.noise * noise_.normal();
        double light = ambient_.light;
        for (const Lamp &lamp : lamps_) light += from_lamp(lamp, cell, body);
        seen_[i] = std::max(0.0, gain * light);
    }
}

} // namespace frob::sim
