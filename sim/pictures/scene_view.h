// Draws the world from above, with the path that the robot drove.
#pragma once

#include "canvas.h"
#include "simulation.h"

namespace frob::sim {

// The area to draw: the bounding box of the world and of the robots' paths, with a margin.
struct Extent {
    Vec low, high;
};

Extent extent(const Simulation &simulation);

// Draws the extent into the rectangle, which must have the same aspect ratio. The coordinates, in
// metres, go to its left and below it.
void draw_scene(Canvas &canvas, const Simulation &simulation, const Extent &extent, Vec corner,
                Vec size);

} // namespace frob::sim
