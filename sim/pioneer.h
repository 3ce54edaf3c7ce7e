// The simulated Pioneer P3-DX: what its controller reads and commands.
#pragma once

#include <cstdint>

#include <frob/pioneer.h>

#include "bumpers.h"
#include "drive.h"
#include "odometry.h"
#include "sonar.h"

namespace frob::sim {

class Pioneer {
  public:
    // Sensors draw their noise from streams of `seed`.
    Pioneer(const Scene &scene, std::uint64_t seed);

    // Moves the motors, before a physics step.
    void push(World &world) { drive_.advance(world.robot()); }

    // Reads the sensors, after a physics step that ended at `time_ns`; also
    // once before the first.
    void sense(std::int64_t time_ns, const World &world);

    // What the controller sees. An echo is in it once, at the first instant
    // after it arrived.
    frob_pioneer_input read(std::int64_t time_ns);

    void command(const frob_pioneer_output &output) { drive_.command(output.forward, output.turn); }

    const DifferentialDrive &drive() const { return drive_; }
    const Odometry &odometry() const { return odometry_; }
    const Sonar &sonar() const { return sonar_; }
    const Bumpers &bumpers() const { return bumpers_; }

  private:
    BatterySettings battery_;
    DifferentialDrive drive_;
    Odometry odometry_;
    Sonar sonar_;
    Bumpers bumpers_;
};

} // namespace frob::sim
