#include "tcp_port.h"

#include <cerrno>
#include <system_error>
#include <utility>

#include <arpa/inet.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <sys/socket.h>
#include <unistd.h>

namespace frob::serve {

TcpPort::TcpPort(int port, std::function<void(const std::string &)> refused)
    : listener_(socket(AF_INET, SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0)),
      refused_(std::move(refused)) {
    const int one = 1;
    sockaddr_in address{};
    socklen_t size = sizeof address;
    address.sin_family = AF_INET;
    address.sin_port = htons(static_cast<std::uint16_t>(port));
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    setsockopt(listener_, SOL_SOCKET, SO_REUSEADDR, &one, sizeof one);
    auto *generic = reinterpret_cast<sockaddr *>(&address);
    if (listener_ < 0 || bind(listener_, generic, size) != 0 || listen(listener_, 1) != 0 ||
        getsockname(listener_, generic, &size) != 0)
        throw std::system_error(errno, std::generic_category(),
                                "cannot listen on port " + std::to_string(port));
    port_ = ntohs(address.sin_port);
}

TcpPort::~TcpPort() {
    leave();
    close(listener_);
}

std::string TcpPort::device() const { return "tcp:127.0.0.1:" + std::to_string(port_); }

void TcpPort::leave() {
    if (client_ >= 0) close(client_);
    client_ = -1;
}

// A robot has only one line, so other clients are disconnected immediately.
void TcpPort::refuse_others() {
    sockaddr_in address{};
    socklen_t size = sizeof address;
    const int other =
        accept4(listener_, reinterpret_cast<sockaddr *>(&address), &size, SOCK_CLOEXEC);
    if (other < 0) return;
    close(other);
    refused_("refused a second client, from port " + std::to_string(ntohs(address.sin_port)) +
             ": another client is connected");
}

void TcpPort::accept_one() {
    const int one = 1;
    client_ = accept4(listener_, nullptr, nullptr, SOCK_NONBLOCK | SOCK_CLOEXEC);
    if (client_ >= 0) setsockopt(client_, IPPROTO_TCP, TCP_NODELAY, &one, sizeof one);
}

// Reads all remaining bytes from a client that has left, so that the next one can connect
// immediately.
Bytes TcpPort::read() {
    Bytes bytes;
    if (client_ < 0) accept_one();
    while (client_ >= 0) {
        std::uint8_t some[4096];
        const ssize_t count = recv(client_, some, sizeof some, 0);
        if (count > 0) {
            bytes.insert(bytes.end(), some, some + count);
            continue;
        }
        if (count < 0 && (errno == EAGAIN || errno == EINTR)) break;
        leave();
    }
    if (client_ >= 0) refuse_others();
    return bytes;
}

void TcpPort::write(const Bytes &bytes) {
    if (client_ < 0 || bytes.empty()) return;
    if (send(client_, bytes.data(), bytes.size(), MSG_NOSIGNAL) < 0 && errno != EAGAIN &&
        errno != EINTR)
        leave();
}

} // namespace frob::serve
