#include "client.h"

#include "control.h"
#include "token.h"

#include <stdlib.h>
#include <string.h>

static void forget(struct client *client, size_t i)
{
    client->count--;
    memmove(client->pending + i, client->pending + i + 1,
            (client->count - i) * sizeof *client->pending);
}

static bool is_for_instant(const char *request)
{
    return strncmp(request, "instant ", 8) == 0 || strncmp(request, "time ", 5) == 0;
}

static bool is_for_picture(const char *request)
{
    return strncmp(request, "picture ", 8) == 0;
}

/* Drops the older requests of a kind (instants or pictures), because the cursor has moved on and
 * only the newest request matters. */
static void drop_older(struct client *client, bool (*is_such)(const char *request))
{
    for (size_t i = client->count; i-- > 0;) {
        if (is_such(client->pending[i])) {
            free(client->pending[i]);
            forget(client, i);
        }
    }
}

static enum reception take(struct client *client, const char *message)
{
    const size_t length = strlen(message) + 1;
    char *copy;
    if (strcmp(message, "more") == 0) {
        client->is_behind = false;
        return GOES_ON;
    }
    copy = (char *)malloc(length);
    if (copy == NULL) {
        client->refused++;
        return GOES_ON;
    }
    memcpy(copy, message, length);
    if (control_is(message)) {
        free(client->command);
        client->command = copy;
        return COMMANDS;
    }
    if (is_for_instant(message))
        drop_older(client, is_for_instant);
    if (is_for_picture(message))
        drop_older(client, is_for_picture);
    if (client->count == SERVER_PENDING) {
        free(copy);
        client->refused++;
        return GOES_ON;
    }
    client->pending[client->count++] = copy;
    return GOES_ON;
}

enum reception client_admit(struct client *client)
{
    client->admitted = true;
    return take(client, "program");
}

static enum reception greet(struct client *client, const char *token, const char *message)
{
    static const char greeting[] = "hello ";
    const bool is_right = strncmp(message, greeting, sizeof greeting - 1) == 0 &&
                          token_is(token, message + sizeof greeting - 1);
    return is_right ? client_admit(client) : WRONG_TOKEN;
}

enum reception client_receive(struct client *client, const char *token, const char *piece,
                              size_t length, bool is_last)
{
    const size_t most = client->admitted ? SERVER_MESSAGE : SERVER_STRANGER_MESSAGE;
    const char *message;
    enum reception verdict;
    if (client->incoming.length + length > most)
        return TOO_LONG;
    buffer_bytes(&client->incoming, piece, length);
    if (!is_last)
        return GOES_ON;
    /* Requests must not contain NUL. */
    message =
        client->incoming.length > 0 && strlen(client->incoming.data) == client->incoming.length
            ? client->incoming.data
            : "";
    verdict = client->admitted ? take(client, message) : greet(client, token, message);
    buffer_clear(&client->incoming);
    return verdict;
}

char *client_next(struct client *client)
{
    char *request;
    if (client->count == 0)
        return NULL;
    request = client->pending[0];
    forget(client, 0);
    return request;
}

void client_end(struct client *client)
{
    while (client->count > 0)
        free(client_next(client));
    buffer_free(&client->incoming);
    buffer_free(&client->answer);
    free(client->command);
}
