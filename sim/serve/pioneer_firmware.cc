#include "pioneer_firmware.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "geometry.h"

namespace frob::serve {
namespace {

using sim::pi;
using sim::radians;

constexpr std::int64_t ms = 1'000'000;
constexpr std::int64_t sip_period_ns = 100 * ms;
constexpr std::int64_t servo_period_ns = 20 * ms;
constexpr std::int64_t watchdog_ns = 2000 * ms;
constexpr std::int64_t handshake_patience_ns = 10'000 * ms;
constexpr std::int64_t sonar_turn_ns = 320 * ms; // time in which each transducer fires once
constexpr std::size_t backlog = 200;             // maximum number of unsent bytes; if there are
                                                 // more, a SIP is skipped

constexpr double no_echo_m = 5.0;
constexpr double counts_per_turn = 4096.0;
constexpr double difference = 0.0056; // omega = difference (v_right - v_left) / 2, v in mm/s
constexpr double vel2_divisor = 20.0;
constexpr int top_speed = 2200, top_turn = 500; // mm/s, deg/s
constexpr double ticks_per_m = 132'000.0;       // the FLASH parameter TicksMM of a P3-DX is 132

constexpr PioneerModel models[] = {
    {"p3dx-sh", 1.0, 1.0},
    {"p3dx", 0.485, 1.0},
    {"p2dx", 0.84, 0.268},
};

// Command numbers, from the manuals.
enum : std::uint8_t {
    PULSE = 0,
    OPEN = 1,
    CLOSE = 2,
    ENABLE = 4,
    SETA = 5,
    SETV = 6,
    SETO = 7,
    MOVE = 8,
    ROTATE = 9,
    SETRV = 10,
    VEL = 11,
    HEAD = 12,
    DHEAD = 13,
    CONFIG = 18,
    ENCODER = 19,
    RVEL = 21,
    DCHEAD = 22,
    SETRA = 23,
    SONAR = 28,
    STOP = 29,
    DIGOUT = 30,
    VEL2 = 32,
    IOREQUEST = 40,
    HOSTBAUD = 50,
    E_STOP = 55
};

constexpr std::pair<std::uint8_t, const char *> names[] = {
    {PULSE, "PULSE"},
    {OPEN, "OPEN"},
    {CLOSE, "CLOSE"},
    {ENABLE, "ENABLE"},
    {SETA, "SETA"},
    {SETV, "SETV"},
    {SETO, "SETO"},
    {MOVE, "MOVE"},
    {ROTATE, "ROTATE"},
    {SETRV, "SETRV"},
    {VEL, "VEL"},
    {HEAD, "HEAD"},
    {DHEAD, "DHEAD"},
    {CONFIG, "CONFIG"},
    {ENCODER, "ENCODER"},
    {RVEL, "RVEL"},
    {DCHEAD, "DCHEAD"},
    {SETRA, "SETRA"},
    {SONAR, "SONAR"},
    {STOP, "STOP"},
    {DIGOUT, "DIGOUT"},
    {VEL2, "VEL2"},
    {IOREQUEST, "IOREQUEST"},
    {HOSTBAUD, "HOSTBAUD"},
    {E_STOP, "E_STOP"},
};

std::string name(std::uint8_t number) {
    for (const auto &[known, text] : names)
        if (known == number) return text;
    return "COMMAND " + std::to_string(number);
}

int rounded(double x) { return static_cast<int>(std::lround(x)); }

} // namespace

PioneerFirmware::PioneerFirmware(frob_sim *sim, const PioneerModel &model, std::uint32_t rate)
    : sim_(sim), model_(model), first_rate_(rate), rate_(rate),
      motion_(top_speed / 1000.0, radians(top_turn)) {
    listen();
}

const PioneerModel *PioneerFirmware::find_model(const std::string &subclass) {
    for (const PioneerModel &model : models)
        if (subclass == model.subclass) return &model;
    return nullptr;
}

// Reads the sensors. This happens before each SIP and at each motor update, so each echo is stored
// until the next SIP.
void PioneerFirmware::look() {
    frob_pioneer_input now{};
    frob_sim_read(sim_, &now);
    for (std::size_t i = 0; i < echoes_.size(); ++i)
        if (now.sonar[i].tag == FROB_EVENT_FLOAT_EVENT)
            echoes_[i] = {true, now.sonar[i].f0, now_ns_};
    sensed_ = now;
}

double PioneerFirmware::heading() const {
    return std::remainder(sensed_.odometry.heading - origin_heading_, 2.0 * pi);
}

// Reads the sensors. A transducer that has not received an echo in its turn reads its maximum
// range.
void PioneerFirmware::listen() {
    look();
    for (std::size_t i = 0; i < echoes_.size(); ++i) {
        Echo &echo = echoes_[i];
        if (now_ns_ - echo.at_ns > sonar_turn_ns + sonar_turn_ns / 8)
            echo = {true, no_echo_m, now_ns_ - sonar_turn_ns / 8};
    }
}

void PioneerFirmware::advance(std::int64_t time_ns) {
    while (std::min(servo_ns_, open_ ? sip_ns_ : servo_ns_) <= time_ns) {
        const bool sip = open_ && sip_ns_ <= servo_ns_;
        now_ns_ = sip ? sip_ns_ : servo_ns_;
        frob_sim_advance(sim_, now_ns_);
        (sip ? sip_ns_ : servo_ns_) += sip ? sip_period_ns : servo_period_ns;
        if (sip) {
            listen();
            send_sip();
        } else {
            look();
            const double elapsed_s = static_cast<double>(servo_period_ns) * 1e-9;
            left_m_ += sensed_.leftWheel * elapsed_s;
            right_m_ += sensed_.rightWheel * elapsed_s;
            motion_.advance({heading(), (sensed_.leftWheel + sensed_.rightWheel) / 2.0,
                             difference * (sensed_.rightWheel - sensed_.leftWheel) * 1000.0 / 2.0},
                            elapsed_s);
            drive();
        }
    }
    now_ns_ = time_ns;
    frob_sim_advance(sim_, now_ns_);
    if (session_ && !tripped_ && now_ns_ - heard_ns_ >= watchdog_ns) {
        tripped_ = true;
        log(now_ns_, "watchdog");
        drive();
    }
    if (!session_ && expected_sync_ > 0 && now_ns_ - handshake_ns_ > handshake_patience_ns)
        expected_sync_ = 0;
}

std::int64_t PioneerFirmware::next_ns() const {
    return open_ ? std::min(sip_ns_, servo_ns_) : servo_ns_;
}

// Makes the motors follow the setpoints if the motors are on and the watchdog has not tripped;
// otherwise stops them.
void PioneerFirmware::drive() {
    frob_pioneer_output output{};
    if (motors_ && !tripped_) {
        output.forward = motion_.forward();
        output.turn = motion_.turn();
    }
    frob_sim_command(sim_, now_ns_, &output);
}

void PioneerFirmware::receive(std::uint8_t byte) {
    const std::optional<P2osCommand> command = reader_.take(byte);
    if (!command) return;
    log(now_ns_, name(command->number) +
                     (command->argument ? " " + std::to_string(*command->argument) : ""));
    heard_ns_ = now_ns_;
    tripped_ = false;
    if (session_)
        obey(*command);
    else
        handshake(*command);
    drive();
}

// Expects SYNC0, SYNC1, SYNC2 in this order and echoes each one. A SYNC0 restarts the handshake.
void PioneerFirmware::handshake(const P2osCommand &command) {
    if (command.number == 0) expected_sync_ = 0;
    if (command.number != expected_sync_ || command.argument) return;
    handshake_ns_ = now_ns_;
    if (command.number < 2) {
        send(P2osBody(command.number).packet());
        ++expected_sync_;
        return;
    }
    send(P2osBody(2).text("FrobSim").text("Pioneer").text(model_.subclass).packet());
    expected_sync_ = 0;
    session_ = true;
    open_ = motors_ = false;
    sonar_on_ = true;
}

void PioneerFirmware::close_session() {
    session_ = open_ = motors_ = tripped_ = false;
    motion_ = PioneerMotion(top_speed / 1000.0, radians(top_turn));
    encoders_ = io_ = Asked::no;
    rate_ = first_rate_;
}

void PioneerFirmware::obey(const P2osCommand &command) {
    const int n = command.argument.value_or(0);
    switch (command.number) {
    case OPEN:
        if (!open_) sip_ns_ = now_ns_ + sip_period_ns;
        open_ = true;
        break;
    case CLOSE: close_session(); break;
    case ENABLE:
        motors_ = n != 0;
        if (!motors_) motion_.halt();
        break;
    case SETO:
        origin_x_ = sensed_.odometry.position.x;
        origin_y_ = sensed_.odometry.position.y;
        origin_heading_ = sensed_.odometry.heading;
        break;
    case VEL: motion_.set_speed(n / 1000.0); break;
    case ROTATE:
    case RVEL: motion_.set_turn(radians(n)); break;
    case MOVE: motion_.move(n / 1000.0); break;
    case HEAD: motion_.face(radians(n)); break;
    case DHEAD: motion_.face_by(radians(n), heading()); break;
    case DCHEAD: motion_.face_by(radians(n), motion_.heading_setpoint().value_or(heading())); break;
    case SETV: motion_.limit_speed(n / 1000.0); break;
    case SETRV: motion_.limit_turn(radians(n)); break;
    case SETA: motion_.accelerate(n / 1000.0); break;
    case SETRA: motion_.accelerate_turn(radians(n)); break;
    case VEL2:
        if (command.raw.size() >= 2) {
            const double right = vel2_divisor * static_cast<std::int8_t>(command.raw[0]);
            const double left = vel2_divisor * static_cast<std::int8_t>(command.raw[1]);
            motion_.set_speed((right + left) / 2000.0);
            motion_.set_turn(difference * (right - left) / 2.0);
        }
        break;
    case STOP: motion_.stop(); break;
    case E_STOP: motion_.halt(); break;
    case ENCODER: encoders_ = asked(n); break;
    case IOREQUEST: io_ = asked(n); break;
    case DIGOUT: {
        const int mask = n >> 8 & 0xFF;
        digital_out_ = (digital_out_ & ~mask) | (n & mask);
        break;
    }
    case SONAR: sonar_on_ = n != 0; break;
    case CONFIG: send_config(); break;
    case HOSTBAUD: {
        constexpr std::array<std::uint32_t, 5> rates = {9600, 19200, 38400, 57600, 115200};
        if (n >= 0 && static_cast<std::size_t>(n) < rates.size())
            rate_ = rates[static_cast<std::size_t>(n)];
        break;
    }
    default: // for PULSE, and for commands that this robot does not support
        break;
    }
}

// Offsets and units follow the ARCOS manual, "Standard server information packet".
void PioneerFirmware::send_sip() {
    if (!has_room()) return;
    const double c = std::cos(-origin_heading_), s = std::sin(-origin_heading_);
    const double dx = sensed_.odometry.position.x - origin_x_;
    const double dy = sensed_.odometry.position.y - origin_y_;
    const double units = 1000.0 / model_.distance_mm;
    const double control = motion_.heading_setpoint().value_or(heading());
    const bool moving = sensed_.leftWheel != 0.0 || sensed_.rightWheel != 0.0;
    const int all_bumpers = 0x3E; // five segments
    P2osBody body(moving ? 0x33 : 0x32);
    body.u16(rounded((c * dx - s * dy) * units) & 0x7FFF)
        .u16(rounded((s * dx + c * dy) * units) & 0x7FFF)
        .u16(rounded(heading() / (2.0 * pi) * counts_per_turn))
        .u16(rounded(sensed_.leftWheel * 1000.0))
        .u16(rounded(sensed_.rightWheel * 1000.0))
        .u8(rounded(sensed_.battery * 10.0))
        .u8((sensed_.leftStall ? 1 : 0) | (sensed_.rearBumper ? all_bumpers : 0))
        .u8((sensed_.rightStall ? 1 : 0) | (sensed_.frontBumper ? all_bumpers : 0))
        .u16(rounded(control / (2.0 * pi) * counts_per_turn))
        .u16((motors_ ? 1 : 0) | (sonar_on_ ? 6 : 0))
        .u8(0);
    int count = 0;
    for (Echo &echo : echoes_) count += echo.fresh && sonar_on_ ? 1 : 0;
    body.u8(count);
    for (std::size_t i = 0; i < echoes_.size(); ++i) {
        if (echoes_[i].fresh && sonar_on_)
            body.u8(static_cast<int>(i))
                .u16(rounded(echoes_[i].range_m * 1000.0 / model_.range_mm));
        echoes_[i].fresh = false;
    }
    body.u8(0).u8(0).u8(0).u8(0).u8(digital_out_); // gripper, analog, digital
    body.u16(rounded(sensed_.battery * 10.0)).u8(0);
    const double turn_rate = difference * (sensed_.rightWheel - sensed_.leftWheel) * 1000.0 / 2.0;
    body.u16(rounded(sim::degrees(turn_rate) * 10.0));
    body.u16(0).u16(0).u8(20).u8(80); // faults, lateral speed, temperature, charge
    send(body.packet());
    if (encoders_ != Asked::no) send_encoders();
    if (io_ != Asked::no) send_io();
}

bool PioneerFirmware::has_room() const { return waiting_output() <= backlog; }

// 32-bit encoder counts, left and right.
void PioneerFirmware::send_encoders() {
    P2osBody body(0x90);
    for (const double way : {left_m_, right_m_}) {
        const auto ticks = static_cast<std::int32_t>(std::lround(way * ticks_per_m));
        body.u16(ticks).u16(ticks >> 16);
    }
    send(body.packet());
    if (encoders_ == Asked::once) encoders_ = Asked::no;
}

// The numbers of digital inputs, digital outputs and analog ports, each followed by the values.
// Nothing is connected to the inputs.
void PioneerFirmware::send_io() {
    P2osBody body(0xF0);
    body.u8(4).u8(0).u8(0).u8(0).u8(0);
    body.u8(2).u8(digital_out_).u8(0);
    body.u8(9);
    for (int port = 0; port < 9; ++port) body.u16(0);
    send(body.packet());
    if (io_ == Asked::once) io_ = Asked::no;
}

// The complete packet, following the ARCOS manual's "Configuration packet" and AriaCoda's reader.
// Clients take their limits from it, so a truncated packet would keep the robot from moving. Speeds
// are in mm/s and deg/s, and accelerations in mm/s^2 and deg/s^2. The fields of parts that this
// robot does not have are 0.
void PioneerFirmware::send_config() {
    constexpr int speed_up = 300, turn_up = 100;                     // defaults in FLASH
    constexpr int turn_gains[] = {40, 20, 0}, gains[] = {40, 30, 0}; // KP, KV, KI
    constexpr int turn_most = 300, speed_most = 750;
    P2osBody body(0x20);
    body.text("Pioneer").text(model_.subclass).text("0").u8(0);    // serial number; four motors
    body.u16(top_turn).u16(top_speed).u16(300).u16(2000).u16(500); // top speeds; PWM
    // SIP period; baud rates of host and auxiliary port
    body.text("FrobSim").u8(sip_period_ns / ms).u8(0).u8(0);
    body.u16(0).u16(1).u8(1); // gripper, sonars
    body.u16(115).u16(16570).u16(static_cast<int>(watchdog_ns / ms)).u8(0);
    body.u16(200).u16(100).u16(speed_most).u16(turn_most); // stalls, joystick
    body.u16(turn_most).u16(speed_most).u16(turn_up).u16(turn_up);
    for (const int gain : turn_gains) body.u16(gain);
    body.u16(speed_up).u16(speed_up);
    for (const int gain : gains) body.u16(gain);
    body.u8(1).u8(1).u8(0).u8(40).u8(0).u8(0); // bumpers, charger, sonar cycle, baud rate, gyro
    body.u16(0).u8(0).u8(0);                   // drift; auxiliary baud rates
    body.u16(rounded(ticks_per_m / 1000.0)).u16(110);
    body.text("2.9").u16(0).u16(0).u8(0); // firmware; gyro; delay
    for (int lateral = 0; lateral < 5; ++lateral) body.u16(0);
    body.u16(0).u8(0).u16(0).u8(-128); // charging, its port, gyro limit, heat: none
    send(body.packet());
}

} // namespace frob::serve
