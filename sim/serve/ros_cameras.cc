#include "ros_cameras.h"

#include <cerrno>
#include <cstring>

#include <sys/mman.h>
#include <unistd.h>

#include <frob/image.h>

#include "options.h"

namespace frob::serve {
namespace {

// The kernel allocates only those pages of this memory that images use.
constexpr std::size_t memory_size = std::size_t{ROS_IMAGE_SLOTS} * ROS_IMAGE_MOST;

} // namespace

RosCameras::RosCameras(frob_sim *sim) : sim_(sim) {
    for (std::size_t i = 0; const char *name = frob_sim_camera_name(sim, i); ++i) {
        if (i == ROS_CAMERAS_MOST)
            throw WrongUse("the world has more than four cameras: remove some");
        Camera &camera = cameras_.emplace_back();
        camera.name = name;
        camera.topic = camera.name == "camera" ? "image_raw" : camera.name + "/image_raw";
        camera.number = frob_sim_look_through(sim, name);
        camera.file = memfd_create(name, 0); // the node inherits it
        if (camera.file < 0 || ftruncate(camera.file, memory_size) != 0)
            throw WrongUse(std::string("cannot share images with the node: ") +
                           std::strerror(errno));
        void *memory =
            mmap(nullptr, memory_size, PROT_READ | PROT_WRITE, MAP_SHARED, camera.file, 0);
        if (memory == MAP_FAILED)
            throw WrongUse(std::string("cannot share images with the node: ") +
                           std::strerror(errno));
        camera.memory = static_cast<std::uint8_t *>(memory);
    }
}

RosCameras::~RosCameras() {
    for (const Camera &camera : cameras_) {
        if (camera.memory != nullptr) munmap(camera.memory, memory_size);
        close(camera.file);
    }
}

std::vector<std::string> RosCameras::arguments() const {
    std::vector<std::string> words;
    for (const Camera &camera : cameras_)
        words.push_back("camera=" + camera.topic + ',' + camera.name + ',' +
                        std::to_string(camera.file));
    return words;
}

void RosCameras::advance(std::int64_t time_ns, const std::function<void(ros_image &)> &send) {
    for (std::uint32_t i = 0; i < cameras_.size(); ++i) {
        Camera &camera = cameras_[i];
        const frob_image *image = frob_sim_frame(sim_, 0, camera.number, time_ns);
        if (image == nullptr || image->format == FROB_DEPTH_M) continue;
        const auto channels = static_cast<std::uint32_t>(image->format == FROB_GREY8 ? 1 : 3);
        const std::size_t row = static_cast<std::size_t>(image->width) * channels;
        if (row * static_cast<std::size_t>(image->height) > ROS_IMAGE_MOST) continue;
        std::uint8_t *to = camera.memory + std::size_t{camera.slot} * ROS_IMAGE_MOST;
        for (std::int32_t y = 0; y < image->height; ++y, to += row)
            std::memcpy(to, frob_image_row(image, y), row);
        ros_image m{};
        m.head.size = sizeof m;
        m.head.kind = ROS_IMAGE;
        m.camera = i;
        m.slot = camera.slot;
        m.stamp_ns = image->captured_ns;
        m.width = static_cast<std::uint32_t>(image->width);
        m.height = static_cast<std::uint32_t>(image->height);
        m.channels = channels;
        send(m);
        camera.slot = (camera.slot + 1) % ROS_IMAGE_SLOTS;
    }
}

} // namespace frob::serve
