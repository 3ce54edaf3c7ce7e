#include "camera.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace frob::sim {
namespace {

// Noise stream for timing, separate from the streams of the robot's other sensors.
constexpr std::uint64_t timing_stream = 1u << 16;

constexpr std::size_t most_waiting = 64; // maximum number of frames in transit; the oldest ones are
                                         // dropped

std::int64_t nanoseconds(double s) { return static_cast<std::int64_t>(std::floor(s * 1e9 + 0.5)); }

} // namespace

Camera::Camera(const CameraSettings &settings, const Chassis &chassis, const Scenery &scenery,
               std::size_t robot, std::uint64_t seed, std::uint64_t trigger)
    : settings_(settings), scenery_(scenery), robot_(robot), timing_(trigger, timing_stream),
      film_(settings, seed) {
    const Vec half = exact_direction(settings.field_of_view / 2);
    geometry_.focal_x = geometry_.focal_y = settings.width / 2.0 * half.x / half.y;
    geometry_.centre_x = (settings.width - 1) / 2.0;
    geometry_.centre_y = (settings.height - 1) / 2.0;
    geometry_.k1 = settings.k1;
    geometry_.k2 = settings.k2;
    geometry_.x_m = settings.ahead.value_or(chassis.camera.x);
    geometry_.y_m = settings.left.value_or(chassis.camera.y);
    geometry_.z_m = settings.up.value_or(chassis.camera_height);
    geometry_.yaw_rad = settings.yaw;
    geometry_.pitch_rad = settings.pitch;
    geometry_.roll_rad = settings.roll;
    shift(settings.aside);
    make_lens_map();
    raster_.emplace(settings.width + 2 * margin_x_);
    light_.resize(3 * static_cast<std::size_t>(settings.width));
}

// Moves the camera by `aside` along its rows, to the left: (0, 1, 0) rotated by Rz(yaw) Ry(pitch)
// Rx(roll).
void Camera::shift(double aside) {
    const Vec yaw = exact_direction(geometry_.yaw_rad),
              pitch = exact_direction(geometry_.pitch_rad);
    const Vec roll = exact_direction(geometry_.roll_rad);
    const Vec left = {pitch.y * roll.y, roll.x};
    geometry_.x_m += aside * (yaw.x * left.x - yaw.y * left.y);
    geometry_.y_m += aside * (yaw.y * left.x + yaw.x * left.y);
    geometry_.z_m += aside * pitch.x * roll.y;
}

// The lens shows the point (a, b) at the distorted position (a', b'), with a' = a (1 + k1 r^2 + k2
// r^4) and b' = b (1 + k1 r^2 + k2 r^4). Solves for (a, b) by fixed-point iteration, as OpenCV
// does.
void Camera::make_lens_map() {
    if (settings_.k1 == 0.0 && settings_.k2 == 0.0) return;
    Vec most = {};
    for (int y = 0; y < settings_.height; ++y) {
        for (int x = 0; x < settings_.width; ++x) {
            const Vec seen = {(x - geometry_.centre_x) / geometry_.focal_x,
                              (y - geometry_.centre_y) / geometry_.focal_y};
            Vec p = seen;
            for (int i = 0; i < 20; ++i) {
                const double r2 = dot(p, p);
                p = (1.0 / (1.0 + r2 * (settings_.k1 + r2 * settings_.k2))) * seen;
            }
            const Vec pixel = geometry_.focal_x * p;
            most = {std::max(most.x, std::abs(pixel.x)), std::max(most.y, std::abs(pixel.y))};
            lens_map_.push_back(pixel);
        }
    }
    margin_x_ = std::max(0, static_cast<int>(std::ceil(most.x - geometry_.centre_x))) + 1;
    margin_y_ = std::max(0, static_cast<int>(std::ceil(most.y - geometry_.centre_y))) + 1;
    for (Vec &pixel : lens_map_)
        pixel = pixel + Vec{geometry_.centre_x + margin_x_, geometry_.centre_y + margin_y_};
}

