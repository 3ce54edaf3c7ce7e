/* source.h -- where frames come from: a kind for each, with a state of its own.
 *
 * A source may wait, and may stay away for as long as it likes: it is used in the process that
 * captures, and nobody else waits for that. */
#ifndef FROB_HOST_CAMERA_SOURCE_H
#define FROB_HOST_CAMERA_SOURCE_H

#include <stdarg.h>

#include "buffers.h"
#include "settings.h"

enum source_result {
    SOURCE_FRAME,   /* the frame has been filled in, but for its number */
    SOURCE_NOTHING, /* none has come within the time; `fault` may say why */
    SOURCE_BROKEN,  /* one has come that is none; `fault` says why, and the next may be good */
    SOURCE_FAULT,   /* it is to be closed, and opened again; `fault` says why */
    SOURCE_OVER     /* there are no more, and never will be */
};

struct source;

struct source_kind {
    /* False: `fault` says why; nothing is left to be closed. */
    bool (*open)(struct source *s);
    enum source_result (*next)(struct source *s, struct captured *frame, int wait_ms);
    void (*close)(struct source *s);
    bool reopens;        /* when it gives nothing: that may help */
    const char *silence; /* what may be the matter then, unless `fault` says it */
};

struct source {
    const struct source_kind *kind;
    const struct camera_options *options;
    void *state;      /* of the kind, while it is open */
    bool is_recorded; /* it has a first frame, which waits for the program */
    uint32_t lost;    /* frames that are known to have been skipped; added up */
    char fault[512];  /* cause, and cure */
    char what[128];   /* when it is open: how it is captured, as "YUYV at 30 Hz"; or empty */
};

/* By what the user has named: a device, an address, a folder; anything else is a file or pipe.
 * One that is not there (yet) is taken for a device below /dev and for a file elsewhere. */
const struct source_kind *source_kind_of(const char *name);

extern const struct source_kind source_folder, source_stream, source_http, source_device;

/* Fills in `fault`; gives `result`. */
enum source_result source_fail(struct source *s, enum source_result result, const char *format, ...)
    __attribute__((format(printf, 3, 4)));

/* The monotonic clock. */
int64_t source_now_ns(void);
void source_sleep_until_ns(int64_t until_ns);

#endif
