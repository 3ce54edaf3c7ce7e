/* line.h -- the robot's line, which is reopened after it was lost. */
#ifndef FROB_HOST_ROBOT_LINE_H
#define FROB_HOST_ROBOT_LINE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "hal/posix/serial.h"

struct line {
    const char *device; /* as the user named it */
    char lasting[512];  /* the adapter's persistent name; "" if none */
    uint32_t rate;
    struct frob_posix_line port; /* fd is -1 while it is closed */
    int64_t retry_ns;
};

/* Initializes a line without opening it. */
void line_init(struct line *line, const char *device, uint32_t rate);

/* Opens the line. The message uses the device name that the user gave. */
enum frob_status line_open(struct line *line, char *message, size_t room);

/* Tries to reopen the line if a retry is due, also under the adapter's current name. Returns true
 * if it is open. */
bool line_reopen(struct line *line, int64_t now_ns);

void line_close(struct line *line);
bool line_is_open(const struct line *line);

#endif
