/* UART 0 of the Cortex-M System Design Kit. It buffers a single byte in each direction, so the
 * receive interrupt fills a ring. */
#include "hal/cortex_m/board.h"
#include "hal/cortex_m/registers.h"

enum { TRANSMITTER_FULL = 1, RECEIVER_FULL = 2 };
enum { TRANSMIT = 1, RECEIVE = 2, RECEIVE_INTERRUPT = 8 };
enum { RING = 1024 }; /* a power of two, large enough for any packet of any robot */

/* Only the interrupt handler changes `end`, and only the program changes `start`. */
static struct {
    volatile uint8_t bytes[RING];
    volatile uint32_t start, end;
} ring;

/* Clears the interrupt first, so that a byte that arrives after the last check raises it again. If
 * it were cleared last, that byte's interrupt would be lost, and the receiver, which would then be
 * full, would never raise another. */
void board_on_receive(void)
{
    UART_0->interrupt = RECEIVER_FULL;
    while ((UART_0->state & RECEIVER_FULL) != 0) {
        uint8_t byte = (uint8_t)UART_0->data;
        if (ring.end - ring.start < RING) {
            ring.bytes[ring.end % RING] = byte;
            ring.end = ring.end + 1u;
        }
    }
}

void board_serial_open(uint32_t bits_per_s)
{
    UART_0->divider = BOARD_CLOCK_HZ / bits_per_s;
    UART_0->control = TRANSMIT | RECEIVE | RECEIVE_INTERRUPT;
    UART_1->divider = BOARD_CLOCK_HZ / 115200u;
    UART_1->control = TRANSMIT;
    NVIC_ENABLE = 1u << UART_0_RECEIVE_INTERRUPT;
}

static enum frob_status line_read(void *port, uint8_t *bytes, size_t room, size_t *count)
{
    (void)port;
    for (*count = 0; *count < room && ring.start != ring.end; ring.start = ring.start + 1u)
        bytes[(*count)++] = ring.bytes[ring.start % RING];
    return FROB_OK;
}

static enum frob_status line_write(void *port, const uint8_t *bytes, size_t count)
{
    int64_t until = frob_now_ns(&board_clock) + FROB_WRITE_PATIENCE_NS;
    (void)port;
    for (size_t i = 0; i < count; i++) {
        while ((UART_0->state & TRANSMITTER_FULL) != 0)
            if (frob_now_ns(&board_clock) >= until)
                return FROB_TIMEOUT;
        UART_0->data = bytes[i];
    }
    return FROB_OK;
}

/* Any interrupt ends the sleep, and the timer raises one every millisecond. */
static enum frob_status line_wait(void *port, int64_t until_ns)
{
    (void)port;
    while (ring.start == ring.end) {
        if (frob_now_ns(&board_clock) >= until_ns)
            return FROB_TIMEOUT;
        __asm__ volatile("wfi" ::: "memory");
    }
    return FROB_OK;
}

static enum frob_status line_set_rate(void *port, uint32_t bits_per_s)
{
    int64_t until = frob_now_ns(&board_clock) + FROB_WRITE_PATIENCE_NS;
    (void)port;
    if (bits_per_s == 0 || BOARD_CLOCK_HZ / bits_per_s < 16u)
        return FROB_UNSUPPORTED;
    while ((UART_0->state & TRANSMITTER_FULL) != 0 && frob_now_ns(&board_clock) < until)
        continue;
    UART_0->divider = BOARD_CLOCK_HZ / bits_per_s;
    return FROB_OK;
}

static enum frob_status line_discard(void *port)
{
    (void)port;
    ring.start = ring.end;
    return FROB_OK;
}

static const struct frob_serial_operations operations = { line_read, line_write, line_wait,
                                                          line_set_rate, line_discard };

const struct frob_serial board_serial = { &operations, 0 };

void board_say(const char *text)
{
    for (; *text != '\0'; text++) {
        int64_t until = frob_now_ns(&board_clock) + FROB_WRITE_PATIENCE_NS;
        while ((UART_1->state & TRANSMITTER_FULL) != 0)
            if (frob_now_ns(&board_clock) >= until)
                return;
        UART_1->data = (uint8_t)*text;
    }
}
