// A world and the robot in it, through time.
#pragma once

#include <memory>
#include <optional>

#include "recorder.h"
#include "robot.h"
#include "wall_distance.h"

namespace frob::sim {

class Simulation {
  public:
    // Throws WorldFileError if the robot starts inside something. Samples are
    // for a picture; without one they need not be kept.
    Simulation(Scene scene, std::uint64_t seed, bool keeps_samples = true);

    Simulation(const Simulation &) = delete;
    Simulation &operator=(const Simulation &) = delete;

    // Runs the physics up to this time since the start. The physics has steps
    // of its own: it stops at the last one that does not go beyond.
    void advance(std::int64_t time_ns);

    // An instant of the controller: the sensors, and then what it commands.
    // The structs are those of the robot's header.
    void read(void *input) { robot_->read(time_ns_, input); }
    void command(std::int64_t time_ns, const void *output);

    std::int64_t time_ns() const { return time_ns_; }
    const Scene &scene() const { return scene_; }
    World &world() { return world_; }
    const World &world() const { return world_; }
    const RobotKind &kind() const { return kind_; }
    const Robot &robot() const { return *robot_; }
    const Recorder &recorder() const { return recorder_; }
    const std::optional<WallDistance> &wall_distance() const { return wall_distance_; }

  private:
    Scene scene_;
    const RobotKind &kind_;
    World world_;
    std::unique_ptr<Robot> robot_;
    Recorder recorder_;
    std::optional<WallDistance> wall_distance_;
    std::int64_t time_ns_ = 0;
};

} // namespace frob::sim
