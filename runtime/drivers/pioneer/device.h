/* device.h -- what the files of the Pioneer driver share. */
#ifndef FROB_DRIVERS_PIONEER_DEVICE_H
#define FROB_DRIVERS_PIONEER_DEVICE_H

#include "drivers/pioneer/pioneer.h"
#include "drivers/pioneer/protocol.h"

/* connect.c: from an open line to a robot that can be commanded. */
void frob_pioneer_connect(struct frob_pioneer *d);
enum frob_status frob_pioneer_connect_packet(struct frob_pioneer *d,
                                             const struct frob_p2os_packet *packet);
enum frob_status frob_pioneer_connect_advance(struct frob_pioneer *d);

/* sense.c: a SIP becomes what the robot senses. */
void frob_pioneer_take_sip(struct frob_pioneer *d, const struct frob_p2os_sip *sip);
void frob_pioneer_sense(void *device, void *input);

/* pioneer.c */
enum frob_status frob_pioneer_write(struct frob_pioneer *d, const uint8_t *bytes, size_t count);
enum frob_status frob_pioneer_send(struct frob_pioneer *d, uint8_t command);
enum frob_status frob_pioneer_send_int(struct frob_pioneer *d, uint8_t command, int32_t argument);

static const int64_t frob_pioneer_ms = INT64_C(1000000);

#endif
