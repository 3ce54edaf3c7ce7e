/* buffers.h -- the newest frames of a camera, handed from one process to another.
 *
 * Five frames in memory that both processes share: one that the writer fills, one that the
 * reader looks at, and the newest three between them. Each side exchanges its own for one of those
 * in the middle, in one step of the processor: nobody waits, the writer never touches what the
 * reader looks at, and a writer that dies in the middle of a frame leaves the others whole.
 *
 * The memory is at the same address in both processes, since it is made before they part. */
#ifndef FROB_HOST_CAMERA_BUFFERS_H
#define FROB_HOST_CAMERA_BUFFERS_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include <frob/image.h>
#include <frob/tags.h>

/* Bytes of the largest frame: 1920 x 1200 in colours. */
#define BUFFERS_ROOM ((size_t)1920 * 1200 * 3)

/* A frame, without gaps between its rows. */
struct captured {
    int32_t width, height;
    enum frob_image_format format; /* of bytes */
    int64_t captured_ns;           /* on the monotonic clock */
    uint32_t number;
    bool has_camera; /* it says itself how its camera sees */
    struct frob_camera camera;
    struct frob_tags tags; /* in it, where they are looked for */
    uint8_t *pixels;
};

struct buffers;

/* NULL without memory, with errno. */
struct buffers *buffers_make(void);
void buffers_free(struct buffers *b);

/* The writer's: where the next frame goes; then it is the newest one. */
struct captured *buffers_back(struct buffers *b);
void buffers_publish(struct buffers *b);

/* The one that was published last, as its writer sees it; NULL before the first. It is only to
 * be read. */
const struct captured *buffers_published(const struct buffers *b);

/* The reader's: the newest frame, once; NULL if there is none that was not taken before. It stays
 * as it is until the next call that gives one. */
const struct captured *buffers_take(struct buffers *b);

/* Those of the three that are newer than what was taken, the newest first: when they were taken and
 * their numbers. Who has two cameras chooses frames that belong together (pair.h). */
enum { BUFFERS_KEPT = 3 };

struct fresh {
    uint32_t state;
    size_t count;
    int64_t captured_ns[BUFFERS_KEPT];
    uint32_t numbers[BUFFERS_KEPT];
};

struct fresh buffers_look(const struct buffers *b);

/* One of these, as buffers_take gives it; those before it can be taken later. NULL if the writer
 * has published another one since: look again. */
const struct captured *buffers_take_one(struct buffers *b, const struct fresh *fresh, size_t k);

/* Waits for so long for a frame to take; whoever drives does not. */
void buffers_wait(struct buffers *b, int wait_ms);

/* Of the reader, for who it hands the address of a frame on to in another process. */
struct frob_image *buffers_image(struct buffers *b);

/* The reader has looked for the first time; whether it has. */
void buffers_begin(struct buffers *b);
bool buffers_have_begun(const struct buffers *b);

/* The writer is alive; how often it has said so. */
void buffers_beat(struct buffers *b);
uint32_t buffers_beats(const struct buffers *b);

#endif
