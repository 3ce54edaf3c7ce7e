/* What compiled programs are given of frames: those of the recording, and what looks at them. */
#ifndef FROB_FUZZ_FRAMES_STUBS_H
#define FROB_FUZZ_FRAMES_STUBS_H

#include "hosts/common/frames.h"

#include <libtcc.h>

/* NULL before there are any. */
const struct frob_frames *frames_of_fuzz(void);

void frames_add_kernels(TCCState *compiler);

#endif
