// An inertial measurement unit: a gyroscope, an accelerometer and a magnetometer.
#pragma once

#include <array>
#include <cstdint>
#include <deque>
#include <vector>

#include <frob/imu.h>

#include "body.h"
#include "noise.h"
#include "scene.h"

namespace frob::sim {

class Imu {
  public:
    Imu(const ImuSettings &settings, std::vector<Magnet> magnets, Noise noise, const Body &body);

    // Takes a measurement if one is due. Must be called after each physics step, with the time
    // since the start.
    void advance(std::int64_t time_ns, const Body &body);

    // Returns the mean of the measurements that have arrived since the last call, with the heading
    // of the newest one; nullptr if none has arrived. Valid until the next call.
    const frob_imu *newest(std::int64_t now_ns);

  private:
    struct Measurement {
        std::int64_t arrives_ns;
        frob_imu value;
    };

    frob_imu measure(double seconds, const Body &body);
    double compass(const Pose &pose);

    ImuSettings settings_;
    std::vector<Magnet> magnets_;
    Noise noise_;
    std::array<double, 3> gyro_bias_{}, acceleration_bias_{};
    // the state at the last measurement
    std::int64_t measured_ns_ = 0;
    double heading_;
    Vec velocity_;
    std::uint32_t next_ = 0; // number of the next measurement
    std::int64_t due_ns_;
    std::deque<Measurement> waiting_;
    frob_imu given_{};
};

} // namespace frob::sim
