#include "echo.h"

namespace frob::sim {

std::optional<double> nearest_in_cone(const World &world, const Pose &transducer,
                                      double half_angle, double reach, int rays) {
    std::optional<double> nearest;
    for (int i = 0; i < rays; ++i) {
        const double off = rays == 1 ? 0.0 : half_angle * (2.0 * i / (rays - 1) - 1.0);
        const std::optional<double> hit =
            world.ray(transducer.position, transducer.heading + off, nearest.value_or(reach));
        if (hit) nearest = hit;
    }
    return nearest;
}

} // namespace frob::sim
