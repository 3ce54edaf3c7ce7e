/* Sends bytes and packets to the robot. */
#include "drivers/pioneer/device.h"

enum frob_status frob_pioneer_write(struct frob_pioneer *d, const uint8_t *bytes, size_t count)
{
    return d->serial.operations->write(d->serial.port, bytes, count);
}

enum frob_status frob_pioneer_send(struct frob_pioneer *d, uint8_t command)
{
    uint8_t packet[FROB_P2OS_COMMAND_MOST];
    return frob_pioneer_write(d, packet, frob_p2os_command(packet, command));
}

enum frob_status frob_pioneer_send_int(struct frob_pioneer *d, uint8_t command, int32_t argument)
{
    uint8_t packet[FROB_P2OS_COMMAND_MOST];
    return frob_pioneer_write(d, packet, frob_p2os_command_int(packet, command, argument));
}
