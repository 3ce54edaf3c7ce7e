/* device.h -- shared by the files of the Pioneer driver: pioneer.c contains the driver's table and
 * calls connect.c and sense.c; all three call send.c. Unless stated otherwise here, a status has
 * the meaning defined in driver.h. */
#ifndef FROB_DRIVERS_PIONEER_DEVICE_H
#define FROB_DRIVERS_PIONEER_DEVICE_H

#include "drivers/pioneer/pioneer.h"
#include "drivers/pioneer/protocol.h"

/* connect.c: connects to a robot over an open line, and maintains the connection.
 * frob_pioneer_connect starts a new connection, frob_pioneer_connect_packet handles a packet that
 * has arrived, and frob_pioneer_connect_advance performs the step that is due. It returns
 * FROB_BUSY_CONNECTING until the robot can be commanded, FROB_TIMEOUT if the robot does not answer,
 * or no longer answers, and FROB_REFUSED if its model is unknown. */
void frob_pioneer_connect(struct frob_pioneer *d);
enum frob_status frob_pioneer_connect_packet(struct frob_pioneer *d,
                                             const struct frob_p2os_packet *packet);
enum frob_status frob_pioneer_connect_advance(struct frob_pioneer *d);

/* sense.c: converts a SIP to the robot's sensor readings. frob_pioneer_sense is the driver's
 * `sense`; it extrapolates odometry to the current time. */
void frob_pioneer_take_sip(struct frob_pioneer *d, const struct frob_p2os_sip *sip);
void frob_pioneer_sense(void *device, void *input);

/* send.c: sends raw bytes, a command, or a command with an argument. */
enum frob_status frob_pioneer_write(struct frob_pioneer *d, const uint8_t *bytes, size_t count);
enum frob_status frob_pioneer_send(struct frob_pioneer *d, uint8_t command);
enum frob_status frob_pioneer_send_int(struct frob_pioneer *d, uint8_t command, int32_t argument);

static const int64_t frob_pioneer_ms = INT64_C(1000000);

#endif
