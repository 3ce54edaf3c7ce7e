#include "sim.h"

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <memory>
#include <string>

#include "own_robot.h"
#include "picture.h"
#include "plan_file.h"
#include "simulation.h"
#include "world_file.h"

using namespace frob::sim;

// A user-defined robot: its body, and the robot kind created from the body.
struct Own {
    explicit Own(const frob_body &table) : body(table), kind(own_robot_kind(body)) {}

    OwnBody body;
    RobotKind kind;
};

struct frob_sim {
    std::unique_ptr<Own> own;
    Simulation simulation;
};

namespace {

void say(char *message, std::size_t room, const std::string &text) {
    std::snprintf(message, room, "%s", text.c_str());
}

} // namespace

frob_sim *frob_sim_open(const char *world_file, const frob_sim_settings *settings, char *message,
                        std::size_t room) {
    try {
        auto own = settings->body != nullptr ? std::make_unique<Own>(*settings->body) : nullptr;
        if (!own && settings->robot != nullptr && robot_kind(settings->robot) == nullptr) {
            say(message, room,
                std::string("there is no simulated ") + settings->robot +
                    "; for your own robot, define its body `frob_" + settings->robot +
                    "_body` in a C file, and add the file with `--with`");
            return nullptr;
        }
        Scene scene = read_world_file(world_file);
        if (scene.robot.empty() && settings->robot != nullptr) scene.robot = settings->robot;
        if (settings->robot != nullptr && scene.robot != settings->robot) {
            say(message, room,
                std::string(world_file) + ": this world is for " + scene.robot + ", not for " +
                    settings->robot);
            return nullptr;
        }
        if (settings->wall_distance_m > 0.0) {
            if (!scene.measure) scene.measure.emplace();
            scene.measure->what = MeasureSettings::What::wall;
            scene.measure->distance = settings->wall_distance_m;
        }
        scene.drive.behind_wire = settings->served != 0;
        const RobotKind *kind = own ? &own->kind : nullptr;
        return new frob_sim{std::move(own),
                            {std::move(scene), settings->seed, settings->picture != 0, kind}};
    } catch (const WorldFileError &error) {
        say(message, room, error.what());
    } catch (const std::exception &error) {
        say(message, room, std::string(world_file) + ": " + error.what());
    }
    return nullptr;
}

void frob_sim_close(frob_sim *sim) { delete sim; }

std::size_t frob_sim_input_size(const frob_sim *sim) { return sim->simulation.kind().input_size; }

std::size_t frob_sim_output_size(const frob_sim *sim) { return sim->simulation.kind().output_size; }

const char *frob_sim_world_robot(const char *world_file, char *message, std::size_t room) {
    try {
        const Scene scene = read_world_file(world_file);
        return scene.robot.empty() ? "" : robot_kind(scene.robot)->name;
    } catch (const std::exception &error) {
        say(message, room, error.what());
        return nullptr;
    }
}

int frob_sim_read_plan(const char *plan_file, char **text) {
    std::string said;
    bool ok = true;
    try {
        said = read_plan_file(plan_file);
    } catch (const std::exception &error) {
        said = error.what();
        ok = false;
    }
    *text = static_cast<char *>(std::malloc(said.size() + 1));
    if (*text != nullptr) std::memcpy(*text, said.c_str(), said.size() + 1);
    return ok ? 1 : 0;
}

std::size_t frob_sim_robots(const frob_sim *sim) { return sim->simulation.robots(); }

void frob_sim_advance(frob_sim *sim, std::int64_t time_ns) { sim->simulation.advance(time_ns); }

void frob_sim_read(frob_sim *sim, void *input) { frob_sim_read_robot(sim, 0, input); }

void frob_sim_read_robot(frob_sim *sim, std::size_t robot, void *input) {
    sim->simulation.read(input, robot);
}

int frob_sim_look_through(frob_sim *sim, const char *camera) {
    const auto number = sim->simulation.look_through(camera);
    return number ? static_cast<int>(*number) : -1;
}

const char *frob_sim_camera_name(const frob_sim *sim, std::size_t number) {
    const auto &cameras = sim->simulation.scene().cameras;
    return number < cameras.size() ? cameras[number].name.c_str() : nullptr;
}

const frob_image *frob_sim_frame(frob_sim *sim, std::size_t robot, int camera,
                                 std::int64_t time_ns) {
    return sim->simulation.newest_frame(time_ns, static_cast<std::size_t>(camera), robot);
}

int frob_sim_open_lidar(frob_sim *sim, const char *lidar) {
    const auto number = sim->simulation.open_lidar(lidar);
    return number ? static_cast<int>(*number) : -1;
}

const char *frob_sim_lidar_name(const frob_sim *sim, std::size_t number) {
    const auto &lidars = sim->simulation.scene().lidars;
    return number < lidars.size() ? lidars[number].name.c_str() : nullptr;
}

void frob_sim_lidar_seat(const frob_sim *sim, std::size_t number, double *ahead_m, double *left_m) {
    const LidarSettings &lidar = sim->simulation.scene().lidars.at(number);
    *ahead_m = lidar.ahead;
    *left_m = lidar.left;
}

const frob_scan *frob_sim_scan(frob_sim *sim, std::size_t robot, int lidar, std::int64_t time_ns) {
    return sim->simulation.newest_scan(time_ns, static_cast<std::size_t>(lidar), robot);
}

