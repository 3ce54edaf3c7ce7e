// Plan files, which specify the runs of a sweep. The simulator reads them, because its reader for
// world files can already report mistakes with file, line and column, and suggest the intended key.
#pragma once

#include <string>

namespace frob::sim {

// Converts the plan to text: one line for each item, with tabs between its cells. If only the
// compiler can check an item, its second cell is the item's place in the file:
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
