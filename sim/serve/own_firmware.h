// The firmware of a user-defined robot. It connects the board (<frob/board.h>) to the simulated
// body (<frob/body.h>), both of which the user's C code describes.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <frob/board.h>
#include <frob/body.h>

#include "firmware.h"
#include "sim.h"

namespace frob::serve {

struct OwnRobot {
    const frob_body *body = nullptr;
    const frob_board *board = nullptr;
};

// Loads the descriptions of the robot from a shared object that was compiled from the user's C
// files. The object stays loaded. Throws WrongUse if a part is missing.
OwnRobot load_own_robot(const std::string &object, const std::string &robot);

class OwnFirmware : public Firmware {
  public:
    // The caller owns the simulation, and must not use it while this object exists.
    OwnFirmware(const frob_board &board, frob_sim *sim, std::uint32_t rate);

    void advance(std::int64_t time_ns) override;
    void receive(std::uint8_t byte) override;
    std::int64_t next_ns() const override { return next_ns_; }
    std::uint32_t rate() const override { return rate_; }

  private:
    static constexpr std::int64_t period_ns = 5'000'000; // interval between reads of the body

    void look(std::int64_t time_ns);
    void pass_on(const frob_answer &answer);

    const frob_board &board_;
    frob_sim *sim_;
    std::uint32_t rate_;
    std::int64_t now_ns_ = 0, next_ns_ = period_ns;
    // The buffers consist of 64-bit words, so that they are aligned for any struct of the board.
    std::vector<std::uint64_t> memory_, input_, output_;
};

} // namespace frob::serve
