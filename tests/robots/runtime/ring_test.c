/* Tests the ring of instants with a writer at full speed and a reader in another process. The
 * reader must never see a torn instant, the same one twice, or instants out of order; it must
 * learn when an instant is too old. */
#include "ring.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

enum { WORDS = 97, ODD = 5, INSTANTS = 400000 };

static int failures;

static void check(const char *name, bool ok)
{
    printf("%s %s\n", ok ? "ok" : "FAIL", name);
    failures += !ok;
}

/* Fills an instant with words computed from its number. */
static void fill(uint64_t *words, uint64_t k)
{
    for (uint64_t i = 0; i < WORDS; i++)
        words[i] = k * UINT64_C(0x9e3779b97f4a7c15) + i;
}

static bool is_of(const uint64_t *words, uint64_t k)
{
    uint64_t expected[WORDS];
    fill(expected, k);
    return memcmp(words, expected, sizeof expected) == 0;
}

static void write_all(struct ring *ring)
{
    uint64_t input[WORDS];
    unsigned char output[ODD];
    for (uint64_t k = 0; k < INSTANTS; k++) {
        fill(input, k);
        memset(output, (int)(k % 251), sizeof output);
        ring_publish(ring, (int64_t)k * 7, input, output, &k);
    }
    ring_end(ring, RING_AT_REST);
}

struct seen {
    uint64_t read, torn, overwritten;
};

/* Reads instants in order; after falling behind, continues with the newest. */
static struct seen read_all(const struct ring *ring)
{
    struct seen seen = { 0, 0, 0 };
    for (uint64_t k = 0; k < INSTANTS;) {
        uint64_t input[WORDS], truth = 0;
        unsigned char output[ODD];
        int64_t time_ns;
        switch (ring_read(ring, k, &time_ns, input, output, &truth)) {
        case RING_READ:
            seen.read++;
            seen.torn += !is_of(input, k) || truth != k || time_ns != (int64_t)k * 7 ||
                         output[0] != k % 251 || output[ODD - 1] != k % 251;
            k++;
            break;
        case RING_OVERWRITTEN:
            seen.overwritten++;
            k = ring_count(ring) - 1;
            break;
        case RING_NOT_YET: break;
        }
    }
    return seen;
}

static void try_instants(void)
{
    const struct ring_sizes sizes = { WORDS * sizeof(uint64_t), ODD, sizeof(uint64_t) };
    struct ring ring, reader;
    struct seen seen;
    pid_t writer;
    check("a ring is made", ring_make(&ring, &sizes, RING_PACES));
    check("it takes at most 4 MB", ring.size <= (4u << 20) + 8192);
    check("it is attached", ring_attach(&reader, dup(ring.file)));
    check("with its permissions",
          ring_permits(&reader, RING_PACES) && !ring_permits(&reader, RING_SENDS));
    check("and its sizes", memcmp(&reader.sizes, &sizes, sizeof sizes) == 0);
    fflush(stdout);
    writer = fork();
    if (writer == 0) {
        write_all(&ring);
        _exit(0);
    }
    seen = read_all(&reader);
    waitpid(writer, NULL, 0);
    check("instants are read", seen.read > 0 && seen.read <= INSTANTS);
    check("none of them torn", seen.torn == 0);
    check("its end is told", ring_has_ended(&reader) && ring_count(&reader) == INSTANTS);
    {
        uint64_t input[WORDS], truth;
        unsigned char output[ODD];
        int64_t time_ns;
        check("the first is gone",
              ring_read(&reader, 0, &time_ns, input, output, &truth) == RING_OVERWRITTEN);
        check("and there is none after the last",
              ring_read(&reader, INSTANTS, &time_ns, input, output, &truth) == RING_NOT_YET);
    }
    ring_close(&reader);
    ring_close(&ring);
}

static void try_words(void)
{
    const struct ring_sizes sizes = { 8, 8, 0 };
    struct ring ring, reader;
    struct ring_event event = { RING_KEY, 0, 0.0, 0.0 };
    uint32_t sent = 0, taken = 0;
    bool in_order = true;
    check("a small one is made", ring_make(&ring, &sizes, RING_SENDS));
    check("and attached", ring_attach(&reader, dup(ring.file)));
    check("nothing is stopped at first",
          !ring_is_stopped(&ring) && !ring_pace(&ring).paused && ring_pace(&ring).speed == 1.0);
    ring_pause(&reader, true);
    ring_step(&reader);
    ring_set_speed(&reader, 0.25);
    ring_beat(&reader);
    check("the host sees how it is to go on",
          ring_pace(&ring).paused && ring_pace(&ring).steps == 1 &&
              ring_pace(&ring).speed == 0.25 && ring_pace(&ring).beats == 1);
    ring_set_speed(&reader, 4e6);
    check("no speed is out of range", ring_pace(&ring).speed == RING_MOST_SPEED);
    ring_stop(&reader);
    check("and a stop", ring_is_stopped(&ring));
    check("no event waits at first", !ring_take(&ring, &event));
    for (event.id = 0; ring_send(&reader, &event); event.id = ++sent)
        continue;
    check("so many events wait", sent == RING_EVENTS);
    for (; ring_take(&ring, &event); taken++)
        in_order = in_order && event.id == taken && event.kind == RING_KEY;
    check("and are taken in order", taken == sent && in_order);
    check("then there is room again", ring_send(&reader, &event) && ring_take(&ring, &event));
    ring_close(&reader);
    ring_close(&ring);
}

static void try_strangers(void)
{
    struct ring ring;
    FILE *file = tmpfile();
    check("a file that is none is refused", file != NULL && !ring_attach(&ring, fileno(file)));
    if (file != NULL && ftruncate(fileno(file), 1 << 16) == 0)
        check("zeros are refused", !ring_attach(&ring, dup(fileno(file))));
    check("no file is refused", !ring_attach(&ring, -1));
}

int main(void)
{
    try_instants();
    try_words();
    try_strangers();
    return failures > 0;
}
