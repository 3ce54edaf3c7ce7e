#include "camera.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "wide.h"

namespace frob::sim {
namespace {

// Streams of noise, apart from those of the robot's other sensors.
constexpr std::uint64_t timing_stream = 1u << 16, frame_stream = std::uint64_t{1} << 32;

constexpr double strongest = 1e6; // exposure and noise: all is white then, or as likely black

constexpr std::size_t most_waiting = 64; // frames on their way; the oldest are lost

std::int64_t nanoseconds(double s) { return static_cast<std::int64_t>(std::floor(s * 1e9 + 0.5)); }

// The steps from light to numbers, of a row each: simple loops, of which compilers make wide ones.

FROB_WIDE void take_colours(const Raster::Single *light, double gain, double *__restrict to,
                            std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) {
        to[3 * i] = gain * static_cast<double>(light[i].red);
        to[3 * i + 1] = gain * static_cast<double>(light[i].green);
        to[3 * i + 2] = gain * static_cast<double>(light[i].blue);
    }
}

FROB_WIDE void take_grey(const Raster::Single *light, double gain, double *__restrict to,
                         std::size_t count) {
    for (std::size_t i = 0; i < count; ++i)
        to[i] = (77 * (gain * static_cast<double>(light[i].red)) +
                 150 * (gain * static_cast<double>(light[i].green)) +
                 29 * (gain * static_cast<double>(light[i].blue))) /
                256;
}

// Of each part of a pixel the sum of three numbers of seven bits: mean 190.5, standard deviation
// 63.998, nearly normal, out to three deviations. All parts are summed at once, as none has a sum
// that reaches into the next one's 21 bits.
void take_grains(std::uint64_t bits, std::int32_t *to, std::size_t parts) {
    constexpr std::uint64_t sevens = 127u | std::uint64_t{127} << 21 | std::uint64_t{127} << 42;
    std::uint64_t sums = (bits & sevens) + (bits >> 7 & sevens) + (bits >> 14 & sevens);
    for (std::size_t i = 0; i < parts; ++i, sums >>= 21) to[i] = static_cast<int>(sums & 511u);
}

FROB_WIDE void add_noise(const std::int32_t *grains, double noise, double *__restrict to,
                         std::size_t count) {
    for (std::size_t i = 0; i < count; ++i)
        to[i] += noise * ((grains[i] - 190.5) * (1.0 / 63.998));
}

// What is too bright, or darker than black, is as far as a number goes; no light is so strong
// that an int has no room for it (strongest).
FROB_WIDE void round(const double *from, std::uint8_t *__restrict to, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) {
        const int level = static_cast<int>(from[i] + 0.5);
        to[i] = static_cast<std::uint8_t>(level < 0 ? 0 : level > 255 ? 255 : level);
    }
}

// A mean's share of each pixel up to `radius` away of which there are `count`, around number i.
float share_of(int i, int count, int radius) {
    const int first = std::max(0, i - radius), last = std::min(count - 1, i + radius);
    return 1.0f / static_cast<float>(last - first + 1);
}

FROB_WIDE void add(const Raster::Single *from, Raster::Single *__restrict to, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) {
        to[i].red += from[i].red;
        to[i].green += from[i].green;
        to[i].blue += from[i].blue;
    }
}

FROB_WIDE void scale(const Raster::Single *from, const float *share, Raster::Single *__restrict to,
                     std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) {
        to[i].red = share[i] * from[i].red;
        to[i].green = share[i] * from[i].green;
        to[i].blue = share[i] * from[i].blue;
    }
}

} // namespace

Camera::Camera(const CameraSettings &settings, const Chassis &chassis, const Scenery &scenery,
               std::size_t robot, std::uint64_t seed, std::uint64_t trigger)
    : settings_(settings), scenery_(scenery), robot_(robot), seed_(seed),
      timing_(trigger, timing_stream) {
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
}

// Along its rows, to the left: (0, 1, 0) turned by Rz(yaw) Ry(pitch) Rx(roll).
void Camera::shift(double aside) {
    const Vec yaw = exact_direction(geometry_.yaw_rad), pitch = exact_direction(geometry_.pitch_rad);
    const Vec roll = exact_direction(geometry_.roll_rad);
    const Vec left = {pitch.y * roll.y, roll.x};
    geometry_.x_m += aside * (yaw.x * left.x - yaw.y * left.y);
    geometry_.y_m += aside * (yaw.y * left.x + yaw.x * left.y);
    geometry_.z_m += aside * pitch.x * roll.y;
}

// What the lens shows at a distorted place (a', b') is at (a, b) with a' = a (1 + k1 r^2 +
// k2 r^4), and likewise b'. Solved by repetition, as OpenCV does it.
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

void Camera::take(std::int64_t time_ns, std::shared_ptr<const Moment> moment) {
    const bool is_lost = timing_.uniform() < settings_.dropout;
    if (!is_lost)
        waiting_.push_back(
            {next_, time_ns, time_ns + nanoseconds(settings_.latency), std::move(moment)});
    if (waiting_.size() > most_waiting) waiting_.pop_front();
    ++next_;
    const double shift = settings_.jitter * (2.0 * timing_.uniform() - 1.0);
    due_ns_ = std::max(time_ns + 1, nanoseconds(next_ / settings_.rate + shift));
}

