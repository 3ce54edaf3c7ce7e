/* Connects to a robot over TCP: to its own computer, a serial server or a simulator. */
#include "hal/posix/parts.h"

#include <errno.h>
#include <fcntl.h>
#include <netdb.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <poll.h>
#include <stdio.h>
#include <string.h>
#include <sys/socket.h>
#include <unistd.h>

#define DEFAULT_PORT "8101"

enum { PATIENCE_MS = 2000, AGAIN_PATIENCE_MS = 500 };

bool frob_posix_is_tcp(const char *device)
{
    return strncmp(device, "tcp:", 4) == 0;
}

/* Splits HOST:PORT; a host that contains colons must be in brackets. */
static bool split(const char *address, char *host, size_t host_room, char *port, size_t port_room)
{
    const char *end, *colon;
    size_t length;
    if (*address == '[') {
        address++;
        end = strchr(address, ']');
        if (end == NULL)
            return false;
        colon = end[1] == ':' ? end + 1 : NULL;
    } else {
        colon = strrchr(address, ':');
        end = colon != NULL ? colon : address + strlen(address);
    }
    length = (size_t)(end - address);
    if (length == 0 || length >= host_room)
        return false;
    memcpy(host, address, length);
    host[length] = '\0';
    if (colon != NULL && (colon[1] == '\0' || strlen(colon + 1) >= port_room))
        return false;
    snprintf(port, port_room, "%s", colon != NULL ? colon + 1 : DEFAULT_PORT);
    return true;
}

/* Waits until the connection is established. Returns 0 or an error number. */
static int finish(int fd, int patience_ms)
{
    struct pollfd wait = { fd, POLLOUT, 0 };
    int error = 0, ready;
    socklen_t size = sizeof error;
    do
        ready = poll(&wait, 1, patience_ms);
    while (ready < 0 && errno == EINTR);
    if (ready == 0)
        return ETIMEDOUT;
    if (ready < 0 || getsockopt(fd, SOL_SOCKET, SO_ERROR, &error, &size) != 0)
        return errno;
    return error;
}

static int try_address(const struct sockaddr *address, socklen_t length, int patience_ms, int *fd)
{
    int one = 1, error = 0;
    *fd = socket(address->sa_family, SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0);
    if (*fd < 0)
        return errno;
    if (connect(*fd, address, length) != 0)
        error = errno == EINPROGRESS ? finish(*fd, patience_ms) : errno;
    if (error == 0) {
        /* Makes the socket send packets immediately and detect a dead peer. */
        setsockopt(*fd, IPPROTO_TCP, TCP_NODELAY, &one, sizeof one);
        setsockopt(*fd, SOL_SOCKET, SO_KEEPALIVE, &one, sizeof one);
        return 0;
    }
    close(*fd);
    *fd = -1;
    return error;
}

int frob_posix_connect_again(struct frob_posix_line *line)
{
    struct sockaddr_storage peer;
    memcpy(&peer, line->peer, line->peer_length);
    return try_address((const struct sockaddr *)&peer, (socklen_t)line->peer_length,
                       AGAIN_PATIENCE_MS, &line->fd);
}

enum frob_status frob_posix_connect(struct frob_posix_line *line, const char *device, char *message,
                                    size_t room)
{
    char host[256], port[16];
    struct addrinfo hints, *addresses = NULL;
    int failure, error = 0;
    line->fd = -1;
    if (!split(device + 4, host, sizeof host, port, sizeof port)) {
        snprintf(message, room, "`%s` is not an address; write tcp:HOST:PORT", device);
        return FROB_NOT_FOUND;
    }
    memset(&hints, 0, sizeof hints);
    hints.ai_socktype = SOCK_STREAM;
    failure = getaddrinfo(host, port, &hints, &addresses);
    if (failure != 0) {
        snprintf(message, room, "there is no host `%s`: %s", host, gai_strerror(failure));
        return FROB_NOT_FOUND;
    }
    for (const struct addrinfo *a = addresses; a != NULL && line->fd < 0; a = a->ai_next) {
        if (a->ai_addrlen > sizeof line->peer)
            continue;
        error = try_address(a->ai_addr, a->ai_addrlen, PATIENCE_MS, &line->fd);
        memcpy(line->peer, a->ai_addr, a->ai_addrlen);
        line->peer_length = (unsigned)a->ai_addrlen;
    }
    freeaddrinfo(addresses);
    if (line->fd >= 0)
        return FROB_OK;
    snprintf(message, room, "cannot connect to %s, port %s: %s", host, port, strerror(error));
    return error == ETIMEDOUT ? FROB_TIMEOUT : FROB_NOT_FOUND;
}

ssize_t frob_posix_send(int fd, const uint8_t *bytes, size_t count)
{
    return send(fd, bytes, count, MSG_NOSIGNAL);
}
