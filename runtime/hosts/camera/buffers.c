#include "buffers.h"

#include <linux/futex.h>
#include <sys/mman.h>
#include <sys/syscall.h>
#include <time.h>
#include <unistd.h>

/* Positions of the frames: the writer's frame, the middle frames (newest first), and the reader's
 * frame. */
enum { BACK = 0, NEWEST = 1, FRONT = NEWEST + BUFFERS_KEPT, COUNT = FRONT + 1 };

struct buffers {
    uint32_t state; /* see `order_of` */
    uint32_t beats, begun;
    struct frob_image image;
    uint32_t published; /* the last published frame */
    struct captured frames[COUNT];
};

/* The unpacked state. It is replaced as a whole, and `changes` is incremented each time, so that an
 * old state is never mistaken for the current one (the ABA problem). */
struct order {
    uint32_t at[COUNT]; /* index of the frame at each position, 3 bits each */
    uint32_t fresh;     /* number of middle frames newer than the frame taken last; 2 bits */
    bool has_any;       /* whether a frame has been published */
    uint32_t changes;   /* 14 bits */
};

enum { FRESH_BIT = 15, ANY_BIT = 17, CHANGES_BIT = 18 };

static struct order order_of(uint32_t state)
{
    struct order o;
    for (unsigned i = 0; i < COUNT; i++)
        o.at[i] = (state >> 3 * i & 7u) % COUNT;
    o.fresh = state >> FRESH_BIT & 3u;
    o.has_any = (state >> ANY_BIT & 1u) != 0;
    o.changes = state >> CHANGES_BIT;
    return o;
}

static uint32_t state_of(const struct order *o)
{
    uint32_t state =
        o->fresh << FRESH_BIT | (o->has_any ? 1u : 0u) << ANY_BIT | o->changes << CHANGES_BIT;
    for (unsigned i = 0; i < COUNT; i++)
        state |= o->at[i] << 3 * i;
    return state;
}

struct buffers *buffers_make(void)
{
    static const struct order first = { { 0, 1, 2, 3, 4 }, 0, false, 0 };
    const size_t size = sizeof(struct buffers) + COUNT * BUFFERS_ROOM;
    void *memory = mmap(NULL, size, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    struct buffers *b = (struct buffers *)memory;
    if (memory == MAP_FAILED)
        return NULL;
    b->state = state_of(&first);
    for (size_t i = 0; i < COUNT; i++)
        b->frames[i].pixels = (uint8_t *)memory + sizeof *b + i * BUFFERS_ROOM;
    return b;
}

void buffers_free(struct buffers *b)
{
    munmap(b, sizeof *b + COUNT * BUFFERS_ROOM);
}

static uint32_t read_state(const struct buffers *b)
{
    return __atomic_load_n(&b->state, __ATOMIC_ACQUIRE);
}

/* Replaces the state if it is still `*seen`. */
static bool change(struct buffers *b, uint32_t *seen, struct order *next)
{
    next->changes++;
    return __atomic_compare_exchange_n(&b->state, seen, state_of(next), false, __ATOMIC_ACQ_REL,
                                       __ATOMIC_ACQUIRE);
}

struct captured *buffers_back(struct buffers *b)
{
    return &b->frames[order_of(read_state(b)).at[BACK]];
}

/* Publishes the writer's frame. The oldest middle frame becomes the writer's next one. */
void buffers_publish(struct buffers *b)
{
    uint32_t seen = read_state(b);
    struct order next;
    b->published = order_of(seen).at[BACK];
    do {
        const struct order now = order_of(seen);
        next = now;
        next.at[BACK] = now.at[FRONT - 1];
        for (unsigned i = NEWEST; i < FRONT; i++)
            next.at[i] = now.at[i - 1];
        next.fresh = now.fresh < BUFFERS_KEPT ? now.fresh + 1 : now.fresh;
        next.has_any = true;
    } while (!change(b, &seen, &next));
    syscall(SYS_futex, &b->state, FUTEX_WAKE, 1, NULL, NULL, 0);
}

const struct captured *buffers_published(const struct buffers *b)
{
    return order_of(read_state(b)).has_any ? &b->frames[b->published] : NULL;
}

/* The writer may change this data while it is read here. The state then also changes, so
 * buffers_take_one does not take the frame. */
struct fresh buffers_look(const struct buffers *b)
{
    struct fresh fresh;
    struct order now;
    fresh.state = read_state(b);
    now = order_of(fresh.state);
    fresh.count = now.fresh;
    for (size_t k = 0; k < now.fresh; k++) {
        const volatile struct captured *frame = &b->frames[now.at[NEWEST + k]];
        fresh.captured_ns[k] = frame->captured_ns;
        fresh.numbers[k] = frame->number;
    }
    return fresh;
}

/* Takes a frame. The older middle frames move up, and the reader's previous frame becomes the last
 * of them. */
const struct captured *buffers_take_one(struct buffers *b, const struct fresh *fresh, size_t k)
{
    uint32_t seen = fresh->state;
    const struct order now = order_of(seen);
    struct order next = now;
    next.at[FRONT] = now.at[NEWEST + k];
    for (size_t i = NEWEST + k; i < FRONT; i++)
        next.at[i] = now.at[i + 1];
    next.fresh = (uint32_t)k;
    return change(b, &seen, &next) ? &b->frames[next.at[FRONT]] : NULL;
}

const struct captured *buffers_take(struct buffers *b)
{
    for (;;) {
        const struct fresh fresh = buffers_look(b);
        const struct captured *frame;
        if (fresh.count == 0)
            return NULL;
        frame = buffers_take_one(b, &fresh, 0);
        if (frame != NULL)
            return frame;
    }
}

void buffers_wait(struct buffers *b, int wait_ms)
{
    const struct timespec wait = { wait_ms / 1000, (long)(wait_ms % 1000) * 1000000 };
    const uint32_t seen = read_state(b);
    if (order_of(seen).fresh == 0)
        syscall(SYS_futex, &b->state, FUTEX_WAIT, seen, &wait, NULL, 0);
}

struct frob_image *buffers_image(struct buffers *b)
{
    return &b->image;
}

void buffers_begin(struct buffers *b)
{
    __atomic_store_n(&b->begun, 1, __ATOMIC_RELAXED);
}

bool buffers_have_begun(const struct buffers *b)
{
    return __atomic_load_n(&b->begun, __ATOMIC_RELAXED) != 0;
}

void buffers_beat(struct buffers *b)
{
    __atomic_add_fetch(&b->beats, 1, __ATOMIC_RELAXED);
}

uint32_t buffers_beats(const struct buffers *b)
{
    return __atomic_load_n(&b->beats, __ATOMIC_RELAXED);
}
