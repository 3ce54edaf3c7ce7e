// The simulated cameras as MJPEG over HTTP, as cameras on networks give it: http://127.0.0.1:PORT/
// and the camera's name. Any number of clients; to one that is slow, fewer frames are sent.
#pragma once

#include <cstdint>
#include <deque>
#include <string>
#include <vector>

#include <sim.h>

namespace frob::serve
{

class CameraPort
{
  public:
    // Looks through all cameras of the world, before its physics runs. Port 0: any that is free.
    // Throws WrongUse if the world has none, or JPEG cannot be made here; std::system_error.
    CameraPort(frob_sim *sim, int port);
    ~CameraPort();
    CameraPort(const CameraPort &) = delete;
    CameraPort &operator=(const CameraPort &) = delete;

    // What a program is to be told, of each camera.
    std::vector<std::string> addresses() const;

    // Takes clients in, and gives each the frames that have come by now. Never waits.
    void advance(std::int64_t time_ns);

  private:
    struct Client {
        int socket = -1;
        std::string asked;   // what has come of its request
        int camera = -1;     // it gets the frames of this one; -1: not yet known
        bool leaves = false; // when all has been sent
        std::string waiting; // to be sent
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
