/* Reads MJPEG over HTTP, as network cameras send it: a sequence of JPEGs in the response to one
 * request. */
#include "answer.h"
#include "chunks.h"
#include "decode.h"
#include "source.h"
#include "splitter.h"

#include <errno.h>
#include <fcntl.h>
#include <netdb.h>
#include <poll.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/socket.h>
#include <unistd.h>

enum { CONNECT_MS = 1000, READ_MOST = 1 << 16 };

struct http {
    int socket;
    bool has_head;
    char head[ANSWER_ROOM];
    size_t head_size;
    struct answer answer;
    struct chunks chunks;
    struct splitter splitter;
};

/* ---- Connecting */

/* Waits at most a second. Returns a socket, or -1 with errno set. */
static int connect_to(const struct addrinfo *where)
{
    const int s = socket(where->ai_family, SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0);
    struct pollfd writable = { s, POLLOUT, 0 };
    int fault = 0;
    socklen_t size = sizeof fault;
    if (s < 0)
        return -1;
    if (connect(s, where->ai_addr, where->ai_addrlen) == 0)
        return s;
    if (errno == EINPROGRESS) {
        if (poll(&writable, 1, CONNECT_MS) <= 0)
            errno = ETIMEDOUT;
        else if (getsockopt(s, SOL_SOCKET, SO_ERROR, &fault, &size) == 0 && fault == 0)
            return s;
        else
            errno = fault;
    }
    fault = errno;
    close(s);
    errno = fault;
    return -1;
}

static int reach(struct source *s, const struct address *address)
{
    struct addrinfo hints, *found = NULL;
    int reached = -1, fault;
    memset(&hints, 0, sizeof hints);
    hints.ai_socktype = SOCK_STREAM;
    fault = getaddrinfo(address->host, address->port, &hints, &found);
    if (fault != 0) {
        source_fail(s, SOURCE_FAULT,
                    "cannot find the address of %s: %s; check the name, and that this machine is "
                    "on the same network",
                    address->host, gai_strerror(fault));
        return -1;
    }
    for (const struct addrinfo *each = found; each != NULL && reached < 0; each = each->ai_next)
        reached = connect_to(each);
    if (reached < 0)
        source_fail(s, SOURCE_FAULT,
                    "cannot connect to port %s of %s: %s; check that the camera is on, and that "
                    "the address and port are right",
                    address->port, address->host, strerror(errno));
    freeaddrinfo(found);
    return reached;
}

/* Sends an HTTP/1.0 request, because a conforming server then sends no chunks. The request is short
 * and the connection is new, so the socket's buffer has room for it. */
static bool ask(struct source *s, int socket, const struct address *address)
{
    char request[2048];
    const bool is_ipv6 = strchr(address->host, ':') != NULL;
    const int length = snprintf(request, sizeof request,
                                "GET %s HTTP/1.0\r\nHost: %s%s%s:%s\r\nAccept: "
                                "multipart/x-mixed-replace, image/jpeg\r\n\r\n",
                                address->path[0] != '\0' ? address->path : "/", is_ipv6 ? "[" : "",
                                address->host, is_ipv6 ? "]" : "", address->port);
    if (length >= (int)sizeof request) {
        source_fail(s, SOURCE_FAULT, "the address is too long");
        return false;
    }
    if (send(socket, request, (size_t)length, MSG_NOSIGNAL) == (ssize_t)length)
        return true;
    source_fail(s, SOURCE_FAULT, "the connection was lost immediately: %s", strerror(errno));
    return false;
}

static bool open_http(struct source *s)
{
    struct address address;
    struct http *h = (struct http *)calloc(1, sizeof *h);
    if (!address_read(&address, s->options->source)) {
        source_fail(s, SOURCE_FAULT, "its address is not valid: write it as http://HOST:PORT/PATH");
    } else if (h == NULL || !splitter_open(&h->splitter, 0)) {
        source_fail(s, SOURCE_FAULT, "not enough memory");
    } else {
        h->socket = reach(s, &address);
        if (h->socket >= 0 && ask(s, h->socket, &address)) {
            s->state = h;
            snprintf(s->what, sizeof s->what, "JPEG");
            return true;
        }
        if (h->socket >= 0)
            close(h->socket);
        splitter_close(&h->splitter);
    }
    free(h);
    return false;
}

static void close_http(struct source *s)
{
    struct http *h = (struct http *)s->state;
    close(h->socket);
    splitter_close(&h->splitter);
    free(h);
}

/* ---- Reading */

