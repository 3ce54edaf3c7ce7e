#include "ring.h"

#include <errno.h>
#include <fcntl.h>
#include <math.h>
#include <stdio.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <time.h>
#include <unistd.h>

#define MAGIC UINT64_C(0x46726f6252696e31) /* "FrobRin1" */
#define MOST_BYTES (4u << 20)              /* maximum total size of the slots */
#define MOST_SLOTS 8192u
#define LEAST_SLOTS 16u
#define LINE 64 /* size of a cache line in bytes */

/* The host's part and the reader's part are in separate cache lines, to avoid false sharing. */
struct ring_shared {
    uint64_t magic;
    uint32_t slots, words; /* `slots` is a power of two; `words` is the number of words of data per
                            * slot */
    struct ring_sizes sizes;
    uint32_t permissions;
    unsigned char gap[LINE];

    uint64_t published; /* written by the host */
    uint32_t ended;
    uint32_t taken;
    uint32_t fate, late;
    int64_t alive_ns; /* last heartbeat of the host (CLOCK_MONOTONIC); 0 before the first one */
    unsigned char gap_after_host[LINE];

    uint32_t beats; /* written by the reader */
    uint32_t stop, paused, steps;
    uint32_t speed; /* in thousandths */
    uint32_t sent;
    struct ring_event events[RING_EVENTS];
    uint64_t seen; /* number of instants that the reader has read */
    unsigned char gap_after_reader[LINE];
};

static size_t words_of(size_t bytes)
{
    return (bytes + sizeof(uint64_t) - 1) / sizeof(uint64_t);
}

static size_t words_of_slot(const struct ring_sizes *sizes)
{
    return 1 + words_of(sizes->input) + words_of(sizes->output) + words_of(sizes->truth);
}

static size_t size_of(size_t slots, size_t words)
{
    return sizeof(struct ring_shared) + slots * (words + 1) * sizeof(uint64_t);
}

/* Returns the sequence number of a slot; the slot's words follow it. */
static uint64_t *slot_of(const struct ring *ring, uint64_t k)
{
    uint64_t *slots = (uint64_t *)(ring->shared + 1);
    return slots + (k & (ring->shared->slots - 1)) * (words_of_slot(&ring->sizes) + 1);
}

/* ---- Creating and mapping */

/* Opens shared memory and unlinks its name. */
static int open_memory(void)
{
    for (unsigned attempt = 0; attempt < 100; attempt++) {
        char name[64];
        struct timespec now;
        int file;
        clock_gettime(CLOCK_MONOTONIC, &now);
        snprintf(name, sizeof name, "/frob-%ld-%ld-%u", (long)getpid(), now.tv_nsec, attempt);
        file = shm_open(name, O_RDWR | O_CREAT | O_EXCL, 0600);
        if (file >= 0) {
            shm_unlink(name);
            return file;
        }
        if (errno != EEXIST)
            return -1;
    }
    return -1;
}

static bool map(struct ring *ring)
{
    void *memory = mmap(NULL, ring->size, PROT_READ | PROT_WRITE, MAP_SHARED, ring->file, 0);
    ring->shared = memory == MAP_FAILED ? NULL : (struct ring_shared *)memory;
    return ring->shared != NULL;
}

bool ring_make(struct ring *ring, const struct ring_sizes *sizes, unsigned permissions)
{
    const size_t words = words_of_slot(sizes);
    uint32_t slots = MOST_SLOTS;
    memset(ring, 0, sizeof *ring);
    while (slots > LEAST_SLOTS && slots * (words + 1) * sizeof(uint64_t) > MOST_BYTES)
        slots /= 2;
    ring->sizes = *sizes;
    ring->size = size_of(slots, words);
    ring->file = open_memory();
    if (ring->file < 0)
        return false;
    if (ftruncate(ring->file, (off_t)ring->size) != 0 || !map(ring)) {
        int why = errno;
        close(ring->file);
        errno = why;
        return false;
    }
    mlock(ring->shared, ring->size); /* if permitted */
    memset(ring->shared, 0, ring->size);
    ring->shared->slots = slots;
    ring->shared->words = (uint32_t)words;
    ring->shared->sizes = *sizes;
    ring->shared->permissions = permissions;
    ring->shared->speed = 1000;
    ring->shared->magic = MAGIC;
    return true;
}