bool Camera::is_rolling() const {
    return std::any_of(waiting_.begin(), waiting_.end(),
                       [](const Exposure &e) { return !e.is_whole(); });
}

void Camera::take(std::int64_t time_ns, std::shared_ptr<const Moment> moment) {
    for (Exposure &exposure : waiting_) {
        if (exposure.is_whole() || exposure.times_ns.back() == time_ns) continue;
        exposure.times_ns.push_back(time_ns);
        exposure.moments.push_back(moment);
    }
    if (time_ns < due_ns_) return;
    const bool is_lost = timing_.uniform() < settings_.dropout;
    const std::int64_t rolled_ns = time_ns + nanoseconds(settings_.rolling);
    if (!is_lost)
        waiting_.push_back({next_,
                            time_ns,
                            rolled_ns,
                            rolled_ns + nanoseconds(settings_.latency),
                            {time_ns},
                            {std::move(moment)}});
    if (waiting_.size() > most_waiting) waiting_.pop_front();
    ++next_;
    const double shift = settings_.jitter * (2.0 * timing_.uniform() - 1.0);
    due_ns_ = std::max(time_ns + 1, nanoseconds(next_ / settings_.rate + shift));
}

const frob_image *Camera::newest(std::int64_t now_ns) {
    std::size_t arrived = 0;
    while (arrived < waiting_.size() && waiting_[arrived].arrives_ns <= now_ns &&
           waiting_[arrived].is_whole())
        ++arrived;
    if (arrived == 0) return nullptr;
    exposure_ = std::move(waiting_[arrived - 1]);
    waiting_.erase(waiting_.begin(), waiting_.begin() + static_cast<std::ptrdiff_t>(arrived));
    draw();
    image_.width = settings_.width;
    image_.height = settings_.height;
    image_.stride = settings_.width * (settings_.grey ? 1 : 3);
    image_.format = settings_.grey ? FROB_GREY8 : FROB_RGB8;
    image_.pixels = film_.pixels();
    image_.captured_ns = exposure_->taken_ns;
    image_.number = exposure_->number;
    image_.camera = geometry_;
    return &image_;
}

// The rotation is Rz(heading + yaw) Ry(pitch) Rx(roll), with the true angles: those in the settings
// plus the hidden misalignment.
Pinhole Camera::eye_of(const Pose &robot) const {
    const Vec u = exact_direction(robot.heading);
    const Vec yaw = exact_direction(robot.heading + geometry_.yaw_rad + settings_.askew_yaw);
    const Vec pitch = exact_direction(geometry_.pitch_rad + settings_.askew_pitch);
    const Vec roll = exact_direction(geometry_.roll_rad + settings_.askew_roll);
    const Vec seat = {geometry_.x_m, geometry_.y_m};
    const Vec at = robot.position + Vec{u.x * seat.x - u.y * seat.y, u.y * seat.x + u.x * seat.y};
    const auto turned = [&](Point p) {
        const Point rolled = {p.x, roll.x * p.y - roll.y * p.z, roll.y * p.y + roll.x * p.z};
        const Point tilted = {pitch.x * rolled.x + pitch.y * rolled.z, rolled.y,
                              pitch.x * rolled.z - pitch.y * rolled.x};
        return Point{yaw.x * tilted.x - yaw.y * tilted.y, yaw.y * tilted.x + yaw.x * tilted.y,
                     tilted.z};
    };
    Pinhole eye;
    eye.origin = at_height(at, geometry_.z_m);
    eye.ahead = turned({1.0, 0.0, 0.0});
    eye.right = turned({0.0, -1.0, 0.0});
    eye.down = turned({0.0, 0.0, -1.0});
    eye.focal = geometry_.focal_x;
    eye.cx = geometry_.centre_x + margin_x_;
    eye.cy = geometry_.centre_y + margin_y_;
    eye.width = settings_.width + 2 * margin_x_;
    eye.height = settings_.height + 2 * margin_y_;
    return eye;
}

