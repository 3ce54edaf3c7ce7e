#include "server.h"

#include "client.h"
#include "control.h"
#include "page_files.h"
#include "worker.h"

#include <libwebsockets.h>

#include <signal.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

struct server {
    struct view *view;
    const char *token;
    char host_name[32], origin[48];         /* as a request must name them */
    struct client *clients[SERVER_CLIENTS]; /* the oldest first */
    size_t client_count;
    unsigned long connections;
    struct worker worker;
    struct control control;
    unsigned long operator; /* the number of the page that asked to operate */
    pid_t host;             /* of the run that is shown */
    lws_sorted_usec_list_t again;
    long idle; /* beats without a page after the run's end */
};

/* What libwebsockets keeps for each connection. */
struct connection {
    struct client *client;        /* of a WebSocket */
    const struct page_file *file; /* of a request for a file … */
    size_t sent;                  /* … of which this has gone */
};

static struct lws_context *serving;
static volatile sig_atomic_t ending;

static void end(int number)
{
    (void)number;
    ending = 1;
    lws_cancel_service(serving);
}

static struct server *server_of(struct lws *wsi)
{
    return (struct server *)lws_context_user(lws_get_context(wsi));
}

static bool header_is(struct lws *wsi, enum lws_token_indexes header, const char *value)
{
    char text[64];
    return lws_hdr_copy(wsi, text, sizeof text, header) > 0 && strcmp(text, value) == 0;
}

/* {1 Files} */

static int refuse(struct lws *wsi, unsigned status)
{
    if (lws_return_http_status(wsi, status, NULL) != 0)
        return -1;
    return lws_http_transaction_completed(wsi) != 0 ? -1 : 0;
}

static int begin_file(struct lws *wsi, struct connection *connection, const char *path)
{
    unsigned char headers[LWS_PRE + 1024], *start = headers + LWS_PRE, *at = start;
    unsigned char *last = headers + sizeof headers - 1;
    const struct page_file *file = page_file(path);
    if (!header_is(wsi, WSI_TOKEN_HOST, server_of(wsi)->host_name))
        return refuse(wsi, HTTP_STATUS_FORBIDDEN);
    if (lws_hdr_total_length(wsi, WSI_TOKEN_GET_URI) <= 0)
        return refuse(wsi, HTTP_STATUS_METHOD_NOT_ALLOWED);
    if (file == NULL)
        return refuse(wsi, HTTP_STATUS_NOT_FOUND);
    connection->file = file;
    connection->sent = 0;
    if (lws_add_http_common_headers(wsi, HTTP_STATUS_OK, file->type,
                                    (lws_filepos_t)(file->end - file->begin), &at, last) != 0 ||
        lws_finalize_write_http_header(wsi, start, &at, last) != 0)
        return -1;
    lws_callback_on_writable(wsi);
    return 0;
}

static int send_file(struct lws *wsi, struct connection *connection)
{
    unsigned char block[LWS_PRE + 8192];
    const size_t whole = (size_t)(connection->file->end - connection->file->begin);
    size_t length = whole - connection->sent;
    bool is_last = length <= sizeof block - LWS_PRE;
    if (!is_last)
        length = sizeof block - LWS_PRE;
    memcpy(block + LWS_PRE, connection->file->begin + connection->sent, length);
    if (lws_write(wsi, block + LWS_PRE, length, is_last ? LWS_WRITE_HTTP_FINAL : LWS_WRITE_HTTP) <
        (int)length)
        return -1;
    connection->sent += length;
    if (is_last)
        return lws_http_transaction_completed(wsi) != 0 ? -1 : 0;
    lws_callback_on_writable(wsi);
    return 0;
}

static int on_http(struct lws *wsi, enum lws_callback_reasons reason, void *user, void *in,
                   size_t length)
{
    struct connection *connection = (struct connection *)user;
    switch (reason) {
    case LWS_CALLBACK_HTTP: return begin_file(wsi, connection, (const char *)in);
    case LWS_CALLBACK_HTTP_WRITEABLE:
        return connection == NULL || connection->file == NULL ? 0 : send_file(wsi, connection);
    case LWS_CALLBACK_FILTER_PROTOCOL_CONNECTION:
        return -1; /* a WebSocket of no protocol that is spoken here */
    default: return lws_callback_http_dummy(wsi, reason, user, in, length);
    }
}

