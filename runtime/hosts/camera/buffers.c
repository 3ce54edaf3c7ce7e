#include "buffers.h"

#include <linux/futex.h>
#include <sys/mman.h>
#include <sys/syscall.h>
#include <time.h>
#include <unistd.h>

enum { COUNT = 3, FRESH = 0x40, ANY = 0x80 };

/* Which frame is whose: two bits each, see `parts`. */
struct buffers {
    uint32_t state;
    uint32_t beats, begun;
    struct frob_image image;
    uint32_t published; /* the frame that was published last */
    struct captured frames[COUNT];
};

struct parts {
    uint32_t back, middle, front;
};

static struct parts parts_of(uint32_t state)
{
    const struct parts p = { state & 3u, state >> 2 & 3u, state >> 4 & 3u };
    return p;
}

static uint32_t state_of(struct parts p, uint32_t flags)
{
    return p.back | p.middle << 2 | p.front << 4 | flags;
}

struct buffers *buffers_make(void)
{
    static const struct parts first = { 0, 1, 2 };
    const size_t size = sizeof(struct buffers) + COUNT * BUFFERS_ROOM;
    void *memory = mmap(NULL, size, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    struct buffers *b = (struct buffers *)memory;
    if (memory == MAP_FAILED)
        return NULL;
    b->state = state_of(first, 0);
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

static bool change(struct buffers *b, uint32_t *seen, uint32_t next)
{
    return __atomic_compare_exchange_n(&b->state, seen, next, false, __ATOMIC_ACQ_REL,
                                       __ATOMIC_ACQUIRE);
}

struct captured *buffers_back(struct buffers *b)
{
    return &b->frames[parts_of(read_state(b)).back];
}

void buffers_publish(struct buffers *b)
{
    uint32_t seen = read_state(b);
    struct parts next;
    b->published = parts_of(seen).back;
    do {
        const struct parts now = parts_of(seen);
        next = now;
        next.back = now.middle;
        next.middle = now.back;
    } while (!change(b, &seen, state_of(next, FRESH | ANY)));
    syscall(SYS_futex, &b->state, FUTEX_WAKE, 1, NULL, NULL, 0);
}

const struct captured *buffers_published(const struct buffers *b)
{
    return (read_state(b) & ANY) != 0 ? &b->frames[b->published] : NULL;
}

const struct captured *buffers_take(struct buffers *b)
{
    uint32_t seen = read_state(b);
    struct parts next;
    do {
        const struct parts now = parts_of(seen);
        if ((seen & FRESH) == 0)
            return NULL;
        next = now;
        next.front = now.middle;
        next.middle = now.front;
    } while (!change(b, &seen, state_of(next, ANY)));
    return &b->frames[next.front];
}

void buffers_wait(struct buffers *b, int wait_ms)
{
    const struct timespec wait = { wait_ms / 1000, (long)(wait_ms % 1000) * 1000000 };
    const uint32_t seen = read_state(b);
    if ((seen & FRESH) == 0)
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
