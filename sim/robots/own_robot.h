// A user-defined robot, whose body is a table in C (<frob/body.h>).
#pragma once

#include <frob/body.h>

#include "floor_sensors.h"
#include "photocells.h"
#include "robot.h"
#include "sonar.h"

namespace frob::sim {

// A body's table, converted to the structs that the simulator uses.
struct OwnBody {
    explicit OwnBody(const frob_body &table);

    const frob_body &table;
    Chassis chassis;
    SonarRing ring;
};

class OwnRobot : public Robot {
  public:
    // The body must outlive the robot.
    OwnRobot(const OwnBody &body, const Scene &scene, std::uint64_t seed);

    void read(std::int64_t time_ns, void *input) override;
    void command(std::int64_t time_ns, const void *output) override;
    const std::vector<Echo> &echoes() const override { return sonar_.echoes(); }
    void forget_echoes() override { sonar_.forget_echoes(); }

  private:
    void look(std::int64_t time_ns, const Body &body) override;

    const OwnBody &described_;
    Sonar sonar_;
    const Floor floor_;
    FloorSensors floor_sensors_;
    Photocells photocells_;
};

// Creates a robot kind with this body. The body must outlive all robots of this kind.
RobotKind own_robot_kind(const OwnBody &body);

} // namespace frob::sim
