#include "simulation.h"

#include <limits>
#include <memory>
#include <string>
#include <utility>

#include "world_file.h"

namespace frob::sim {
namespace {

// Maximum number of collisions stored for each robot. Further ones are only counted.
constexpr std::size_t most_collisions = 5;

const RobotKind &kind_of(const Scene &scene) {
    return scene.robot.empty() ? robot_kinds().front() : *robot_kind(scene.robot);
}

std::string called(std::size_t robot, std::size_t robots) {
    return robots == 1 ? "the robot" : "robot " + std::to_string(robot + 1);
}

} // namespace

Simulation::Simulation(Scene scene, std::uint64_t seed, bool keeps_samples, const RobotKind *own)
    : scene_(std::move(scene)), kind_(own ? *own : kind_of(scene_)),
      world_(scene_, kind_.chassis()), seed_(seed) {
    if (kind_.equipped && scene_.lidars.empty()) scene_.lidars.emplace_back();
    if (kind_.equipped && scene_.imus.empty()) scene_.imus.emplace_back();
    for (std::size_t k = 0; k < scene_.starts.size(); ++k) {
        if (body(k).overlaps())
            throw WorldFileError(scene_.starts[k].place + ": " + called(k, scene_.starts.size()) +
                                 " starts inside a wall or another object");
        members_.push_back({kind_.make(scene_, Noise::seed_of_robot(seed, k)),
                            Recorder(keeps_samples),
                            std::nullopt,
                            std::nullopt,
                            std::nullopt,
                            {},
                            {},
                            {},
                            {},
                            false});
        if (!scene_.measure) continue;
        if (scene_.measure->what == MeasureSettings::What::tape)
            members_.back().tape_distance.emplace(scene_, *scene_.measure);
        else if (scene_.measure->what == MeasureSettings::What::ball)
            members_.back().ball_distance.emplace(*scene_.measure);
        else
            members_.back().wall_distance.emplace(scene_, kind_.chassis(), *scene_.measure);
    }
    for (std::size_t k = 0; k < members_.size(); ++k) members_[k].robot->sense(0, body(k));
}

void Simulation::advance(std::int64_t time_ns) {
    std::vector<Body> &bodies = world_.robots();
    if (time_ns_ + step_ns <= time_ns)
        for (Member &member : members_) member.touched = false;
    while (time_ns_ + step_ns <= time_ns) {
        for (std::size_t k = 0; k < bodies.size(); ++k) members_[k].robot->push(bodies[k]);
        world_.step();
        time_ns_ += step_ns;
        for (std::size_t k = 0; k < bodies.size(); ++k) {
            members_[k].robot->sense(time_ns_, bodies[k]);
            watch(members_[k], bodies[k]);
            for (Lidar &lidar : members_[k].lidars) lidar.advance(time_ns_, bodies[k]);
            for (Imu &imu : members_[k].imus) imu.advance(time_ns_, bodies[k]);
        }
        if (scenery_) take_frames();
    }
}

void Simulation::watch(Member &member, const Body &body) {
    const Contacts &contacts = member.robot->contacts();
    if (!contacts.points().empty()) member.touched = true;
    if (contacts.begun() && member.collisions.size() < most_collisions)
        member.collisions.push_back({time_ns_, world_.name_of(*contacts.begun()->with),
                                     contacts.begun()->where,
                                     clearance(scene_, body.pose().position)});
}

// Takes all frames that are due at this step. They share one snapshot of all positions.
void Simulation::take_frames() {
    std::shared_ptr<const Moment> moment;
    for (Member &member : members_) {
        for (Camera &camera : member.cameras) {
            if (!camera.is_due(time_ns_)) continue;
            if (!moment) {
                std::vector<Pose> poses;
                for (const Body &body : world_.robots()) poses.push_back(body.pose());
                moment = std::make_shared<const Moment>(
                    Moment{std::move(poses), world_.box_poses(), world_.ball_places()});
            }
            camera.take(time_ns_, moment);
        }
    }
}

std::optional<std::size_t> Simulation::look_through(const std::string &name) {
    for (std::size_t i = 0; i < scene_.cameras.size(); ++i) {
        const CameraSettings &settings = scene_.cameras[i];
        if (settings.name != name) continue;
        if (!scenery_) scenery_ = std::make_unique<Scenery>(scene_, kind_.chassis());
        // Each camera has its own noise.
        for (std::size_t k = 0; k < members_.size(); ++k) {
            const auto seed_of = [&](std::size_t camera) {
                return Noise(Noise::seed_of_robot(seed_, k), Robot::camera_stream + camera).bits();
            };
            members_[k].cameras.emplace_back(settings, kind_.chassis(), *scenery_, k, seed_of(i),
                                             seed_of(settings.partner.value_or(i)));
        }
        take_frames();
        return members_.front().cameras.size() - 1;
    }
    return std::nullopt;
}

std::optional<std::size_t> Simulation::open_lidar(const std::string &name) {
    for (std::size_t i = 0; i < scene_.lidars.size(); ++i) {
        if (scene_.lidars[i].name != name) continue;
        for (std::size_t k = 0; k < members_.size(); ++k) {
            const Noise noise(Noise::seed_of_robot(seed_, k), Robot::lidar_stream + i);
            members_[k].lidars.emplace_back(scene_.lidars[i], noise);
            members_[k].lidars.back().advance(time_ns_, body(k));
        }
        return members_.front().lidars.size() - 1;
    }
    return std::nullopt;
}

std::optional<std::size_t> Simulation::open_imu(const std::string &name) {
    for (std::size_t i = 0; i < scene_.imus.size(); ++i) {
        if (scene_.imus[i].name != name) continue;
        for (std::size_t k = 0; k < members_.size(); ++k) {
            const Noise noise(Noise::seed_of_robot(seed_, k), Robot::imu_stream + i);
            members_[k].imus.emplace_back(scene_.imus[i], scene_.magnets, noise, body(k));
        }
        return members_.front().imus.size() - 1;
    }
    return std::nullopt;
}

void Simulation::read(void *input, std::size_t robot) {
    members_[robot].robot->read(time_ns_, input);
}

Pose Simulation::believed(std::size_t robot) const {
    return from_frame(scene_.starts[robot].pose, members_[robot].robot->odometry().pose());
}

double Simulation::measure(Member &member, std::int64_t time_ns, const Pose &pose) {
    if (member.wall_distance) return member.wall_distance->observe(time_ns, pose);
    if (member.tape_distance) return member.tape_distance->observe(time_ns, pose);
    if (member.ball_distance)
        return member.ball_distance->observe(time_ns, pose, world_.ball_places());
    return std::numeric_limits<double>::quiet_NaN();
}

void Simulation::command(std::int64_t time_ns, const void *output, std::size_t robot) {
    Member &member = members_[robot];
    member.robot->command(time_ns, output);
    const Pose pose = body(robot).pose();
    const double distance = measure(member, time_ns, pose);
    member.recorder.arrive(pose.position);
    if (!member.recorder.keeps_samples()) {
        member.robot->forget_echoes();
        return;
    }
    const b2Body &rigid = body(robot).rigid();
    const b2Vec2 velocity = rigid.GetLinearVelocity();
    Sample sample{};
    sample.time_ns = time_ns;
    sample.pose = pose;
    sample.believed = believed(robot);
    sample.forward = dot({static_cast<double>(velocity.x), static_cast<double>(velocity.y)},
                         direction(pose.heading));
    sample.turn = static_cast<double>(rigid.GetAngularVelocity());
    sample.commanded_forward = member.robot->drive().commanded_forward();
    sample.commanded_turn = member.robot->drive().commanded_turn();
    sample.measured_distance = distance;
    sample.collisions = member.robot->contacts().collisions();
    member.recorder.add(sample);
}

} // namespace frob::sim
