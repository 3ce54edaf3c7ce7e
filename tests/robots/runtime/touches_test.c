/* Tests the delivery of keys to a program, in virtual time: the linker replaces clock_gettime. A
 * second key waits for the next instant, unless the host was frozen in between. */
#include "touches.h"

#include <stdio.h>
#include <string.h>
#include <time.h>

static int failures;
static int64_t now_ns = 1000000000;

int __wrap_clock_gettime(clockid_t clock, struct timespec *to);
int __wrap_clock_gettime(clockid_t clock, struct timespec *to)
{
    (void)clock;
    to->tv_sec = (time_t)(now_ns / 1000000000);
    to->tv_nsec = (long)(now_ns % 1000000000);
    return 0;
}

int32_t console_key(struct console *console)
{
    (void)console;
    return -1;
}

void frob_console_key(const struct frob_program *program, void *input, int32_t key)
{
    (void)program, (void)input, (void)key;
}

bool frob_console_touch(const struct frob_program *program, void *input, size_t control, double x,
                        double y)
{
    (void)program, (void)input, (void)control, (void)x, (void)y;
    return false;
}

static void check(const char *name, bool ok)
{
    printf("%s %s\n", ok ? "ok" : "FAIL", name);
    failures += !ok;
}

static void send_keys(struct ring *ring, const char *keys)
{
    struct ring_event event;
    memset(&event, 0, sizeof event);
    event.kind = RING_KEY;
    for (; *keys != '\0'; keys++) {
        event.id = (uint32_t)*keys;
        check("an event is sent", ring_send(ring, &event));
    }
}

static int32_t key_after(struct touches *touches, struct ring *ring, int64_t passed_ns)
{
    now_ns += passed_ns;
    touches_take(touches, NULL, ring);
    return touches->key;
}

int main(void)
{
    static const struct ring_sizes sizes = { 8, 8, 0 };
    static struct frob_program program;
    const int64_t instant_ns = 20000000, freeze_ns = 2 * RING_PATIENCE_NS;
    struct ring ring;
    struct touches touches;
    if (!ring_make(&ring, &sizes, ~0u) || !touches_start(&touches, &program))
        return 1;
    check("nothing was pressed", key_after(&touches, &ring, instant_ns) == -1);
    send_keys(&ring, "abc");
    check("the first key comes at the next instant", key_after(&touches, &ring, instant_ns) == 'a');
    check("the second waits for one more", key_after(&touches, &ring, instant_ns) == 'b');
    check("none is late", ring_late(&ring) == 0);
    check("after a freeze none comes", key_after(&touches, &ring, freeze_ns) == -1);
    check("which is counted", ring_late(&ring) == 1);
    send_keys(&ring, "de");
    check("later keys come", key_after(&touches, &ring, instant_ns) == 'd');
    now_ns += freeze_ns;
    ring_publish(&ring, 0, "input..", "output.", NULL);
    check("a freeze before the instant is published counts as well",
          key_after(&touches, &ring, instant_ns) == -1 && ring_late(&ring) == 2);
    check("and is over then", key_after(&touches, &ring, instant_ns) == -1);
    touches_end(&touches);
    ring_close(&ring);
    return failures > 0;
}
