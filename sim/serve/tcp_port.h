// A TCP port on this machine, for one client at a time.
#pragma once

#include "connection.h"

namespace frob::serve {

class TcpPort : public Connection {
  public:
    explicit TcpPort(int port); // 0: any free one; throws std::system_error
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

    int listener_ = -1, client_ = -1;
    int port_ = 0;
};

} // namespace frob::serve
