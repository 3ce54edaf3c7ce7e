// Helpers that command a simulated Pioneer directly.
#pragma once

#include <frob/pioneer.h>

#include "simulation.h"

inline frob_pioneer_output drive(double forward, double turn)
{
    frob_pioneer_output output{};
    output.forward = forward;
    output.turn = turn;
    return output;
}

inline void command(frob::sim::Simulation &simulation, std::int64_t time_ns,
                    const frob_pioneer_output &output)
{
    simulation.command(time_ns, &output);
}

inline frob_pioneer_input read(frob::sim::Simulation &simulation)
{
    frob_pioneer_input input;
    simulation.read(&input);
    return input;
}
