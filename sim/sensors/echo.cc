#include "echo.h"

#include "ray_fan.h"

namespace frob::sim {

std::optional<double> nearest_in_cone(const Body &body, const Pose &transducer, double half_angle,
                                      double reach, int rays) {
    if (rays == 1) return body.ray(transducer.position, transducer.heading, reach);
    const RayFan fan(body, transducer.position, transducer.heading, half_angle, reach);
    std::optional<double> nearest;
    for (int i = 0; i < rays; ++i) {
        const double off = half_angle * (2.0 * i / (rays - 1) - 1.0);
        const std::optional<double> hit =
            fan.ray(transducer.heading + off, nearest.value_or(reach));
        if (hit) nearest = hit;
    }
    return nearest;
}

} // namespace frob::sim
