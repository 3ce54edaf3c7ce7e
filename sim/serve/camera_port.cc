#include "camera_port.h"

#include <algorithm>
#include <cerrno>
#include <system_error>

#include <arpa/inet.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <sys/socket.h>
#include <unistd.h>

#include <frob/image.h>
#include <hosts/camera/turbo.h>

#include "options.h"

namespace frob::serve {
namespace {

constexpr std::size_t most_asked = 8192; // maximum size of a request in bytes
constexpr std::size_t most_clients = 16;
constexpr int quality = 90;
const std::string boundary = "frame";

const turbo &jpeg() {
    const char *fault = nullptr;
    const turbo *found = turbo_find(&fault);
    if (found == nullptr) throw WrongUse(fault);
    return *found;
}

std::string head(const std::string &status, const std::string &type) {
    return "HTTP/1.0 " + status + "\r\nContent-Type: " + type +
           "\r\nCache-Control: no-store\r\nConnection: close\r\n\r\n";
}

} // namespace

CameraPort::CameraPort(frob_sim *sim, int port) : sim_(sim) {
    const int one = 1;
    sockaddr_in address{};
    socklen_t size = sizeof address;
    auto *generic = reinterpret_cast<sockaddr *>(&address);
    while (const char *name = frob_sim_camera_name(sim, names_.size())) names_.emplace_back(name);
    if (names_.empty()) throw WrongUse("the world has no camera: add a table [camera] to its file");
    compressor_ = jpeg().init_compress();
    for (const std::string &name : names_) frob_sim_look_through(sim, name.c_str());
    address.sin_family = AF_INET;
    address.sin_port = htons(static_cast<std::uint16_t>(port));
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    listener_ = socket(AF_INET, SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0);
    setsockopt(listener_, SOL_SOCKET, SO_REUSEADDR, &one, sizeof one);
    if (listener_ < 0 || bind(listener_, generic, size) != 0 || listen(listener_, 8) != 0 ||
        getsockname(listener_, generic, &size) != 0)
        throw std::system_error(errno, std::generic_category(),
                                "cannot listen on port " + std::to_string(port));
    port_ = ntohs(address.sin_port);
}

CameraPort::~CameraPort() {
    for (Client &client : clients_) client.close();
    if (listener_ >= 0) ::close(listener_);
}

std::vector<std::string> CameraPort::addresses() const {
    std::vector<std::string> all;
    for (const std::string &name : names_)
        all.push_back("http://127.0.0.1:" + std::to_string(port_) + "/" + name);
    return all;
}

void CameraPort::accept_all() {
    for (;;) {
        const int one = 1;
        Client client;
        client.socket = accept4(listener_, nullptr, nullptr, SOCK_NONBLOCK | SOCK_CLOEXEC);
        if (client.socket < 0) return;
        setsockopt(client.socket, IPPROTO_TCP, TCP_NODELAY, &one, sizeof one);
        if (clients_.size() < most_clients)
            clients_.push_back(client);
        else
            client.close();
    }
}

void CameraPort::Client::close() {
    if (socket >= 0) ::close(socket);
    socket = -1;
}

void CameraPort::Client::flush() {
    while (socket >= 0 && !waiting.empty()) {
        const ssize_t sent = send(socket, waiting.data(), waiting.size(), MSG_NOSIGNAL);
        if (sent < 0 && errno == EAGAIN) return;
        if (sent < 0 && errno != EINTR) return close();
        waiting.erase(0, sent < 0 ? 0 : static_cast<std::size_t>(sent));
    }
    if (leaves) close();
}

// Only the path of a request matters. Anything else that the client sends is ignored.
void CameraPort::Client::receive(const CameraPort &port) {
    char some[4096];
    for (;;) {
        const ssize_t count = recv(socket, some, sizeof some, 0);
        if (count < 0 && (errno == EAGAIN || errno == EINTR)) break;
        if (count <= 0) return close();
        if (camera < 0 && !leaves) asked.append(some, static_cast<std::size_t>(count));
    }
    if (camera < 0 && !leaves &&
        (asked.find("\r\n\r\n") != std::string::npos || asked.size() > most_asked))
        port.answer(*this);
}

void CameraPort::answer(Client &client) const {
    const std::size_t end = client.asked.find(' ', 4);
    const std::string path = client.asked.rfind("GET /", 0) == 0 && end != std::string::npos
                                 ? client.asked.substr(5, end - 5)
                                 : "?";
    const auto found = std::find(names_.begin(), names_.end(), path);
    if (found == names_.end()) {
        client.leaves = true;
        client.waiting = head("404 Not Found", "text/plain");
        for (const std::string &address : addresses()) client.waiting += address + "\n";
        return;
    }
    client.camera = static_cast<int>(found - names_.begin());
    client.waiting = head("200 OK", "multipart/x-mixed-replace; boundary=" + boundary);
}

std::string CameraPort::encode(const frob_image &image) {
    const bool is_grey = image.format == FROB_GREY8;
    unsigned char *bytes = nullptr;
    unsigned long size = 0;
    std::string part;
    if (jpeg().compress(compressor_, static_cast<const unsigned char *>(image.pixels), image.width,
                        image.stride, image.height, is_grey ? TURBO_GREY : TURBO_RGB, &bytes, &size,
                        is_grey ? TURBO_SAMPLES_GREY : TURBO_SAMPLES_422, quality,
                        TURBO_ACCURATE) == 0) {
        part = "--" + boundary +
               "\r\nContent-Type: image/jpeg\r\nContent-Length: " + std::to_string(size) +
               "\r\n\r\n";
        part.append(reinterpret_cast<const char *>(bytes), size);
        part += "\r\n";
    }
    jpeg().release(bytes);
    return part;
}

// Draws and compresses a frame only if a client is watching.
void CameraPort::advance(std::int64_t time_ns) {
    accept_all();
    for (Client &client : clients_) client.receive(*this);
    for (std::size_t k = 0; k < names_.size(); ++k) {
        const auto wants = [k](const Client &client) {
            return client.socket >= 0 && client.camera == static_cast<int>(k) &&
                   client.waiting.size() < 1024;
        };
        if (std::none_of(clients_.begin(), clients_.end(), wants)) continue;
        const frob_image *image = frob_sim_frame(sim_, 0, static_cast<int>(k), time_ns);
        if (image == nullptr) continue;
        const std::string part = encode(*image);
        for (Client &client : clients_)
            if (wants(client)) client.waiting += part;
    }
    for (Client &client : clients_) client.flush();
    clients_.erase(std::remove_if(clients_.begin(), clients_.end(),
                                  [](const Client &client) { return client.socket < 0; }),
                   clients_.end());
}

} // namespace frob::serve
