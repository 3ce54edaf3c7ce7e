/* client.h -- one page that is connected: its requests, as they wait. */
#ifndef FROB_VIEW_CLIENT_H
#define FROB_VIEW_CLIENT_H

#include "server.h"

struct client {
    bool admitted;          /* it has said the token */
    struct buffer incoming; /* of a message that has not yet come whole */
    char *pending[SERVER_PENDING];
    size_t count;
    bool is_to_be_told; /* that the program has been run over the recording */
};

/* What to do with a page after what it sent. */
enum verdict { GOES_ON, TOO_LONG, WRONG_TOKEN, TOO_MANY };

/* Takes a piece of a message, the last or not. */
enum verdict client_receive(struct client *client, const char *token, const char *piece,
                            size_t length, bool is_last);

/* The oldest request, which the caller frees; NULL if none waits. */
char *client_next(struct client *client);

void client_end(struct client *client);

#endif