/* {1 The page's WebSocket} */

static int close_with(struct lws *wsi, enum lws_close_status status, const char *why)
{
    unsigned char text[64];
    size_t length = strlen(why);
    memcpy(text, why, length);
    lws_close_reason(wsi, status, text, length);
    return -1;
}

static int open_client(struct lws *wsi, struct connection *connection)
{
    struct server *server = server_of(wsi);
    struct client *client;
    if (server->client_count == SERVER_CLIENTS)
        return close_with(wsi, LWS_CLOSE_STATUS_POLICY_VIOLATION, "too many pages are open");
    client = (struct client *)calloc(1, sizeof *client);
    if (client == NULL)
        return -1;
    client->line = wsi;
    client->number = ++server->connections;
    connection->client = client;
    server->clients[server->client_count++] = client;
    lws_set_timer_usecs(wsi, SERVER_PATIENCE * LWS_USEC_PER_SEC);
    return 0;
}

/* Each is told how the run goes on. */
static void tell_run(struct server *server)
{
    for (size_t i = 0; i < server->client_count; i++) {
        struct client *client = server->clients[i];
        if (client->admitted && server->control.ring != NULL) {
            client->is_to_be_told_run = true;
            lws_callback_on_writable(client->line);
        }
    }
}

/* The page that operates: the one that asked to, or else the oldest. */
static const struct client *operator_of(const struct server *server)
{
    for (size_t i = 0; i < server->client_count; i++)
        if (server->clients[i]->number == server->operator)
            return server->clients[i];
    for (size_t i = 0; i < server->client_count; i++)
        if (server->clients[i]->admitted)
            return server->clients[i];
    return NULL;
}

static void close_client(struct lws *wsi, struct connection *connection)
{
    struct server *server = server_of(wsi);
    size_t i = 0;
    if (connection->client == NULL)
        return;
    while (server->clients[i] != connection->client)
        i++;
    server->client_count--;
    memmove(server->clients + i, server->clients + i + 1,
            (server->client_count - i) * sizeof(struct client *));
    client_end(connection->client);
    free(connection->client);
    connection->client = NULL;
    tell_run(server);
}

/* Hands requests over, one of each page at a time, so that no page keeps others waiting. */
static void ask(struct server *server)
{
    for (size_t i = 0; i < server->client_count; i++) {
        struct client *client = server->clients[i];
        if (!client->is_waiting && client->count > 0 && worker_is_free(&server->worker)) {
            client->is_waiting = true;
            worker_ask(&server->worker, client->number, client_next(client));
        }
    }
}

/* At once, whatever else a page has asked for. */
static void command(struct server *server, struct client *client)
{
    const char *refusal =
        control_do(&server->control, client->command, client == operator_of(server));
    if (refusal != NULL)
        client->refusal = refusal;
    else if (strcmp(client->command, "take") == 0)
        server->operator= client->number;
    free(client->command);
    client->command = NULL;
    tell_run(server);
}

static int receive(struct lws *wsi, struct connection *connection, const char *piece, size_t length)
{
    struct server *server = server_of(wsi);
    struct client *client = connection->client;
    bool is_last = lws_is_final_fragment(wsi) && lws_remaining_packet_payload(wsi) == 0;
    if (client == NULL)
        return -1;
    if (lws_frame_is_binary(wsi))
        return close_with(wsi, LWS_CLOSE_STATUS_UNACCEPTABLE_OPCODE, "requests are text");
    const bool was_admitted = client->admitted;
    switch (client_receive(client, server->token, piece, length, is_last)) {
    case TOO_LONG:
        return close_with(wsi, LWS_CLOSE_STATUS_MESSAGE_TOO_LARGE, "this request is too long");
    case WRONG_TOKEN:
        return close_with(wsi, LWS_CLOSE_STATUS_POLICY_VIOLATION, "this is not the token");
    case TOO_MANY: return close_with(wsi, LWS_CLOSE_STATUS_POLICY_VIOLATION, "too many requests");
    case COMMANDS: command(server, client); break;
    case GOES_ON: break;
    }
    if (client->admitted && !was_admitted)
        tell_run(server);
    ask(server);
    lws_callback_on_writable(wsi);
    return 0;
}

