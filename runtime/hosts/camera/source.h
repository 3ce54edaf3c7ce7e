/* source.h -- sources of frames; each kind has its own state.
 *
 * A source may block for any length of time, because only the capture process uses it, and no
 * other process waits for that process. */
#ifndef FROB_HOST_CAMERA_SOURCE_H
#define FROB_HOST_CAMERA_SOURCE_H

#include <stdarg.h>

#include "buffers.h"
#include "settings.h"

enum source_result {
    SOURCE_FRAME,   /* a frame was stored; only its number is not set yet */
    SOURCE_NOTHING, /* no frame arrived before the timeout; `fault` may contain the reason */
    SOURCE_BROKEN,  /* an invalid frame arrived; `fault` contains the reason, and the next frame
                     * may be valid */
    SOURCE_FAULT,   /* the source must be closed and opened again; `fault` contains the reason */
    SOURCE_OVER     /* no more frames will arrive */
};

struct source;

struct source_kind {
    /* Opens the source. On failure, returns false with the reason in `fault`, and there is nothing
     * to close. */
    bool (*open)(struct source *s);
    enum source_result (*next)(struct source *s, struct captured *frame, int wait_ms);
    void (*close)(struct source *s);
    bool reopens;        /* whether reopening it may help if no frames arrive */
    const char *silence; /* the likely reason why no frames arrive, used if `fault` is empty */
};

struct source {
    const struct source_kind *kind;
    const struct camera_options *options;
    void *state;      /* private data of `kind` while the source is open */
    bool is_recorded; /* whether its first frame is held back until the program starts */
    uint32_t lost;    /* total number of frames known to have been skipped */
    char fault[512];  /* cause and fix */
    char what[128];   /* how it captures while it is open, such as "YUYV at 30 Hz"; may be empty */
};

/* Prefix of the name of a source that is a ROS 2 topic (hosts/ros/camera.h). */
#define SOURCE_TOPIC "ros:"

/* Returns the kind of the source that the user has named: a device, an address, a folder or
 * a topic. Anything else is a file or pipe. A name that does not exist (yet) counts as a device if
 * it is in /dev, and otherwise as a file. */
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
