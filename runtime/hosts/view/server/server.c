#include "server.h"

#include "client.h"
#include "control.h"
#include "listener.h"
#include "loopback.h"
#include "page_files.h"
#include "strangers.h"
#include "token.h"
#include "worker.h"

#include <libwebsockets.h>

#include <errno.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

struct server {
    struct view *view;
    const char *token;
    int listener;
    struct strangers strangers;
    struct client *clients[SERVER_CLIENTS + STRANGERS]; /* oldest first */
    size_t client_count;
    unsigned long connections;
    struct worker worker;
    struct control control;
    unsigned long operator; /* number of the page that last took control */
    pid_t host;             /* process id of the host of the run */
    bool host_has_ended, was_visited;
    bool has_terminal; /* whether a user can read the address in a terminal, and end the run with
                        * Ctrl-C */
    long leaving;      /* number of beats since the server was asked to end, or since the host
                        * ended */
    lws_sorted_usec_list_t again;
    long idle; /* number of beats since the last page was closed, or since the run ended */
};

/* Data that libwebsockets keeps for each connection. */
struct connection {
    struct client *client;  /* for a WebSocket connection */
    const char *rest, *end; /* when sending a file: the bytes that remain to be sent */
};

static struct lws_context *serving;
static volatile sig_atomic_t ending, asked_to_end;

/* The alarm ends the process even if the thread that answers requests is running a program that
 * does not end. */
static void end(int number)
{
    (void)number;
    ending = 1;
    alarm(SERVER_ENDS);
    lws_cancel_service(serving);
}

/* Signal handler for a live run: before the server exits, it tells the pages how the run ended. */
static void end_with_run(int number)
{
    (void)number;
    asked_to_end = 1;
    alarm(2 * SERVER_ENDS);
}

static struct server *server_of(struct lws *wsi)
{
    return (struct server *)lws_context_user(lws_get_context(wsi));
}

static bool header_is(struct lws *wsi, enum lws_token_indexes header,
                      bool (*is_such)(const char *text, size_t length))
{
    char text[64];
    const int length = lws_hdr_copy(wsi, text, sizeof text, header);
    return length > 0 && is_such(text, (size_t)length);
}

/* ---- Files */

static int refuse(struct lws *wsi, unsigned status, const char *why)
{
    if (lws_return_http_status(wsi, status, why) != 0)
        return -1;
    return lws_http_transaction_completed(wsi) != 0 ? -1 : 0;
}

static int begin_file(struct lws *wsi, struct connection *connection, const char *path,
                      size_t length)
{
    unsigned char headers[LWS_PRE + 1024], *start = headers + LWS_PRE, *at = start;
    unsigned char *last = headers + sizeof headers - 1;
    const struct page_file *file = strlen(path) == length ? page_file(path) : NULL;
    bool is_packed;
    if (!header_is(wsi, WSI_TOKEN_HOST, loopback_is_host))
        return refuse(
            wsi, HTTP_STATUS_FORBIDDEN,
            "This page is only available on this computer: open it as localhost, 127.0.0.1 or "
            "[::1]. From another computer, use a tunnel (ssh -L PORT:127.0.0.1:PORT).");
    if (lws_hdr_total_length(wsi, WSI_TOKEN_GET_URI) <= 0)
        return refuse(wsi, HTTP_STATUS_METHOD_NOT_ALLOWED, "Only GET requests are supported.");
    if (file == NULL)
        return refuse(wsi, HTTP_STATUS_NOT_FOUND, "This file does not exist.");
    is_packed = header_is(wsi, WSI_TOKEN_HTTP_ACCEPT_ENCODING, page_file_may_be_packed);
    connection->rest = is_packed ? file->packed : file->begin;
    connection->end = is_packed ? file->packed_end : file->end;
    if (lws_add_http_common_headers(wsi, HTTP_STATUS_OK, file->type,
                                    (lws_filepos_t)(connection->end - connection->rest), &at,
                                    last) != 0 ||
        (is_packed &&
         lws_add_http_header_by_token(wsi, WSI_TOKEN_HTTP_CONTENT_ENCODING,
                                      (const unsigned char *)"gzip", 4, &at, last) != 0) ||
        lws_finalize_write_http_header(wsi, start, &at, last) != 0)
        return -1;
    lws_callback_on_writable(wsi);
    return 0;
}

