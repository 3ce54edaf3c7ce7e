// The parts that all simulated robots share. Each kind of robot is a subclass, which handles the C
// structs of its controller's input and output.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "chassis.h"
#include "contacts.h"
#include "drive.h"
#include "echo.h"
#include "odometry.h"

namespace frob::sim {

class Robot {
  public:
    virtual ~Robot() = default;
    Robot(const Robot &) = delete;
    Robot &operator=(const Robot &) = delete;

    // Drives the motors, before a physics step.
    void push(Body &body) { drive_.advance(body.rigid()); }

    // Reads the sensors, after a physics step that ended at `time_ns`; also called once before the
    // first step.
    void sense(std::int64_t time_ns, const Body &body);

    // Writes the sensor readings to the robot's input struct. Each event occurs in the input only
    // once, at the first instant after it happened.
    virtual void read(std::int64_t time_ns, void *input) = 0;

    // Reads the controller's command at this instant from the robot's output struct.
    virtual void command(std::int64_t time_ns, const void *output) = 0;

    // All echoes in order of arrival, for the picture. If there is no picture, the simulation
    // calls `forget_echoes` regularly, so that the echoes do not use up memory.
    virtual const std::vector<Echo> &echoes() const = 0;
    virtual void forget_echoes() = 0;

    const Chassis &chassis() const { return chassis_; }
    const DifferentialDrive &drive() const { return drive_; }
    const Odometry &odometry() const { return odometry_; }
    const Contacts &contacts() const { return contacts_; }

    // Numbers of the noise streams, one for each source of noise.
    enum Stream : std::uint64_t {
        drive_stream = 1,
        odometry_stream,
        sonar_stream,
        light_stream,
        floor_stream,
        photocell_stream,
        camera_stream = 1u << 12, // the first of a range, one for each camera
        lidar_stream = 1u << 13,  // the same for lidars
        imu_stream = 1u << 14     // the same for inertial measurement units
    };

  protected:
    // The noise streams of the sensors are derived from `seed`.
    Robot(const Chassis &chassis, const Scene &scene, std::uint64_t seed);

    // Reads the sensors that are specific to this kind of robot.
    virtual void look(std::int64_t time_ns, const Body &body) = 0;

    double battery_voltage(std::int64_t time_ns) const;

    // Fills in the fields that have the same names in the input structs of all kinds of robots.
    template <typename Input>
    void read_motion(Input &input) const {
        const Pose &believed = odometry_.pose();
        input.odometry.position.x = believed.position.x;
        input.odometry.position.y = believed.position.y;
        input.odometry.heading = believed.heading;
        input.leftWheel = drive_.left_speed();
        input.rightWheel = drive_.right_speed();
    }

    const Chassis &chassis_;
    BatterySettings battery_;
    DifferentialDrive drive_;
    Odometry odometry_;
    Contacts contacts_;
};

// A kind of robot that can be simulated.
struct RobotKind {
    const char *name;                    // name in hosts and world files, such as "pioneer"
    std::size_t input_size, output_size; // sizes of its C structs
    std::function<const Chassis &()> chassis;
    std::function<std::unique_ptr<Robot>(const Scene &scene, std::uint64_t seed)> make;
    // Whether the robot has a default lidar and a default inertial measurement unit, which apply if
    // the world file does not describe any.
    bool equipped = false;
};

// The first kind is the default for worlds that do not name a robot.
const std::vector<RobotKind> &robot_kinds();

// Returns nullptr if there is no kind with this name.
const RobotKind *robot_kind(const std::string &name);

} // namespace frob::sim
