/* What core/robot.h promises to drivers, with a driver that does nothing else. */
#include "check.h"

#include "core/robot.h"
#include "hal/fake/fake.h"

#include <string.h>

/* A driver that keeps the addresses that it is given, as it may. */
struct keeper {
    const struct frob_serial *serial;
    const struct frob_clock *clock;
};

static void start(void *device, const double *settings, const struct frob_serial *serial,
                  const struct frob_clock *clock)
{
    struct keeper *k = (struct keeper *)device;
    (void)settings;
    k->serial = serial;
    k->clock = clock;
}

static enum frob_status poll(void *device)
{
    struct keeper *k = (struct keeper *)device;
    const uint8_t zero = 'z';
    (void)frob_now_ns(k->clock);
    return k->serial->operations->write(k->serial->port, &zero, 1);
}

static int64_t sensed_ns(const void *device)
{
    (void)device;
    return INT64_MIN;
}

static enum frob_status stop(void *device)
{
    (void)device;
    return FROB_OK;
}

static const struct frob_driver driver = { .robot = "keeper",
                                           .rate = 9600,
                                           .device_size = sizeof(struct keeper),
                                           .start = start,
                                           .poll = poll,
                                           .sensed_ns = sensed_ns,
                                           .stop = stop };

static void line_and_clock_stay(void)
{
    static struct frob_fake_clock now;
    static struct frob_fake_line line;
    static struct frob_robot robot;
    struct keeper device = { NULL, NULL };
    now.now_ns = 1000;
    frob_fake_line_open(&line, &now);
    {
        struct frob_serial serial = frob_fake_serial(&line);
        struct frob_clock clock = frob_fake_time(&now);
        frob_robot_start(&robot, &driver, &device, NULL, &serial, &clock, 100);
        memset(&serial, 0, sizeof serial);
        memset(&clock, 0, sizeof clock);
    }
    check(frob_robot_poll(&robot) != FROB_ROBOT_FAILED && device.serial->port != NULL &&
              device.clock->operations != NULL,
          "the line and the clock that a driver is given stay");
}

int main(void)
{
    line_and_clock_stay();
    return check_status();
}
