/* capture.h -- the process that captures and decodes the frames of one camera. */
#ifndef FROB_HOST_CAMERA_CAPTURE_H
#define FROB_HOST_CAMERA_CAPTURE_H

#include "../common/tag_finder.h"
#include "buffers.h"
#include "settings.h"

/* What it says of itself, whenever that changes: one message on its socket. */
enum capture_state {
    CAPTURE_WORKS,
    CAPTURE_FAILS, /* no frames come; it goes on trying */
    CAPTURE_ENDED  /* no frames will come any more */
};

struct capture_report {
    enum capture_state state;
    char text[640];
};

/* The way of a camera's frames to the program. */
struct capture_way {
    struct buffers *seen;      /* as they were captured */
    struct buffers *given;     /* what the program takes: the same, but where … */
    struct tag_finder *finder; /* … this one looks for tags on the way; NULL: nobody does */
};

/* The process: frames on their way, until the other end of the socket is gone. Whatever happens to
 * those who capture, decode and look for tags, they begin anew. */
void capture_run(const struct camera_options *options, const struct capture_way *way, int socket)
    __attribute__((noreturn));

#endif
