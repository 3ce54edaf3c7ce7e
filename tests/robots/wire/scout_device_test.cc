// Tests the Scout's driver against the simulated robot's end of the line.
#include "bench.h"
#include "slow.h"
#include "check.h"

using ScoutBench = Bench<ScoutKind>;

static void connects_and_drives()
{
    ScoutBench b;
    b.body.battery = 12.5;
    b.start();
    b.run(b.time.now_ns + second);
    check(b.state == FROB_ROBOT_READY && b.robot.connections == 1, "scout: connects");
    b.drive(0.5, 0, 2 * second);
    check(b.wire.left() == 197 && b.wire.right() == 197, "scout: half a metre a second");
    check_near(b.input.odometry.position.x, b.body.odometry.position.x, 0.06,
               "scout: odometry ahead");
    check_near(b.input.leftWheel, 0.5, 0.03, "scout: measured speed");
    b.drive(0, 1, second);
    check_near(b.input.leftWheel, -0.1726, 0.02, "scout: left wheel back in a turn to the left");
    check_near(b.input.odometry.heading, 0.97, 0.1, "scout: heading");
    check_near(b.input.battery, 12.5, 0.02, "scout: battery");
    frob_robot_close(&b.robot);
    b.act();
    check(b.wire.left() == 0 && b.wire.right() == 0, "scout: rests after the session");
}

// The first two CONF_TM commands to the robot lose a byte.
struct LosesWatchdog : NoFaults {
    void pass(std::uint8_t byte, std::vector<std::uint8_t> &out)
    {
        const std::size_t n = out.size();
        const bool is_type = n >= 3 && out[n - 3] == 1 && out[n - 2] == 3 && out[n - 1] == 0;
        if (!(is_type && byte == FROB_SCOUT_CONF_TM && lost++ < 2))
            out.push_back(byte);
    }
    int lost = 0;
};

static void is_not_connected_before_its_watchdog_is_set()
{
    Bench<ScoutKind, LosesWatchdog> b;
    int watchdogs = 0;
    b.wire.log = [&](const std::string &text) { watchdogs += text == "CONF_TM 1"; };
    b.start();
    for (int i = 0; i < 40; ++i) { // a host that commands a stop all the time
        frob_robot_halt(&b.robot);
        b.run(b.time.now_ns + 17 * ms);
    }
    b.run(b.time.now_ns + second);
    check(b.state == FROB_ROBOT_READY && b.to_robot.lost > 2 && watchdogs >= 1,
          "scout: stops between the steps of connecting leave none of them out");
}

static void limits_wheels_together()
{
    ScoutBench b;
    b.start();
    b.run(b.time.now_ns + second);
    b.drive(1, 5, 500 * ms);
    check(b.wire.right() == 393 && b.wire.left() == 29,
          "scout: too fast a wheel slows both, and the curve stays");
    b.settings[FROB_SCOUT_LEFT_FIRST] = 1;
    b.drive(0, 1, 500 * ms);
    check(b.wire.right() == -68 && b.wire.left() == 68,
          "scout: the order of the axes is a setting");
}

static void senses()
{
    ScoutBench b;
    int echoes = 0, others = 0;
    double distance = 0;
    b.start();
    b.run(b.time.now_ns + second);
    b.body.bumpers[2] = true;
    b.body.emergencyStop = true;
    b.body.charging = true;
    b.drive(0, 0, second / 10);
    check(b.input.bumpers[2] && !b.input.bumpers[0] && b.input.emergencyStop && b.input.charging,
          "scout: bumpers, stop button, charger");
    for (int round = 0; round < 96; ++round) {
        b.body.sonar[3].tag = FROB_EVENT_FLOAT_EVENT;
        b.body.sonar[3].f0 = 1.0;
        b.drive(0, 0, second / 30);
        echoes += b.input.sonar[3].tag == FROB_EVENT_FLOAT_EVENT;
        others += b.input.sonar[4].tag == FROB_EVENT_FLOAT_EVENT;
        if (b.input.sonar[3].tag == FROB_EVENT_FLOAT_EVENT)
            distance = b.input.sonar[3].f0;
    }
    check_near(distance, 1.0, 0.0127, "scout: an echo's distance, to the inch");
    // 3.2 s are five rounds of 640 ms.
    check(echoes >= 4 && echoes <= 6 && others == 0,
          "scout: an echo that stays is new once a round");
}

