#include "p2os_packet.h"

namespace frob::serve {
namespace {

constexpr std::uint8_t mark_1 = 0xFA, mark_2 = 0xFB;
constexpr std::size_t least_count = 3,
                      most_count = 206; // maximum size of a client's packet; larger packets
                                        // are dropped
constexpr std::uint8_t positive = 0x3B, negative = 0x1B;

unsigned checksum(const std::uint8_t *body, std::size_t length) {
    unsigned sum = 0;
    while (length > 1) {
        sum = (sum + (static_cast<unsigned>(body[0]) << 8) + body[1]) & 0xFFFF;
        body += 2;
        length -= 2;
    }
    return length == 1 ? sum ^ *body : sum;
}

P2osCommand command_of(const std::uint8_t *body, std::size_t length) {
    P2osCommand command;
    command.number = body[0];
    if (length >= 2) command.raw.assign(body + 2, body + length);
    if (length >= 4 && (body[1] == positive || body[1] == negative)) {
        const int magnitude = body[2] | body[3] << 8;
        command.argument = body[1] == negative ? -magnitude : magnitude;
    }
    return command;
}

} // namespace

Bytes p2os_packet(const Bytes &body) {
    const unsigned sum = checksum(body.data(), body.size());
    Bytes packet{mark_1, mark_2, static_cast<std::uint8_t>(body.size() + 2)};
    for (const std::uint8_t byte : body) packet.push_back(byte);
    packet.push_back(static_cast<std::uint8_t>(sum >> 8));
    packet.push_back(static_cast<std::uint8_t>(sum & 0xFF));
    return packet;
}

P2osBody &P2osBody::u8(int value) {
    bytes_.push_back(static_cast<std::uint8_t>(value & 0xFF));
    return *this;
}

P2osBody &P2osBody::u16(int value) { return u8(value).u8(value >> 8); }

P2osBody &P2osBody::text(const std::string &text) {
    for (const char c : text) u8(c);
    return u8(0);
}

// The firmware searches for FA FB and then trusts the count.
std::optional<P2osCommand> P2osReader::take(std::uint8_t byte) {
    packet_.push_back(byte);
    if (packet_.size() == 1 && byte != mark_1) packet_.clear();
    if (packet_.size() == 2 && byte != mark_2) {
        packet_.clear();
        if (byte == mark_1) packet_.push_back(byte);
    }
    if (packet_.size() == 3 && (byte < least_count || byte > most_count)) packet_.clear();
    if (packet_.size() < 3 || packet_.size() < packet_[2] + 3u) return std::nullopt;
    const Bytes packet = std::exchange(packet_, {});
    const std::size_t length = packet[2] - 2u;
    const unsigned sum = static_cast<unsigned>(packet[3 + length]) << 8 | packet[4 + length];
    if (sum != checksum(packet.data() + 3, length)) return std::nullopt;
    return command_of(packet.data() + 3, length);
}

} // namespace frob::serve
