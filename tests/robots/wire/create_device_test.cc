// Tests the Create's driver against the simulated robot's end of the line.
#include "bench.h"
#include "slow.h"
#include "drivers/create/lights.h"
#include "check.h"

using CreateBench = Bench<CreateKind>;
using Mode = frob::sim::CreateWire::Mode;

static void connects_and_drives()
{
    CreateBench b;
    b.body.battery = 14.9;
    b.body.charge = 0.5;
    b.start();
    b.run(b.time.now_ns + second);
    check(b.state == FROB_ROBOT_READY && b.wire.mode() == Mode::safe,
          "create: connects, in mode Safe");
    b.drive(0.3, 0, 2 * second);
    check(b.wire.left_mm_s() == 300 && b.wire.right_mm_s() == 300, "create: 300 mm/s");
    check_near(b.input.odometry.position.x, b.body.odometry.position.x, 0.02,
               "create: odometry ahead");
    check_near(b.input.leftWheel, 0.3, 0.02, "create: measured speed");
    b.drive(-0.3, 0, 6 * second);
    check_near(b.input.odometry.position.x, b.body.odometry.position.x, 0.02,
               "create: odometry back, below where the counts began");
    b.drive(0, 1, second);
    check_near(b.input.odometry.heading, 0.97, 0.06, "create: heading");
    check_near(b.input.battery, 14.9, 1e-9, "create: battery");
    check_near(b.input.charge, 0.5, 1e-9, "create: charge");
    check(b.input.obeying, "create: obeying");
    frob_robot_close(&b.robot);
    b.act();
    check(b.wire.left_mm_s() == 0 && b.wire.mode() == Mode::passive,
          "create: rests in mode Passive after the session");
}

static void limits_wheels_together()
{
    CreateBench b;
    b.start();
    b.run(b.time.now_ns + second);
    b.drive(0.5, 2, 500 * ms);
    check(b.wire.right_mm_s() == 500 && b.wire.left_mm_s() == 180,
          "create: too fast a wheel slows both, and the curve stays");
}

static void senses()
{
    CreateBench b;
    b.start();
    b.run(b.time.now_ns + second);
    b.body.bumpLeft = true;
    b.body.cliffs[3] = true;
    b.body.light[1] = 700;
    for (int i = 0; i < 4; ++i)
        b.body.cliffSignals[i] = 300 * (i + 1);
    b.body.virtualWall = b.body.cleanButton = b.body.leftOvercurrent = true;
    b.body.beacon = 161;
    b.drive(0, 0, second / 10);
    check(b.input.bumpLeft && !b.input.bumpRight, "create: bump on the left");
    check(b.input.cliffs[3] && !b.input.cliffs[0], "create: cliff on the right");
    check(b.input.cliffSignals[0] == 300 && b.input.cliffSignals[1] == 600 &&
              b.input.cliffSignals[2] == 900 && b.input.cliffSignals[3] == 1200,
          "create: what the floor gives back, from the left to the right");
    check(b.input.light[1] == 700 && b.input.light[0] == 0, "create: light bumper");
    check(b.input.virtualWall && b.input.beacon == 161 && b.input.cleanButton,
          "create: beacons, button");
    check(b.input.leftOvercurrent && !b.input.rightOvercurrent, "create: overcurrent on the left");
}

static void leaving_safe_mode_is_a_fault()
{
    CreateBench b;
    b.start();
    b.run(b.time.now_ns + second);
    b.drive(0.3, 0, second);
    b.body.cliffs[1] = true;
    b.drive(0.3, 0, 100 * ms);
    check(b.state == FROB_ROBOT_FAILED && b.robot.status == FROB_REFUSED,
          "create: a cliff is a fault");
    check(std::strstr(frob_create_driver.describe(&b.device), "cliff") != nullptr,
          "create: and says so");
    check(b.wire.left_mm_s() == 0 && b.wire.mode() == Mode::passive, "create: the robot stands");
    b.drive(0.3, 0, 2 * second);
    check(b.wire.mode() == Mode::passive, "create: Safe is not entered again by itself");
    b.body.cliffs[1] = false;
    b.start();
    b.run(b.time.now_ns + second);
    check(b.state == FROB_ROBOT_READY, "create: but when the host starts anew");
}

static void does_not_drive_in_the_air()
{
    CreateBench b;
    b.body.leftDrop = true;
    b.start();
    b.run(b.time.now_ns + second);
    check(b.state == FROB_ROBOT_FAILED && b.robot.status == FROB_REFUSED,
          "create: lifted, it is refused");
}

static void stops_when_frames_stay_away()
{
    CreateBench b;
    b.start();
    b.run(b.time.now_ns + second);
    b.drive(0.3, 0, second);
    b.cut = true; // towards the driver only; the robot still hears
    b.drive(0.3, 0, 350 * ms);
    check(b.state == FROB_ROBOT_STALE && b.wire.left_mm_s() == 0,
          "create: stale frames stop the robot");
    b.cut = false;
    b.drive(0.3, 0, second);
    check(b.state == FROB_ROBOT_READY && b.wire.left_mm_s() == 300,
          "create: and driving goes on after them");
    const std::uint8_t pause[] = { 150, 0 };
    b.wire.receive(pause, sizeof pause);
    b.drive(0.3, 0, second);
    check(b.state == FROB_ROBOT_READY && b.wire.left_mm_s() == 300,
          "create: a stream that pauses is asked for again");
    b.cut = true;
    b.run(b.time.now_ns + 2 * second);
    check(b.state == FROB_ROBOT_FAILED && b.robot.status == FROB_TIMEOUT,
          "create: a silent robot is lost");
}