static int send_file(struct lws *wsi, struct connection *connection)
{
    unsigned char block[LWS_PRE + 8192];
    size_t length = (size_t)(connection->end - connection->rest);
    bool is_last = length <= sizeof block - LWS_PRE;
    if (!is_last)
        length = sizeof block - LWS_PRE;
    memcpy(block + LWS_PRE, connection->rest, length);
    if (lws_write(wsi, block + LWS_PRE, length, is_last ? LWS_WRITE_HTTP_FINAL : LWS_WRITE_HTTP) <
        (int)length)
        return -1;
    connection->rest += length;
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
    case LWS_CALLBACK_WSI_DESTROY: strangers_remove(&server_of(wsi)->strangers, wsi); return 0;
    case LWS_CALLBACK_HTTP:
        strangers_hear(&server_of(wsi)->strangers, wsi);
        return begin_file(wsi, connection, (const char *)in, length);
    case LWS_CALLBACK_HTTP_WRITEABLE:
        strangers_hear(&server_of(wsi)->strangers, wsi);
        return connection == NULL || connection->rest == NULL ? 0 : send_file(wsi, connection);
    case LWS_CALLBACK_FILTER_PROTOCOL_CONNECTION:
        return -1; /* this is a WebSocket with an unknown protocol */
    default: return lws_callback_http_dummy(wsi, reason, user, in, length);
    }
}

/* ---- The page's WebSocket */

/* libwebsockets does not define this close code; IANA registers it as "Try Again Later"
 * (RFC 6455). */
#define TRY_AGAIN_LATER ((enum lws_close_status)1013)

static int close_with(struct lws *wsi, enum lws_close_status status, const char *why)
{
    unsigned char text[64];
    size_t length = strlen(why);
    memcpy(text, why, length);
    lws_close_reason(wsi, status, text, length);
    return -1;
}

static size_t pages(const struct server *server)
{
    size_t count = 0;
    for (size_t i = 0; i < server->client_count; i++)
        count += server->clients[i]->admitted ? 1 : 0;
    return count;
}

/* Sends the state of the run to each page. */
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

/* Returns the page that operates the run: the last one that took control or, if none did, the
 * oldest one. */
static struct client *operator_of(const struct server *server)
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

/* Passes requests to the worker. Only one request from each page is in progress at a time, so that
 * no page delays others. */
static void ask(struct server *server)
{
    for (size_t i = 0; i < server->client_count; i++) {
        struct client *client = server->clients[i];
        if (client->admitted && !client->is_waiting && client->count > 0 &&
            worker_is_free(&server->worker)) {
            client->is_waiting = true;
            worker_ask(&server->worker, client->number, client_next(client));
        }
    }
}

/* Executes a command immediately, regardless of pending requests. */
static void command(struct server *server, struct client *client)
{
    const char *request = client->command, *refusal = control_in_time(&request);
    if (refusal == NULL)
        refusal = control_do(&server->control, request, client == operator_of(server));
    if (refusal != NULL)
        client->refusal = refusal;
    else if (strcmp(request, "take") == 0)
        server->operator= client->number;
    free(client->command);
    client->command = NULL;
    tell_run(server);
}

/* Acts on a message from a page. */
static int react(struct server *server, struct client *client, bool was_admitted,
                 enum reception reception)
{
    struct lws *wsi = client->line;
    switch (reception) {
    case TOO_LONG:
        return close_with(wsi, LWS_CLOSE_STATUS_MESSAGE_TOO_LARGE, "this request is too long");
    case WRONG_TOKEN:
        return close_with(wsi, LWS_CLOSE_STATUS_POLICY_VIOLATION, "the token is wrong");
    case COMMANDS: command(server, client); break;
    case GOES_ON: break;
    }
    if (client->admitted && !was_admitted) {
        if (pages(server) > SERVER_CLIENTS) {
            client->admitted = false;
            return close_with(wsi, TRY_AGAIN_LATER, "too many pages are open");
        }
        strangers_remove(&server->strangers, wsi);
        client->is_to_be_told_beat = true;
        tell_run(server);
    }
    ask(server);
    lws_callback_on_writable(wsi);
    return 0;
}

/* A page presents the token in the address of its WebSocket; other clients must send it within
 * SERVER_PATIENCE. */
