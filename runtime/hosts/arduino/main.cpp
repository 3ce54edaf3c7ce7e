// The main program for a board with the Arduino framework: the robot is on Serial1, and
// human-readable messages go to Serial. `frobc export --platformio` copies this file.
//
// Nothing here supervises the loop. A step of a Frob program always ends, but C code that it calls
// may not. If your board has a timer, call loop_watch(now_ns(nullptr)) from its interrupt ten
// times a second, or use the board's watchdog.
#include <Arduino.h>

#include "hosts/board/loop.h"

static_assert(sizeof(double) == 8, "Frob needs 64-bit doubles, which this board does not have");

// micros() wraps around after 71 minutes, but it is read much more often.
static int64_t now_ns(void *)
{
    static uint32_t before = 0;
    static int64_t passed_us = 0;
    const uint32_t now = micros();
    passed_us += static_cast<uint32_t>(now - before);
    before = now;
    return passed_us * 1000;
}

static void sleep_until(void *, int64_t until_ns)
{
    while (now_ns(nullptr) < until_ns)
        yield();
}

static frob_status line_read(void *, uint8_t *bytes, size_t room, size_t *count)
{
    for (*count = 0; *count < room && Serial1.available() > 0;)
        bytes[(*count)++] = static_cast<uint8_t>(Serial1.read());
    return FROB_OK;
}

static frob_status line_write(void *, const uint8_t *bytes, size_t count)
{
    const int64_t until = now_ns(nullptr) + FROB_WRITE_PATIENCE_NS;
    for (size_t i = 0; i < count; ++i) {
        while (Serial1.availableForWrite() <= 0)
            if (now_ns(nullptr) >= until)
                return FROB_TIMEOUT;
        Serial1.write(bytes[i]);
    }
    return FROB_OK;
}

static frob_status line_wait(void *, int64_t until_ns)
{
    while (Serial1.available() <= 0) {
        if (now_ns(nullptr) >= until_ns)
            return FROB_TIMEOUT;
        yield();
    }
    return FROB_OK;
}

static frob_status line_set_rate(void *, uint32_t bits_per_s)
{
    Serial1.flush();
    Serial1.begin(bits_per_s);
    return FROB_OK;
}

static frob_status line_discard(void *)
{
    while (Serial1.available() > 0)
        Serial1.read();
    return FROB_OK;
}

static const frob_clock_operations clock_operations = { now_ns, sleep_until };
static const frob_serial_operations line_operations = { line_read, line_write, line_wait,
                                                        line_set_rate, line_discard };
static const frob_clock board_clock = { &clock_operations, nullptr };
static const frob_serial board_line = { &line_operations, nullptr };
static bool running = false;

void setup()
{
    const uint32_t rate = loop_line_rate();
    Serial.begin(115200);
    Serial1.begin(rate != 0 ? rate : 9600);
    const char *const why_not = loop_start(&board_line, &board_clock);
    running = why_not == nullptr;
    if (!running)
        Serial.println(why_not);
}

void loop()
{
    if (running)
        line_wait(nullptr, loop_round());
}