// The state of the world when a row of the raster was exposed. If the lens distorts, the raster has
// margins, whose rows are exposed together with the nearest row of the picture.
Moment Camera::moment_of(int y) const {
    const int row = std::clamp(y - margin_y_, 0, settings_.height - 1);
    const std::int64_t time_ns =
        exposure_->taken_ns + nanoseconds(settings_.rolling * row / (settings_.height - 1));
    const std::vector<std::int64_t> &times = exposure_->times_ns;
    std::size_t next = 1;
    while (next + 1 < times.size() && times[next] < time_ns) ++next;
    const double share = static_cast<double>(time_ns - times[next - 1]) /
                         static_cast<double>(times[next] - times[next - 1]);
    return between(*exposure_->moments[next - 1], *exposure_->moments[next], share);
}

// Draws one row of the raster. Rows are drawn in order. With a rolling shutter, each group of four
// rows shows the world at its own time.
void Camera::draw_row(int y, float *to) {
    constexpr int few = 4;
    const auto look = [&](const Moment &moment) {
        raster_->start(eye_of(moment.robots[robot_]));
        scenery_.draw(*raster_, moment, robot_);
    };
    if (exposure_->moments.size() == 1) {
        if (y == 0) look(*exposure_->moments.front());
    } else if (y % few == 0) {
        look(moment_of(y + few / 2));
    }
    raster_->row(y, to);
}

void Camera::draw() {
    film_.start(exposure_->number);
    if (!lens_map_.empty()) return draw_distorted();
    for (int y = 0; y < settings_.height; ++y) {
        draw_row(y, light_.data());
        film_.expose(light_.data());
    }
}

Truth Camera::truth() {
    Truth truth(settings_.width, settings_.height);
    const int width = settings_.width + 2 * margin_x_, height = settings_.height + 2 * margin_y_;
    Truth straight(width, height);
    std::vector<float> light(3 * static_cast<std::size_t>(width));
    for (int y = 0; y < height; ++y) {
        draw_row(y, light.data());
        for (int x = 0; x < width; ++x) straight.set(x, y, raster_->depth(x), raster_->thing(x));
    }
    if (lens_map_.empty()) return straight;
    const Vec *p = lens_map_.data();
    for (int y = 0; y < settings_.height; ++y) {
        for (int x = 0; x < settings_.width; ++x, ++p) {
            const int i = static_cast<int>(p->x + 0.5), j = static_cast<int>(p->y + 0.5);
            truth.set(x, y, straight.depth_at(i, j), straight.thing_at(i, j));
        }
    }
    return truth;
}

// Interpolates each pixel between four pixels of the undistorted picture.
void Camera::draw_distorted() {
    const int height = settings_.height + 2 * margin_y_;
    const std::size_t row = 3 * static_cast<std::size_t>(settings_.width + 2 * margin_x_);
    straight_.resize(row * static_cast<std::size_t>(height));
    for (int y = 0; y < height; ++y) draw_row(y, &straight_[row * static_cast<std::size_t>(y)]);
    const Vec *p = lens_map_.data();
    for (int y = 0; y < settings_.height; ++y) {
        for (std::size_t i = 0; i < light_.size(); i += 3, ++p) {
            const auto left = static_cast<std::size_t>(p->x), top = static_cast<std::size_t>(p->y);
            const float right_share = static_cast<float>(p->x - static_cast<double>(left));
            const float low_share = static_cast<float>(p->y - static_cast<double>(top));
            const float *high = &straight_[row * top + 3 * left], *low = high + row;
            for (std::size_t k = 0; k < 3; ++k) {
                const float above = high[k] + right_share * (high[k + 3] - high[k]);
                const float below = low[k] + right_share * (low[k + 3] - low[k]);
                light_[i + k] = above + low_share * (below - above);
            }
        }
        film_.expose(light_.data());
    }
}

} // namespace frob::sim
