#include "create_wire.h"

#include <algorithm>
#include <cmath>

#include "../create2.h"

namespace frob::sim {
namespace {

constexpr double mm_per_count = 3.14159265358979323846 * 72.0 / 508.8;
constexpr double separation_mm = 235.0;
constexpr int most_mm_s = 500;
constexpr std::int64_t frame_period_ns = 15000000;
constexpr std::int64_t refresh_ns = 15000000, understood_ns = 1000000;
constexpr std::size_t most_frame = 172; // maximum number of bytes that can be sent in 15 ms at
                                        // 115200 baud
constexpr std::uint8_t header = 19;

// Number of data bytes in each single packet, from packet 7 on.
constexpr std::array<std::uint8_t, 52> sizes = {
    1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 2, 2, 1, 2, 2, 1, 2, 2, 2, 2, 2, 2, 2, 1,
    2, 1, 1, 1, 1, 1, 2, 2, 2, 2, 2, 2, 1, 2, 2, 2, 2, 2, 2, 1, 1, 2, 2, 2, 2, 1};

struct Group {
    unsigned id, first, last;
};
constexpr std::array<Group, 11> groups = {{{0, 7, 26},
                                           {1, 7, 16},
                                           {2, 17, 20},
                                           {3, 21, 26},
                                           {4, 27, 34},
                                           {5, 35, 42},
                                           {6, 7, 42},
                                           {100, 7, 58},
                                           {101, 43, 58},
                                           {106, 46, 51},
                                           {107, 54, 58}}};

// Text that the robot sends while it restarts, and how long after opcode 7 it is sent.
struct Said {
    std::int64_t after_ns;
    const char *text;
};
constexpr std::array<Said, 2> boot_says = {
    {{1000000000,
      "bl-start\r\nSTR730\r\nbootloader id: #x47186549 82ECCFFF\r\n"
      "bootloader info rev: #xF000\r\nbootloader rev: #x0001\r\n2007-05-14-1715-L \r\n"},
     {3000000000,
      "Roomba by iRobot!\r\nstr730\r\n2015-08-24-1648-L\r\nbattery-current-zero 261\r\n"}}};

unsigned count_of(double way_mm) {
    return static_cast<unsigned>(std::llround(std::floor(way_mm / mm_per_count)) & 0xFFFF);
}

unsigned two_complement(int value) { return static_cast<unsigned>(value) & 0xFFFFu; }

} // namespace

// The length of the current command, including its data, as far as it is known from the bytes
// received so far.
std::size_t CreateWire::needed() const {
    const std::size_t have = command_.size();
    switch (command_[0]) {
    case 129:
    case 141:
    case 142:
    case 150:
    case 165: return 2;
    case 138: return 2;
    case 168:
    case 139:
    case 144: return 4;
    case 137:
    case 145:
    case 146:
    case 163:
    case 164: return 5;
    case 162: return 3;
    case 167: return 16;
    case 148:
    case 149: // count, then ids
        return have < 2 ? 2 : 2u + command_[1];
    case 140: // number, length, then notes of two bytes each
        return have < 3 ? 3 : 3u + 2u * command_[2];
    default: return 1;
    }
}

void CreateWire::receive(const std::uint8_t *bytes, std::size_t count) {
    for (std::size_t i = 0; i < count && to_boot_ == 0; ++i) {
        command_.push_back(bytes[i]);
        if (command_.size() < needed()) continue;
        command();
        command_.clear();
    }
}

int CreateWire::word(std::size_t at) const {
    const int value = command_[at] << 8 | command_[at + 1];
    return value < 0x8000 ? value : value - 0x10000;
}

void CreateWire::enter(Mode mode) {
    mode_ = mode;
    drive_wheels(0, 0);
    if (mode != Mode::off) return;
    streaming_ = false;
    asked_.clear();
}

// The motors obey commands only in Safe and Full mode, except that they always obey a speed of
// zero.
void CreateWire::drive_wheels(int right_mm_s, int left_mm_s) {
    const bool obeys = mode_ == Mode::safe || mode_ == Mode::full;
    right_mm_s_ = obeys ? std::clamp(right_mm_s, -most_mm_s, most_mm_s) : 0;
    left_mm_s_ = obeys ? std::clamp(left_mm_s, -most_mm_s, most_mm_s) : 0;
    speed_mm_s_ = radius_mm_ = 0;
}

// DRIVE: a positive radius turns left. Two special radius values mean straight ahead, and two
// others mean turning in place.
void CreateWire::drive_curve(int speed_mm_s, int radius_mm) {
    speed_mm_s = std::clamp(speed_mm_s, -most_mm_s, most_mm_s);
    if (radius_mm == -32768 || radius_mm == 32767 || radius_mm == 0) {
        drive_wheels(speed_mm_s, speed_mm_s);
    } else if (radius_mm == 1 || radius_mm == -1) {
        drive_wheels(radius_mm * speed_mm_s, -radius_mm * speed_mm_s);
    } else {
        const double across = separation_mm / 2.0 / std::clamp(radius_mm, -2000, 2000);
        drive_wheels(static_cast<int>(std::lround(speed_mm_s * (1.0 + across))),
                     static_cast<int>(std::lround(speed_mm_s * (1.0 - across))));
    }
    speed_mm_s_ = speed_mm_s;
    radius_mm_ = radius_mm;
}

void CreateWire::tell() const {
    std::string text;
    switch (command_[0]) {
    case 7: text = "RESET"; break;
    case 128: text = "START"; break;
    case 130:
    case 131: text = "SAFE"; break;
    case 132: text = "FULL"; break;
    case 137: text = "DRIVE"; break;
    case 139: text = "LEDS"; break;
    case 140: text = "SONG"; break;
    case 141: text = "PLAY"; break;
    case 142: text = "SENSORS"; break;
    case 145: text = "DRIVE_DIRECT"; break;
    case 146: text = "DRIVE_PWM"; break;
    case 148: text = "STREAM"; break;
    case 149: text = "QUERY_LIST"; break;
    case 150: text = "PAUSE_STREAM"; break;
    case 173: text = "STOP_OI"; break;
    default: text = "OPCODE " + std::to_string(command_[0]); break;
    }
    if (command_[0] == 137 || command_[0] == 145 || command_[0] == 146)
        text += " " + std::to_string(word(1)) + " " + std::to_string(word(3));
    else
        for (std::size_t i = 1; i < command_.size(); ++i) text += " " + std::to_string(command_[i]);
    log(text);
}

void CreateWire::command() {
    const unsigned opcode = command_[0];
    if (log && opcode != 0) tell();
    if (opcode == 7) return reset();
    if (opcode == 173 || opcode == 133) return enter(Mode::off);
    if (opcode == 128) return enter(Mode::passive);
    if (mode_ == Mode::off) return;
    switch (opcode) {
    case 130:
    case 131:
        // A robot that is lifted or on its charger stays in Passive mode.
        if (!senses_.leftDrop && !senses_.rightDrop && !senses_.charging) enter(Mode::safe);
        break;
    case 132: enter(Mode::full); break;
    case 134:
    case 135:
    case 136:
    case 143: enter(Mode::passive); break;
    case 137: drive_curve(word(1), word(3)); break;
    case 145: drive_wheels(word(1), word(3)); break;
    case 146: // duty cycle, from 0 to 255
        drive_wheels(word(1) * most_mm_s / 255, word(3) * most_mm_s / 255);
        break;
    case 142:
    case 149: // one packet; or a list, preceded by its length
        if (asked_.empty())
            answer_ns_ = (now_ns_ + understood_ns + refresh_ns - 1) / refresh_ns * refresh_ns;
        asked_.insert(asked_.end(), command_.begin() + (opcode == 142 ? 1 : 2), command_.end());
        break;
    case 148:
        streamed_.assign(command_.begin() + 2, command_.end());
        streaming_ = !streamed_.empty(); // a request for no packets ends the stream
        frame_ns_ = now_ns_ + frame_period_ns;
        break;
    case 150:
        streaming_ = command_[1] != 0 && !streamed_.empty();
        frame_ns_ = now_ns_ + frame_period_ns;
        break;
    default: break;
    }
}

void CreateWire::answer() {
    for (const std::uint8_t id : asked_) append(id, to_client);
    asked_.clear();
}

void CreateWire::reset() {
    enter(Mode::off);
    reset_ns_ = now_ns_;
    to_boot_ = boot_says.size();
}

void CreateWire::boot() {
    for (; to_boot_ > 0; --to_boot_) {
        const Said &said = boot_says[boot_says.size() - to_boot_];
        if (now_ns_ < reset_ns_ + said.after_ns) return;
        const std::string text = said.text;
        to_client.insert(to_client.end(), text.begin(), text.end());
    }
}

// Appends a packet's data, or the data of all packets in a group; appends nothing for an unknown
// id.
void CreateWire::append(unsigned id, std::vector<std::uint8_t> &to) {
    if (id < 7 || id > 58) {
        for (const Group &group : groups)
            if (group.id == id)
                for (unsigned part = group.first; part <= group.last; ++part) append(part, to);
        return;
    }
    const frob_create_input &s = senses_;
    const double way = 0.5 * (left_way_mm_ + right_way_mm_), turn = right_way_mm_ - left_way_mm_;
    unsigned value = 0;
    switch (id) {
    case 7:
        value = (s.bumpRight ? 1u : 0u) | (s.bumpLeft ? 2u : 0u) | (s.rightDrop ? 4u : 0u) |
                (s.leftDrop ? 8u : 0u);
        break;
    case 9:
    case 10:
    case 11:
    case 12: value = s.cliffs[id - 9]; break;
    case 13: value = s.virtualWall; break;
    case 14: value = (s.rightOvercurrent ? 8u : 0u) | (s.leftOvercurrent ? 16u : 0u); break;
    case 17: value = static_cast<unsigned>(s.beacon) & 0xFFu; break;
    case 18: value = s.cleanButton; break;
    case 19:
        value = two_complement(static_cast<int>(std::lround(way - asked_way_mm_)));
        asked_way_mm_ = way;
        break;
    case 20:
        value = two_complement(static_cast<int>(
            std::lround((turn - asked_turn_mm_) / separation_mm * 180.0 / 3.14159265358979323846)));
        asked_turn_mm_ = turn;
        break;
    case 21: value = s.charging ? 2 : 0; break;
    case 22:
        value = static_cast<unsigned>(std::lround(std::clamp(s.battery, 0.0, 65.0) * 1e3));
        break;
    case 24: value = 25; break;
    case 25:
        value = static_cast<unsigned>(std::lround(2696 * std::clamp(s.charge, 0.0, 1.0)));
        break;
    case 26: value = 2696; break;
    case 28:
    case 29:
    case 30:
    case 31: value = static_cast<unsigned>(std::clamp(s.cliffSignals[id - 28], 0, 4095)); break;
    case 34: value = s.charging ? 2 : 0; break;
    case 35: value = static_cast<unsigned>(mode_); break;
    case 38: value = static_cast<unsigned>(streamed_.size()); break;
    case 39: value = two_complement(speed_mm_s_); break;
    case 40: value = two_complement(radius_mm_); break;
    case 41: value = two_complement(right_mm_s_); break;
    case 42: value = two_complement(left_mm_s_); break;
    case 43: value = count_of(left_way_mm_); break;
    case 44: value = count_of(right_way_mm_); break;
    case 45:
        for (unsigned i = 0; i < 6; ++i)
            value |= s.light[i] >= create2::faintest_light ? 1u << i : 0u;
        break;
    case 46:
    case 47:
    case 48:
    case 49:
    case 50:
    case 51: value = static_cast<unsigned>(std::clamp(s.light[id - 46], 0, 4095)); break;
    default: break;
    }
    if (sizes[id - 7] == 2) to.push_back(static_cast<std::uint8_t>(value >> 8));
    to.push_back(static_cast<std::uint8_t>(value & 0xFFu));
}

void CreateWire::send_frame() {
    frame_.assign({header, 0});
    for (const std::uint8_t id : streamed_) {
        frame_.push_back(id);
        append(id, frame_);
    }
    frame_[1] = static_cast<std::uint8_t>(frame_.size() - 2);
    unsigned sum = 0;
    for (const std::uint8_t byte : frame_) sum += byte;
    frame_.push_back(static_cast<std::uint8_t>(0u - sum));
    if (frame_.size() <= most_frame)
        to_client.insert(to_client.end(), frame_.begin(), frame_.end());
}

void CreateWire::sense(const frob_create_input &input, std::int64_t now_ns) {
    const double elapsed_s = static_cast<double>(now_ns - sensed_ns_) * 1e-9;
    left_way_mm_ += 1e3 * input.leftWheel * elapsed_s;
    right_way_mm_ += 1e3 * input.rightWheel * elapsed_s;
    now_ns_ = sensed_ns_ = now_ns;
    senses_ = input;
    const bool moves = left_mm_s_ != 0 || right_mm_s_ != 0;
    const bool cliff =
        std::any_of(std::begin(input.cliffs), std::end(input.cliffs), [](bool c) { return c; });
    if (mode_ == Mode::safe && (input.leftDrop || input.rightDrop || input.charging ||
                                (cliff && moves && left_mm_s_ + right_mm_s_ >= 0)))
        enter(Mode::passive);
}

void CreateWire::advance(std::int64_t now_ns) {
    now_ns_ = std::max(now_ns_, now_ns);
    boot();
    if (answer_ns_ <= now_ns_) answer();
    for (; streaming_ && frame_ns_ <= now_ns; frame_ns_ += frame_period_ns) send_frame();
}

frob_create_output CreateWire::output() const {
    frob_create_output output{};
    output.forward = 0.5e-3 * (left_mm_s_ + right_mm_s_);
    output.turn = (right_mm_s_ - left_mm_s_) / separation_mm;
    return output;
}

} // namespace frob::sim
