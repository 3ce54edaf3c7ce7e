/* capture.h -- the process that captures and decodes the frames of one camera. */
#ifndef FROB_HOST_CAMERA_CAPTURE_H
#define FROB_HOST_CAMERA_CAPTURE_H

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

/* The process: frames into the buffers, until the other end of the socket is gone. Whatever
 * happens to it while it decodes, it begins anew. */
void capture_run(const struct camera_options *options, struct buffers *buffers, int socket)
    __attribute__((noreturn));

#endif