bool ring_attach(struct ring *ring, int file)
{
    struct stat status;
    const struct ring_shared *shared;
    memset(ring, 0, sizeof *ring);
    ring->file = file;
    if (fstat(file, &status) != 0 || status.st_size < (off_t)sizeof(struct ring_shared))
        return false;
    ring->size = (size_t)status.st_size;
    if (!map(ring))
        return false;
    shared = ring->shared;
    ring->sizes = shared->sizes;
    if (shared->magic == MAGIC && shared->words == words_of_slot(&shared->sizes) &&
        shared->slots > 0 && (shared->slots & (shared->slots - 1)) == 0 &&
        ring->size == size_of(shared->slots, shared->words))
        return true;
    ring_close(ring);
    return false;
}

void ring_close(struct ring *ring)
{
    if (ring->shared == NULL)
        return;
    munmap(ring->shared, ring->size);
    close(ring->file);
    ring->shared = NULL;
}

/* ---- Instants */

/* Words are stored and loaded atomically, so that reading a slot that is being written is not a
 * data race; the reader discards the result. */
static uint64_t *put(uint64_t *to, const void *from, size_t size)
{
    const unsigned char *bytes = (const unsigned char *)from;
    uint64_t word;
    for (; size >= sizeof word; size -= sizeof word, bytes += sizeof word) {
        memcpy(&word, bytes, sizeof word);
        __atomic_store_n(to++, word, __ATOMIC_RELAXED);
    }
    if (size > 0) {
        word = 0;
        memcpy(&word, bytes, size);
        __atomic_store_n(to++, word, __ATOMIC_RELAXED);
    }
    return to;
}

static const uint64_t *get(void *to, const uint64_t *from, size_t size)
{
    unsigned char *bytes = (unsigned char *)to;
    for (; size > 0; from++) {
        const uint64_t word = __atomic_load_n(from, __ATOMIC_RELAXED);
        const size_t part = size < sizeof word ? size : sizeof word;
        memcpy(bytes, &word, part);
        bytes += part;
        size -= part;
    }
    return from;
}

void ring_publish(struct ring *ring, int64_t time_ns, const void *input, const void *output,
                  const void *truth)
{
    uint64_t *number, *word;
    if (ring->shared == NULL)
        return;
    number = slot_of(ring, ring->published);
    word = number + 1;
    __atomic_store_n(number, 2 * ring->published + 1, __ATOMIC_RELAXED);
    __atomic_thread_fence(__ATOMIC_RELEASE);
    word = put(word, &time_ns, sizeof time_ns);
    word = put(word, input, ring->sizes.input);
    word = put(word, output, ring->sizes.output);
    if (truth != NULL)
        put(word, truth, ring->sizes.truth);
    ring->published++;
    __atomic_store_n(number, 2 * ring->published, __ATOMIC_RELEASE);
    __atomic_store_n(&ring->shared->published, ring->published, __ATOMIC_RELEASE);
    ring_show_alive(ring);
}

enum ring_status ring_read(const struct ring *ring, uint64_t k, int64_t *time_ns, void *input,
                           void *output, void *truth)
{
    const uint64_t *number = slot_of(ring, k), *word = number + 1;
    const uint64_t wanted = 2 * (k + 1);
    const uint64_t before = __atomic_load_n(number, __ATOMIC_ACQUIRE);
    if (before != wanted)
        return before < wanted ? RING_NOT_YET : RING_OVERWRITTEN;
    word = get(time_ns, word, sizeof *time_ns);
    word = get(input, word, ring->sizes.input);
    word = get(output, word, ring->sizes.output);
    get(truth, word, truth == NULL ? 0 : ring->sizes.truth);
    __atomic_thread_fence(__ATOMIC_ACQUIRE);
    return __atomic_load_n(number, __ATOMIC_RELAXED) == wanted ? RING_READ : RING_OVERWRITTEN;
}

uint64_t ring_count(const struct ring *ring)
{
    return __atomic_load_n(&ring->shared->published, __ATOMIC_ACQUIRE);
}

/* ---- Words */

static uint32_t load(const uint32_t *word)
{
    return __atomic_load_n(word, __ATOMIC_ACQUIRE);
}

static void store(uint32_t *word, uint32_t value)
{
    __atomic_store_n(word, value, __ATOMIC_RELEASE);
}

void ring_stopping(struct ring *ring)
{
    if (ring->shared != NULL)
        store(&ring->shared->fate, RING_STOPPING);
}

