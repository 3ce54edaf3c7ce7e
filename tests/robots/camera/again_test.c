/* Tests how soon a camera delivers frames again after a failure, in virtual time, with thousands
 * of random failures of each kind. When the camera works again, the program must get a frame
 * within two seconds. The capturing code (runtime/hosts/camera/capture.c) is the real one; its
 * source and its clock are simulated. */
#include <stdlib.h>

#include "../drivers/check.h"
#include "hosts/camera/capture.c" /* included to call its steps one by one */

#define MS INT64_C(1000000)
#define WITHIN_NS (2000 * MS)

static int64_t now_ns;

int64_t source_now_ns(void)
{
    return now_ns;
}

void source_sleep_until_ns(int64_t until_ns)
{
    if (until_ns > now_ns)
        now_ns = until_ns;
}

/* ---- The simulated source */

enum matter {
    GOOD,
    UNPLUGGED, /* the device has disappeared, so its open descriptor is dead */
    /* the open descriptor stays silent forever; trying to open it again takes a second and fails */
    CUT_OFF,
    SILENT, /* no data while this lasts */
    FROZEN,
    DAMAGED,
    WRONG_SIZE,
    MATTERS
};

static const char *const names[MATTERS] = { "",       "unplugged", "cut off",   "silent",
                                            "frozen", "damaged",   "wrong size" };

static enum matter matter;  /* the current failure … */
static int64_t until_ns;    /* … and when it ends and the next one begins */
static int64_t well_ns;     /* since when the camera has worked */
static uint32_t cuts;       /* how often an open descriptor has been lost forever … */
static bool is_mute;        /* … and whether it reports no error then */
static uint32_t opened_cut; /* the value of `cuts` when it was opened */
static int64_t due_ns, period_ns;
static uint8_t shade;
static uint32_t random_state;

static uint32_t random_below(uint32_t n)
{
    random_state ^= random_state << 13;
    random_state ^= random_state >> 17;
    random_state ^= random_state << 5;
    return random_state % n;
}

/* Advances to the state at the current time. */
static void live(void)
{
    while (now_ns >= until_ns) {
        if (matter == GOOD) {
            matter = (enum matter)(1 + random_below(MATTERS - 1));
            until_ns += (100 + random_below(8000)) * MS;
            cuts += matter == UNPLUGGED || matter == CUT_OFF;
            is_mute = matter == CUT_OFF;
        } else {
            matter = GOOD;
            well_ns = until_ns;
            /* sometimes the camera fails again soon */
            until_ns += (random_below(3) == 0 ? 20 + random_below(500) : 4000) * MS;
        }
    }
}

static bool open_it(struct source *s)
{
    now_ns += (10 + random_below(300)) * MS;
    live();
    if (matter == CUT_OFF)
        now_ns += 1000 * MS;
    opened_cut = cuts;
    due_ns = now_ns;
    if (matter != UNPLUGGED && matter != CUT_OFF)
        return true;
    source_fail(s, SOURCE_FAULT, "away");
    return false;
}

static enum source_result next_of(struct source *s, struct captured *frame, int wait_ms)
{
    live();
    if (matter == UNPLUGGED || (opened_cut != cuts && !is_mute))
        return source_fail(s, SOURCE_FAULT, "gone");
    if (opened_cut != cuts || matter == SILENT || due_ns > now_ns + wait_ms * MS) {
        now_ns += wait_ms * MS;
        return SOURCE_NOTHING;
    }
    source_sleep_until_ns(due_ns);
    due_ns += period_ns;
    if (matter == DAMAGED)
        return source_fail(s, SOURCE_BROKEN, "damaged");
    shade += matter != FROZEN;
    frame->width = matter == WRONG_SIZE ? 16 : 8;
    frame->height = 8;
    frame->format = FROB_GREY8;
    frame->captured_ns = now_ns;
    frame->has_camera = false;
    memset(frame->pixels, shade, (size_t)(frame->width * frame->height));
    return SOURCE_FRAME;
}

static void close_it(struct source *s)
{
    s->state = NULL;
}

const struct source_kind *source_kind_of(const char *name)
{
    static const struct source_kind kind = { open_it, next_of, close_it, true, "silent" };
    (void)name;
    return &kind;
}

enum source_result source_fail(struct source *s, enum source_result result, const char *format, ...)
{
    snprintf(s->fault, sizeof s->fault, "%s", format);
    return result;
}

/* ---- Other functions that capture.c calls, not needed here */

struct frob_camera camera_geometry(const struct camera_options *o, int32_t width, int32_t height)
{
    const struct frob_camera none = { 0 };
    (void)o, (void)width, (void)height;
    return none;
}

void tagger_run(struct tag_finder *finder, struct buffers *seen, struct buffers *given)
{
    (void)finder, (void)seen, (void)given;
    abort();
}

/* ---- The test */

static void hear(int socket)
{
    struct capture_report heard;
    while (recv(socket, &heard, sizeof heard, MSG_DONTWAIT) > 0)
        ;
}

/* Simulates an hour of failures; records, for each kind of failure, the longest time until a
 * frame came. */
static void an_hour(uint32_t seed, int64_t longest_ns[MATTERS], int counts[MATTERS])
{
    struct camera_options options;
    const struct capture_way way = { buffers_make(), NULL, NULL };
    struct capture c;
    int sockets[2];
    enum matter before = GOOD; /* the last failure; GOOD if a frame has come since */
    memset(&options, 0, sizeof options);
    options.settings[CAMERA_FROZEN] = 1.0;
    memset(&c, 0, sizeof c);
    random_state = seed;
    now_ns = 1000 * MS;
    matter = GOOD;
    well_ns = now_ns;
    until_ns = now_ns + 2000 * MS;
    period_ns = (10 + random_below(150)) * MS;
    if (socketpair(AF_UNIX, SOCK_SEQPACKET, 0, sockets) != 0)
        abort();
    c.options = c.source.options = &options;
    c.way = &way;
    c.buffers = way.seen;
    c.socket = sockets[0];
    while (now_ns < 3600 * 1000 * MS) {
        const uint32_t number = c.number;
        step(&c);
        hear(sockets[1]);
        live();
        if (matter != GOOD) {
            before = matter;
        } else if (before != GOOD && (c.number != number || now_ns - well_ns > WITHIN_NS)) {
            const int64_t took = now_ns - well_ns;
            counts[before]++;
            if (took > longest_ns[before])
                longest_ns[before] = took;
            before = GOOD;
        }
    }
    close(sockets[0]);
    close(sockets[1]);
    buffers_free(way.seen);
}

int main(void)
{
    int64_t longest_ns[MATTERS] = { 0 };
    int counts[MATTERS] = { 0 };
    for (uint32_t seed = 1; seed <= 20; seed++)
        an_hour(seed, longest_ns, counts);
    for (int k = GOOD + 1; k < MATTERS; k++) {
        char text[80];
        snprintf(text, sizeof text, "delivers frames again within two seconds, after it was %s",
                 names[k]);
        check(counts[k] > 100 && longest_ns[k] <= WITHIN_NS, text);
        if (longest_ns[k] > WITHIN_NS)
            printf("     %.3f s, and more\n", (double)longest_ns[k] / 1e9);
    }
    return check_status();
}
