// The simulation: a world, its robots, and the measurements of their runs.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "ball_distance.h"
#include "camera.h"
#include "imu.h"
#include "lidar.h"
#include "recorder.h"
#include "robot.h"
#include "tape_distance.h"
#include "wall_distance.h"
#include "world.h"

namespace frob::sim {

// The beginning of a robot's collision.
struct Collision {
    std::int64_t time_ns;
    std::string with; // the object, for display
    Vec where;        // in world coordinates
    double clearance; // distance from the robot's centre to the nearest fixed object, at that time
};

// One robot, and the record of its run.
struct Member {
    std::unique_ptr<Robot> robot;
    Recorder recorder;
    std::optional<WallDistance> wall_distance; // present if the world requests this measurement
    std::optional<TapeDistance> tape_distance;
    std::optional<BallDistance> ball_distance;
    std::vector<Camera> cameras;       // the opened cameras
    std::vector<Lidar> lidars;         // the opened lidars
    std::vector<Imu> imus;             // the opened inertial measurement units
    std::vector<Collision> collisions; // the first few collisions
    bool touched = false;              // whether the robot touched anything during the last call to
                                       // `advance` that ran a step
};

class Simulation {
  public:
    // Throws WorldFileError if a robot starts inside an object. `keeps_samples`: whether to store
    // the samples that a picture needs. If `own` is given, it is the kind of all robots, and must
    // outlive the simulation; otherwise the scene names the kind.
    Simulation(Scene scene, std::uint64_t seed, bool keeps_samples = true,
               const RobotKind *own = nullptr);

    Simulation(const Simulation &) = delete;
    Simulation &operator=(const Simulation &) = delete;

    // Runs the physics up to this time since the start. The physics has its own steps: it
    // stops at the last step that is not later than this time.
    void advance(std::int64_t time_ns);

    // At each step of a robot's controller, read its input and then send its command. The robot's
    // header declares the structs.
    void read(void *input, std::size_t robot = 0);
    void command(std::int64_t time_ns, const void *output, std::size_t robot = 0);

    // Opens the camera with this name on all robots. Must be called before the physics runs.
    // Returns the camera's number, or no value if the world has no such camera.
    std::optional<std::size_t> look_through(const std::string &name);

    // Returns the newest frame that has arrived from a robot's camera by now, or nullptr if none
    // has arrived since the last call. Valid until the next call for the same camera.
    const frob_image *newest_frame(std::int64_t now_ns, std::size_t camera, std::size_t robot = 0) {
        return members_[robot].cameras[camera].newest(now_ns);
    }

    // The same functions for lidars and inertial measurement units.
    std::optional<std::size_t> open_lidar(const std::string &name);
    const frob_scan *newest_scan(std::int64_t now_ns, std::size_t lidar, std::size_t robot = 0) {
        return members_[robot].lidars[lidar].newest(now_ns);
    }
    std::optional<std::size_t> open_imu(const std::string &name);
    const frob_imu *newest_imu(std::int64_t now_ns, std::size_t imu, std::size_t robot = 0) {
        return members_[robot].imus[imu].newest(now_ns);
    }

    // Ground truth for the frame that `newest_frame` returned last for this camera; there must be
    // one.
    Truth frame_truth(std::size_t camera, std::size_t robot = 0) {
        return members_[robot].cameras[camera].truth();
    }

    std::int64_t time_ns() const { return time_ns_; }
    const Scene &scene() const { return scene_; }
    World &world() { return world_; }
    const World &world() const { return world_; }
    const RobotKind &kind() const { return kind_; }

    // Robots are numbered from 0, in the order of the scene's starts.
    std::size_t robots() const { return members_.size(); }
    const Body &body(std::size_t robot = 0) const { return world_.robots()[robot]; }
    const Robot &robot(std::size_t robot = 0) const { return *members_[robot].robot; }
    const std::vector<Collision> &collisions(std::size_t robot = 0) const {
        return members_[robot].collisions;
    }
    // Whether the robot has touched an object since the previous instant.
    bool touched(std::size_t robot = 0) const { return members_[robot].touched; }
    const Recorder &recorder(std::size_t robot = 0) const { return members_[robot].recorder; }
    const std::optional<WallDistance> &wall_distance(std::size_t robot = 0) const {
        return members_[robot].wall_distance;
    }
    const std::optional<TapeDistance> &tape_distance(std::size_t robot = 0) const {
        return members_[robot].tape_distance;
    }

    const std::optional<BallDistance> &ball_distance(std::size_t robot = 0) const {
        return members_[robot].ball_distance;
    }

    // The last frame that the robot's first camera delivered; nullptr if there is none.
    const frob_image *last_frame(std::size_t robot = 0) const {
        const std::vector<Camera> &cameras = members_[robot].cameras;
        return cameras.empty() ? nullptr : cameras.front().last();
    }

    // The robot's own estimate of its pose: odometry that started from the true pose.
    Pose believed(std::size_t robot = 0) const;

  private:
    Scene scene_;
    const RobotKind &kind_;
    World world_;
    // Updates the quantity that the world file selects for measurement, and returns its value. NaN
    // if the file does not select one.
    double measure(Member &member, std::int64_t time_ns, const Pose &pose);
    void take_frames();
    void watch(Member &member, const Body &body);

    std::uint64_t seed_;
    std::unique_ptr<Scenery> scenery_; // present if a camera has been opened
    std::vector<Member> members_;
    std::int64_t time_ns_ = 0;
};

} // namespace frob::sim