static int open_client(struct lws *wsi, struct connection *connection)
{
    struct server *server = server_of(wsi);
    struct client *client = NULL;
    char token[TOKEN_LENGTH + 2];
    const int length = lws_hdr_total_length(wsi, WSI_TOKEN_HTTP_URI_ARGS);
    if (server->client_count < sizeof server->clients / sizeof server->clients[0])
        client = (struct client *)calloc(1, sizeof *client);
    if (client == NULL)
        return -1;
    client->line = wsi;
    client->number = ++server->connections;
    connection->client = client;
    server->clients[server->client_count++] = client;
    strangers_hear(&server->strangers, wsi);
    lws_set_timer_usecs(wsi, SERVER_PATIENCE * LWS_USEC_PER_SEC);
    if (length <= 0)
        return 0;
    if (lws_hdr_copy(wsi, token, sizeof token, WSI_TOKEN_HTTP_URI_ARGS) != TOKEN_LENGTH ||
        !token_is(server->token, token))
        return react(server, client, false, WRONG_TOKEN);
    return react(server, client, false, client_admit(client));
}

static int receive(struct lws *wsi, struct connection *connection, const char *piece, size_t length)
{
    struct server *server = server_of(wsi);
    struct client *client = connection->client;
    bool is_last = lws_is_final_fragment(wsi) && lws_remaining_packet_payload(wsi) == 0;
    bool was_admitted;
    if (client == NULL)
        return -1;
    if (lws_frame_is_binary(wsi))
        return close_with(wsi, LWS_CLOSE_STATUS_UNACCEPTABLE_OPCODE, "requests must be text");
    was_admitted = client->admitted;
    return react(server, client, was_admitted,
                 client_receive(client, server->token, piece, length, is_last));
}

