#include "ros_robot.h"

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>

#include <poll.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <frob/imu.h>
#include <frob/lidar.h>
#include <frob/ros.h>

#include "options.h"

namespace frob::serve {
namespace {

constexpr std::int64_t step_ns = 5'000'000;
constexpr std::int64_t clock_ns = 10'000'000;     // period of /clock
constexpr std::int64_t odometry_ns = 20'000'000;  // period of odom
constexpr std::int64_t states_ns = 50'000'000;    // period of the bumpers and the battery
constexpr std::int64_t patience_ns = 500'000'000; // The robot stops after this time without a
                                                  // velocity command, as most robots do.
constexpr int start_ms = 20000;

std::int64_t real_time_ns() {
    timespec now{};
    clock_gettime(CLOCK_REALTIME, &now);
    return static_cast<std::int64_t>(now.tv_sec) * 1'000'000'000 + now.tv_nsec;
}

void turn_by(double heading, double (&rotation)[4]) {
    rotation[2] = std::sin(heading / 2.0);
    rotation[3] = std::cos(heading / 2.0);
}

} // namespace

RosRobot::RosRobot(frob_sim *sim, const std::string &node, bool stamped,
                   const std::vector<std::string> &arguments)
    : sim_(sim), cameras_(sim), scan_(std::make_unique<ros_scan>()), epoch_ns_(real_time_ns()) {
    open_sensors();
    start(node, stamped, arguments);
}

RosRobot::~RosRobot() {
    if (socket_ >= 0) close(socket_);
    if (process_ <= 0) return;
    for (int i = 0; i < 2000; ++i) {
        if (waitpid(process_, nullptr, WNOHANG) != 0) return;
        usleep(1000);
    }
    kill(process_, SIGKILL);
    waitpid(process_, nullptr, 0);
}

// The lidar named `lidar` publishes on the topic `scan`, as on most robots. The other sensors
// publish on topics with their own names.
void RosRobot::open_sensors() {
    for (std::size_t i = 0; const char *name = frob_sim_lidar_name(sim_, i); ++i) {
        Sensor &sensor = sensors_.emplace_back(Sensor{
            frob_sim_open_lidar(sim_, name), true, std::string(name) == "lidar" ? "scan" : name});
        frob_sim_lidar_seat(sim_, i, &sensor.ahead, &sensor.left);
    }
    for (std::size_t i = 0; const char *name = frob_sim_imu_name(sim_, i); ++i)
        sensors_.push_back({frob_sim_open_imu(sim_, name), false, name});
    if (sensors_.size() > ROS_SENSORS_MOST)
        throw WrongUse(
            "the world has more than eight lidars and inertial measurement units in total: remove "
            "some");
}

void RosRobot::start(const std::string &node, bool stamped,
                     const std::vector<std::string> &arguments) {
    int ends[2];
    if (socketpair(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC, 0, ends) != 0)
        throw WrongUse(std::string("cannot start the ROS 2 node: ") + std::strerror(errno));
    std::vector<std::string> words{node};
    words.push_back(std::to_string(dup(ends[1])));
    if (stamped) words.push_back("stamped");
    for (const Sensor &sensor : sensors_)
        words.push_back((sensor.is_lidar ? "scan=" : "imu=") + sensor.topic + ',' +
                        std::to_string(sensor.ahead) + ',' + std::to_string(sensor.left));
    for (const std::string &word : cameras_.arguments()) words.push_back(word);
    words.push_back("--");
    words.insert(words.end(), arguments.begin(), arguments.end());
    std::vector<char *> argv;
    for (std::string &word : words) argv.push_back(word.data());
    argv.push_back(nullptr);
    socket_ = ends[0];
    process_ = fork();
    if (process_ == 0) {
        execv(node.c_str(), argv.data());
        _exit(1);
    }
    close(ends[1]);
    close(std::atoi(words[1].c_str()));
    if (process_ < 0) throw WrongUse("cannot start the ROS 2 node");
    union {
        ros_head head;
        ros_started started;
        ros_refused refused;
    } first{};
    pollfd wait{socket_, POLLIN, 0};
    if (poll(&wait, 1, start_ms) == 0) throw WrongUse("the ROS 2 node did not start within 20 s");
    const ssize_t got = recv(socket_, &first, sizeof first, 0);
    if (got == static_cast<ssize_t>(sizeof first.refused) && first.head.kind == ROS_REFUSED)
        throw WrongUse(first.refused.reason);
    if (got != static_cast<ssize_t>(sizeof first.started) || first.head.kind != ROS_STARTED)
        throw WrongUse("the ROS 2 node could not start");
    started_ = first.started;
}

std::vector<std::string> RosRobot::description() const {
    std::vector<std::string> lines{std::string("node: ") + started_.node,
                                   std::string("odometry: ") + started_.odometry};
    for (std::size_t i = 0; i < sensors_.size(); ++i)
        lines.push_back((sensors_[i].is_lidar ? "lidar: " : "imu: ") +
                        std::string(started_.sensors[i].topic));
    lines.push_back(std::string("velocity: ") + started_.velocity);
    return lines;
}

// ---- Messages

template <class Message>
Message RosRobot::message(ros_kind kind) const {
    Message message{};
    message.head.size = sizeof message;
    message.head.kind = kind;
    return message;
}

void RosRobot::send(const ros_head &message) const {
    // A message may be lost, as usual in ROS.
    if (::send(socket_, &message, message.size, MSG_NOSIGNAL | MSG_DONTWAIT) < 0) return;
}

void RosRobot::send_odometry(std::int64_t time_ns) {
    frob_ros_input input{};
    frob_sim_read(sim_, &input);
    auto m = message<ros_odometry>(ROS_ODOMETRY);
    m.stamp_ns = epoch_ns_ + time_ns;
    m.x_m = input.odometry.position.x;
    m.y_m = input.odometry.position.y;
    turn_by(input.odometry.heading, m.rotation);
    m.speed_m_s = input.speed;
    m.turning_rad_s = input.turning;
    send(m.head);
}

void RosRobot::send_states(std::int64_t time_ns) {
    frob_ros_input input{};
    frob_sim_read(sim_, &input);
    const frob_sim_bumps bumps = frob_sim_bumps_robot(sim_, 0);
    auto m = message<ros_states>(ROS_STATES);
    m.stamp_ns = epoch_ns_ + time_ns;
    m.pressed[0] = bumps.left != 0;
    m.pressed[1] = bumps.right != 0;
    m.pressed[2] = bumps.back != 0;
    m.battery_v = input.battery;
    send(m.head);
}

void RosRobot::send_scan(std::uint32_t sensor, std::int64_t time_ns) {
    const frob_scan *scan = frob_sim_scan(sim_, 0, sensors_[sensor].number, time_ns);
    if (scan == nullptr) return;
    ros_scan &m = *scan_;
    m.count = static_cast<std::uint32_t>(std::min<std::size_t>(scan->count, ROS_RAYS_MOST));
    m.head.size =
        static_cast<std::uint32_t>(offsetof(ros_scan, ranges_m) + m.count * sizeof m.ranges_m[0]);
    m.head.kind = ROS_SCAN;
    m.origin.control = sensor;
    m.origin.stamp_ns = epoch_ns_ + scan->taken_ns;
    m.first_rad = scan->first_rad;
    m.step_rad = scan->step_rad;
    m.nearest_m = scan->nearest_m;
    m.farthest_m = scan->farthest_m;
    for (std::uint32_t i = 0; i < m.count; ++i)
        m.ranges_m[i] = static_cast<float>(scan->ranges_m[i]);
    send(m.head);
}

void RosRobot::send_imu(std::uint32_t sensor, std::int64_t time_ns) {
    const frob_imu *imu = frob_sim_imu(sim_, 0, sensors_[sensor].number, time_ns);
    if (imu == nullptr) return;
    auto m = message<ros_imu>(ROS_IMU);
    m.origin.control = sensor;
    m.origin.stamp_ns = epoch_ns_ + imu->taken_ns;
    std::copy(std::begin(imu->rate_radps), std::end(imu->rate_radps), m.rate_radps);
    std::copy(std::begin(imu->acceleration_mps2), std::end(imu->acceleration_mps2),
              m.acceleration_mps2);
    m.has_rotation = !std::isnan(imu->heading_rad);
    turn_by(m.has_rotation ? imu->heading_rad : 0.0, m.rotation);
    send(m.head);
}

// ---- Running

void RosRobot::look(std::int64_t time_ns) {
    frob_sim_advance(sim_, time_ns);
    if (time_ns - heard_ns_ > patience_ns) command(time_ns, 0.0, 0.0);
    if (time_ns % clock_ns == 0) {
        auto m = message<ros_clock>(ROS_CLOCK);
        m.time_ns = epoch_ns_ + time_ns;
        send(m.head);
    }
    if (time_ns % odometry_ns == 0) send_odometry(time_ns);
    if (time_ns % states_ns == 0) send_states(time_ns);
    for (std::uint32_t i = 0; i < sensors_.size(); ++i)
        if (sensors_[i].is_lidar)
            send_scan(i, time_ns);
        else
            send_imu(i, time_ns);
    cameras_.advance(time_ns, [this](ros_image &image) {
        image.stamp_ns += epoch_ns_;
        send(image.head);
    });
}

void RosRobot::command(std::int64_t time_ns, double speed, double turn) {
    frob_ros_output output{};
    output.forward = speed;
    output.turn = turn;
    frob_sim_command(sim_, time_ns, &output);
    if (log_ && (speed != speed_ || turn != turn_)) {
        char text[80];
        std::snprintf(text, sizeof text, "VEL %.4f %.4f", speed, turn);
        log_(time_ns, text);
    }
    speed_ = speed;
    turn_ = turn;
}

// Returns false if the node has ended.
bool RosRobot::receive(std::int64_t time_ns) {
    for (;;) {
        ros_velocity velocity{};
        const ssize_t got = recv(socket_, &velocity, sizeof velocity, MSG_DONTWAIT);
        if (got < 0 && errno != EINTR) return errno == EAGAIN;
        if (got == 0) return false;
        if (got != static_cast<ssize_t>(sizeof velocity) || velocity.head.kind != ROS_VELOCITY)
            continue;
        heard_ns_ = time_ns;
        if (std::isfinite(velocity.speed_m_s) && std::isfinite(velocity.turn_rad_s)) {
            command(time_ns, velocity.speed_m_s, velocity.turn_rad_s);
            continue;
        }
        command(time_ns, 0.0, 0.0);
        if (!told_)
            std::fprintf(stderr, "warning: a velocity on %s is not a number; the robot stops\n",
                         started_.velocity);
        told_ = true;
    }
}

bool RosRobot::advance(std::int64_t time_ns) {
    for (; next_ns_ <= time_ns; next_ns_ += step_ns) look(next_ns_);
    return receive(time_ns);
}

void RosRobot::wait(std::int64_t time_ns) const {
    const timespec patience{
        0, static_cast<long>(std::clamp<std::int64_t>(next_ns_ - time_ns, 0, step_ns))};
    pollfd input{socket_, POLLIN, 0};
    ppoll(&input, 1, &patience, nullptr);
}

} // namespace frob::serve
