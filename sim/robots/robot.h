// A simulated robot: what all have in common. Each robot is a class of its own,
// which knows the C structs of its controller's input and output.
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

namespace frob::sim
{

class Robot
{
  public:
    virtual ~Robot() = default;
    Robot(const Robot &) = delete;
    Robot &operator=(const Robot &) = delete;

    // Moves the motors, before a physics step.
    void push(Body &body) { drive_.advance(body.rigid()); }

    // Reads the sensors, after a physics step that ended at `time_ns`; also
    // once before the first.
    void sense(std::int64_t time_ns, const Body &body);

    // What the controller sees, as the robot's input struct. An event is in it
    // once, at the first instant after it happened.
    virtual void read(std::int64_t time_ns, void *input) = 0;

    // What the controller wants, as the robot's output struct.
    virtual void command(const void *output) = 0;

    // All echoes, in order of arrival, for the picture; where there is to be none
    // they are forgotten again and again, and take no memory.
    virtual const std::vector<Echo> &echoes() const = 0;
    virtual void forget_echoes() = 0;

    const Chassis &chassis() const { return chassis_; }
    const DifferentialDrive &drive() const { return drive_; }
    const Odometry &odometry() const { return odometry_; }
    const Contacts &contacts() const { return contacts_; }

    // Streams of noise, one for each thing that has some.
    enum Stream : std::uint64_t {
        drive_stream = 1,
        odometry_stream,
        sonar_stream,
        light_stream,
        floor_stream,
        photocell_stream,
        camera_stream = 1u << 12 // and those after it, of each camera
    };

  protected:
    // Sensors draw their noise from streams of `seed`.
    Robot(const Chassis &chassis, const Scene &scene, std::uint64_t seed);

    // The robot's own sensors.
    virtual void look(std::int64_t time_ns, const Body &body) = 0;

    double battery_voltage(std::int64_t time_ns) const;

    // What all inputs call so.
    template <typename Input>
    void read_motion(Input &input) const
    {
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
    const char *name;                    // "pioneer", as hosts and world files call it
    std::size_t input_size, output_size; // of its structs
    std::function<const Chassis &()> chassis;
    std::function<std::unique_ptr<Robot>(const Scene &scene, std::uint64_t seed)> make;
};

// The first one is what a world has that does not say.
const std::vector<RobotKind> &robot_kinds();

// nullptr if there is none of this name.
const RobotKind *robot_kind(const std::string &name);

} // namespace frob::sim
