// Tests speeds below the resolution of the robot's protocol.
#pragma once

#include <cmath>
#include <string>

#include "bench.h"
#include "check.h"

// Turns at 0.008 rad/s, half a degree per second, which no protocol can send in one command.
template <class Kind>
void turns_slowly()
{
    const std::string robot = std::string(Kind::driver().robot) + ": ";
    Bench<Kind> b;
    b.start();
    b.run(b.time.now_ns + second);
    const double before = b.true_heading;
    b.drive(0, 0.008, 8 * second);
    check_near(b.true_heading - before, 0.064, 0.001,
               (robot + "a slow turn is as far as it should be").c_str());
    b.drive(0, 0, second / 10);
    bool moves = false;
    b.acted = [&] {
        moves = moves || b.wire.output().turn != 0.0 || b.wire.output().forward != 0.0;
    };
    b.drive(0, 0, second);
    check(!moves, (robot + "what is owed does not move a robot that is told to stand").c_str());
    b.acted = nullptr;
    b.drive(0.0004, 0.004, 7 * second / 30);
    frob_robot_halt(&b.robot);
    b.run(b.time.now_ns + second / 10);
    b.acted = [&] {
        moves = moves || b.wire.output().turn != 0.0 || b.wire.output().forward != 0.0;
    };
    b.run(b.time.now_ns + second);
    check(!moves, (robot + "nor one that was stopped").c_str());
}
