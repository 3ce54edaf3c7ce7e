// Runs the Pioneer in the bench: the firmware of `frobc serve`, with a body of the bench instead of
// the simulator's.
#pragma once

#include <cstdint>
#include <vector>

#include "drivers/pioneer/pioneer.h"
#include "p2os_packet.h"
#include "pioneer_firmware.h"
#include "sim.h"

// The part of the simulator's C interface that the firmware uses.
struct frob_sim {
    frob_pioneer_input body{};
    frob_pioneer_output output{};
};

class PioneerWire
{
  public:
    PioneerWire() : firmware_(&sim_, *frob::serve::PioneerFirmware::find_model("p3dx-sh"), 38400) {}

    void receive(const std::uint8_t *bytes, std::size_t count)
    {
        for (std::size_t i = 0; i < count; ++i) {
            firmware_.receive(bytes[i]);
            if (const auto command = reader_.take(bytes[i])) {
                if (command->number == close)
                    limited_ = false;
                for (const std::uint8_t limit : limits)
                    limited_ = limited_ || command->number == limit;
            }
        }
        collect();
    }
    void sense(const frob_pioneer_input &body, std::int64_t) { sim_.body = body; }
    void advance(std::int64_t now_ns)
    {
        firmware_.advance(now_ns);
        collect();
    }
    frob_pioneer_output output() const { return sim_.output; }

    // Whether a damaged command with a valid checksum has limited the speed or acceleration. The
    // driver sets no limits; one lasts until the session ends.
    bool limited() const { return limited_; }

    std::vector<std::uint8_t> to_client;

  private:
    static constexpr std::uint8_t close = 2,
                                  limits[] = { 5, 6, 10, 23 }; // SETA, SETV, SETRV, SETRA

    void collect()
    {
        const std::vector<std::uint8_t> sent = firmware_.take_output();
        to_client.insert(to_client.end(), sent.begin(), sent.end());
    }

    frob_sim sim_;
    frob::serve::PioneerFirmware firmware_;
    frob::serve::P2osReader reader_; // the same reader that the firmware uses
    bool limited_ = false;
};

struct PioneerKind {
    using Wire = PioneerWire;
    using Input = frob_pioneer_input;
    using Output = frob_pioneer_output;
    using Device = frob_pioneer;
    static const frob_driver &driver() { return frob_pioneer_driver; }
    static constexpr double separation_m = 2.0 / 5.6;
};
