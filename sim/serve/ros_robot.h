// A simulated robot in ROS 2. It publishes its sensor values on topics, and drives at the
// velocities that it receives on cmd_vel.
//
// The node is a separate process (runtime/hosts/ros_robot), because the simulator does not depend
// on ROS. They communicate over a socket; runtime/hosts/ros/messages.h defines the messages.
//
// Timestamps and /clock are based on this machine's time, so other nodes may use either the system
// clock or /clock.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include <sys/types.h>

#include <hosts/ros/messages.h>

#include "ros_cameras.h"
#include "sim.h"

namespace frob::serve {

class RosRobot {
  public:
    using Log = std::function<void(std::int64_t time_ns, const std::string &text)>;

    // Opens the world's lidars, inertial measurement units and cameras, starts the node, and waits
    // until it has joined the ROS 2 system. `node`: the executable. `stamped`: whether cmd_vel is a
    // TwistStamped. Throws WrongUse if any of this fails.
    RosRobot(frob_sim *sim, const std::string &node, bool stamped,
             const std::vector<std::string> &arguments);
    ~RosRobot();
    RosRobot(const RosRobot &) = delete;
    RosRobot &operator=(const RosRobot &) = delete;

    // Lines that describe the node and its topics.
    std::vector<std::string> description() const;

    // Runs the robot up to this time, which must not be earlier than in the previous call. Returns
    // false if the node has ended.
    bool advance(std::int64_t time_ns);

    // Waits until a velocity arrives, an event is due, or a signal interrupts the wait.
    void wait(std::int64_t time_ns) const;

    // Called for each command that differs from the previous one.
    void set_log(Log log) { log_ = std::move(log); }

  private:
    struct Sensor {
        int number; // number of the lidar or inertial measurement unit
        bool is_lidar;
        std::string topic;
        double ahead = 0.0, left = 0.0; // m, its position on the robot
    };

    void open_sensors();
    void start(const std::string &node, bool stamped, const std::vector<std::string> &arguments);
    void look(std::int64_t time_ns);
    void send_odometry(std::int64_t time_ns);
    void send_states(std::int64_t time_ns);
    void send_scan(std::uint32_t sensor, std::int64_t time_ns);
    void send_imu(std::uint32_t sensor, std::int64_t time_ns);
    bool receive(std::int64_t time_ns);
    void command(std::int64_t time_ns, double speed, double turn);
    template <class Message>
    Message message(ros_kind kind) const;
    void send(const ros_head &message) const;

    frob_sim *sim_;
    std::vector<Sensor> sensors_;
    RosCameras cameras_;
    int socket_ = -1;
    pid_t process_ = 0;
    ros_started started_{};
    std::unique_ptr<ros_scan> scan_; // buffer for a message
    std::int64_t epoch_ns_;          // this machine's time at the start
    std::int64_t next_ns_ = 0;
    std::int64_t heard_ns_ = 0; // time at which the last velocity arrived
    double speed_ = 0.0, turn_ = 0.0;
    bool told_ = false; // whether the warning about a non-finite velocity was printed
    Log log_;
};

} // namespace frob::serve
