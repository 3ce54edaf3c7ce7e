/* capture.h -- the process that captures and decodes the frames of one camera. */
#ifndef FROB_HOST_CAMERA_CAPTURE_H
#define FROB_HOST_CAMERA_CAPTURE_H

#include <sys/types.h>

#include "../common/tag_finder.h"
#include "buffers.h"
#include "settings.h"

/* State of the process, which sends a message on its socket whenever the state changes. */
enum capture_state {
    CAPTURE_WORKS,
    CAPTURE_FAILS, /* no frames arrive; the process keeps trying */
    CAPTURE_ENDED  /* no more frames will arrive */
};

struct capture_report {
    enum capture_state state;
    char text[640];
};

/* How frames get from a camera to the program. */
struct capture_way {
    struct buffers *seen;      /* frames as captured */
    struct buffers *given;     /* the frames for the program; the same as `seen` if there is no tag
                                * finder */
    struct tag_finder *finder; /* looks for tags and passes the frames on; NULL if there is none */
};

/* Runs the camera process, a child of `supervisor`, which delivers frames until `supervisor` ends.
 * Restarts the processes that capture, decode and look for tags whenever one of them fails. */
void capture_run(const struct camera_options *options, const struct capture_way *way, int socket,
                 pid_t supervisor) __attribute__((noreturn));

#endif
