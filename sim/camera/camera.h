// A camera on a robot: when it takes frames, when they arrive, and what they show.
#pragma once

#include <cstdint>
#include <deque>
#include <memory>
#include <optional>
#include <vector>

#include <frob/image.h>

#include "film.h"
#include "noise.h"
#include "scenery.h"
#include "truth.h"

namespace frob::sim {

class Camera {
  public:
    // The camera of robot number `robot`. Cameras share the scenery, which must outlive them.
    // Cameras with the same `trigger` seed take their frames at the same times.
    Camera(const CameraSettings &settings, const Chassis &chassis, const Scenery &scenery,
           std::size_t robot, std::uint64_t seed, std::uint64_t trigger);

    // Whether the camera must take a frame, or some rows of one, at this step of the physics.
    bool is_due(std::int64_t time_ns) const { return time_ns >= due_ns_ || is_rolling(); }

    // Takes the frame or rows that are due. The picture is drawn only when `newest` returns the
    // frame.
    void take(std::int64_t time_ns, std::shared_ptr<const Moment> moment);

    // Returns the newest frame that has arrived by now and drops the older ones; nullptr if none
    // has arrived since the last call. Valid until the next call.
    const frob_image *newest(std::int64_t now_ns);

    // Returns the frame that `newest` returned last; nullptr before the first.
    const frob_image *last() const { return image_.pixels == nullptr ? nullptr : &image_; }

    // Ground truth, without blur or noise, for the pixels of the frame that `last` returns, which
    // must exist. If the lens distorts, each pixel gets the truth of the nearest pixel in the
    // undistorted picture.
    Truth truth();

  private:
    struct Exposure {
        std::uint32_t number;
        // times of the first row, of the last row, and of the frame's arrival
        std::int64_t taken_ns, rolled_ns, arrives_ns;
        // times of `moments`, from the first row to the last
        std::vector<std::int64_t> times_ns;
        std::vector<std::shared_ptr<const Moment>> moments;

        bool is_whole() const { return times_ns.back() >= rolled_ns; }
    };

    bool is_rolling() const;
    void draw();
    void draw_row(int y, float *to);
    Moment moment_of(int y) const;
    Pinhole eye_of(const Pose &robot) const;
    void shift(double aside);
    void make_lens_map();
    void draw_distorted();

    CameraSettings settings_;
    const Scenery &scenery_;
    std::size_t robot_;
    Noise timing_;
    frob_camera geometry_{};
    std::int64_t due_ns_ = 0;
    std::uint32_t next_ = 0; // number of the next frame
    std::deque<Exposure> waiting_;

    std::optional<Raster> raster_;
    int margin_x_ = 0, margin_y_ = 0; // extra pixels of the raster around the picture, for
                                      // distortion
    std::vector<Vec> lens_map_;       // position of each pixel in the raster, for distortion
    std::vector<float> straight_;     // light of the whole raster, for distortion
    std::vector<float> light_;        // light of one row: red, green, blue of each pixel
    Film film_;
    frob_image image_{};
    std::optional<Exposure> exposure_; // exposure of `image_`
};

} // namespace frob::sim
