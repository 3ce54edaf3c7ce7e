#include "summary.h"

#include <cmath>
#include <cstdio>

namespace frob::serve {

void print_summary(const frob_sim *sim) {
    const frob_sim_summary s = frob_sim_summarize(sim);
    const frob_sim_place place = frob_sim_place_robot(sim, 0);
    std::printf("time simulated: %.3f s\n", s.time_s);
    std::printf("distance driven: %.3f m\n", s.distance_m);
    std::printf("position: %.3f m, %.3f m, heading %.1f degrees\n", place.x_m, place.y_m,
                place.heading_rad * 180.0 / 3.14159265358979323846);
    if (s.measured) {
        std::printf("wall distance to keep: %.3f m\n", s.wall_distance_m);
        if (std::isnan(s.mean_error_m)) {
            std::printf("wall distance error: not measured, because the run ended before "
                        "the robot had settled\n");
        } else {
            std::printf("mean wall distance error: %.4f m\n", s.mean_error_m);
            std::printf("largest wall distance error: %.4f m\n", s.largest_error_m);
        }
    }
    if (s.tape_measured) {
        if (std::isnan(s.mean_tape_m)) {
            std::printf("distance from the tape: not measured, because the run ended before "
                        "the robot had settled\n");
        } else {
            std::printf("mean distance from the tape: %.4f m\n", s.mean_tape_m);
            std::printf("largest distance from the tape: %.4f m\n", s.largest_tape_m);
            std::printf("distance along the tape: %.3f m\n", s.tape_way_m);
        }
    }
    if (s.ball_measured && !std::isnan(s.mean_ball_m)) {
        std::printf("mean ball distance error: %.4f m\n", s.mean_ball_m);
        std::printf("largest ball distance error: %.4f m\n", s.largest_ball_m);
    }
    std::printf("odometry error at the end: %.3f m\n", s.odometry_error_m);
    std::printf("collisions: %d\n", s.collisions);
    frob_sim_collision collision;
    for (std::size_t i = 0; frob_sim_collision_robot(sim, 0, i, &collision); ++i) {
        char text[400];
        frob_sim_describe_collision(&collision, text, sizeof text);
        std::printf("%s\n", text);
    }
}

} // namespace frob::serve
