#include "scout_wire.h"

#include <algorithm>
#include <cmath>

namespace frob::sim {
namespace {

constexpr double unit_m = 0.00254; // 0.1 inch
constexpr double degree = 3.14159265358979323846 / 180.0;
constexpr double separation_m = 0.3452;
constexpr std::uint8_t start = 0x01, end = 0x5C;
constexpr unsigned refused = 8;

// Number of data bytes of each command that a Scout accepts; -1 for other commands.
int data_of(unsigned type) {
    switch (type) {
    case 1:
    case 2:
    case 3:
    case 5: // AC SP PR VM
        return 6;
    case 7:
    case 9:
    case 10:
    case 13: // GS ST LP ZR
    case 20:
    case 21:
    case 22:
    case 27: // GET_SN GET_RC GET_RV GET_BP
        return 0;
    case 12:
    case 30:
    case 31: // DP DA WS
        return 4;
    case 15: // CONF_SN
        return 17;
    case 18: // CONF_TM
        return 1;
    case 43: // MV
        return 12;
    default: return -1;
    }
}

int signed_at(const std::uint8_t *data) {
    const int magnitude = data[0] | (data[1] & 0x7F) << 8;
    return (data[1] & 0x80) != 0 ? -magnitude : magnitude;
}

unsigned unsigned_at(const std::uint8_t *data) {
    return data[0] | static_cast<unsigned>(data[1]) << 8;
}

void put(std::vector<std::uint8_t> &to, unsigned value) {
    to.push_back(static_cast<std::uint8_t>(value & 0xFFu));
    to.push_back(static_cast<std::uint8_t>(value >> 8 & 0xFFu));
}

// Encodes a number as sign and magnitude. A number that does not fit loses its highest bits.
void put_signed(std::vector<std::uint8_t> &to, double value) {
    const long long n = std::llround(value);
    put(to, static_cast<unsigned>(std::llabs(n) & 0x7FFF) | (n < 0 ? 0x8000u : 0u));
}

void put_time(std::vector<std::uint8_t> &to, std::int64_t now_ns) {
    const auto ms = static_cast<std::uint32_t>(now_ns / 1000000);
    put(to, ms & 0xFFFFu);
    put(to, ms >> 16);
}

std::uint8_t raw_voltage(double volts, double range) {
    return static_cast<std::uint8_t>(
        std::clamp(std::lround((volts * 5.0 / range - 2.0) * 255.0 / 3.0), 0l, 255l));
}

} // namespace

void ScoutWire::receive(const std::uint8_t *bytes, std::size_t count) {
    pending_.insert(pending_.end(), bytes, bytes + count);
    find_packets();
}

// After an invalid packet, the search continues at its second byte.
void ScoutWire::find_packets() {
    std::size_t at = 0;
    while (at < pending_.size()) {
        if (pending_[at] != start) {
            ++at;
            continue;
        }
        const std::size_t left = pending_.size() - at;
        if (left < 4) break;
        const std::size_t length = unsigned_at(&pending_[at + 1]);
        if (length < 2 || length > 255) {
            ++at;
            continue;
        }
        if (left < length + 4) break;
        unsigned sum = 0;
        for (std::size_t i = 0; i < length + 2; ++i) sum += pending_[at + i];
        if ((sum & 0xFFu) != pending_[at + 2 + length] || pending_[at + 3 + length] != end) {
            ++at;
            continue;
        }
        command(pending_[at + 3], pending_.data() + at + 4, length - 2);
        at += length + 4;
    }
    pending_.erase(pending_.begin(), pending_.begin() + static_cast<std::ptrdiff_t>(at));
}

void ScoutWire::answer(unsigned type, const std::vector<std::uint8_t> &data) {
    std::vector<std::uint8_t> packet = {start};
    put(packet, static_cast<unsigned>(data.size()) + 2);
    packet.push_back(static_cast<std::uint8_t>(type));
    packet.insert(packet.end(), data.begin(), data.end());
    unsigned sum = 0;
    for (const std::uint8_t byte : packet) sum += byte;
    packet.push_back(static_cast<std::uint8_t>(sum & 0xFFu));
    packet.push_back(end);
    to_client.insert(to_client.end(), packet.begin(), packet.end());
}

// Units are 0.1 inch and 0.1 degree. Headings range from 0 to 3599, as in Jenkin's programs.
ScoutWire::Place ScoutWire::place() const {
    const frob_pose &pose = senses_.odometry;
    const double turn = defined_.heading / 10.0 * degree - origin_.heading;
    const double dx = (pose.position.x - origin_.position.x) / unit_m;
    const double dy = (pose.position.y - origin_.position.y) / unit_m;
    const double heading = defined_.heading + (pose.heading - origin_.heading) / degree * 10.0;
    return {defined_.x + dx * std::cos(turn) - dy * std::sin(turn),
            defined_.y + dx * std::sin(turn) + dy * std::cos(turn),
            std::fmod(std::fmod(std::round(heading), 3600.0) + 3600.0, 3600.0)};
}

void ScoutWire::define(const Place &here) {
    defined_ = here;
    origin_ = senses_.odometry;
}

void ScoutWire::put_bumpers(std::vector<std::uint8_t> &to) const {
    unsigned bits = 0;
    for (unsigned i = 0; i < 6; ++i) bits |= senses_.bumpers[i] ? 1u << i : 0u;
    put(to, bits);
    to.push_back(0);
}

void ScoutWire::answer_with_state(unsigned type) {
    const frob_scout_input &s = senses_;
    const Place here = place();
    std::vector<std::uint8_t> data(sonar_in_.begin(), sonar_in_.end());
    put_bumpers(data);
    put_signed(data, here.x);
    put_signed(data, here.y);
    put_signed(data, here.heading);
    put_signed(data, here.heading); // turret
    put_signed(data, s.rightWheel / unit_m);
    put_signed(data, s.leftWheel / unit_m);
    put_signed(data, 0);
    put(data, 0); // compass
    data.push_back(
        static_cast<std::uint8_t>((s.leftWheel != 0 ? 1 : 0) | (s.rightWheel != 0 ? 2 : 0) |
                                  (s.battery > 12   ? 2 << 2
                                   : s.battery > 11 ? 1 << 2
                                                    : 0) |
                                  (s.charging ? 3 << 4 : 0) | (s.emergencyStop ? 1 << 6 : 0)));
    put_time(data, now_ns_);
    data.push_back(raw_voltage(12.0, 12.0));
    data.push_back(raw_voltage(s.battery, 12.85));
    answer(type, data);
}

void ScoutWire::tell(unsigned type, const std::uint8_t *data, std::size_t count) const {
    std::string text;
    switch (type) {
    case 1: text = "AC"; break;
    case 2: text = "SP"; break;
    case 3: text = "PR"; break;
    case 5: text = "VM"; break;
    case 7: text = "GS"; break;
    case 9: text = "ST"; break;
    case 10: text = "LP"; break;
    case 12: text = "DP"; break;
    case 15: text = "CONF_SN"; break;
    case 18: text = "CONF_TM"; break;
    case 30: text = "DA"; break;
    default: text = "COMMAND " + std::to_string(type); break;
    }
    if (type == 15 || type == 18)
        for (std::size_t i = 0; i < count; ++i) text += " " + std::to_string(data[i]);
    else
        for (std::size_t i = 0; i + 1 < count; i += 2)
            text += " " + std::to_string(signed_at(data + i));
    log(text);
}

void ScoutWire::command(unsigned type, const std::uint8_t *data, std::size_t count) {
    commanded_ns_ = now_ns_;
    if (log) tell(type, data, count);
    if (data_of(type) != static_cast<int>(count)) return answer(refused, {});
    std::vector<std::uint8_t> reply;
    switch (type) {
    case 2: // SP: right, left
        speed_right_ = static_cast<int>(unsigned_at(data));
        speed_left_ = static_cast<int>(unsigned_at(data + 2));
        break;
    case 3: // PR
        right_goal_ = right_way_ + signed_at(data);
        left_goal_ = left_way_ + signed_at(data + 2);
        moving_ = true;
        move_towards_goal();
        break;
    case 5: // VM
        moving_ = false;
        right_ = signed_at(data);
        left_ = signed_at(data + 2);
        break;
    case 43: // MV: a mode (VM or PR) and a value for each axis; mode 0 leaves the axis unchanged
        for (std::size_t axis = 0; axis < 2; ++axis) {
            int &speed = axis == 0 ? right_ : left_;
            if (unsigned_at(data + 4 * axis) == 1) speed = signed_at(data + 4 * axis + 2);
            if (unsigned_at(data + 4 * axis) == 3) speed = 0;
        }
        break;
    case 9:
    case 10: // ST LP
        moving_ = false;
        left_ = right_ = 0;
        break;
    case 12: // DP
        define({static_cast<double>(signed_at(data)), static_cast<double>(signed_at(data + 2)),
                place().heading});
        break;
    case 30: // DA
        define({place().x, place().y, static_cast<double>(signed_at(data))});
        break;
    case 13: // ZR
        define({0, 0, 0});
        break;
    case 15: { // CONF_SN: rate in units of 4 ms, then the firing order, ended by 255
        on_.fill(false);
        int count_on = 0;
        for (std::size_t i = 1; i <= 16 && data[i] != 255; ++i) {
            on_[data[i] % 16u] = true;
            ++count_on;
        }
        round_ns_ = std::int64_t{4000000} * data[0] * count_on;
        break;
    }
    case 18: watchdog_s_ = data[0]; break;
    case 20:
        reply.assign(sonar_in_.begin(), sonar_in_.end());
        put_time(reply, now_ns_);
        return answer(type, reply);
    case 21:
        put_signed(reply, place().x);
        put_signed(reply, place().y);
        put_signed(reply, place().heading);
        put_signed(reply, 0);
        return answer(type, reply);
    case 22:
        put_signed(reply, senses_.rightWheel / unit_m);
        put_signed(reply, senses_.leftWheel / unit_m);
        put_signed(reply, 0);
        return answer(type, reply);
    case 27:
        put_bumpers(reply);
        put_time(reply, now_ns_);
        return answer(type, reply);
    case 31: // WS: answered when the wheels have stopped, or after its timeout
        waits_until_ns_ = now_ns_ + std::int64_t{1000000000} * data[3];
        waits_ = true;
        return end_waiting();
    default: break;
    }
    answer_with_state(type);
}

void ScoutWire::end_waiting() {
    if (!waits_ || ((left_ != 0 || right_ != 0) && now_ns_ < waits_until_ns_)) return;
    waits_ = false;
    answer_with_state(31);
}

// PR: each wheel runs until it has travelled its distance.
void ScoutWire::move_towards_goal() {
    if (!moving_) return;
    const double left = left_goal_ - left_way_, right = right_goal_ - right_way_;
    left_ = left > 0.5 ? speed_left_ : left < -0.5 ? -speed_left_ : 0;
    right_ = right > 0.5 ? speed_right_ : right < -0.5 ? -speed_right_ : 0;
    moving_ = left_ != 0 || right_ != 0;
}

void ScoutWire::sense(const frob_scout_input &input, std::int64_t now_ns) {
    const double elapsed_s = static_cast<double>(now_ns - sensed_ns_) * 1e-9;
    left_way_ += input.leftWheel / unit_m * elapsed_s;
    right_way_ += input.rightWheel / unit_m * elapsed_s;
    now_ns_ = sensed_ns_ = now_ns;
    senses_ = input;
    if (input.emergencyStop) {
        moving_ = false;
        left_ = right_ = 0;
    }
    for (std::size_t i = 0; i < sonar_in_.size(); ++i) {
        if (!on_[i]) continue;
        if (input.sonar[i].tag == FROB_EVENT_FLOAT_EVENT) {
            sonar_in_[i] = static_cast<std::uint8_t>(
                std::clamp(std::lround(input.sonar[i].f0 / 0.0254), 1l, 255l));
            echo_ns_[i] = now_ns;
        } else if (now_ns - echo_ns_[i] > round_ns_) {
            sonar_in_[i] = 255;
        }
    }
    move_towards_goal();
}

void ScoutWire::advance(std::int64_t now_ns) {
    now_ns_ = std::max(now_ns_, now_ns);
    const bool moves = left_ != 0 || right_ != 0;
    if (moves && watchdog_s_ != 0 &&
        now_ns_ - commanded_ns_ >= std::int64_t{1000000000} * watchdog_s_) {
        if (log) log("watchdog");
        moving_ = false;
        left_ = right_ = 0;
    }
    end_waiting();
}

frob_scout_output ScoutWire::output() const {
    frob_scout_output output{};
    output.forward = 0.5 * (left_ + right_) * unit_m;
    output.turn = (right_ - left_) * unit_m / separation_m;
    return output;
}

} // namespace frob::sim
