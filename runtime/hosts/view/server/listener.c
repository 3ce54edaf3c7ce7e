#include "listener.h"

#include <arpa/inet.h>
#include <errno.h>
#include <fcntl.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <stdint.h>
#include <string.h>
#include <sys/socket.h>
#include <unistd.h>

static int set_flags(int number)
{
    if (number >= 0) {
        fcntl(number, F_SETFD, FD_CLOEXEC);
        fcntl(number, F_SETFL, O_NONBLOCK);
    }
    return number;
}

int listener_open(int *port)
{
    const int on = 1, listener = set_flags(socket(AF_INET, SOCK_STREAM, 0));
    struct sockaddr_in address;
    socklen_t length = sizeof address;
    memset(&address, 0, sizeof address);
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    address.sin_port = htons((uint16_t)*port);
    if (listener < 0)
        return -1;
    if (setsockopt(listener, SOL_SOCKET, SO_REUSEADDR, &on, sizeof on) != 0 ||
        bind(listener, (struct sockaddr *)&address, sizeof address) != 0 ||
        listen(listener, SOMAXCONN) != 0 ||
        getsockname(listener, (struct sockaddr *)&address, &length) != 0) {
        const int why = errno;
        close(listener);
        errno = why;
        return -1;
    }
    *port = ntohs(address.sin_port);
    return listener;
}

int listener_accept(int listener)
{
    const int on = 1, number = set_flags(accept(listener, NULL, NULL));
    /* Otherwise, an answer could wait up to 40 ms for the acknowledgement of the preceding beat. */
    if (number >= 0)
        setsockopt(number, IPPROTO_TCP, TCP_NODELAY, &on, sizeof on);
    return number;
}
