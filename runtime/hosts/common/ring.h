/* ring.h -- memory that a running host shares with viewers.
 *
 * There is one writer, the host, which publishes each instant in a slot and overwrites the oldest
 * one. A sequence number in front of each slot identifies its contents, and is odd while they are
 * being written (a sequence lock). Therefore a reader detects an inconsistent read, and the writer
 * does not depend on readers: it does not make system calls, take locks, allocate memory or wait.
 * In the other direction, a single reader writes a few words (stop, pause, speed) and a bounded
 * queue of events.
 *
 * The host validates all data that a reader writes. In the worst case, such data can end or pause
 * the run, or send unintended events.
 *
 * As in a recording, dt is the difference between the times of consecutive instants. */
#ifndef FROB_HOST_RING_H
#define FROB_HOST_RING_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* Sizes of the data of an instant, in bytes. */
struct ring_sizes {
    uint32_t input, output; /* sizes of the program's structs */
    uint32_t truth;         /* size of the simulator's ground truth; 0 if there is none */
};

/* Operator input. */
enum ring_event_kind {
    RING_KEY = 1,   /* a typed key; `id` is its character code */
    RING_TOUCH = 2, /* `id` is the index of a control in the program's console; see
                     * frob_console_touch */
    RING_HOLD = 3   /* like RING_TOUCH, for a held button; `y` is the CLOCK_MONOTONIC time in
                     * seconds */
};

struct ring_event {
    uint32_t kind, id;
    double x, y;
};

#define RING_EVENTS 64 /* maximum number of pending events */

/* Additional permissions for viewers. */
enum ring_permission {
    RING_PACES = 1, /* pause the run, single-step it and set its speed */
    RING_SENDS = 2  /* send events */
};

struct ring_shared;

struct ring {
    struct ring_shared *shared; /* NULL: none */
    int file;
    size_t size;
    struct ring_sizes sizes;
    uint64_t published; /* number of instants that this process has published */
    uint32_t freezes;   /* number of times that this host process was frozen */
};

/* ---- The host's side */

/* Creates a ring and touches all of its memory. Returns false with errno set on failure. */
bool ring_make(struct ring *ring, const struct ring_sizes *sizes, unsigned permissions);

/* Publishes the next instant. `truth` may be NULL if its size is 0. */
void ring_publish(struct ring *ring, int64_t time_ns, const void *input, const void *output,
                  const void *truth);

/* State of the run, as reported by its host. A page states that a robot has stopped only if the
 * host has reported this. */
enum ring_fate {
    RING_GOES_ON,
    RING_STOPPING,   /* the host is ending the run and sending the stop command */
    RING_AT_REST,    /* the run is over, and the robot was seen to stand still */
    RING_TOLD,       /* the run is over; the stop command was sent, but the robot was not seen to
                      * stand still */
    RING_NOT_REACHED /* the run is over; the stop command could not be sent */
};

/* Reports that the host is ending the run. */
void ring_stopping(struct ring *ring);

/* Reports that no more instants will come, and whether the robot is known to be at rest. */
void ring_end(struct ring *ring, enum ring_fate fate);

/* Updates the host's heartbeat, which tells readers that the host would act on a stop request now.
 * A host must call this at least ten times a second, whether or not it publishes instants. If the
 * previous call was longer than RING_PATIENCE_NS ago, the host was frozen and pending events are
 * stale, so this function drops them and counts them as late. It also counts the freeze, so that
 * callers can discard events that they took earlier. */
#define RING_PATIENCE_NS INT64_C(500000000)
void ring_show_alive(struct ring *ring);

/* Returns whether a viewer has asked the run to stop. */
bool ring_is_stopped(const struct ring *ring);

/* The maximum speed relative to real time. It is so high that a host at this speed never waits for
 * the clock. */
#define RING_MOST_SPEED 1000000.0

/* The pace that a viewer has requested for the run. */
struct ring_pace {
    uint32_t beats; /* heartbeat: changes while the reader is alive */
    bool paused;
    uint32_t steps; /* total number of instants to run while paused */
    double speed;   /* relative to real time, 0.1 to RING_MOST_SPEED */
};
struct ring_pace ring_pace(const struct ring *ring);

/* Returns whether more than half of the ring is still unread. */
bool ring_is_half_unread(const struct ring *ring);

/* Takes the oldest pending event. Returns false if there is none. */
bool ring_take(struct ring *ring, struct ring_event *event);

/* ---- The reader's side */

/* Maps the ring that a file descriptor refers to. Returns false if it is not a ring. */
bool ring_attach(struct ring *ring, int file);

/* Returns the number of published instants; the index of the newest is one less. */
uint64_t ring_count(const struct ring *ring);

enum ring_status { RING_READ, RING_NOT_YET, RING_OVERWRITTEN };

/* Copies instant `k` to the buffers, which have the sizes in ring_sizes. The contents of the
 * buffers are valid only if the result is RING_READ. */
enum ring_status ring_read(const struct ring *ring, uint64_t k, int64_t *time_ns, void *input,
                           void *output, void *truth);

bool ring_has_ended(const struct ring *ring);
enum ring_fate ring_fate(const struct ring *ring);

/* Returns the seconds since the host's last heartbeat; infinite before the first one. */
double ring_silence_s(const struct ring *ring);

bool ring_permits(const struct ring *ring, enum ring_permission permission);

/* Updates the reader's heartbeat. Call it several times a second. */
void ring_beat(struct ring *ring);

/* Reports how many instants the reader has read. */
void ring_saw(struct ring *ring, uint64_t count);

void ring_stop(struct ring *ring);
void ring_pause(struct ring *ring, bool paused);
void ring_step(struct ring *ring);
void ring_set_speed(struct ring *ring, double speed); /* 0.1 to RING_MOST_SPEED */

/* Reports that the host has dropped an event that it had taken before a freeze. */
void ring_drop_late(struct ring *ring);

/* Number of times that the host has dropped stale events. */
uint32_t ring_late(const struct ring *ring);

/* Queues an event. Returns false if the queue is full. */
bool ring_send(struct ring *ring, const struct ring_event *event);

/* ---- Both */

void ring_close(struct ring *ring);

#endif
