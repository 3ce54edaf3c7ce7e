/* hal/status.h -- how a call to a device ended.
 *
 * Failures that are to be expected are values; a broken contract (a null
 * pointer, a device used before it was started) is not checked for. */
#ifndef FROB_HAL_STATUS_H
#define FROB_HAL_STATUS_H

#ifdef __cplusplus
extern "C" {
#endif

enum frob_status {
    FROB_OK,
    FROB_BUSY_CONNECTING, /* no failure: the robot is being connected to */
    FROB_TIMEOUT,         /* the other side did not take or give bytes in time */
    FROB_LOST,            /* the line is gone: hang-up, cable pulled, closed by the peer */
    FROB_NOT_FOUND,       /* there is no such device */
    FROB_DENIED,          /* it may not be opened */
    FROB_IN_USE,          /* another program holds it */
    FROB_UNSUPPORTED,     /* the port cannot do this: a rate, for example */
    FROB_REFUSED          /* the robot answered, but is not one that the driver can drive,
                             or left the mode in which it can be driven */
};

#ifdef __cplusplus
}
#endif
#endif
