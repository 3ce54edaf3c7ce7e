// The firmware of a robot of the user's own: the board that a C file of theirs
// describes (<frob/board.h>), in front of the simulated body that another describes
// (<frob/body.h>).
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <frob/board.h>
#include <frob/body.h>

#include "firmware.h"
#include "sim.h"

namespace frob::serve
{

struct OwnRobot {
    const frob_body *body = nullptr;
    const frob_board *board = nullptr;
};

// What the user's C files, compiled to this shared object, say of the robot. Throws
// WrongUse if a part is missing. They stay loaded.
OwnRobot load_own_robot(const std::string &object, const std::string &robot);

class OwnFirmware : public Firmware
{
  public:
    // The simulation is the caller's, and nobody else's while this is used.
    OwnFirmware(const frob_board &board, frob_sim *sim, std::uint32_t rate);

    void advance(std::int64_t time_ns) override;
    void receive(std::uint8_t byte) override;
    std::int64_t next_ns() const override { return next_ns_; }
    std::uint32_t rate() const override { return rate_; }

  private:
    static constexpr std::int64_t period_ns = 5'000'000; // between two looks at the body

    void look(std::int64_t time_ns);
    void pass_on(const frob_answer &answer);

    const frob_board &board_;
    frob_sim *sim_;
    std::uint32_t rate_;
    std::int64_t now_ns_ = 0, next_ns_ = period_ns;
    // In words, so that it is aligned for anything that a board keeps.
    std::vector<std::uint64_t> memory_, input_, output_;
};

} // namespace frob::serve
