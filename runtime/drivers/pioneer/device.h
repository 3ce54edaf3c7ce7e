/* device.h -- what the files of the Pioneer driver share: pioneer.c, the driver's
 * table, calls connect.c and sense.c, and all that has something to say send.c.
 * A status is the line's, as driver.h says, but where more is said here. */
#ifndef FROB_DRIVERS_PIONEER_DEVICE_H
#define FROB_DRIVERS_PIONEER_DEVICE_H

#include "drivers/pioneer/pioneer.h"
#include "drivers/pioneer/protocol.h"

/* connect.c: from an open line to a robot that can be commanded, and on. Begins
 * anew; takes a packet that has arrived; does what the time asks for. The last one
 * is FROB_BUSY_CONNECTING until the robot can be commanded, FROB_TIMEOUT if none
 * answers, or none any more, FROB_REFUSED if it is of no known model. */
void frob_pioneer_connect(struct frob_pioneer *d);
enum frob_status frob_pioneer_connect_packet(struct frob_pioneer *d,
                                             const struct frob_p2os_packet *packet);
enum frob_status frob_pioneer_connect_advance(struct frob_pioneer *d);

/* sense.c: a SIP becomes what the robot senses. The second one is the driver's
 * `sense`, with odometry carried on to now. */
void frob_pioneer_take_sip(struct frob_pioneer *d, const struct frob_p2os_sip *sip);
void frob_pioneer_sense(void *device, void *input);

/* send.c: bytes as they are, a command, and a command with its argument. */
enum frob_status frob_pioneer_write(struct frob_pioneer *d, const uint8_t *bytes, size_t count);
enum frob_status frob_pioneer_send(struct frob_pioneer *d, uint8_t command);
enum frob_status frob_pioneer_send_int(struct frob_pioneer *d, uint8_t command, int32_t argument);

static const int64_t frob_pioneer_ms = INT64_C(1000000);

#endif
