/* source.h -- sources of frames; each kind has its own state.
 *
 * A source may block for as long as it likes, because it is used only in the capture process, and
 * no other process waits for that one. */
#ifndef FROB_HOST_CAMERA_SOURCE_H
#define FROB_HOST_CAMERA_SOURCE_H

#include <stdarg.h>

#include "buffers.h"
#include "settings.h"

enum source_result {
    SOURCE_FRAME,   /* a frame was stored, except its number */
    SOURCE_NOTHING, /* no frame arrived within the time; `fault` may have the reason */
    SOURCE_BROKEN,  /* an invalid frame arrived; `fault` has the reason, and the next may be
                     * good */
    SOURCE_FAULT,   /* close the source and open it again; `fault` has the reason */
    SOURCE_OVER     /* there will be no more frames */
};

struct source;

struct source_kind {
    /* Opens the source. On failure returns false with the reason in `fault`; then there is nothing
     * to close. */
    bool (*open)(struct source *s);
    enum source_result (*next)(struct source *s, struct captured *frame, int wait_ms);
    void (*close)(struct source *s);
    bool reopens;        /* reopening it may help if no frames arrive */
    const char *silence; /* the likely reason in this case, unless `fault` has one */
};

struct source {
    const struct source_kind *kind;
    const struct camera_options *options;
    void *state;      /* state of this kind, while it is open */
    bool is_recorded; /* its first frame waits for the program to start */
    uint32_t lost;    /* total number of frames known to have been skipped */
    char fault[512];  /* cause and fix */
    char what[128];   /* while open: how it captures, such as "YUYV at 30 Hz"; or empty */
};

/* Begins the name of a topic in ROS 2 (hosts/ros/camera.h). */
#define SOURCE_TOPIC "ros:"

/* Returns the kind of the source that the user has named: a device, an address or a folder;
 * anything else is a file or pipe. A name that does not exist (yet) is a device if it is in /dev,
 * and a file otherwise. */
const struct source_kind *source_kind_of(const char *name);

extern const struct source_kind source_folder, source_stream, source_topic, source_http,
    source_device;

/* Formats the message `fault`, and returns `result`. */
enum source_result source_fail(struct source *s, enum source_result result, const char *format, ...)
    __attribute__((format(printf, 3, 4)));

/* Time on the monotonic clock. */
int64_t source_now_ns(void);
void source_sleep_until_ns(int64_t until_ns);

#endif
