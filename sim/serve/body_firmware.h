// The firmware of a robot whose protocol is in sim/wire: its line's end in front
// of the simulated body, which is looked at every 5 ms.
#pragma once

#include <algorithm>
#include <cstdint>

#include "firmware.h"
#include "sim.h"

namespace frob::serve
{

// `Wire` is a robot's end of its line; `Input` is what the body senses.
template <class Wire, class Input>
class BodyFirmware : public Firmware
{
  public:
    // The simulation is the caller's, and nobody else's while this is used.
    BodyFirmware(frob_sim *sim, std::uint32_t rate) : sim_(sim), rate_(rate)
    {
        wire_.log = [this](const std::string &text) { log(now_ns_, text); };
        look(0);
    }

    void advance(std::int64_t time_ns) override
    {
        for (; next_ns_ <= time_ns; next_ns_ += period_ns)
            look(next_ns_);
        now_ns_ = std::max(now_ns_, time_ns);
    }

    void receive(std::uint8_t byte) override
    {
        wire_.receive(&byte, 1);
        pass_on();
    }

    void forget() override { wire_.forget(); }
    std::int64_t next_ns() const override { return next_ns_; }
    std::uint32_t rate() const override { return rate_; }

    const Wire &wire() const { return wire_; }

  private:
    static constexpr std::int64_t period_ns = 5'000'000;

    void look(std::int64_t time_ns)
    {
        Input input{};
        now_ns_ = time_ns;
        frob_sim_advance(sim_, time_ns);
        frob_sim_read(sim_, &input);
        wire_.sense(input, time_ns);
        wire_.advance(time_ns);
        pass_on();
    }

    // The wheels turn and the bytes go as the robot wants it now.
    void pass_on()
    {
        const auto output = wire_.output();
        frob_sim_command(sim_, now_ns_, &output);
        send(wire_.to_client);
        wire_.to_client.clear();
    }

    frob_sim *sim_;
    std::uint32_t rate_;
    std::int64_t now_ns_ = 0, next_ns_ = period_ns;
    Wire wire_;
};

} // namespace frob::serve
