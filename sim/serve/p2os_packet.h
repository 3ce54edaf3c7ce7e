// The packets of Pioneer robots, from the robot's side. This code was written from the manuals,
// independently of the driver, so that the two test each other.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "firmware.h"

namespace frob::serve {

// Builds a packet: FA FB, count, body, and the checksum with its high byte first.
Bytes p2os_packet(const Bytes &body);

// Builds a packet's body. Numbers are little-endian, and strings end with a NUL.
class P2osBody {
  public:
    explicit P2osBody(std::uint8_t type) : bytes_{type} {}
    P2osBody &u8(int value);
    P2osBody &u16(int value); // writes negative values in two's complement
    P2osBody &text(const std::string &text);
    Bytes packet() const { return p2os_packet(bytes_); }

  private:
    Bytes bytes_;
};

// A command from a client. An argument that is missing or truncated is ignored, because some
// clients send an argument's type without a value.
struct P2osCommand {
    std::uint8_t number = 0;
    std::optional<int> argument;
    Bytes raw; // the bytes after the argument's type
};

// Finds commands in a stream of bytes. Drops invalid packets, as the firmware does.
class P2osReader {
  public:
    std::optional<P2osCommand> take(std::uint8_t byte);

    // Drops a partially received packet.
    void forget() { packet_.clear(); }

  private:
    Bytes packet_; // starts at FA
};

} // namespace frob::serve
