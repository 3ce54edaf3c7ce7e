/* loopback.h -- recognizes the names by which a computer addresses itself: `localhost`,
 * `127.0.0.1` and `[::1]`, with or without a port.
 *
 * A request for any other host name comes from a page of another site, whose name was made to
 * resolve to this computer (DNS rebinding). Any port is allowed, because a browser that connects
 * through `ssh -L` uses the port of its own end of the tunnel. */
#ifndef FROB_VIEW_LOOPBACK_H
#define FROB_VIEW_LOOPBACK_H

#include <stdbool.h>
#include <stddef.h>

/* Returns whether the header `Host` names this computer. The text is `length` bytes long and must
 * not contain a NUL. */
bool loopback_is_host(const char *text, size_t length);

/* Returns whether the header `Origin` names a page on this computer: `http://` followed by a host
 * that loopback_is_host accepts. */
bool loopback_is_origin(const char *text, size_t length);

#endif
