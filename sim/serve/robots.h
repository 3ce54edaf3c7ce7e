// The kinds of robots that frob-serve can simulate.
#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "firmware.h"
#include "sim.h"

namespace frob::serve {

// The usual rate of the robot's line, in bits per second; 0 if there is no such robot.
std::uint32_t usual_rate(const std::string &robot);

// Creates the firmware of a robot, connected to its simulated body, which must outlive the
// firmware. `model` is for Pioneers only. Returns null if there is no such robot or model.
std::unique_ptr<Firmware> make_firmware(const std::string &robot, const std::string &model,
                                        std::uint32_t rate, frob_sim *sim);

} // namespace frob::serve
