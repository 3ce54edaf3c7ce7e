/* The frames of the recording and the vision kernels, for compiled programs. */
#ifndef FROB_FUZZ_FRAMES_STUBS_H
#define FROB_FUZZ_FRAMES_STUBS_H

#include "frames.h"

#include <libtcc.h>

/* NULL until frames have been written. */
const struct frob_frames *frames_of_fuzz(void);

void frames_add_kernels(TCCState *compiler);

#endif
