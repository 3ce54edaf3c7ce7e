// The client's side of the line: a terminal or a TCP port.
#pragma once

#include <cstdint>
#include <string>

#include "firmware.h"

namespace frob::serve {

class Connection {
  public:
    virtual ~Connection() = default;

    // The device that a client opens: a path, or `tcp:ADDRESS:PORT`.
    virtual std::string device() const = 0;

    // Descriptor to poll for input; -1 if there is currently none.
    virtual int descriptor() const = 0;

    // Whether a client is connected.
    virtual bool connected() const = 0;

    // Returns the bytes that have arrived. Never blocks.
    virtual Bytes read() = 0;

    // Sends the bytes. Any bytes that cannot be sent immediately are lost, as on a line
    // without a reader.
    virtual void write(const Bytes &bytes) = 0;

    // The bit rate that the client has set; 0 if the connection has none.
    virtual std::uint32_t rate() const = 0;
};

} // namespace frob::serve