const frob_image *Camera::newest(std::int64_t now_ns) {
    std::size_t arrived = 0;
    while (arrived < waiting_.size() && waiting_[arrived].arrives_ns <= now_ns) ++arrived;
    if (arrived == 0) return nullptr;
    const Exposure exposure = std::move(waiting_[arrived - 1]);
    waiting_.erase(waiting_.begin(), waiting_.begin() + static_cast<std::ptrdiff_t>(arrived));
    draw(exposure);
    develop(exposure);
    return &image_;
}

// The rotation is Rz(heading + yaw) Ry(pitch) Rx(roll), of angles as they really are.
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

void Camera::draw(const Exposure &exposure) {
    raster_.start(eye_of(exposure.moment->robots[robot_]));
    scenery_.draw(raster_, *exposure.moment, robot_);
    if (lens_map_.empty()) {
        raster_.give_tints(light_);
        return blur();
    }
    light_.clear();
    for (const Vec &p : lens_map_) {
        const int x = static_cast<int>(p.x), y = static_cast<int>(p.y);
        const float right = static_cast<float>(p.x - x), low = static_cast<float>(p.y - y);
        const auto mean = [&](float Raster::Single::*part) {
            const float top = raster_.tint(x, y).*part, bottom = raster_.tint(x, y + 1).*part;
            const float above = top + right * (raster_.tint(x + 1, y).*part - top);
            const float below = bottom + right * (raster_.tint(x + 1, y + 1).*part - bottom);
            return above + low * (below - above);
        };
        light_.push_back({mean(&Raster::Single::red), mean(&Raster::Single::green),
                          mean(&Raster::Single::blue)});
    }
    blur();
}

// Means over squares, along rows and then along columns; at the rim of what is there. Sums go from
// one end to the other, of many pixels side by side.
void Camera::blur() {
    const int radius = static_cast<int>(settings_.blur);
    if (radius == 0) return;
    const auto width = static_cast<std::size_t>(settings_.width);
    std::vector<Raster::Single> sums(width);
    std::vector<float> shares(width);
    for (int x = 0; x < settings_.width; ++x)
        shares[static_cast<std::size_t>(x)] = share_of(x, settings_.width, radius);
    blurred_.resize(light_.size());
    for (std::size_t at = 0; at < light_.size(); at += width) {
        std::fill(sums.begin(), sums.end(), Raster::Single{0.0f, 0.0f, 0.0f});
        for (int by = -radius; by <= radius; ++by) {
            const auto before = static_cast<std::size_t>(std::max(0, -by));
            const auto after = static_cast<std::size_t>(std::max(0, by));
            if (before + after < width)
                add(&light_[at] + after, sums.data() + before, width - before - after);
        }
        scale(sums.data(), shares.data(), &blurred_[at], width);
    }
    for (int y = 0; y < settings_.height; ++y) {
        std::fill(sums.begin(), sums.end(), Raster::Single{0.0f, 0.0f, 0.0f});
        const int first = std::max(0, y - radius);
        const int last = std::min(settings_.height - 1, y + radius);
        for (int k = first; k <= last; ++k)
            add(&blurred_[static_cast<std::size_t>(k) * width], sums.data(), width);
        std::fill(shares.begin(), shares.end(), share_of(y, settings_.height, radius));
        scale(sums.data(), shares.data(), &light_[static_cast<std::size_t>(y) * width], width);
    }
}

// From light to numbers: value = 255 exposure light + noise n, n normal.
void Camera::develop(const Exposure &exposure) {
    const double gain = 255.0 * std::min(settings_.exposure, strongest);
    const double noise = std::min(settings_.noise, strongest);
    const std::size_t parts = settings_.grey ? 1 : 3;
    const auto width = static_cast<std::size_t>(settings_.width), row = parts * width;
    Noise random(seed_, frame_stream + exposure.number);
    std::vector<double> values(row);
    std::vector<std::int32_t> grains(row);
    pixels_.resize(parts * light_.size());
    for (std::size_t y = 0; y * width < light_.size(); ++y) {
        const Raster::Single *light = &light_[y * width];
        if (settings_.grey)
            take_grey(light, gain, values.data(), width);
        else
            take_colours(light, gain, values.data(), width);
        if (noise > 0.0) {
            for (std::size_t x = 0; x < width; ++x)
                take_grains(random.bits(), &grains[parts * x], parts);
            add_noise(grains.data(), noise, values.data(), row);
        }
        round(values.data(), &pixels_[y * row], row);
    }
    image_.width = settings_.width;
    image_.height = settings_.height;
    image_.stride = settings_.width * (settings_.grey ? 1 : 3);
    image_.format = settings_.grey ? FROB_GREY8 : FROB_RGB8;
    image_.pixels = pixels_.data();
    image_.captured_ns = exposure.taken_ns;
    image_.number = exposure.number;
    image_.camera = geometry_;
}

} // namespace frob::sim
