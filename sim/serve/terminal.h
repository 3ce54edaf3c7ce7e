// A pseudo-terminal, for clients that open a serial device.
#pragma once

#include "connection.h"

namespace frob::serve {

class Terminal : public Connection {
  public:
    Terminal(); // throws std::system_error
    ~Terminal() override;
    Terminal(const Terminal &) = delete;
    Terminal &operator=(const Terminal &) = delete;

    std::string device() const override { return path_; }
    int descriptor() const override { return connected_ ? master_ : -1; }
    bool connected() const override { return connected_; }
    Bytes read() override;
    void write(const Bytes &bytes) override;
    std::uint32_t rate() const override;

  private:
    int master_ = -1;
    std::string path_;
    bool connected_ = false; // whether a client has the other side open
};

} // namespace frob::serve
