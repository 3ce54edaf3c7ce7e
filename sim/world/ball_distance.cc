#include "ball_distance.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace frob::sim {

double BallDistance::observe(std::int64_t time_ns, const Pose &robot,
                             const std::vector<Vec> &balls) {
    double nearest = std::numeric_limits<double>::infinity();
    for (const Vec &ball : balls) nearest = std::min(nearest, length(ball - robot.position));
    if (static_cast<double>(time_ns) >= settings_.settle * 1e9) {
        const double error = std::abs(nearest - settings_.distance);
        sum_ += error;
        largest_ = std::max(largest_, error);
        ++count_;
    }
    return nearest;
}

double BallDistance::mean_error() const {
    return count_ == 0 ? std::numeric_limits<double>::quiet_NaN()
                       : sum_ / static_cast<double>(count_);
}

double BallDistance::largest_error() const {
    return count_ == 0 ? std::numeric_limits<double>::quiet_NaN() : largest_;
}

} // namespace frob::sim
