/* tagger.h -- the process that looks for tags in the frames of one camera.
 *
 * It stands between the process that captures and the program, and hands each frame on with its
 * tags. Looking for them takes longer than a frame may: meanwhile the other one goes on capturing,
 * so that frames have their times, and the newest is looked at next. */
#ifndef FROB_HOST_CAMERA_TAGGER_H
#define FROB_HOST_CAMERA_TAGGER_H

#include "../common/tag_finder.h"
#include "buffers.h"

/* From `seen` to `given`, until the process is ended; it beats for `given`. The finder is open. */
void tagger_run(struct tag_finder *finder, struct buffers *seen, struct buffers *given)
    __attribute__((noreturn));

#endif
