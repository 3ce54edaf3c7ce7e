#include "simulation.h"

#include <limits>
#include <utility>

#include "world_file.h"

namespace frob::sim {
namespace {

const RobotKind &kind_of(const Scene &scene) {
    return scene.robot.empty() ? robot_kinds().front() : *robot_kind(scene.robot);
}

} // namespace

Simulation::Simulation(Scene scene, std::uint64_t seed, bool keeps_samples)
    : scene_(std::move(scene)), kind_(kind_of(scene_)), world_(scene_, kind_.chassis()),
      robot_(kind_.make(scene_, seed)), recorder_(keeps_samples) {
    if (world_.robot_overlaps())
        throw WorldFileError(scene_.start_place +
                             ": the robot would start inside a wall or another thing");
    if (scene_.measure) wall_distance_.emplace(scene_, kind_.chassis(), *scene_.measure);
    robot_->sense(0, world_);
}

void Simulation::advance(std::int64_t time_ns) {
    while (time_ns_ + step_ns <= time_ns) {
        robot_->push(world_);
        world_.step();
        time_ns_ += step_ns;
        robot_->sense(time_ns_, world_);
    }
}

void Simulation::command(std::int64_t time_ns, const void *output) {
    robot_->command(output);
    const Pose pose = world_.robot_pose();
    const double wall_distance = wall_distance_ ? wall_distance_->observe(time_ns, pose)
                                                : std::numeric_limits<double>::quiet_NaN();
    recorder_.arrive(pose.position);
    if (!recorder_.keeps_samples()) return;
    const b2Vec2 velocity = world_.robot().GetLinearVelocity();
    Sample sample{};
    sample.time_ns = time_ns;
    sample.pose = pose;
    sample.believed = from_frame(scene_.start, robot_->odometry().pose());
    sample.forward = dot({static_cast<double>(velocity.x), static_cast<double>(velocity.y)},
                         direction(pose.heading));
    sample.turn = static_cast<double>(world_.robot().GetAngularVelocity());
    sample.commanded_forward = robot_->drive().commanded_forward();
    sample.commanded_turn = robot_->drive().commanded_turn();
    sample.wall_distance = wall_distance;
    sample.collisions = robot_->contacts().collisions();
    recorder_.add(sample);
}

} // namespace frob::sim
