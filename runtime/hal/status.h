/* hal/status.h -- the result of a call to a device.
 *
 * Expected failures are return values. A violated precondition (a null pointer, a device used
 * before it was started) is not detected. */
#ifndef FROB_HAL_STATUS_H
#define FROB_HAL_STATUS_H

#ifdef __cplusplus
extern "C" {
#endif

enum frob_status {
    FROB_OK,
    FROB_BUSY_CONNECTING, /* not a failure: still connecting to the robot */
    FROB_TIMEOUT,         /* the other side did not accept or send bytes in time */
    FROB_LOST,            /* the line is gone: hang-up, cable pulled, closed by the peer */
    FROB_NOT_FOUND,       /* no such device */
    FROB_DENIED,          /* no permission to open the device */
    FROB_IN_USE,          /* another program has the device open */
    FROB_UNSUPPORTED,     /* the port cannot do this; for example, it does not support this
                           * rate */
    /* The robot answered, but the driver cannot drive it, or the robot has left the mode in
     * which it can be driven. */
    FROB_REFUSED
};

#ifdef __cplusplus
}
#endif
#endif