static void stops_when_states_stay_away()
{
    ScoutBench b;
    b.start();
    b.run(b.time.now_ns + second);
    b.drive(0.5, 0, second);
    b.cut = true; // towards the driver only; the robot still hears
    b.drive(0.5, 0, 350 * ms);
    check(b.state == FROB_ROBOT_STALE && b.wire.left() == 0, "scout: stale states stop the robot");
    b.cut = false;
    b.drive(0.5, 0, second);
    check(b.state == FROB_ROBOT_READY && b.wire.left() == 197,
          "scout: and driving goes on after them");
    b.cut = true;
    b.run(b.time.now_ns + 2 * second);
    check(b.state == FROB_ROBOT_FAILED && b.robot.status == FROB_TIMEOUT,
          "scout: a silent robot is lost");
}

static void watchdog_ends_what_is_forgotten()
{
    ScoutBench b;
    b.start();
    b.run(b.time.now_ns + second);
    b.drive(0.5, 0, second);
    // The host polls but sends no more commands.
    b.run(b.time.now_ns + 3 * second);
    check(b.wire.left() == 0, "scout: the robot's watchdog ends a motion that the host forgot");
}

static void places_out_of_reach_are_refused()
{
    frob_scout_odometry o{};
    frob_scout_state state{};
    std::int64_t now_ns = second;
    bool taken = true;
    state.heading = 900; // the axes of the robot's counters are rotated by a quarter turn
    for (int i = 0; i <= 50; ++i, now_ns += 50 * ms) {
        state.y = (32760 + 10 * i) & 0x7FFF; // 200 a second, past the counter's wraparound
        taken = taken && frob_scout_odometry_add(&o, &state, now_ns);
    }
    check(taken, "scout: places that wrap are taken");
    check_near(o.place.x_m, 500 * 0.00254, 1e-9, "scout: ahead, whatever the counters' axes are");
    check_near(o.place.y_m, 0, 1e-9, "scout: and nothing aside");
    check_near(o.forward_m_s, 200 * 0.00254, 0.02, "scout: speed from places");
    frob_scout_state damaged = state;
    damaged.x = 5000;
    check(!frob_scout_odometry_add(&o, &damaged, now_ns), "scout: places out of reach are refused");
    check(frob_scout_odometry_add(&o, &state, now_ns + 50 * ms),
          "scout: and the next good one is taken");
    for (int i = 1; i <= 5; ++i)
        taken = frob_scout_odometry_add(&o, &damaged, now_ns + 100 * ms);
    check(taken, "scout: a robot that counts anew is believed in the end");
    check_near(o.place.x_m, 500 * 0.00254, 1e-9, "scout: and keeps its place");
}

static void keeps_its_place_when_connected_again()
{
    ScoutBench b;
    b.body.odometry.heading = b.true_heading = 2.0;
    b.start();
    b.run(b.time.now_ns + second);
    b.drive(0.5, 0, 2 * second);
    const double before = b.input.odometry.position.x;
    b.start();
    b.run(b.time.now_ns + second);
    frob_robot_sense(&b.robot, &b.input);
    check_near(before, 1.0, 0.06, "scout: the place is counted from where the robot was first");
    check_near(b.input.odometry.position.x, before, 0.1, "scout: a new connection keeps the place");
    check(b.wire.left() == 0, "scout: and begins at rest");
}

int main()
{
    connects_and_drives();
    is_not_connected_before_its_watchdog_is_set();
    limits_wheels_together();
    turns_slowly<ScoutKind>();
    senses();
    stops_when_states_stay_away();
    watchdog_ends_what_is_forgotten();
    places_out_of_reach_are_refused();
    keeps_its_place_when_connected_again();
    return check_status();
}
