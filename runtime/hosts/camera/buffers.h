/* buffers.h -- passes the newest frames of a camera from one process to another.
 *
 * Five frames are in memory shared by both processes: one that the writer fills, one that the
 * reader uses, and the newest three between them. Each side exchanges its frame for one of the
 * middle ones in an atomic operation. Neither side waits, the writer never changes the reader's
 * frame, and if the writer dies while it fills a frame, the others remain intact.
 *
 * The memory has the same address in both processes, because it is mapped before the fork. */
#ifndef FROB_HOST_CAMERA_BUFFERS_H
#define FROB_HOST_CAMERA_BUFFERS_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include <frob/image.h>
#include <frob/tags.h>

/* Maximum size of a frame in bytes: 1920 x 1200 in colour. */
#define BUFFERS_ROOM ((size_t)1920 * 1200 * 3)

/* A frame, stored without gaps between its rows. */
struct captured {
    int32_t width, height;
    enum frob_image_format format; /* a format whose pixels are bytes rather than depths */
    int64_t captured_ns;           /* on the monotonic clock */
    uint32_t number;
    bool has_camera; /* whether the frame contains its camera's projection and pose */
    struct frob_camera camera;
    struct frob_tags tags; /* the tags in the frame, if a finder looks for them */
    uint8_t *pixels;
};

struct buffers;

/* Returns NULL and sets errno if memory runs out. */
struct buffers *buffers_make(void);
void buffers_free(struct buffers *b);

/* For the writer: returns where to store the next frame. buffers_publish makes it the newest
 * frame. */
struct captured *buffers_back(struct buffers *b);
void buffers_publish(struct buffers *b);

/* For the writer: returns the last published frame, read-only; NULL before the first. */
const struct captured *buffers_published(const struct buffers *b);

/* For the reader: returns the newest frame, or NULL if it has been taken already. The frame stays
 * unchanged until the next call that returns a frame. */
const struct captured *buffers_take(struct buffers *b);

/* For the reader: returns the capture times and numbers of the middle frames that are newer than
 * the frame taken last, newest first. A reader of two cameras uses them to choose frames that
 * belong together (pair.h). */
enum { BUFFERS_KEPT = 3 };

struct fresh {
    uint32_t state;
    size_t count;
    int64_t captured_ns[BUFFERS_KEPT];
    uint32_t numbers[BUFFERS_KEPT];
};

struct fresh buffers_look(const struct buffers *b);

/* For the reader: like buffers_take, but returns frame `k` of `fresh`; the newer ones can still be
 * taken later. Returns NULL if the writer has published another frame since buffers_look; then call
 * buffers_look again. */
const struct captured *buffers_take_one(struct buffers *b, const struct fresh *fresh, size_t k);

/* Waits at most `wait_ms` for a new frame. The process that drives the robot must not call it. */
void buffers_wait(struct buffers *b, int wait_ms);

/* Memory for the reader's image, at an address that is valid in the other process too. */
struct frob_image *buffers_image(struct buffers *b);

/* buffers_begin records that the reader has asked for its first frame; buffers_have_begun returns
 * whether it has. */
void buffers_begin(struct buffers *b);
bool buffers_have_begun(const struct buffers *b);

/* buffers_beat increments the writer's heartbeat; buffers_beats returns it. */
void buffers_beat(struct buffers *b);
uint32_t buffers_beats(const struct buffers *b);

#endif
