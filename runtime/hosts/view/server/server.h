/* server.h -- serves the page, and answers its requests over a WebSocket.
 *
 * It listens only on 127.0.0.1. Requests must name this computer as their host and come from a page
 * on this computer (loopback.h). The server answers a page only after the page has presented the
 * token, either in the query of the WebSocket's address or in its first message, `hello TOKEN`. At
 * most SERVER_CLIENTS pages are served at a time. Connections that have not presented the token do
 * not count towards this limit (strangers.h).
 *
 * The server sends `beat` to each page ten times a second, whatever else it is doing. The beat
 * shows that the viewer is alive, and states how long the host of a run has been silent. */
#ifndef FROB_VIEW_SERVER_H
#define FROB_VIEW_SERVER_H

#include "../answers/view.h"

#define SERVER_CLIENTS 4
#define SERVER_MESSAGE 65536 /* maximum length of a request, in bytes */
#define SERVER_PENDING 64    /* maximum number of pending requests of a page */
#define SERVER_PATIENCE 5    /* maximum time, in seconds, to present the token */
/* Once a run is over, the viewer exits after this many seconds without a connected page:
 * SERVER_LINGERS before the first page connects (no limit if there is a terminal), and
 * SERVER_RELOADS after that, which leaves time to reload a page. */
#define SERVER_LINGERS 5
#define SERVER_RELOADS 2
#define SERVER_ENDS 2              /* maximum time for shutting down, in seconds */
#define SERVER_FAREWELL 3          /* number of beats that tell pages how a run ended */
#define SERVER_STRANGER_MESSAGE 64 /* maximum length of a request from a stranger, in bytes */
#define SERVER_BEAT_US 100000

/* Called when the server is ready. Returns false if it cannot report the address; the server then
 * exits, because no page could find it. */
typedef bool server_ready(void *context, int port);

/* Serves until the process receives SIGTERM, or SIGINT if the run is not live. A live run is served
 * until it is over and no page is open. Port 0 means any free port. Returns false if `ready` fails,
 * or if the server cannot start, for example because the port is in use. In the latter case, prints
 * the reason on standard error. */
bool server_run(struct view *view, int port, const char *token, server_ready *ready, void *context);

#endif