/* What a page is to be told next; false if there is nothing. What is urgent comes first. */
static bool next_message(struct server *server, struct client *client, struct buffer *text)
{
    if (client->is_to_be_told_run) {
        client->is_to_be_told_run = false;
        control_state(&server->control, client == operator_of(server), text);
    } else if (client->refusal != NULL) {
        buffer_text(text, "{\"is\":\"refused\",\"why\":");
        buffer_string(text, client->refusal);
        buffer_text(text, "}");
        client->refusal = NULL;
    } else if (client->answer.length > 0) {
        buffer_bytes(text, client->answer.data, client->answer.length);
        text->is_binary = client->answer.is_binary;
        buffer_clear(&client->answer);
        client->is_waiting = false;
    } else if (client->is_to_be_told_news && !client->is_behind) {
        client->is_to_be_told_news = false;
        client->is_behind = true;
        worker_news(&server->worker, text);
    } else {
        return false;
    }
    return true;
}

static int write_message(struct lws *wsi, struct connection *connection)
{
    static const char room[LWS_PRE];
    struct server *server = server_of(wsi);
    struct buffer text = { 0 };
    size_t length;
    int status = 0;
    buffer_bytes(&text, room, sizeof room);
    if (connection->client == NULL || text.failed ||
        !next_message(server, connection->client, &text)) {
        buffer_free(&text);
        return 0;
    }
    length = text.length - sizeof room;
    if (text.failed || lws_write(wsi, (unsigned char *)text.data + LWS_PRE, length,
                                 text.is_binary ? LWS_WRITE_BINARY : LWS_WRITE_TEXT) < (int)length)
        status = -1;
    buffer_free(&text);
    ask(server);
    lws_callback_on_writable(wsi);
    return status;
}

/* The worker has something: answers to the pages that asked, news for all. */
static void deliver(struct server *server)
{
    struct buffer text;
    unsigned long number;
    while (worker_answer(&server->worker, &number, &text)) {
        for (size_t i = 0; i < server->client_count; i++) {
            struct client *client = server->clients[i];
            if (client->number == number) {
                buffer_free(&client->answer);
                client->answer = text;
                memset(&text, 0, sizeof text);
                lws_callback_on_writable(client->line);
            }
        }
        buffer_free(&text);
    }
    if (worker_has_news(&server->worker)) {
        for (size_t i = 0; i < server->client_count; i++) {
            server->clients[i]->is_to_be_told_news |= server->clients[i]->admitted;
            lws_callback_on_writable(server->clients[i]->line);
        }
    }
    ask(server);
}

static int on_page(struct lws *wsi, enum lws_callback_reasons reason, void *user, void *in,
                   size_t length)
{
    struct connection *connection = (struct connection *)user;
    switch (reason) {
    case LWS_CALLBACK_FILTER_PROTOCOL_CONNECTION:
        return header_is(wsi, WSI_TOKEN_HOST, server_of(wsi)->host_name) &&
                       header_is(wsi, WSI_TOKEN_ORIGIN, server_of(wsi)->origin)
                   ? 0
                   : -1;
    case LWS_CALLBACK_ESTABLISHED: return open_client(wsi, connection);
    case LWS_CALLBACK_TIMER:
        return connection->client != NULL && connection->client->admitted ? 0 : -1;
    case LWS_CALLBACK_RECEIVE: return receive(wsi, connection, (const char *)in, length);
    case LWS_CALLBACK_SERVER_WRITEABLE: return write_message(wsi, connection);
    case LWS_CALLBACK_EVENT_WAIT_CANCELLED: deliver(server_of(wsi)); return 0;
    case LWS_CALLBACK_CLOSED: close_client(wsi, connection); return 0;
    default: return 0;
    }
}

