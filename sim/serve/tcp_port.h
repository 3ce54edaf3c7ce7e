// A TCP port on this machine for one client at a time; it refuses others.
#pragma once

#include <functional>
#include <string>

#include "connection.h"

namespace frob::serve {

class TcpPort : public Connection {
  public:
    // Port 0 means any free port. Throws std::system_error. Calls `refused` with a message for
    // each client that it refuses.
    TcpPort(int port, std::function<void(const std::string &)> refused);
    ~TcpPort() override;
    TcpPort(const TcpPort &) = delete;
    TcpPort &operator=(const TcpPort &) = delete;

    std::string device() const override;
    int descriptor() const override { return client_ >= 0 ? client_ : listener_; }
    bool connected() const override { return client_ >= 0; }
    Bytes read() override;
    void write(const Bytes &bytes) override;
    std::uint32_t rate() const override { return 0; }

  private:
    void leave();
    void accept_one();
    void refuse_others();

    int listener_ = -1, client_ = -1;
    int port_ = 0;
    std::function<void(const std::string &)> refused_;
};

} // namespace frob::serve
