// A world and the robots in it, through time.
#pragma once

#include <memory>
#include <optional>

#include "ball_distance.h"
#include "camera.h"
#include "recorder.h"
#include "robot.h"
#include "tape_distance.h"
#include "wall_distance.h"
#include "world.h"

namespace frob::sim
{

// One of the robots, and what is known of its run.
struct Member {
    std::unique_ptr<Robot> robot;
    Recorder recorder;
    std::optional<WallDistance> wall_distance; // as the world says what to measure
    std::optional<TapeDistance> tape_distance;
    std::optional<BallDistance> ball_distance;
    std::vector<Camera> cameras; // those that are looked through
};

class Simulation
{
  public:
    // Throws WorldFileError if a robot starts inside something. Samples are
    // for a picture; without one they need not be kept.
    // The robot is the scene's, or the user's own, which must stay.
    Simulation(Scene scene, std::uint64_t seed, bool keeps_samples = true,
               const RobotKind *own = nullptr);

    Simulation(const Simulation &) = delete;
    Simulation &operator=(const Simulation &) = delete;

    // Runs the physics up to this time since the start. The physics has steps
    // of its own: it stops at the last one that does not go beyond.
    void advance(std::int64_t time_ns);

    // An instant of a robot's controller: the sensors, and then what it
    // commands. The structs are those of the robot's header.
    void read(void *input, std::size_t robot = 0);
    void command(std::int64_t time_ns, const void *output, std::size_t robot = 0);

    // Begins to look through the camera of this name, of all robots, before the physics runs.
    // Its number; none if the world has no such camera.
    std::optional<std::size_t> look_through(const std::string &name);

    // The newest frame that has arrived by now, once, of a robot's camera of this number; nullptr
    // if there is none. Good until the next call for the same camera.
    const frob_image *newest_frame(std::int64_t now_ns, std::size_t camera, std::size_t robot = 0)
    {
        return members_[robot].cameras[camera].newest(now_ns);
    }

    // What that frame really shows. It must have been given.
    Truth frame_truth(std::size_t camera, std::size_t robot = 0)
    {
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
    const Recorder &recorder(std::size_t robot = 0) const { return members_[robot].recorder; }
    const std::optional<WallDistance> &wall_distance(std::size_t robot = 0) const
    {
        return members_[robot].wall_distance;
    }
    const std::optional<TapeDistance> &tape_distance(std::size_t robot = 0) const
    {
        return members_[robot].tape_distance;
    }

    const std::optional<BallDistance> &ball_distance(std::size_t robot = 0) const
    {
        return members_[robot].ball_distance;
    }

    // The last frame of the first camera that a robot's program was given; nullptr without one.
    const frob_image *last_frame(std::size_t robot = 0) const
    {
        const std::vector<Camera> &cameras = members_[robot].cameras;
        return cameras.empty() ? nullptr : cameras.front().last();
    }

    // Where a robot believes to be, by odometry that began at its true start.
    Pose believed(std::size_t robot = 0) const;

  private:
    Scene scene_;
    const RobotKind &kind_;
    World world_;
    // Of what the world says to measure; NaN if it says nothing.
    double measure(Member &member, std::int64_t time_ns, const Pose &pose);
    void take_frames();

    std::uint64_t seed_;
    std::unique_ptr<Scenery> scenery_; // if a camera is looked through
    std::vector<Member> members_;
    std::int64_t time_ns_ = 0;
};

} // namespace frob::sim
