#include "server.h"

#include <algorithm>

#include <poll.h>
#include <time.h>

namespace frob::serve {
namespace {

constexpr std::int64_t most_wait_ns = 5'000'000; // also the maximum time until a new client is
                                                 // noticed
constexpr std::int64_t pause_ns = 100'000'000;   // longer than any pause within a command

// Corrupts a byte that was received at the wrong rate.
std::uint8_t garbled(std::uint8_t byte) { return static_cast<std::uint8_t>((byte ^ 0x5A) * 3 + 1); }

} // namespace

void Server::plug(std::unique_ptr<Connection> connection) {
    connection_ = std::move(connection);
    to_robot_.clear();
    to_client_.clear();
    firmware_.forget();
}

// Passes bytes to the firmware in order, each at its time of arrival. A new client's bytes wait
// until the previous client's bytes have been delivered.
void Server::receive(std::int64_t time_ns) {
    if (left_ && to_robot_.travelling() == 0) {
        firmware_.forget();
        left_ = false;
    }
    if (connection_ && !left_) {
        Bytes bytes = connection_->read();
        const std::uint32_t theirs = connection_->rate();
        if (theirs != 0 && theirs != firmware_.rate())
            std::transform(bytes.begin(), bytes.end(), bytes.begin(), garbled);
        to_robot_.push(bytes, time_ns, firmware_.rate());
        left_ = !connection_->connected() && (there_ || !bytes.empty());
        there_ = connection_->connected();
    }
    std::uint8_t byte = 0;
    std::int64_t arrived_ns = 0;
    while (to_robot_.take(time_ns, byte, arrived_ns)) {
        firmware_.advance(arrived_ns);
        if (arrived_ns - heard_ns_ > pause_ns) firmware_.forget();
        heard_ns_ = arrived_ns;
        firmware_.receive(byte);
        to_client_.push(firmware_.take_output(), arrived_ns, firmware_.rate());
    }
}

void Server::send(std::int64_t time_ns) {
    to_client_.push(firmware_.take_output(), time_ns, firmware_.rate());
    Bytes due;
    std::uint8_t byte = 0;
    std::int64_t arrived_ns = 0;
    while (to_client_.take(time_ns, byte, arrived_ns)) due.push_back(byte);
    if (!connection_) return;
    const std::uint32_t theirs = connection_->rate();
    if (theirs != 0 && theirs != firmware_.rate())
        std::transform(due.begin(), due.end(), due.begin(), garbled);
    connection_->write(due);
}

void Server::advance(std::int64_t time_ns) {
    receive(time_ns);
    firmware_.advance(time_ns);
    send(time_ns);
}

std::int64_t Server::due_ns() const {
    return std::min({firmware_.next_ns(), to_robot_.next_ns(), to_client_.next_ns()});
}

void Server::wait(std::int64_t time_ns) const {
    const std::int64_t left = std::clamp<std::int64_t>(due_ns() - time_ns, 0, most_wait_ns);
    const timespec patience{0, static_cast<long>(left)};
    pollfd input{connection_ ? connection_->descriptor() : -1, POLLIN, 0};
    ppoll(&input, 1, &patience, nullptr);
}

} // namespace frob::serve
