// Serves the simulated cameras as MJPEG over HTTP, as network cameras do, at
// http://127.0.0.1:PORT/NAME. Any number of clients may connect; slow clients skip frames.
#pragma once

#include <cstdint>
#include <deque>
#include <string>
#include <vector>

#include <sim.h>

namespace frob::serve {

class CameraPort {
  public:
    // Opens all cameras of the world. Must be called before the physics runs. Port 0 means any free
    // port. Throws WrongUse if the world has no cameras or this build cannot encode JPEG, and
    // std::system_error if it cannot listen on the port.
    CameraPort(frob_sim *sim, int port);
    ~CameraPort();
    CameraPort(const CameraPort &) = delete;
    CameraPort &operator=(const CameraPort &) = delete;

    // The URLs of the cameras.
    std::vector<std::string> addresses() const;

    // Accepts new clients, and sends each one the frames that have arrived by now. Never blocks.
    void advance(std::int64_t time_ns);

  private:
    struct Client {
        int socket = -1;
        std::string asked;   // the part of its request received so far
        int camera = -1;     // index of the camera that it watches; -1 if not known yet
        bool leaves = false; // whether to close the connection when everything has been sent
        std::string waiting; // data still to be sent
        void receive(const CameraPort &port);
        void flush();
        void close();
    };

    void accept_all();
    void answer(Client &client) const;
    std::string encode(const frob_image &image);

    frob_sim *sim_;
    int listener_ = -1, port_ = 0;
    void *compressor_ = nullptr;
    std::vector<std::string> names_;
    std::vector<Client> clients_;
};

} // namespace frob::serve
