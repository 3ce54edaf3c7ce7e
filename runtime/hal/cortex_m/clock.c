/* Computes the time from SysTick: milliseconds counted in its interrupt, and the timer's current
 * value. */
#include "hal/cortex_m/board.h"
#include "hal/cortex_m/registers.h"

#define TICK_CYCLES (BOARD_CLOCK_HZ / 1000u)
#define NS_PER_CYCLE (1000000000u / BOARD_CLOCK_HZ)
#define NS_PER_TICK INT64_C(1000000)

static volatile int64_t ticks_ns;
static void (*on_tick)(int64_t now_ns);

void board_on_tick(void)
{
    ticks_ns += NS_PER_TICK;
    if (on_tick != 0)
        on_tick(ticks_ns);
}

void board_clock_start(void (*tick)(int64_t now_ns))
{
    on_tick = tick;
    ticks_ns = 0;
    SYSTICK->reload = TICK_CYCLES - 1u;
    SYSTICK->value = 0;
    SYSTICK->control = 7;
}

/* A tick may occur between the two reads. Because interrupts are disabled, the tick remains
 * pending, and the function adds it. */
static int64_t now_ns(void *port)
{
    int64_t ticks;
    uint32_t left, mask;
    (void)port;
    __asm__ volatile("mrs %0, primask\n cpsid i" : "=r"(mask)::"memory");
    ticks = ticks_ns;
    left = SYSTICK->value;
    if ((ICSR & ICSR_SYSTICK_PENDING) != 0) {
        ticks += NS_PER_TICK;
        left = SYSTICK->value;
    }
    if (mask == 0)
        __asm__ volatile("cpsie i" ::: "memory");
    return ticks + (int64_t)(TICK_CYCLES - 1u - left) * NS_PER_CYCLE;
}

static void sleep_until(void *port, int64_t until_ns)
{
    while (now_ns(port) < until_ns)
        __asm__ volatile("wfi" ::: "memory");
}

static const struct frob_clock_operations operations = { now_ns, sleep_until };

const struct frob_clock board_clock = { &operations, 0 };
