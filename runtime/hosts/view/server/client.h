/* client.h -- a connected page: its pending requests, and the messages for it. Only the newest
 * message of each kind is kept, so a page that does not read its messages does not use up
 * memory. */
#ifndef FROB_VIEW_CLIENT_H
#define FROB_VIEW_CLIENT_H

#include "server.h"

struct lws;

struct client {
    struct lws *line;
    unsigned long number;   /* unique number of the connection */
    bool admitted;          /* whether the page has presented the token */
    struct buffer incoming; /* the parts of an incomplete message */
    char *pending[SERVER_PENDING];
    size_t count;
    size_t refused;       /* number of requests to refuse, because too many were pending */
    bool is_waiting;      /* whether an answer to a request is pending */
    struct buffer answer; /* an answer to send */
    char *command;        /* a command for the run, to be executed immediately */
    bool is_to_be_told_news, is_to_be_told_run, is_to_be_told_beat;
    bool is_behind;      /* whether the page has yet to draw the latest news */
    const char *refusal; /* why the last command was refused */
};

/* How to react to a page's message. */
enum reception { GOES_ON, COMMANDS, TOO_LONG, WRONG_TOKEN };

/* Handles a piece of a message. */
enum reception client_receive(struct client *client, const char *token, const char *piece,
                              size_t length, bool is_last);

/* Accepts a page that has presented the token, and queues the request `program` for it. */
enum reception client_admit(struct client *client);

/* Returns the oldest request, which the caller frees; NULL if there is none. */
char *client_next(struct client *client);

void client_end(struct client *client);

#endif
