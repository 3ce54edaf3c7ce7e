// Where the line's other end plugs in.
#pragma once

#include <cstdint>
#include <string>

#include "firmware.h"

namespace frob::serve
{

class Connection
{
  public:
    virtual ~Connection() = default;

    // What a client opens: a path, or `tcp:ADDRESS:PORT`.
    virtual std::string device() const = 0;

    // To be polled for input; -1 if there is none now.
    virtual int descriptor() const = 0;

    // Whether somebody is there.
    virtual bool connected() const = 0;

    // What has arrived. Never waits.
    virtual Bytes read() = 0;

    // What does not go is lost, as on a line that nobody reads.
    virtual void write(const Bytes &bytes) = 0;

    // The rate that the client has set; 0 where there is none.
    virtual std::uint32_t rate() const = 0;
};

} // namespace frob::serve