void ring_end(struct ring *ring, enum ring_fate fate)
{
    if (ring->shared == NULL)
        return;
    store(&ring->shared->fate, (uint32_t)fate); /* stored before `ended`, so that readers see
                                                 * both */
    store(&ring->shared->ended, 1);
}

enum ring_fate ring_fate(const struct ring *ring)
{
    const uint32_t fate = load(&ring->shared->fate);
    return fate <= RING_NOT_REACHED ? (enum ring_fate)fate : RING_GOES_ON;
}

static int64_t clock_ns(void)
{
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return (int64_t)now.tv_sec * 1000000000 + now.tv_nsec;
}

void ring_show_alive(struct ring *ring)
{
    struct ring_shared *shared = ring->shared;
    int64_t now_ns, before_ns;
    if (shared == NULL)
        return;
    now_ns = clock_ns();
    before_ns = shared->alive_ns;
    if (before_ns != 0 && now_ns - before_ns > RING_PATIENCE_NS) {
        const uint32_t sent = load(&shared->sent);
        if (shared->taken != sent)
            store(&shared->late, shared->late + 1);
        store(&shared->taken, sent);
        ring->freezes++;
    }
    __atomic_store_n(&shared->alive_ns, now_ns, __ATOMIC_RELEASE);
}

void ring_drop_late(struct ring *ring)
{
    store(&ring->shared->late, load(&ring->shared->late) + 1);
}

uint32_t ring_late(const struct ring *ring)
{
    return load(&ring->shared->late);
}

double ring_silence_s(const struct ring *ring)
{
    const int64_t alive_ns = __atomic_load_n(&ring->shared->alive_ns, __ATOMIC_ACQUIRE);
    return alive_ns == 0 ? (double)INFINITY : (double)(clock_ns() - alive_ns) / 1e9;
}

bool ring_has_ended(const struct ring *ring)
{
    return load(&ring->shared->ended) != 0;
}

bool ring_permits(const struct ring *ring, enum ring_permission permission)
{
    return (ring->shared->permissions & (unsigned)permission) != 0;
}

bool ring_is_stopped(const struct ring *ring)
{
    return ring->shared != NULL && load(&ring->shared->stop) != 0;
}

void ring_stop(struct ring *ring)
{
    store(&ring->shared->stop, 1);
}

void ring_beat(struct ring *ring)
{
    store(&ring->shared->beats, load(&ring->shared->beats) + 1);
}

void ring_saw(struct ring *ring, uint64_t count)
{
    __atomic_store_n(&ring->shared->seen, count, __ATOMIC_RELEASE);
}

bool ring_is_half_unread(const struct ring *ring)
{
    const struct ring_shared *shared = ring->shared;
    const uint64_t seen = __atomic_load_n(&shared->seen, __ATOMIC_ACQUIRE);
    return ring_count(ring) > seen + shared->slots / 2;
}

void ring_pause(struct ring *ring, bool paused)
{
    store(&ring->shared->paused, paused ? 1 : 0);
}

void ring_step(struct ring *ring)
{
    store(&ring->shared->steps, load(&ring->shared->steps) + 1);
}

void ring_set_speed(struct ring *ring, double speed)
{
    store(&ring->shared->speed, (uint32_t)(speed * 1000.0 + 0.5));
}

struct ring_pace ring_pace(const struct ring *ring)
{
    const struct ring_shared *shared = ring->shared;
    const uint32_t speed = load(&shared->speed);
    struct ring_pace pace;
    pace.beats = load(&shared->beats);
    pace.paused = load(&shared->paused) != 0;
    pace.steps = load(&shared->steps);
    pace.speed = (double)(speed < 100 ? 100 : speed) / 1000.0;
    if (pace.speed > RING_MOST_SPEED)
        pace.speed = RING_MOST_SPEED;
    return pace;
}

/* ---- Events */

bool ring_send(struct ring *ring, const struct ring_event *event)
{
    struct ring_shared *shared = ring->shared;
    const uint32_t sent = shared->sent;
    if (sent - load(&shared->taken) >= RING_EVENTS)
        return false;
    shared->events[sent % RING_EVENTS] = *event;
    store(&shared->sent, sent + 1);
    return true;
}

bool ring_take(struct ring *ring, struct ring_event *event)
{
    struct ring_shared *shared = ring->shared;
    if (shared == NULL || shared->taken == load(&shared->sent))
        return false;
    *event = shared->events[shared->taken % RING_EVENTS];
    store(&shared->taken, shared->taken + 1);
    return true;
}
