// A firmware on a line, in the time of the clock.
#pragma once

#include <functional>
#include <memory>

#include "connection.h"
#include "firmware.h"
#include "paced_line.h"

namespace frob::serve
{

class Server
{
  public:
    Server(Firmware &firmware, bool paced)
        : firmware_(firmware), to_robot_(paced), to_client_(paced)
    {
    }

    // Plugs the line in; with nothing, pulls it out.
    void plug(std::unique_ptr<Connection> connection);
    const Connection *connection() const { return connection_.get(); }

    // Moves the robot and the bytes to this time.
    void advance(std::int64_t time_ns);

    // When something happens next: the robot does something, or a byte arrives.
    std::int64_t due_ns() const;

    // Waits until a byte comes or something is due; signals end it.
    void wait(std::int64_t time_ns) const;

  private:
    void receive(std::int64_t time_ns);
    void send(std::int64_t time_ns);

    Firmware &firmware_;
    PacedLine to_robot_, to_client_;
    std::unique_ptr<Connection> connection_;
    bool there_ = false, left_ = false; // a client; one whose bytes are still on their way
    std::int64_t heard_ns_ = 0;         // the last byte
};

} // namespace frob::serve
