/* Tests that the viewer of a live run knows whether the host has published more instants than it
 * has read, so that it does not wait before it reads them. */
#include "common/ring.h"
#include "view/run/live.h"

#include <stdio.h>
#include <string.h>

enum { INSTANTS = 1500, AT_ONCE = 1000 };

static int failures;

static void check(const char *name, bool ok)
{
    printf("%s %s\n", ok ? "ok" : "FAIL", name);
    failures += !ok;
}

static const struct frob_constructor nothing = { "Nothing", 0, 0, NULL };
static const struct frob_value record = { FROB_PRODUCT, 0, 0, 1, &nothing };

int main(void)
{
    const struct ring_sizes sizes = { 8, 8, 0 };
    const double value = 1.0;
    struct frob_program program;
    struct signals signals;
    struct recording recording;
    struct ring ring;
    struct live live;
    memset(&program, 0, sizeof program);
    program.input_size = program.output_size = 8;
    program.input = program.output = &record;
    if (!ring_make(&ring, &sizes, 0) || !signals_start(&signals, &program, NULL) ||
        !live_start(&live, &ring, NULL, &signals, &recording))
        return 1;
    for (int64_t k = 0; k < INSTANTS; k++)
        ring_publish(&ring, k, &value, &value, NULL);
    check("some instants are read", live_take(&live, AT_ONCE) && recording.count == AT_ONCE);
    check("the viewer is behind", live.is_behind);
    check("the others are read", live_take(&live, AT_ONCE) && recording.count == INSTANTS);
    check("the viewer is no longer behind", !live.is_behind);
    live_end(&live);
    recording_free(&recording);
    signals_end(&signals);
    ring_close(&ring);
    return failures > 0;
}
