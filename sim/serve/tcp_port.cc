#include "tcp_port.h"

#include <cerrno>
#include <system_error>

#include <arpa/inet.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <sys/socket.h>
#include <unistd.h>

namespace frob::serve {

TcpPort::TcpPort(int port)
    : listener_(socket(AF_INET, SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0)) {
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

Bytes TcpPort::read() {
    if (client_ < 0) {
        const int one = 1;
        client_ = accept4(listener_, nullptr, nullptr, SOCK_NONBLOCK | SOCK_CLOEXEC);
        if (client_ < 0) return {};
        setsockopt(client_, IPPROTO_TCP, TCP_NODELAY, &one, sizeof one);
    }
    Bytes bytes(4096);
    const ssize_t count = recv(client_, bytes.data(), bytes.size(), 0);
    if (count == 0 || (count < 0 && errno != EAGAIN && errno != EINTR)) leave();
    bytes.resize(count > 0 ? static_cast<std::size_t>(count) : 0);
    return bytes;
}

void TcpPort::write(const Bytes &bytes) {
    if (client_ < 0 || bytes.empty()) return;
    if (send(client_, bytes.data(), bytes.size(), MSG_NOSIGNAL) < 0 && errno != EAGAIN &&
        errno != EINTR)
        leave();
}

} // namespace frob::serve
