// Plan files, which specify the runs of a sweep. The simulator reads them because it contains the
// reader for world files, which reports mistakes with file, line and column, and suggests the
// intended key.
#pragma once

#include <string>

namespace frob::sim {

// Converts the plan to text: one line for each item, with tabs between its cells. If only the
// compiler can find mistakes in an item, its second cell is its place in the file:
//     program PLACE FILE
//     trial PLACE LABEL
//     seeds FIRST LAST            lasts SECONDS            rate HZ
//     world PLACE FILE            robot PLACE NAME
//     sampling HOW POINTS SEED    (grid, random or latin)
//     range PLACE NAME LOW HIGH STEPS     (0 steps: sampled)
//     values PLACE NAME VALUE...
// Throws WorldFileError, which lists every mistake found.
std::string read_plan_file(const std::string &path);

} // namespace frob::sim