// 145 mm/s on the right is 00 91, and 91 is the opcode: without padding, the effects of a lost byte
// would last forever.
static void a_lost_byte_is_felt_once()
{
    CreateBench b;
    b.start();
    b.run(b.time.now_ns + second);
    const std::uint8_t begun[] = { 145 };
    bool always_right = true;
    for (int round = 0; round < 20; ++round) {
        b.wire.receive(begun, sizeof begun); // the rest of this command is lost
        b.drive(0.145, 0, second / 30);
        b.drive(0.145, 0, second / 30);
        always_right = always_right && b.wire.right_mm_s() == 145 && b.wire.left_mm_s() == 145;
    }
    check(always_right, "create: the command after an incomplete one is understood");
}

static void lights_and_tones()
{
    frob_create_output output{};
    std::uint8_t leds[] = { 139, 2, 255, 128 };
    std::uint8_t note[] = { 140, 0, 1, 69, 32, 141, 0 };
    std::uint8_t bytes[16];
    output.spotLight = true;
    output.powerColour = 7;
    output.powerLight = 0.5;
    check(frob_create_lights(&output, bytes) == 4 && std::memcmp(bytes, leds, 4) == 0,
          "create: lights");
    output.powerColour = NAN;
    frob_create_lights(&output, bytes);
    check(bytes[2] == 0, "create: a colour that is no number is the first");
    output.tone.f0 = 440;
    output.tone.f1 = 0.5;
    check(frob_create_tone(&output, bytes) == 7 && std::memcmp(bytes, note, 7) == 0,
          "create: a tone");
    output.tone.f0 = -1;
    output.tone.f1 = NAN;
    check(frob_create_tone(&output, bytes) == 7 && bytes[3] == 31 && bytes[4] == 1,
          "create: tones out of range are brought into it");
}

static void counts_out_of_reach_are_refused()
{
    frob_create_odometry o{};
    std::int64_t now_ns = second;
    bool taken = frob_create_odometry_add(&o, 65500, 100, now_ns, 0.235);
    for (int i = 1; i <= 100; ++i) {
        now_ns += 15 * ms;
        taken = taken &&
                frob_create_odometry_add(&o, static_cast<std::uint16_t>(65500 + 10 * i),
                                         static_cast<std::uint16_t>(100 + 10 * i), now_ns, 0.235);
    }
    check(taken, "create: counts that wrap are taken");
    check_near(o.x_m, 1000 * FROB_CREATE_METRES_PER_COUNT, 1e-9,
               "create: a thousand counts are 0.44 m");
    check_near(o.left_m_s, 10 * FROB_CREATE_METRES_PER_COUNT / 0.015, 0.01,
               "create: speed from counts");
    const double before = o.x_m;
    check(!frob_create_odometry_add(&o, 30000, 1100, now_ns + 15 * ms, 0.235) && o.x_m == before,
          "create: counts out of reach are refused");
    check(frob_create_odometry_add(&o, 974, 1110, now_ns + 30 * ms, 0.235) && o.x_m > before,
          "create: and the next good ones are taken");
    const double there = o.x_m;
    for (int i = 1; i <= 5; ++i)
        taken = frob_create_odometry_add(&o, 0, static_cast<std::uint16_t>(20000 + i),
                                         now_ns + 100 * ms, 0.235);
    check(taken && std::fabs(o.x_m - there) < 0.01,
          "create: a robot that counts anew keeps its place");
}

static void keeps_its_place_when_connected_again()
{
    CreateBench b;
    b.start();
    b.run(b.time.now_ns + second);
    b.drive(0.3, 0, 2 * second);
    const double before = b.input.odometry.position.x;
    b.start();
    b.run(b.time.now_ns + second);
    frob_robot_sense(&b.robot, &b.input);
    check_near(b.input.odometry.position.x, before, 0.02,
               "create: a new connection keeps the place");
    check(b.wire.left_mm_s() == 0, "create: and begins at rest");
}

// A line that delays the robot's bytes.
struct Delayed : NoFaults {
    std::int64_t delay_ns(std::int64_t) { return 120 * ms; }
};

// After a session was killed, the robot still streams frames of mode Safe. On a slow line they
// arrive when the next session already waits for that mode, and frames of mode Passive follow.
static void frames_of_an_earlier_session_are_no_fault()
{
    Bench<CreateKind, Delayed> b;
    b.start();
    b.run(b.time.now_ns + second);
    b.drive(0.3, 0, second);
    for (int phase = 0; phase < 15; ++phase) {
        b.run(b.time.now_ns + phase * ms);
        b.start();
        b.run(b.time.now_ns + second);
        check(b.state == FROB_ROBOT_READY, "create: frames of an earlier session are no fault");
        check(b.wire.left_mm_s() == 0, "create: and do not make it drive");
    }
    b.body.cliffs[1] = true;
    b.drive(0.3, 0, 300 * ms);
    check(b.state == FROB_ROBOT_FAILED && b.robot.status == FROB_REFUSED,
          "create: a cliff still is one");
}

int main()
{
    connects_and_drives();
    limits_wheels_together();
    turns_slowly<CreateKind>();
    senses();
    leaving_safe_mode_is_a_fault();
    does_not_drive_in_the_air();
    stops_when_frames_stay_away();
    a_lost_byte_is_felt_once();
    lights_and_tones();
    counts_out_of_reach_are_refused();
    keeps_its_place_when_connected_again();
    frames_of_an_earlier_session_are_no_fault();
    return check_status();
}
