/* tagger.h -- the process that looks for tags in the frames of one camera.
 *
 * It runs between the capture process and the program, and passes each frame on with its tags.
 * Finding tags may take longer than the period between frames. The capture process continues in the
 * meantime, so the capture times of frames are correct, and the next search uses the newest
 * frame. */
#ifndef FROB_HOST_CAMERA_TAGGER_H
#define FROB_HOST_CAMERA_TAGGER_H

#include "../common/tag_finder.h"
#include "buffers.h"

/* Passes frames from `seen` to `given` until the process is ended, and updates the heartbeat of
 * `given`. The finder must be open. */
void tagger_run(struct tag_finder *finder, struct buffers *seen, struct buffers *given)
    __attribute__((noreturn));

#endif
