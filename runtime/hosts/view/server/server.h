/* server.h -- serves the page, and answers it over a WebSocket.
 *
 * Only for this computer (127.0.0.1), only under the exact name of its address, only to
 * pages of its own origin, and only to who says the token first. At most
 * SERVER_CLIENTS pages at a time. */
#ifndef FROB_VIEW_SERVER_H
#define FROB_VIEW_SERVER_H

#include "../answers/view.h"

#define SERVER_CLIENTS 4
#define SERVER_MESSAGE 65536 /* bytes of a request, at most */
#define SERVER_PENDING 64    /* requests that a page may have waiting */
#define SERVER_PATIENCE 5    /* seconds for the token */
#define SERVER_LINGERS 5     /* seconds without a page, after the end of the run that is shown */
#define SERVER_BEAT_US 200000

/* Called when the page can be asked for. False if nobody can be told, so that there is no
 * use in serving. */
typedef bool server_ready(void *context, int port);

/* Serves until the process gets SIGTERM, or SIGINT if this is no run that goes on; one that
 * does is served until it is over and no page is open. Port 0 is any that is free. False if the
 * port cannot be had, with one line on standard error, or nobody was told. */
bool server_run(struct view *view, int port, const char *token, server_ready *ready, void *context);

#endif
