/* ring.h -- memory that a running host shares with who looks on.
 *
 * One writer, the host, publishes each instant in a slot; the oldest is overwritten. A
 * number in front of each slot says what is in it, and is odd while that is being written (a
 * sequence lock), so a reader knows when it has read something torn, and the writer never
 * knows of readers: no system call, no lock, no allocation, no wait. The other way go a few
 * words (a stop, a pause, a speed) and a bounded queue of events, of one writer too.
 *
 * What a reader writes can make nothing worse than a run that ends, stands, or takes other
 * events: all of it is checked where it is read.
 *
 * How long an instant is comes from the times of two, as in a recording. */
#ifndef FROB_HOST_RING_H
#define FROB_HOST_RING_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* Of an instant, in bytes. */
struct ring_sizes {
    uint32_t input, output; /* of the program's structs */
    uint32_t truth;         /* of what a simulator knows besides; 0: nothing */
};

/* What happened on a console. */
enum ring_event_kind {
    RING_KEY = 1,   /* `id` is its character code */
    RING_TOUCH = 2, /* of number `id` on the program's console: see frob_console_touch */
    RING_HOLD = 3   /* likewise, of a button that is held; `y` is when, in seconds of
                     * CLOCK_MONOTONIC */
};

struct ring_event {
    uint32_t kind, id;
    double x, y;
};

#define RING_EVENTS 64 /* that wait, at most */

/* What looks on may do besides. */
enum ring_permission {
    RING_PACES = 1, /* pause the run, step it, and set its speed */
    RING_SENDS = 2  /* send events */
};

struct ring_shared;

struct ring {
    struct ring_shared *shared; /* NULL: there is none */
    int file;
    size_t size;
    struct ring_sizes sizes;
    uint64_t published; /* by this process */
};

/* {1 The host's side} */

/* Makes one, with all of its memory touched. False with errno set. */
bool ring_make(struct ring *ring, const struct ring_sizes *sizes, unsigned permissions);

/* Publishes the next instant. `truth` may be NULL if there is none. */
void ring_publish(struct ring *ring, int64_t time_ns, const void *input, const void *output,
                  const void *truth);

/* No more instants will come. */
void ring_end(struct ring *ring);

/* Whether the run is to be stopped. */
bool ring_is_stopped(const struct ring *ring);

/* How the run is to go on. */
struct ring_pace {
    uint32_t beats; /* the reader is there while this goes on */
    bool paused;
    uint32_t steps; /* instants that it is to take while paused, since the beginning */
    double speed;   /* of a clock on the wall, 0.1 to 100 */
};
struct ring_pace ring_pace(const struct ring *ring);

/* Takes the oldest event that waits; false if none does. */
bool ring_take(struct ring *ring, struct ring_event *event);

/* {1 The reader's side} */

/* Maps the ring behind a file descriptor. False if it is none. */
bool ring_attach(struct ring *ring, int file);

/* How many instants were published: the newest is one less. */
uint64_t ring_count(const struct ring *ring);

enum ring_status { RING_READ, RING_NOT_YET, RING_OVERWRITTEN };

/* Copies instant `k`, in what there is room for (see ring_sizes). Only with RING_READ the
 * bytes are its. */
enum ring_status ring_read(const struct ring *ring, uint64_t k, int64_t *time_ns, void *input,
                           void *output, void *truth);

bool ring_has_ended(const struct ring *ring);
bool ring_permits(const struct ring *ring, enum ring_permission permission);

/* To be called several times a second. */
void ring_beat(struct ring *ring);

void ring_stop(struct ring *ring);
void ring_pause(struct ring *ring, bool paused);
void ring_step(struct ring *ring);
void ring_set_speed(struct ring *ring, double speed); /* 0.1 to 100 */

/* False if the queue is full. */
bool ring_send(struct ring *ring, const struct ring_event *event);

/* {1 Both} */

void ring_close(struct ring *ring);

#endif