frob_sim_bumps frob_sim_bumps_robot(const frob_sim *sim, std::size_t robot) {
    constexpr double middle = 0.02; // m
    frob_sim_bumps bumps{};
    for (const Vec &at : sim->simulation.robot(robot).contacts().points()) {
        if (at.x <= 0.0) {
            bumps.back = 1;
            continue;
        }
        if (at.y > -middle) bumps.left = 1;
        if (at.y < middle) bumps.right = 1;
    }
    return bumps;
}

int frob_sim_open_imu(frob_sim *sim, const char *imu) {
    const auto number = sim->simulation.open_imu(imu);
    return number ? static_cast<int>(*number) : -1;
}

const char *frob_sim_imu_name(const frob_sim *sim, std::size_t number) {
    const auto &imus = sim->simulation.scene().imus;
    return number < imus.size() ? imus[number].name.c_str() : nullptr;
}

const struct frob_imu *frob_sim_imu(frob_sim *sim, std::size_t robot, int imu,
                                    std::int64_t time_ns) {
    return sim->simulation.newest_imu(time_ns, static_cast<std::size_t>(imu), robot);
}

void frob_sim_command(frob_sim *sim, std::int64_t time_ns, const void *output) {
    frob_sim_command_robot(sim, 0, time_ns, output);
}

void frob_sim_command_robot(frob_sim *sim, std::size_t robot, std::int64_t time_ns,
                            const void *output) {
    sim->simulation.command(time_ns, output, robot);
}

int frob_sim_is_away(const frob_sim *sim, std::int64_t time_ns) {
    const OutageSettings &outage = sim->simulation.scene().outage;
    const auto ns = [](double seconds) { return std::llround(seconds * 1e9); };
    if (outage.lasts <= 0.0 || time_ns < ns(outage.from)) return 0;
    const std::int64_t since = time_ns - ns(outage.from);
    return (outage.every > 0.0 ? since % ns(outage.every) : since) < ns(outage.lasts) ? 1 : 0;
}

frob_sim_place frob_sim_place_robot(const frob_sim *sim, std::size_t robot) {
    const Pose pose = sim->simulation.body(robot).pose();
    return {pose.position.x, pose.position.y, pose.heading, sim->simulation.touched(robot) ? 1 : 0};
}

std::size_t frob_sim_objects(const frob_sim *sim) { return sim->simulation.world().objects(); }

frob_sim_place frob_sim_place_object(const frob_sim *sim, std::size_t object) {
    const Pose pose = sim->simulation.world().object(object);
    return {pose.position.x, pose.position.y, pose.heading, 0};
}

double frob_sim_clearance_robot(const frob_sim *sim, std::size_t robot) {
    return clearance(sim->simulation.scene(), sim->simulation.body(robot).pose().position);
}

int frob_sim_collision_robot(const frob_sim *sim, std::size_t robot, std::size_t number,
                             frob_sim_collision *collision) {
    const auto &collisions = sim->simulation.collisions(robot);
    if (number >= collisions.size()) return 0;
    const Collision &one = collisions[number];
    *collision = {static_cast<double>(one.time_ns) * 1e-9, one.where.x, one.where.y, one.clearance,
                  one.with.c_str()};
    return 1;
}

void frob_sim_describe_collision(const frob_sim_collision *collision, char *text,
                                 std::size_t room) {
    std::snprintf(text, room, "collision at %.3f s: %s, x %.3f m, y %.3f m, clearance %.3f m",
                  collision->time_s, collision->with, collision->x_m, collision->y_m,
                  collision->clearance_m);
}

frob_sim_summary frob_sim_summarize(const frob_sim *sim) {
    return frob_sim_summarize_robot(sim, 0);
}

frob_sim_summary frob_sim_summarize_robot(const frob_sim *sim, std::size_t robot) {
    const Simulation &simulation = sim->simulation;
    frob_sim_summary summary{};
    summary.time_s = static_cast<double>(simulation.time_ns()) * 1e-9;
    summary.distance_m = simulation.recorder(robot).distance_driven();
    summary.collisions = simulation.robot(robot).contacts().collisions();
    summary.odometry_error_m =
        length(simulation.believed(robot).position - simulation.body(robot).pose().position);
    if (const auto &measured = simulation.wall_distance(robot)) {
        summary.measured = 1;
        summary.wall_distance_m = simulation.scene().measure->distance;
        summary.mean_error_m = measured->mean_error();
        summary.largest_error_m = measured->largest_error();
    }
    if (const auto &measured = simulation.tape_distance(robot)) {
        summary.tape_measured = 1;
        summary.mean_tape_m = measured->mean();
        summary.largest_tape_m = measured->largest();
        summary.tape_way_m = measured->way();
    }
    if (const auto &measured = simulation.ball_distance(robot)) {
        summary.ball_measured = 1;
        summary.ball_distance_m = simulation.scene().measure->distance;
        summary.mean_ball_m = measured->mean_error();
        summary.largest_ball_m = measured->largest_error();
    }
    return summary;
}

int frob_sim_picture(const frob_sim *sim, const char *file, char *message, std::size_t room) {
    try {
        draw_picture(sim->simulation, file);
        return 1;
    } catch (const std::exception &error) {
        say(message, room, error.what());
        return 0;
    }
}
