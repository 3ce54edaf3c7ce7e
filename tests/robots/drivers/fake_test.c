/* Tests the in-memory line and its clock, on which the drivers are tested. */
#include "check.h"

#include "hal/fake/fake.h"
#include "hal/template/template.h"

#include <string.h>

static struct frob_fake_clock time_now;
static struct frob_fake_line line;

static void start(struct frob_serial *serial)
{
    time_now.now_ns = 1000;
    frob_fake_line_open(&line, &time_now);
    *serial = frob_fake_serial(&line);
}

static void bytes_arrive_when_due(void)
{
    struct frob_serial s;
    uint8_t bytes[8];
    size_t count = 9;
    start(&s);
    frob_fake_send(&line, (const uint8_t *)"ab", 2, 500);
    frob_fake_send(&line, (const uint8_t *)"c", 1, 0);
    check(s.operations->read(s.port, bytes, sizeof bytes, &count) == FROB_OK && count == 0,
          "bytes on their way are not read");
    check(s.operations->wait(s.port, 1200) == FROB_TIMEOUT && time_now.now_ns == 1200,
          "waiting ends at its time");
    check(s.operations->wait(s.port, 9000) == FROB_OK && time_now.now_ns == 1500,
          "waiting ends when bytes arrive");
    check(s.operations->read(s.port, bytes, sizeof bytes, &count) == FROB_OK && count == 3 &&
              memcmp(bytes, "abc", 3) == 0,
          "bytes do not overtake each other");
}

static void faults_show(void)
{
    struct frob_serial s;
    uint8_t bytes[8];
    size_t count;
    start(&s);
    line.blocked = true;
    check(s.operations->write(s.port, (const uint8_t *)"x", 1) == FROB_TIMEOUT,
          "a line without room times out");
    line.blocked = false;
    check(s.operations->write(s.port, (const uint8_t *)"xy", 2) == FROB_OK &&
              frob_fake_receive(&line, bytes, sizeof bytes) == 2 && memcmp(bytes, "xy", 2) == 0,
          "the test reads what was written");
    line.refuses_rates = true;
    check(s.operations->set_rate(s.port, 9600) == FROB_UNSUPPORTED, "a rate may be unsupported");
    line.refuses_rates = false;
    line.fastest = 9600;
    check(s.operations->set_rate(s.port, 38400) == FROB_UNSUPPORTED &&
              s.operations->set_rate(s.port, 9600) == FROB_OK,
          "or those beyond one");
    line.lost = true;
    check(s.operations->read(s.port, bytes, sizeof bytes, &count) == FROB_LOST && count == 0 &&
              s.operations->write(s.port, bytes, 1) == FROB_LOST &&
              s.operations->wait(s.port, 5000) == FROB_LOST,
          "a lost line is lost to every call");
}

static void template_links(void)
{
    size_t count = 1;
    uint8_t byte;
    frob_template_clock_start();
    check(frob_template_serial_open(9600) == FROB_OK &&
              frob_template_serial.operations->read(frob_template_serial.port, &byte, 1, &count) ==
                  FROB_OK &&
              count == 0 && frob_now_ns(&frob_template_clock) == 0,
          "the template port compiles and links");
    frob_template_clock.operations->sleep_until(frob_template_clock.port, 7);
    check(frob_now_ns(&frob_template_clock) == 7, "the template's time passes");
}

int main(void)
{
    bytes_arrive_when_due();
    faults_show();
    template_links();
    return check_status();
}
