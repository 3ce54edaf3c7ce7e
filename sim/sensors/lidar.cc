#include "lidar.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "ray_fan.h"

namespace frob::sim {
namespace {

constexpr double turn = 6.283185307179586;
constexpr double widest_fan = turn / 4;    // a fan must be narrower than half a turn
constexpr std::size_t most_waiting = 1000; // scans that have not arrived yet

std::int64_t nanoseconds(double seconds) { return std::llround(seconds * 1e9); }

// The equivalent angle from 0 (inclusive) to a full turn (exclusive).
double positive(double angle) { return angle - turn * std::floor(angle / turn); }

} // namespace

// The rays of a full circle begin straight ahead; otherwise they are spread evenly from the right
// end of the field of view to the left end.
Lidar::Lidar(const LidarSettings &settings, Noise noise) : settings_(settings), noise_(noise) {
    const bool is_circle = settings.field_of_view > turn - 1e-9;
    step_ =
        is_circle ? turn / settings.rays : settings.field_of_view / std::max(1, settings.rays - 1);
    first_ = settings.yaw;
    if (!is_circle && settings.rays > 1) first_ -= settings.field_of_view / 2;
    for (int i = 0; i < settings.rays; ++i) masked_.push_back(is_masked(first_ + i * step_));
}

bool Lidar::is_masked(double bearing) const {
    return std::any_of(settings_.masks.begin(), settings_.masks.end(), [&](const Vec &mask) {
        return positive(bearing - mask.x) <= positive(mask.y - mask.x);
    });
}

// seen = true distance + noise * n, n normal. The value of a lost or blocked ray is NaN, and that
// of a ray that hits nothing is infinity.
std::vector<double> Lidar::measure(const Body &body) {
    constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
    constexpr double nothing = std::numeric_limits<double>::infinity();
    const Pose seat = from_frame(body.pose(), Pose{{settings_.ahead, settings_.left}, 0.0});
    std::vector<double> ranges;
    const int in_fan = std::max(1, static_cast<int>(widest_fan / step_));
    for (int begin = 0; begin < settings_.rays; begin += in_fan) {
        const int end = std::min(settings_.rays, begin + in_fan);
        const double half = 0.5 * step_ * (end - 1 - begin);
        const double middle = seat.heading + first_ + step_ * begin + half;
        const RayFan fan(body, seat.position, middle, half, settings_.farthest);
        for (int i = begin; i < end; ++i) {
            // Draws the noise of all rays, so that an obstacle does not change the noise of other
            // rays.
            const double error = settings_.noise * noise_.normal();
            const bool is_lost = noise_.uniform() < settings_.dropout;
            if (masked_[static_cast<std::size_t>(i)] || is_lost) {
                ranges.push_back(unknown);
                continue;
            }
            const auto hit = fan.ray(seat.heading + first_ + i * step_, settings_.farthest);
            ranges.push_back(hit ? std::max(0.0, *hit + error) : nothing);
        }
    }
    return ranges;
}

void Lidar::advance(std::int64_t time_ns, const Body &body) {
    if (time_ns < due_ns_) return;
    waiting_.push_back({time_ns, time_ns + nanoseconds(settings_.latency), next_, measure(body)});
    if (waiting_.size() > most_waiting) waiting_.pop_front();
    ++next_;
    due_ns_ = std::max(time_ns + 1, nanoseconds(next_ / settings_.rate));
}

const frob_scan *Lidar::newest(std::int64_t now_ns) {
    std::size_t arrived = 0;
    while (arrived < waiting_.size() && waiting_[arrived].arrives_ns <= now_ns) ++arrived;
    if (arrived == 0) return nullptr;
    given_ = std::move(waiting_[arrived - 1]);
    waiting_.erase(waiting_.begin(), waiting_.begin() + static_cast<std::ptrdiff_t>(arrived));
    scan_ = {given_.ranges.data(), given_.ranges.size(), first_,          step_,
             settings_.nearest,    settings_.farthest,   settings_.ahead, settings_.left,
             given_.taken_ns,      given_.number};
    return &scan_;
}

} // namespace frob::sim
