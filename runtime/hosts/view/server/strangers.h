/* strangers.h -- connections that have not presented the token.
 *
 * Any user of this computer can open connections. They must not lock out the operator, so the
 * number of such connections is limited, and a connection beyond the limit replaces the one that
 * has been idle longest. A page presents the token in its first request, so it is a stranger for
 * about a millisecond. To displace it, an attacker must open more connections in that time than the
 * limit allows. */
#ifndef FROB_VIEW_STRANGERS_H
#define FROB_VIEW_STRANGERS_H

#include <stddef.h>

struct lws;

/* Maximum number of strangers: a large multiple of LISTENER_AT_ONCE (listener.h). */
#define STRANGERS 256

struct strangers {
    struct lws *each[STRANGERS]; /* the connections; the one that has been idle longest is first */
    size_t count;
};

/* Closes the connection that has been idle longest. */
void strangers_end_one(struct strangers *strangers);

/* Registers a new connection. */
void strangers_add(struct strangers *strangers, struct lws *wsi);

/* Records that a connection has sent or received data. Does nothing if it is not a stranger. */
void strangers_hear(struct strangers *strangers, struct lws *wsi);

/* Removes a connection that has presented the token or was closed. Does nothing if it is not a
 * stranger. */
void strangers_remove(struct strangers *strangers, struct lws *wsi);

#endif
