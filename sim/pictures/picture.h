// The picture of a run: the world above, plots of its signals below.
#pragma once

#include <string>

#include "simulation.h"

namespace frob::sim
{

// The file's name ends in .svg or .png. Throws std::runtime_error when it does
// not, or when it cannot be written.
void draw_picture(const Simulation &simulation, const std::string &file);

} // namespace frob::sim
