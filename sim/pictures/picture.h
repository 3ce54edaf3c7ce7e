// The picture of a run: the world at the top, plots of its signals below.
#pragma once

#include <string>

#include "simulation.h"

namespace frob::sim {

// Draws the picture. Throws std::runtime_error if the file name does not end in .svg or .png, or if
// the file cannot be written.
void draw_picture(const Simulation &simulation, const std::string &file);

} // namespace frob::sim
