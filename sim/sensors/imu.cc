#include "imu.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace frob::sim {
namespace {

constexpr double gravity = 9.80665; // m/s^2
constexpr double closest = 0.05;    // m; closer to a magnet than this, its field decreases linearly
                                    // to zero
constexpr std::size_t most_waiting = 10000; // measurements that have not arrived yet

std::int64_t nanoseconds(double seconds) { return std::llround(seconds * 1e9); }

// The velocity of the point midway between the wheels, in world coordinates.
Vec velocity_of(const Body &body) {
    const b2Vec2 v = body.rigid().GetLinearVelocityFromLocalPoint({0.0f, 0.0f});
    return {static_cast<double>(v.x), static_cast<double>(v.y)};
}

} // namespace

Imu::Imu(const ImuSettings &settings, std::vector<Magnet> magnets, Noise noise, const Body &body)
    : settings_(settings), magnets_(std::move(magnets)), noise_(noise),
      heading_(body.pose().heading), velocity_(velocity_of(body)),
      due_ns_(nanoseconds(1.0 / settings.rate)) {
    for (double &bias : gyro_bias_) bias = settings.gyro_bias * noise_.normal();
    for (double &bias : acceleration_bias_) bias = settings.acceleration_bias * noise_.normal();
}

// The horizontal field in the world is the sum of the Earth's field, which points along the x
// axis, and the fields of the magnets:
//   B = (1, 0) + sum of strength * r / |r|^4, with r from the magnet to the robot.
// The compass assumes that this field points along the x axis.
double Imu::compass(const Pose &pose) {
    Vec field = {1.0, 0.0};
    for (const Magnet &magnet : magnets_) {
        const Vec r = pose.position - magnet.position;
        const double distance = std::max(closest, length(r));
        field = field + magnet.strength / (distance * distance * distance * distance) * r;
    }
    return wrap_angle(pose.heading - std::atan2(field.y, field.x) + settings_.compass_error +
                      settings_.compass_noise * noise_.normal());
}

// The rate and the acceleration are means over the time since the last measurement, so integrating
// them adds no error.
//   gyroscope = (1 + scale error) * rate + bias + noise * n
//   accelerometer = acceleration + (0, 0, gravity) + bias + noise * n
// The bias of the gyroscope performs a random walk: bias += drift * sqrt(seconds) * n.
frob_imu Imu::measure(double seconds, const Body &body) {
    const Pose pose = body.pose();
    const Vec velocity = velocity_of(body);
    const double turned = wrap_angle(pose.heading - heading_);
    const Vec u = direction(heading_ + 0.5 * turned); // at the middle of the interval
    const Vec change = 1.0 / seconds * (velocity - velocity_);
    const double rate[3] = {0.0, 0.0, turned / seconds};
    const double acceleration[3] = {dot(u, change), cross(u, change), gravity};
    frob_imu value{};
    for (std::size_t i = 0; i < 3; ++i) {
        gyro_bias_[i] += settings_.gyro_drift * std::sqrt(seconds) * noise_.normal();
        value.rate_radps[i] = (1.0 + settings_.gyro_scale) * rate[i] + gyro_bias_[i] +
                              settings_.gyro_noise * noise_.normal();
        value.acceleration_mps2[i] = acceleration[i] + acceleration_bias_[i] +
                                     settings_.acceleration_noise * noise_.normal();
    }
    const double heading = compass(pose);
    value.heading_rad = settings_.compass ? heading : std::numeric_limits<double>::quiet_NaN();
    heading_ = pose.heading;
    velocity_ = velocity;
    return value;
}

void Imu::advance(std::int64_t time_ns, const Body &body) {
    if (time_ns < due_ns_ || time_ns == measured_ns_) return;
    frob_imu value = measure(static_cast<double>(time_ns - measured_ns_) * 1e-9, body);
    value.taken_ns = measured_ns_ = time_ns;
    value.number = next_++;
    waiting_.push_back({time_ns + nanoseconds(settings_.latency), value});
    if (waiting_.size() > most_waiting) waiting_.pop_front();
    due_ns_ = std::max(time_ns + 1, nanoseconds((next_ + 1) / settings_.rate));
}

const frob_imu *Imu::newest(std::int64_t now_ns) {
    frob_imu sum{};
    double count = 0.0;
    for (; !waiting_.empty() && waiting_.front().arrives_ns <= now_ns; waiting_.pop_front()) {
        frob_imu value = waiting_.front().value;
        for (std::size_t i = 0; i < 3; ++i) {
            value.rate_radps[i] += sum.rate_radps[i];
            value.acceleration_mps2[i] += sum.acceleration_mps2[i];
        }
        sum = value;
        count += 1.0;
    }
    if (count < 1.0) return nullptr;
    for (std::size_t i = 0; i < 3; ++i) {
        sum.rate_radps[i] /= count;
        sum.acceleration_mps2[i] /= count;
    }
    given_ = sum;
    return &given_;
}

} // namespace frob::sim
