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

namespace frob::sim
{

class Camera
{
  public:
    // Of robot number `robot`; the scenery, which cameras share, must stay. Cameras with the same
    // `trigger`, a seed, take their frames at the same times.
    Camera(const CameraSettings &settings, const Chassis &chassis, const Scenery &scenery,
           std::size_t robot, std::uint64_t seed, std::uint64_t trigger);

    // Whether a frame, or some of its rows, are to be taken at this step of the physics.
    bool is_due(std::int64_t time_ns) const { return time_ns >= due_ns_ || is_rolling(); }

    // Takes them. What a frame shows is drawn if it is asked for.
    void take(std::int64_t time_ns, std::shared_ptr<const Moment> moment);

    // The newest frame that has arrived by now, once; those before it are gone. nullptr if there
    // is none. Good until the next call.
    const frob_image *newest(std::int64_t now_ns);

    // That one once more; nullptr before the first.
    const frob_image *last() const { return image_.pixels == nullptr ? nullptr : &image_; }

    // What the pixels of that one really show, without blur and noise; with a lens that distorts,
    // each pixel shows what is nearest to its place in a straight picture. There must be one.
    Truth truth();

  private:
    struct Exposure {
        std::uint32_t number;
        std::int64_t taken_ns, rolled_ns, arrives_ns; // first row, last row, frame
        std::vector<std::int64_t> times_ns;           // of moments, from the first row to the last
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
    std::uint32_t next_ = 0; // the number of the next frame
    std::deque<Exposure> waiting_;

    std::optional<Raster> raster_;
    int margin_x_ = 0, margin_y_ = 0; // of the raster around the picture, with distortion
    std::vector<Vec> lens_map_;       // for each pixel where it is in the raster, likewise
    std::vector<float> straight_;     // the light of all of the raster, likewise
    std::vector<float> light_;        // of a row: red, green, blue of each pixel
    Film film_;
    frob_image image_{};
    std::optional<Exposure> exposure_; // of that one
};

} // namespace frob::sim
