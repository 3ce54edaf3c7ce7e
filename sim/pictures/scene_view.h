// Draws the world from above, with the path that the robot drove.
#pragma once

#include "canvas.h"
#include "simulation.h"

namespace frob::sim {

// The part of the world to show: the whole world and the whole path.
struct Extent {
    Vec low, high;
};

Extent extent(const Simulation &simulation);

// Draws the extent into the rectangle, which must have the same aspect ratio. Labels in metres go
// to the left of it and below it.
void draw_scene(Canvas &canvas, const Simulation &simulation, const Extent &extent, Vec corner,
                Vec size);

} // namespace frob::sim
