/* server.h -- serves the page, and answers its requests over a WebSocket.
 *
 * It listens only on 127.0.0.1. Requests must name this computer as their host and come from a page
 * of this computer (loopback.h). A page must present the token before it is answered: in the query
 * of the WebSocket's address, or in its first message, `hello TOKEN`. At most SERVER_CLIENTS pages
 * are served at a time. Connections that have not presented the token do not count towards this
 * limit (strangers.h).
 *
 * The server sends `beat` to each page ten times a second, whatever else it does. The beat shows
 * that the viewer works, and contains how long the host of a run has been silent. */
#ifndef FROB_VIEW_SERVER_H
#define FROB_VIEW_SERVER_H

#include "../answers/view.h"

#define SERVER_CLIENTS 4
#define SERVER_MESSAGE 65536 /* maximum bytes of a request */
#define SERVER_PENDING 64    /* maximum number of pending requests of a page */
#define SERVER_PATIENCE 5    /* maximum time, in seconds, to present the token */
/* The time without a page, in seconds, after which the viewer of a finished run ends. The limit
 * also applies while a page reloads and, unless there is a terminal, before the first page
 * connects. */
#define SERVER_LINGERS 5
#define SERVER_RELOADS 2
#define SERVER_ENDS 2              /* maximum time for shutting down, in seconds */
#define SERVER_FAREWELL 3          /* number of beats that tell pages how a run ended */
#define SERVER_STRANGER_MESSAGE 64 /* maximum bytes of a request without the token */
#define SERVER_BEAT_US 100000

/* Called when the server is ready. Returns false if the address cannot be reported, so that serving
 * would be useless. */
typedef bool server_ready(void *context, int port);

/* Serves until the process receives SIGTERM, or SIGINT if the run is not live. A live run is served
 * until it is over and no page is open. Port 0 means any free port. Returns false if the port is
 * not available, with a line on standard error, or if `ready` fails. */
bool server_run(struct view *view, int port, const char *token, server_ready *ready, void *context);

#endif
