/* The main program for a Cortex-M board: the loop of hosts/board, the timer interrupt that watches
 * it, and a periodic status line for the user. */
#include "hal/cortex_m/board.h"
#include "hosts/board/loop.h"

#define TOLD_PERIOD_NS INT64_C(5000000000)

void board_on_fault(void)
{
    loop_stop();
    board_say("fault: sent a stop command to the robot\n");
    for (;;)
        __asm__ volatile("wfi");
}

static void say_number(const char *name, uint32_t number)
{
    char digits[12];
    size_t at = sizeof digits - 1;
    digits[at] = '\0';
    do {
        digits[--at] = (char)('0' + number % 10u);
        number /= 10u;
    } while (number > 0);
    board_say(name);
    board_say(digits + at);
}

static void tell(int64_t now_ns)
{
    static int64_t told_ns;
    struct loop_counts counts;
    if (now_ns - told_ns < TOLD_PERIOD_NS)
        return;
    told_ns = now_ns;
    counts = loop_count();
    say_number("time ", (uint32_t)(now_ns / 1000000000));
    say_number(" s, steps ", counts.steps);
    say_number(", overruns ", counts.overruns);
    say_number(", late ", counts.late);
    say_number(", stale ", counts.stale);
    say_number(", connections ", counts.connections);
    say_number(", stack ", (uint32_t)board_stack_used());
    board_say(" bytes\n");
}

int main(void)
{
    uint32_t rate = loop_line_rate();
    const char *why_not;
    board_clock_start(loop_watch);
    board_serial_open(rate != 0 ? rate : 9600);
    why_not = loop_start(&board_serial, &board_clock);
    if (why_not != NULL) {
        board_say(why_not);
        board_say("\n");
        return 1;
    }
    for (;;) {
        int64_t until = loop_round();
        tell(frob_now_ns(&board_clock));
        board_serial.operations->wait(board_serial.port, until);
    }
}
