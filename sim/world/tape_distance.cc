#include "tape_distance.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace frob::sim {
namespace {

constexpr double farthest_step = 0.1; // m along the tape, the maximum movement from one instant to
                                      // the next

double length_of(const Tape &tape) {
    double sum = tape.closed ? length(tape.points.front() - tape.points.back()) : 0.0;
    for (std::size_t i = 0; i + 1 < tape.points.size(); ++i)
        sum += length(tape.points[i + 1] - tape.points[i]);
    return sum;
}

// Distance from `a`, along the segment, to the point nearest to `p`.
double along_segment(Vec p, Vec a, Vec b) {
    const double size = length(b - a);
    return size > 0.0 ? std::clamp(dot(p - a, b - a) / size, 0.0, size) : 0.0;
}

} // namespace

OnTape nearest_on_tape(const Scene &scene, Vec point) {
    OnTape nearest{0, std::numeric_limits<double>::infinity(), 0.0};
    for (std::size_t k = 0; k < scene.tapes.size(); ++k) {
        const Tape &tape = scene.tapes[k];
        const std::size_t n = tape.points.size();
        double before = 0.0;
        for (std::size_t i = 0; i < (tape.closed ? n : n - 1); ++i) {
            const Vec a = tape.points[i], b = tape.points[(i + 1) % n];
            const double distance = std::sqrt(squared_distance_to_segment(point, a, b));
            if (distance < nearest.distance)
                nearest = {k, distance, before + along_segment(point, a, b)};
            before += length(b - a);
        }
    }
    return nearest;
}

TapeDistance::TapeDistance(const Scene &scene, const MeasureSettings &settings)
    : scene_(scene), settings_(settings) {
    for (const Tape &tape : scene.tapes) lengths_.push_back(tape.closed ? length_of(tape) : 0.0);
}

double TapeDistance::observe(std::int64_t time_ns, const Pose &robot) {
    const OnTape now = nearest_on_tape(scene_, robot.position);
    if (static_cast<double>(time_ns) < settings_.settle * 1e9) return now.distance;
    sum_ += now.distance;
    largest_ = std::max(largest_, now.distance);
    ++count_;
    if (settled_ && now.tape == before_.tape) {
        double step = now.along - before_.along;
        // The robot may have passed the first point of a closed tape.
        if (lengths_[now.tape] > 0.0) step = std::remainder(step, lengths_[now.tape]);
        if (std::abs(step) <= farthest_step) way_ += step;
    }
    settled_ = true;
    before_ = now;
    return now.distance;
}

double TapeDistance::mean() const {
    return count_ == 0 ? std::numeric_limits<double>::quiet_NaN()
                       : sum_ / static_cast<double>(count_);
}

double TapeDistance::largest() const {
    return count_ == 0 ? std::numeric_limits<double>::quiet_NaN() : largest_;
}

} // namespace frob::sim
