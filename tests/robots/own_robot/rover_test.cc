// Tests the Rover's driver against its board.
#include "check.h"
#include "rover_kind.h"

using RoverBench = Bench<RoverKind>;

static void connects_and_drives()
{
    RoverBench b;
    b.body.battery = 12.0;
    b.start();
    b.run(b.time.now_ns + second);
    check(b.state == FROB_ROBOT_READY && b.robot.connections == 1, "connects");
    b.drive(0.3, 0, 2 * second);
    check_near(b.wire.output().forward, 0.3, 1e-9, "80 counts in a loop are 0.3 m/s");
    check_near(b.input.odometry.position.x, b.body.odometry.position.x, 0.02, "odometry ahead");
    check_near(b.input.leftWheel, 0.3, 0.02, "measured speed");
    b.drive(0, 1, second);
    check_near(b.input.leftWheel, -0.095, 0.01, "left wheel back in a turn to the left");
    check_near(b.input.odometry.heading, b.true_heading, 0.06, "heading");
    check_near(b.input.battery, 12.0, 0.02, "battery");
    frob_robot_close(&b.robot);
    b.act();
    check_near(b.wire.output().forward, 0, 0, "rests after the session");
}

static void limits_wheels_together()
{
    RoverBench b;
    b.start();
    b.run(b.time.now_ns + second);
    b.drive(0.5, 4, 500 * ms);
    const auto output = b.wire.output();
    check_near(output.forward + 0.5 * 0.19 * output.turn, 0.5, 0.004,
               "the faster wheel at its most");
    check_near(output.turn / output.forward, 8, 0.2,
               "too fast a wheel slows both, and the curve stays");
}

static void hears_echoes_once()
{
    RoverBench b;
    int echoes = 0, others = 0;
    double distance = 0;
    b.start();
    b.run(b.time.now_ns + second);
    for (int i = 0; i < 60; ++i) {
        b.body.sonar[3].tag = FROB_EVENT_FLOAT_EVENT;
        b.body.sonar[3].f0 = 1.234;
        b.drive(0, 0, second / 30);
        others += b.input.sonar[2].tag == FROB_EVENT_FLOAT_EVENT;
        if (b.input.sonar[3].tag != FROB_EVENT_FLOAT_EVENT)
            continue;
        ++echoes;
        distance = b.input.sonar[3].f0;
    }
    check_near(distance, 1.23, 1e-9, "an echo, to the centimetre");
    // In 2 s; a round of five rangers takes 0.15 to 0.25 s.
    check(echoes >= 8 && echoes <= 14 && others == 0, "an echo is an event, once a round");
}

static void stops_when_answers_stay_away()
{
    RoverBench b;
    b.start();
    b.run(b.time.now_ns + second);
    b.drive(0.3, 0, second);
    b.cut = true; // towards the driver only; the robot still hears
    b.drive(0.3, 0, 400 * ms);
    check(b.state == FROB_ROBOT_STALE && b.wire.output().forward == 0,
          "stale readings stop the robot");
    b.cut = false;
    b.drive(0.3, 0, second);
    check(b.state == FROB_ROBOT_READY && b.wire.output().forward > 0.29,
          "and driving goes on after them");
    b.cut = true;
    b.run(b.time.now_ns + 2 * second);
    check(b.state == FROB_ROBOT_FAILED && b.robot.status == FROB_TIMEOUT, "a silent robot is lost");
}

static void watchdog_ends_what_is_forgotten()
{
    RoverBench b;
    b.start();
    b.run(b.time.now_ns + second);
    b.drive(0.3, 0, second);
    b.run(b.time.now_ns + 400 * ms);
    check(b.wire.output().forward > 0, "a speed holds for a while");
    b.run(b.time.now_ns + 300 * ms); // the host polls but sends no more commands
    check(b.wire.output().forward == 0 && b.state == FROB_ROBOT_READY,
          "the watchdog ends a motion that the host forgot, though the robot is asked");
}

// The board sometimes sends an answer that nothing asked for.
struct MakesUpAnswers : NoFaults {
    void begin(std::int64_t room, std::vector<std::uint8_t> &out)
    {
        if (room < 4 || ++turn % 40 != 0)
            return;
        out.insert(out.end(), { 'O', 'K', '\r', '\n' });
        ++made;
    }
    int turn = 0, made = 0;
};

static void answers_are_not_taken_for_others()
{
    Bench<RoverKind, MakesUpAnswers> b;
    bool wrong = false;
    int echoes = 0;
    b.body.battery = 12.0;
    b.start();
    b.run(b.time.now_ns + second);
    for (int i = 0; i < 300; ++i) {
        b.body.sonar[3].tag = FROB_EVENT_FLOAT_EVENT;
        b.body.sonar[3].f0 = 1.0;
        b.drive(0.1, 0, second / 30);
        wrong = wrong || std::fabs(b.input.battery - 12.0) > 0.02;
        for (std::size_t k = 0; k < 5; ++k) {
            if (b.input.sonar[k].tag != FROB_EVENT_FLOAT_EVENT)
                continue;
            wrong = wrong || k != 3;
            ++echoes;
        }
    }
    check(b.to_driver.made > 20 && echoes > 20, "answers are made up");
    check(b.state == FROB_ROBOT_READY && !wrong,
          "an answer too many does not shift those that follow");
}

static void counts_out_of_reach_are_refused()
{
    rover_odometry o{};
    std::int64_t now_ns = second;
    bool taken = true;
    for (int i = 0; i <= 50; ++i, now_ns += 50 * ms) { // past the counter's wraparound
        const auto left = static_cast<std::int32_t>(static_cast<std::uint32_t>(INT32_MAX - 2000) +
                                                    static_cast<std::uint32_t>(100 * i));
        taken = taken && rover_odometry_add(&o, left, left, 8000, 0.19, now_ns);
    }
    check(taken, "counts that wrap are taken");
    check_near(o.x_m, 5000.0 / 8000, 1e-9, "and are a way ahead");
    check_near(o.left_m_s, 0.25, 1e-9, "speed from counts");
    const rover_odometry before = o;
    check(!rover_odometry_add(&o, o.left + 90000, o.right, 8000, 0.19, now_ns),
          "a leap is refused");
    check(rover_odometry_add(&o, before.left, before.right, 8000, 0.19, now_ns),
          "and the next is taken");
    for (int i = 0; i < 4; ++i)
        taken = rover_odometry_add(&o, 0, 0, 8000, 0.19, now_ns += 50 * ms);
    check(taken, "a board that counts anew is believed in the end");
    check_near(o.x_m, before.x_m, 1e-9, "and the robot keeps its place");
}

static void keeps_its_place_when_connected_again()
{
    RoverBench b;
    b.start();
    b.run(b.time.now_ns + second);
    b.drive(0.3, 0, 2 * second);
    const double before = b.input.odometry.position.x;
    b.start();
    b.run(b.time.now_ns + second);
    frob_robot_sense(&b.robot, &b.input);
    check_near(b.input.odometry.position.x, before, 0.03, "a new connection keeps the place");
    check(b.wire.output().forward == 0, "and begins at rest");
}

int main()
{
    connects_and_drives();
    limits_wheels_together();
    hears_echoes_once();
    stops_when_answers_stay_away();
    watchdog_ends_what_is_forgotten();
    answers_are_not_taken_for_others();
    counts_out_of_reach_are_refused();
    keeps_its_place_when_connected_again();
    return check_status();
}
