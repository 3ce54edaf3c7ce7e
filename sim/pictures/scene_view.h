// The world from above, with the path that the robot drove.
#pragma once

#include "canvas.h"
#include "simulation.h"

namespace frob::sim
{

// What part of the world is shown: all of it, and the path.
struct Extent {
    Vec low, high;
};

Extent extent(const Simulation &simulation);

// Draws the extent into the rectangle, which has its shape; labels in metres
// stand left of and below it.
void draw_scene(Canvas &canvas, const Simulation &simulation, const Extent &extent, Vec corner,
                Vec size);

} // namespace frob::sim
