// The cameras of a simulated robot in ROS 2. Their images are too large for the socket to the node,
// so they are passed through shared memory (runtime/hosts/ros_robot/images.h).
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include <hosts/ros/messages.h>

#include "sim.h"

namespace frob::serve {

class RosCameras {
  public:
    // Opens the world's cameras. Throws WrongUse if there are too many, or if there is no memory
    // for their images.
    explicit RosCameras(frob_sim *sim);
    ~RosCameras();
    RosCameras(const RosCameras &) = delete;
    RosCameras &operator=(const RosCameras &) = delete;

    // The arguments for the node. They contain file descriptors that the node inherits.
    std::vector<std::string> arguments() const;

    // Writes the images that have arrived by now to the shared memory, and calls `send` with the
    // messages for the node. Their timestamps are in simulated time.
    void advance(std::int64_t time_ns, const std::function<void(ros_image &)> &send);

  private:
    struct Camera {
        std::string name, topic;
        int number = -1; // its number in the simulation
        int file = -1;   // the shared memory
        std::uint8_t *memory = nullptr;
        std::uint32_t slot = 0; // the next slot to write
    };

    frob_sim *sim_;
    std::vector<Camera> cameras_;
};

} // namespace frob::serve
