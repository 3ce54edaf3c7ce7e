// Dimensions of the Pioneer P3-DX. The origin of the robot's frame is midway between the driving
// wheels, with x forward and y left.
#pragma once

#include <array>

#include "chassis.h"
#include "sonar_ring.h"

namespace frob::sim::p3dx {

constexpr double mass = 9.0;                   // kg
constexpr double body_length = 0.511;          // m, bumpers included
constexpr double body_width = 0.425;           // m
constexpr double body_center = -0.0445;        // m; the body extends farther to the rear than to
                                               // the front
constexpr double corner_cut = 0.115;           // m, cut off each corner of the outline
constexpr double wheel_radius = 0.09;          // m
constexpr double wheel_separation = 2.0 / 5.6; // m, effective distance: 2 / DiffConvFactor
constexpr double wheel_force = 20.0;           // N, the maximum force of a wheel on the floor

// Counter-clockwise, starting at the front right corner.
constexpr std::array<Vec, 8> outline = [] {
    constexpr double front = body_center + body_length / 2, back = body_center - body_length / 2;
    constexpr double side = body_width / 2, c = corner_cut;
    return std::array<Vec, 8>{Vec{front, c - side}, Vec{front, side - c}, Vec{front - c, side},
                              Vec{back + c, side},  Vec{back, side - c},  Vec{back, c - side},
                              Vec{back + c, -side}, Vec{front - c, -side}};
}();

// Positions and directions of the transducers: 0-7 are the front array, from left to right; 8-15
// are the rear array, from right to left.
constexpr std::array<Pose, 16> sonars = {{
    {{0.069, 0.136}, radians(90)},
    {{0.114, 0.119}, radians(50)},
    {{0.148, 0.078}, radians(30)},
    {{0.166, 0.027}, radians(10)},
    {{0.166, -0.027}, radians(-10)},
    {{0.148, -0.078}, radians(-30)},
    {{0.114, -0.119}, radians(-50)},
    {{0.069, -0.136}, radians(-90)},
    {{-0.157, -0.136}, radians(-90)},
    {{-0.203, -0.119}, radians(-130)},
    {{-0.237, -0.078}, radians(-150)},
    {{-0.255, -0.027}, radians(-170)},
    {{-0.255, 0.027}, radians(170)},
    {{-0.237, 0.078}, radians(150)},
    {{-0.203, 0.119}, radians(130)},
    {{-0.157, 0.136}, radians(90)},
}};

// the transducers of the front array that point straight to the left and right
constexpr std::size_t left_sonar = 0, right_sonar = 7;
constexpr std::array<std::size_t, 2> front_sonars = {3, 4};

constexpr double sonar_half_angle = radians(12.0); // half the opening angle of the cone
constexpr double sonar_nearest = 0.1;              // m; the reading for any nearer object
constexpr double sonar_farthest = 5.0;             // m; farther objects return no echo

// The same dimensions in the structs that the rest of the simulator uses.
const Chassis &chassis();
const SonarRing &ring();

} // namespace frob::sim::p3dx
