/* listener.h -- the socket that pages connect to.
 *
 * libwebsockets keeps accepting connections while any are waiting. Therefore a client that opens
 * connections fast enough prevents it from reading accepted connections, which locks out every
 * page. This listener accepts only a few connections at a time, and then lets the server read from
 * every connection that has sent data. */
#ifndef FROB_VIEW_LISTENER_H
#define FROB_VIEW_LISTENER_H

#define LISTENER_AT_ONCE 8

/* Listens on 127.0.0.1 at port `*port`; if that is 0, chooses a free port and stores it there.
 * Returns -1 with errno set on failure. */
int listener_open(int *port);

/* Accepts the next connection; returns -1 if none is waiting. */
int listener_accept(int listener);

#endif
