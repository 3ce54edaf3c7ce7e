// Connects a robot's firmware to a line, in real time.
#pragma once

#include <functional>
#include <memory>

#include "connection.h"
#include "firmware.h"
#include "paced_line.h"

namespace frob::serve {

class Server {
  public:
    Server(Firmware &firmware, bool paced)
        : firmware_(firmware), to_robot_(paced), to_client_(paced) {}

    // Connects the line; a null connection disconnects it.
    void plug(std::unique_ptr<Connection> connection);
    const Connection *connection() const { return connection_.get(); }

    // Advances the robot and the bytes in transit to this time.
    void advance(std::int64_t time_ns);

    // The next time at which the robot acts or a byte arrives.
    std::int64_t due_ns() const;

    // Waits until a byte arrives, an event is due, or a signal interrupts the wait.
    void wait(std::int64_t time_ns) const;

  private:
    void receive(std::int64_t time_ns);
    void send(std::int64_t time_ns);

    Firmware &firmware_;
    PacedLine to_robot_, to_client_;
    std::unique_ptr<Connection> connection_;
    bool there_ = false, left_ = false; // whether a client is connected, and whether one has left
                                        // whose bytes are still in transit
    std::int64_t heard_ns_ = 0;         // time of the last byte
};

} // namespace frob::serve
