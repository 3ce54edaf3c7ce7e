// A robot's body, its wheels, and the places of its sensors. The physics, the measurements and the
// picture need this data. The origin of the robot's frame is midway between the driving wheels,
// with x forward and y left.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "drivers/steps.h"

#include "geometry.h"

namespace frob::sim {

// The firmware's limits on commands, unless the world file sets them.
struct DriveLimits {
    double speed;             // m/s
    double turn;              // rad/s
    double acceleration;      // m/s^2, when speeding up and braking
    double turn_acceleration; // rad/s^2
};

// Transducers that measure distances, such as sonars.
struct RangeFinders {
    std::vector<Pose> seats;        // their positions and directions
    double half_angle;              // half the opening angle of each cone
    std::size_t left, right;        // the transducers that face most directly left and right
    std::vector<std::size_t> front; // the transducers that point ahead
    const char *noun;               // the transducers' name in the picture, such as "sonar"
};

struct Chassis {
    std::string title;        // "Pioneer P3-DX"
    double mass;              // kg
    double inertia;           // kg m^2, about the origin
    Vec center;               // centre of the body
    double radius;            // radius of a round body; 0 if the body has an outline
    std::vector<Vec> outline; // convex, counter-clockwise, at most 8 corners
    double wheel_radius;      // m
    double wheel_separation;  // m
    double wheel_force;       // N, the maximum force of a wheel on the floor
    double count;             // m of travel per encoder count; 0 if the encoder is continuous
    double battery;           // V, the initial voltage, unless the world file sets it
    DriveLimits limits;
    frob_wire wire;  // range and resolution of commands; a step of 0 means no rounding
    Vec left, right; // points from which the distances to the left and right are measured
    RangeFinders range_finders;
    double height = 0.24;        // m, height of the body, for cameras
    Vec camera = {0.12, 0.0};    // position of a camera, unless the world file sets it
    double camera_height = 0.27; // m, height of a camera, unless the world file sets it
};

// The outline of a body in the robot's frame. It is a polygon even for a round body.
std::vector<Vec> outline_of(const Chassis &chassis);

} // namespace frob::sim
