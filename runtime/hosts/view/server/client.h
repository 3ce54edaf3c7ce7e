/* client.h -- one page that is connected: its requests, as they wait, and what it is to be
 * told. Of that only the newest is kept, so a page that does not listen takes no memory. */
#ifndef FROB_VIEW_CLIENT_H
#define FROB_VIEW_CLIENT_H

#include "server.h"

struct lws;

struct client {
    struct lws *line;
    unsigned long number;   /* of its connection; none has it again */
    bool admitted;          /* it has said the token */
    struct buffer incoming; /* of a message that has not yet come whole */
    char *pending[SERVER_PENDING];
    size_t count;
    bool is_waiting;      /* for the answer to a request */
    struct buffer answer; /* that has come */
    char *command;        /* what it wants to do to a run, to be done at once */
    bool is_to_be_told_news, is_to_be_told_run;
    bool is_behind;      /* it has not drawn the last news yet */
    const char *refusal; /* why a command was not done */
};

/* What to do with a page after what it sent. */
enum reception { GOES_ON, COMMANDS, TOO_LONG, WRONG_TOKEN, TOO_MANY };

/* Takes a piece of a message, the last or not. */
enum reception client_receive(struct client *client, const char *token, const char *piece,
                              size_t length, bool is_last);

/* The oldest request, which the caller frees; NULL if none waits. */
char *client_next(struct client *client);

void client_end(struct client *client);

#endif
