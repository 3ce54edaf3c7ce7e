#include "light_bumpers.h"

#include <algorithm>
#include <cmath>

#include "create2.h"

namespace frob::sim {

void LightBumpers::advance(std::int64_t time_ns, const Body &body) {
    if (time_ns % refresh_ns != 0) return;
    const RangeFinders &bumpers = create2::chassis().range_finders;
    for (std::size_t i = 0; i < signals_.size(); ++i) {
        const Pose from = from_frame(body.pose(), bumpers.seats[i]);
        const std::optional<double> distance =
            nearest_in_cone(body, from, 0.0, create2::farthest_light, 1);
        // Draws the noise even if nothing is in range, so that the noise of the other sensors
        // stays the same.
        const double gain = 1 + settings_.noise * noise_.normal();
        const double signal =
            distance ? gain * create2::light_constant / std::max(*distance * *distance, 1e-6) : 0.0;
        signals_[i] = static_cast<std::int32_t>(
            std::lround(std::clamp(signal, 0.0, double{create2::largest_signal})));
        // Programs ignore weaker signals.
        if (signals_[i] >= create2::faintest_light && time_ns % keep_ns == 0)
            echoes_.push_back({time_ns, i, *distance, from});
    }
}

} // namespace frob::sim
