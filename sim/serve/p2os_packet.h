// The packets of Pioneer robots, from the robot's side. Written from the
// manuals and not from the driver, so that each tests the other.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "firmware.h"

namespace frob::serve
{

// FA FB, count, body, checksum with its high byte first.
Bytes p2os_packet(const Bytes &body);

// Builds a body: numbers low byte first, texts with a NUL.
class P2osBody
{
  public:
    explicit P2osBody(std::uint8_t type) : bytes_{ type } {}
    P2osBody &u8(int value);
    P2osBody &u16(int value); // two's complement where negative
    P2osBody &text(const std::string &text);
    Bytes packet() const { return p2os_packet(bytes_); }

  private:
    Bytes bytes_;
};

// A client's command. A missing or cut argument is no argument: some clients
// send an argument's type without a value.
struct P2osCommand {
    std::uint8_t number = 0;
    std::optional<int> argument;
    Bytes raw; // the bytes after the argument's type
};

// Finds commands in a stream of bytes; what is not a good packet is dropped,
// as the firmware does.
class P2osReader
{
  public:
    std::optional<P2osCommand> take(std::uint8_t byte);

    // A packet that has begun.
    void forget() { packet_.clear(); }

  private:
    Bytes packet_; // from FA on
};

} // namespace frob::serve
