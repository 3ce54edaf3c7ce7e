// Runs the Rover of examples/own_robot in the benches of tests/robots/wire and tests/robots/faults:
// its board, which `frobc serve` runs, behind an in-memory line.
#pragma once

#include <cstdint>
#include <vector>

#include <frob/board.h>

#include "bench.h"
#include "rover.h"
#include "rover_driver.h"

extern "C" const frob_board frob_rover_board;

class RoverWire
{
  public:
    RoverWire() : memory_(frob_rover_board.size / sizeof(std::uint64_t) + 1) {}

    void receive(const std::uint8_t *bytes, std::size_t count)
    {
        for (std::size_t i = 0; i < count; ++i)
            collect(
                [&](frob_answer &answer) { frob_rover_board.receive(board(), bytes[i], &answer); });
    }
    void sense(const frob_rover_input &body, std::int64_t now_ns)
    {
        frob_rover_board.sense(board(), &body, now_ns);
    }
    void advance(std::int64_t now_ns)
    {
        collect([&](frob_answer &answer) { frob_rover_board.advance(board(), now_ns, &answer); });
    }
    frob_rover_output output() const
    {
        frob_rover_output output{};
        frob_rover_board.drive(memory_.data(), &output);
        return output;
    }

    std::vector<std::uint8_t> to_client;

  private:
    void *board() { return memory_.data(); }
    template <class Call>
    void collect(Call call)
    {
        frob_answer answer{};
        call(answer);
        to_client.insert(to_client.end(), answer.bytes, answer.bytes + answer.count);
    }

    std::vector<std::uint64_t> memory_;
};

struct RoverKind {
    using Wire = RoverWire;
    using Input = frob_rover_input;
    using Output = frob_rover_output;
    using Device = rover;
    static const frob_driver &driver() { return frob_rover_driver; }
    static constexpr double separation_m = 0.19;
};