/* Writes the most urgent message for a page. Returns false if there is none. */
static bool next_message(struct server *server, struct client *client, struct buffer *text)
{
    if (!client->admitted)
        return false;
    if (client->is_to_be_told_run) {
        client->is_to_be_told_run = false;
        control_state(&server->control, client == operator_of(server), text);
    } else if (client->refusal != NULL) {
        buffer_text(text, "{\"is\":\"refused\",\"command\":true,\"why\":");
        buffer_string(text, client->refusal);
        buffer_text(text, "}");
        client->refusal = NULL;
    } else if (client->refused > 0) {
        client->refused--;
        buffer_text(text, "{\"is\":\"refused\",\"why\":\"too many requests are pending\"}");
    } else if (client->is_to_be_told_beat) {
        client->is_to_be_told_beat = false;
        control_beat(&server->control, server->host_has_ended, text);
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

/* Distributes the worker's results: answers to the pages that asked, news to all pages. */
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
        return header_is(wsi, WSI_TOKEN_HOST, loopback_is_host) &&
                       header_is(wsi, WSI_TOKEN_ORIGIN, loopback_is_origin)
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

/* ---- Connections */

static int on_listener(struct lws *wsi, enum lws_callback_reasons reason, void *user, void *in,
                       size_t length)
{
    struct server *server = server_of(wsi);
    (void)user;
    (void)in;
    (void)length;
    for (int i = 0; reason == LWS_CALLBACK_RAW_RX_FILE && i < LISTENER_AT_ONCE; i++) {
        const int number = listener_accept(server->listener);
        struct lws *line;
        if (number < 0) {
            if (errno == EMFILE || errno == ENFILE)
                strangers_end_one(&server->strangers);
            break;
        }
        line = lws_adopt_socket_vhost(lws_get_vhost(wsi), number);
        if (line != NULL)
            strangers_add(&server->strangers, line);
    }
    return 0;
}

/* ---- Serving */

static const struct lws_protocols protocols[] = {
    { "http", on_http, sizeof(struct connection), 0, 0, NULL, 0 },
    { "frob-view", on_page, sizeof(struct connection), 4096, 0, NULL, 0 },
    { "listener", on_listener, 0, 0, 0, NULL, 0 },
    { NULL, NULL, 0, 0, 0, NULL, 0 },
};

/* Checks, at each beat of a live run, whether the viewer must exit: because no page is open,
 * because the host has requested it, or because the host has ended. */
static bool is_to_end(struct server *server, bool is_over)
{
    const long patience_s = server->was_visited ? SERVER_RELOADS : SERVER_LINGERS;
    const bool is_visited = pages(server) > 0;
    server->was_visited |= is_visited;
    /* Waits indefinitely for the first page if a user can see the address in a terminal and open it
     * later. */
    server->idle = is_visited || (!server->was_visited && (!is_over || server->has_terminal))
                       ? 0
                       : server->idle + 1;
    if (asked_to_end || server->host_has_ended)
        server->leaving++;
    if (is_over && server->leaving > 0 && !is_visited)
        return true;
    return (is_over && server->idle * SERVER_BEAT_US > patience_s * LWS_USEC_PER_SEC) ||
           server->leaving > (is_over ? SERVER_FAREWELL : SERVER_ENDS * 1000000 / SERVER_BEAT_US);
}

/* Sends the viewer's heartbeat to the host and the pages. */
static void beat(lws_sorted_usec_list_t *again)
{
    struct server *server = lws_container_of(again, struct server, again);
    struct ring *ring = server->control.ring;
    for (size_t i = 0; i < server->client_count; i++) {
        if (server->clients[i]->admitted) {
            server->clients[i]->is_to_be_told_beat = true;
            lws_callback_on_writable(server->clients[i]->line);
        }
    }
    if (ring != NULL) {
        struct client *client = operator_of(server);
        if (control_was_late(&server->control) && client != NULL)
            client->refusal = CONTROL_TOO_LATE;
        ring_beat(ring);
        server->host_has_ended = getppid() != server->host;
        if (is_to_end(server, ring_has_ended(ring) || server->host_has_ended))
            ending = 1;
    }
    if (ending) {
        /* Otherwise, the server would wait for the next event from a page. */
        lws_cancel_service(serving);
        alarm(SERVER_ENDS);
    } else {
        lws_sul_schedule(serving, 0, again, beat, SERVER_BEAT_US);
    }
}

static void wake(void)
{
    lws_cancel_service(serving);
}

static bool serve(struct server *server)
{
    if (!worker_start(&server->worker, server->view, wake)) {
        fprintf(stderr, "error: cannot create a thread\n");
        return false;
    }
    beat(&server->again);
    while (!ending && lws_service(serving, 0) >= 0)
        continue;
    worker_end(&server->worker);
    return true;
}

/* The page may load and contact only this server, and may not be embedded in another page. */
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
    lws_sock_file_fd_type listener;
    struct lws_vhost *vhost;
    bool serves = false;
    memset(&info, 0, sizeof info);
    info.port = CONTEXT_PORT_NO_LISTEN_SERVER;
    info.protocols = protocols;
    info.headers = &security;
    info.user = &server;
    info.options = LWS_SERVER_OPTION_DISABLE_IPV6 | LWS_SERVER_OPTION_VALIDATE_UTF8 |
                   LWS_SERVER_OPTION_EXPLICIT_VHOSTS;
    lws_set_log_level(0, NULL);
    serving = lws_create_context(&info);
    vhost = serving == NULL ? NULL : lws_create_vhost(serving, &info);
    server.listener = listener.filefd = listener_open(&port);
    if (server.listener < 0 && errno == EADDRINUSE) {
        fprintf(stderr, "error: port %d is in use; remove --port to use any free port\n", port);
    } else if (server.listener < 0) {
        fprintf(stderr, "error: cannot listen on port %d of this computer (127.0.0.1): %s\n", port,
                strerror(errno));
    } else if (vhost == NULL || lws_adopt_descriptor_vhost(vhost, LWS_ADOPT_RAW_FILE_DESC, listener,
                                                           "listener", NULL) == NULL) {
        fprintf(stderr, "error: not enough memory to serve the page\n");
    } else {
        control_start(&server.control, view->live.ring);
        server.has_terminal = isatty(STDERR_FILENO) == 1;
        /* In a live run, only the host reacts to SIGINT; the page stays open after the run. Ctrl-Z
         * is ignored, because it would disable the Stop button without stopping the robot. */
        signal(SIGINT, view->live.ring != NULL ? SIG_IGN : end);
        if (view->live.ring != NULL)
            signal(SIGTSTP, SIG_IGN);
        signal(SIGTERM, view->live.ring != NULL ? end_with_run : end);
        signal(SIGPIPE, SIG_IGN);
        serves = ready(context, port) && serve(&server);
    }
    if (serving != NULL)
        lws_context_destroy(serving);
    return serves;
}
