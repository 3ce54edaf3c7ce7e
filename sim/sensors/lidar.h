// A lidar: rays in many horizontal directions, all measured at the same time.
#pragma once

#include <cstdint>
#include <deque>
#include <vector>

#include <frob/lidar.h>

#include "body.h"
#include "noise.h"
#include "scene.h"

namespace frob::sim {

class Lidar {
  public:
    Lidar(const LidarSettings &settings, Noise noise);

    // Takes a scan if one is due. Must be called after each physics step, with the time since the
    // start.
    void advance(std::int64_t time_ns, const Body &body);

    // Returns the newest scan that has arrived by now and drops the older ones; nullptr if none has
    // arrived since the last call. Valid until the next call.
    const frob_scan *newest(std::int64_t now_ns);

  private:
    struct Scan {
        std::int64_t taken_ns, arrives_ns;
        std::uint32_t number;
        std::vector<double> ranges;
    };

    std::vector<double> measure(const Body &body);
    bool is_masked(double bearing) const;

    LidarSettings settings_;
    Noise noise_;
    double first_, step_;      // bearing of ray 0 and angle between rays, in rad
    std::vector<bool> masked_; // for each ray: whether a part of the robot blocks it
    std::uint32_t next_ = 0;   // number of the next scan
    std::int64_t due_ns_ = 0;
    std::deque<Scan> waiting_;
    Scan given_{}; // the scan that `newest` returned last
    frob_scan scan_{};
};

} // namespace frob::sim