/* {1 Serving} */

static const struct lws_protocols protocols[] = {
    { "http", on_http, sizeof(struct connection), 0, 0, NULL, 0 },
    { "frob-view", on_page, sizeof(struct connection), 4096, 0, NULL, 0 },
    { NULL, NULL, 0, 0, 0, NULL, 0 },
};

/* A few times a second, while there is a host to hear it. */
static void beat(lws_sorted_usec_list_t *again)
{
    struct server *server = lws_container_of(again, struct server, again);
    struct ring *ring = server->control.ring;
    ring_beat(ring);
    if (ring_has_ended(ring) || getppid() != server->host)
        server->idle += server->client_count == 0 ? 1 : 0;
    if (server->client_count > 0)
        server->idle = 0;
    if (server->idle * SERVER_BEAT_US > SERVER_LINGERS * LWS_USEC_PER_SEC)
        ending = 1;
    else
        lws_sul_schedule(serving, 0, again, beat, SERVER_BEAT_US);
}

static void wake(void)
{
    lws_cancel_service(serving);
}

static bool serve(struct server *server)
{
    if (!worker_start(&server->worker, server->view, wake)) {
        fprintf(stderr, "error: no thread can be made\n");
        return false;
    }
    if (server->control.ring != NULL)
        beat(&server->again);
    while (!ending && lws_service(serving, 0) >= 0)
        continue;
    worker_end(&server->worker);
    return true;
}

/* A page can run and ask for only what comes from here, and be in no other page. */
static const struct lws_protocol_vhost_options
    no_sniffing = { NULL, NULL, "x-content-type-options:", "nosniff" },
    no_caching = { &no_sniffing, NULL, "cache-control:", "no-store" },
    no_referrer = { &no_caching, NULL, "referrer-policy:", "no-referrer" },
    security = { &no_referrer, NULL, "content-security-policy:",
                 "default-src 'none'; script-src 'self'; style-src 'self'; connect-src 'self'; "
                 "img-src 'self'; base-uri 'none'; form-action 'none'; frame-ancestors 'none'" };

bool server_run(struct view *view, int port, const char *token, server_ready *ready, void *context)
{
    struct server server = { .view = view, .token = token, .host = getppid() };
    struct lws_context_creation_info info;
    struct lws_vhost *vhost;
    bool serves = false;
    memset(&info, 0, sizeof info);
    info.port = port;
    info.iface = "127.0.0.1";
    info.protocols = protocols;
    info.headers = &security;
    info.user = &server;
    info.options = LWS_SERVER_OPTION_DISABLE_IPV6 | LWS_SERVER_OPTION_VALIDATE_UTF8 |
                   LWS_SERVER_OPTION_EXPLICIT_VHOSTS | LWS_SERVER_OPTION_FAIL_UPON_UNABLE_TO_BIND;
    lws_set_log_level(0, NULL);
    serving = lws_create_context(&info);
    vhost = serving == NULL ? NULL : lws_create_vhost(serving, &info);
    if (vhost == NULL) {
        if (port != 0)
            fprintf(stderr, "error: port %d is taken; without --port any that is free is used\n",
                    port);
        else
            fprintf(stderr, "error: no port of this computer (127.0.0.1) can be listened at\n");
    } else {
        port = lws_get_vhost_listen_port(vhost);
        snprintf(server.host_name, sizeof server.host_name, "127.0.0.1:%d", port);
        snprintf(server.origin, sizeof server.origin, "http://%s", server.host_name);
        control_start(&server.control, view->live.ring);
        /* An interrupt is for the run, if there is one, and this is to be seen after it; and what
         * cannot suspend a robot is not to suspend its Stop. */
        signal(SIGINT, view->live.ring != NULL ? SIG_IGN : end);
        if (view->live.ring != NULL)
            signal(SIGTSTP, SIG_IGN);
        signal(SIGTERM, end);
        signal(SIGPIPE, SIG_IGN);
        serves = ready(context, port) && serve(&server);
    }
    if (serving != NULL)
        lws_context_destroy(serving);
    return serves;
}
