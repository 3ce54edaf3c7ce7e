// A sweep's plan: which runs of a trial to make. Read here because the reader of world files is:
// it names file, line and column, and the key that was meant.
#pragma once

#include <string>

namespace frob::sim
{

// What the plan says, a line for each thing, with tabs between its cells; where something may be
// wrong that only the compiler can tell, its place is the second cell:
//
//     program PLACE FILE
//     trial PLACE LABEL
//     seeds FIRST LAST            lasts SECONDS            rate HZ
//     world PLACE FILE            robot PLACE NAME
//     sampling HOW POINTS SEED    (grid, random or latin)
//     range PLACE NAME LOW HIGH STEPS     (0 steps: sampled)
//     values PLACE NAME VALUE...
//
// Throws WorldFileError with every mistake that was found.
std::string read_plan_file(const std::string &path);

} // namespace frob::sim
