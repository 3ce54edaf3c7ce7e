// The summary of a run, readable by people and scripts.
#pragma once

#include "sim.h"

namespace frob::serve {

// Prints the summary to standard output, with one `name: value unit` per line, as frob-sim does.
void print_summary(const frob_sim *sim);

} // namespace frob::serve
