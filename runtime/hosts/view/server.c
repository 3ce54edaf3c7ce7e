#include "server.h"

#include "client.h"
#include "page_files.h"

#include <libwebsockets.h>

#include <signal.h>
#include <stdlib.h>
#include <string.h>

struct server {
    struct view *view;
    const char *token;
    char host[32], origin[48]; /* as a request must name them */
    unsigned clients;
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
    if (!header_is(wsi, WSI_TOKEN_HOST, server_of(wsi)->host))
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
    if (lws_write(wsi, block + LWS_PRE, length,
                  is_last ? LWS_WRITE_HTTP_FINAL : LWS_WRITE_HTTP) < (int)length)
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
    case LWS_CALLBACK_HTTP:
        return begin_file(wsi, connection, (const char *)in);
    case LWS_CALLBACK_HTTP_WRITEABLE:
        return connection == NULL || connection->file == NULL ? 0 : send_file(wsi, connection);
    case LWS_CALLBACK_FILTER_PROTOCOL_CONNECTION:
        return -1; /* a WebSocket of no protocol that is spoken here */
    default:
        return lws_callback_http_dummy(wsi, reason, user, in, length);
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
    if (server->clients == SERVER_CLIENTS)
        return close_with(wsi, LWS_CLOSE_STATUS_POLICY_VIOLATION, "too many pages are open");
    connection->client = (struct client *)calloc(1, sizeof *connection->client);
    if (connection->client == NULL)
        return -1;
    server->clients++;
    lws_set_timer_usecs(wsi, SERVER_PATIENCE * LWS_USEC_PER_SEC);
    return 0;
}

static void close_client(struct lws *wsi, struct connection *connection)
{
    if (connection->client == NULL)
        return;
    client_end(connection->client);
    free(connection->client);
    connection->client = NULL;
    server_of(wsi)->clients--;
}

static int receive(struct lws *wsi, struct connection *connection, const char *piece,
                   size_t length)
{
    bool is_last = lws_is_final_fragment(wsi) && lws_remaining_packet_payload(wsi) == 0;
    if (connection->client == NULL)
        return -1;
    if (lws_frame_is_binary(wsi))
        return close_with(wsi, LWS_CLOSE_STATUS_UNACCEPTABLE_OPCODE, "requests are text");
    switch (client_receive(connection->client, server_of(wsi)->token, piece, length, is_last)) {
    case TOO_LONG:
        return close_with(wsi, LWS_CLOSE_STATUS_MESSAGE_TOO_LARGE, "this request is too long");
    case WRONG_TOKEN:
        return close_with(wsi, LWS_CLOSE_STATUS_POLICY_VIOLATION, "this is not the token");
    case TOO_MANY:
        return close_with(wsi, LWS_CLOSE_STATUS_POLICY_VIOLATION, "too many requests");
    case GOES_ON:
        break;
    }
    lws_callback_on_writable(wsi);
    return 0;
}

/* One request at a time, so that no page keeps the others waiting. */
static int answer(struct lws *wsi, struct connection *connection)
{
    static const char room[LWS_PRE];
    struct client *client = connection->client;
    struct buffer text = { 0 }, body = { 0 };
    char *request = client == NULL ? NULL : client_next(client);
    size_t length;
    int status = 0;
    if (request == NULL && (client == NULL || !client->is_to_be_told))
        return 0;
    if (request != NULL) {
        view_answer(server_of(wsi)->view, request, &body);
    } else {
        client->is_to_be_told = false;
        view_progress(server_of(wsi)->view, &body);
    }
    buffer_bytes(&text, room, sizeof room);
    buffer_bytes(&text, body.data, body.length);
    text.failed = text.failed || body.failed;
    buffer_free(&body);
    length = text.length - sizeof room;
    if (text.failed ||
        lws_write(wsi, (unsigned char *)text.data + LWS_PRE, length, LWS_WRITE_TEXT) < (int)length)
        status = -1;
    buffer_free(&text);
    free(request);
    if (client->count > 0 || client->is_to_be_told)
        lws_callback_on_writable(wsi);
    return status;
}

static int on_page(struct lws *wsi, enum lws_callback_reasons reason, void *user, void *in,
                   size_t length)
{
    struct connection *connection = (struct connection *)user;
    switch (reason) {
    case LWS_CALLBACK_FILTER_PROTOCOL_CONNECTION:
        return header_is(wsi, WSI_TOKEN_HOST, server_of(wsi)->host) &&
                       header_is(wsi, WSI_TOKEN_ORIGIN, server_of(wsi)->origin)
                   ? 0
                   : -1;
    case LWS_CALLBACK_ESTABLISHED:
        return open_client(wsi, connection);
    case LWS_CALLBACK_TIMER:
        return connection->client != NULL && connection->client->admitted ? 0 : -1;
    case LWS_CALLBACK_RECEIVE:
        return receive(wsi, connection, (const char *)in, length);
    case LWS_CALLBACK_SERVER_WRITEABLE:
        return answer(wsi, connection);
    case LWS_CALLBACK_USER: /* from tell_all */
        if (connection != NULL && connection->client != NULL && connection->client->admitted) {
            connection->client->is_to_be_told = true;
            lws_callback_on_writable(wsi);
        }
        return 0;
    case LWS_CALLBACK_CLOSED:
        close_client(wsi, connection);
        return 0;
    default:
        return 0;
    }
}

/* {1 Serving} */

static const struct lws_protocols protocols[] = {
    { "http", on_http, sizeof(struct connection), 0, 0, NULL, 0 },
    { "frob-view", on_page, sizeof(struct connection), 4096, 0, NULL, 0 },
    { NULL, NULL, 0, 0, 0, NULL, 0 },
};

static void tell_all(struct lws_vhost *vhost)
{
    lws_callback_all_protocol_vhost_args(vhost, &protocols[1], LWS_CALLBACK_USER, NULL, 0);
}

/* Serves, and meanwhile runs the program over the recording. */
static void serve(struct view *view, struct lws_vhost *vhost)
{
    bool goes_on = true;
    while (!ending) {
        if (lws_service(serving, goes_on ? -1 : 0) < 0)
            return;
        if (goes_on) {
            goes_on = view_advance(view, 0.005);
            if (!goes_on)
                tell_all(vhost);
        }
    }
}

/* A page can run and ask for only what comes from here, and be in no other page. */
static const struct lws_protocol_vhost_options
    no_sniffing = { NULL, NULL, "x-content-type-options:", "nosniff" },
    no_caching = { &no_sniffing, NULL, "cache-control:", "no-store" },
    no_referrer = { &no_caching, NULL, "referrer-policy:", "no-referrer" },
    security = { &no_referrer, NULL, "content-security-policy:",
                 "default-src 'none'; script-src 'self'; style-src 'self'; connect-src 'self'; "
                 "img-src 'self'; base-uri 'none'; form-action 'none'; frame-ancestors 'none'" };

bool server_run(struct view *view, int port, const char *token, server_ready *ready,
                void *context)
{
    struct server server = { view, token, "", "", 0 };
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
        snprintf(server.host, sizeof server.host, "127.0.0.1:%d", port);
        snprintf(server.origin, sizeof server.origin, "http://%s", server.host);
        signal(SIGINT, end);
        signal(SIGTERM, end);
        signal(SIGPIPE, SIG_IGN);
        serves = ready(context, port);
        if (serves)
            serve(view, vhost);
    }
    if (serving != NULL)
        lws_context_destroy(serving);
    return serves;
}