static enum source_result judge(struct source *s, const struct answer *answer)
{
    if (answer->status == 401 || answer->status == 403)
        return source_fail(s, SOURCE_FAULT,
                           "the server answers with %d and requires a password: configure it to "
                           "send its stream without one",
                           answer->status);
    if (answer->status == 404)
        return source_fail(s, SOURCE_FAULT,
                           "the server answers with 404, so this path does not exist; look up the "
                           "path of the stream in the camera's manual");
    if (answer->status != 200)
        return source_fail(s, SOURCE_FAULT, "the server answers with %d instead of a stream",
                           answer->status);
    if (strncmp(answer->type, "text/", 5) == 0)
        return source_fail(s, SOURCE_FAULT,
                           "the server answers with %s, which is not a stream of pictures; look up "
                           "the path of the stream in the camera's manual",
                           answer->type);
    return SOURCE_FRAME;
}

/* Handles bytes of the response: first its head, then its images. */
static enum source_result feed(struct source *s, struct http *h, uint8_t *bytes, size_t size)
{
    size_t room, length = 0;
    uint8_t *space;
    ptrdiff_t count = (ptrdiff_t)size;
    if (!h->has_head) {
        const size_t before = h->head_size;
        const size_t more = size < ANSWER_ROOM - before ? size : ANSWER_ROOM - before;
        enum source_result verdict;
        memcpy(h->head + before, bytes, more);
        h->head_size += more;
        switch (answer_read(&h->answer, h->head, h->head_size, &length)) {
        case ANSWER_MORE: return SOURCE_FRAME;
        case ANSWER_WRONG:
            return source_fail(s, SOURCE_FAULT, "the server does not speak HTTP; check the port");
        case ANSWER_GOOD: break;
        }
        h->has_head = true;
        verdict = judge(s, &h->answer);
        if (verdict != SOURCE_FRAME)
            return verdict;
        return feed(s, h, bytes + (length - before), size - (length - before));
    }
    if (h->answer.is_chunked)
        count = chunks_take(&h->chunks, bytes, size);
    if (count < 0)
        return source_fail(s, SOURCE_FAULT, "the server sends invalid HTTP chunks");
    space = splitter_space(&h->splitter, &room);
    if (room < (size_t)count)
        return source_fail(s, SOURCE_FAULT, "a frame of the stream is too large, or has no end");
    memcpy(space, bytes, (size_t)count);
    splitter_feed(&h->splitter, (size_t)count, source_now_ns());
    return SOURCE_FRAME;
}

static enum source_result take_in(struct source *s, struct http *h)
{
    uint8_t bytes[READ_MOST];
    const ssize_t got = recv(h->socket, bytes, sizeof bytes, 0);
    if (got > 0)
        return feed(s, h, bytes, (size_t)got);
    if (got < 0 && (errno == EAGAIN || errno == EINTR))
        return SOURCE_NOTHING;
    if (got < 0)
        return source_fail(s, SOURCE_FAULT, "the connection was lost: %s", strerror(errno));
    return source_fail(s, SOURCE_FAULT,
                       h->has_head ? "the server ended the stream"
                                   : "the server closed the connection without an answer");
}

static enum source_result next(struct source *s, struct captured *frame, int wait_ms)
{
    struct http *h = (struct http *)s->state;
    const int64_t until = source_now_ns() + wait_ms * INT64_C(1000000);
    const uint32_t torn = h->splitter.torn;
    const uint8_t *bytes;
    const char *fault;
    char message[256];
    size_t size;
    while ((bytes = splitter_take_newest(&h->splitter, &size, &frame->captured_ns, &s->lost)) ==
           NULL) {
        struct pollfd input = { h->socket, POLLIN, 0 };
        const int64_t left = until - source_now_ns();
        enum source_result result;
        if (h->splitter.torn > torn)
            return source_fail(s, SOURCE_BROKEN, "a JPEG is truncated");
        if (left <= 0)
            return SOURCE_NOTHING;
        if (poll(&input, 1, (int)(left / 1000000) + 1) <= 0)
            continue;
        result = take_in(s, h);
        if (result == SOURCE_FAULT)
            return result;
    }
    s->lost += h->splitter.torn - torn;
    fault = decode_picture(bytes, size, s->options->settings[CAMERA_GREY] > 0.0, frame, message);
    return fault == NULL ? SOURCE_FRAME : source_fail(s, SOURCE_BROKEN, "%s", fault);
}

const struct source_kind source_http = {
    open_http,
    next,
    close_http,
    true,
    "the server accepts connections but sends no complete picture; check the camera and the "
    "address of its stream",
};
