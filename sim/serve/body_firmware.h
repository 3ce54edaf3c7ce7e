// The firmware of robots whose protocol is in sim/wire. It connects the robot's end of the line to
// the simulated body, which it reads every 5 ms.
#pragma once

#include <algorithm>
#include <cstdint>

#include "firmware.h"
#include "sim.h"

namespace frob::serve {

// `Wire` is the robot's end of its serial line, and `Input` is the input struct of the body.
template <class Wire, class Input>
class BodyFirmware : public Firmware {
  public:
    // The caller owns the simulation, and must not use it while this object exists.
    BodyFirmware(frob_sim *sim, std::uint32_t rate) : sim_(sim), rate_(rate) {
        wire_.log = [this](const std::string &text) { log(now_ns_, text); };
        look(0);
    }

    void advance(std::int64_t time_ns) override {
        for (; next_ns_ <= time_ns; next_ns_ += period_ns) look(next_ns_);
        now_ns_ = std::max(now_ns_, time_ns);
    }

    void receive(std::uint8_t byte) override {
        wire_.advance(now_ns_);
        wire_.receive(&byte, 1);
        pass_on();
    }

    void forget() override { wire_.forget(); }
    std::int64_t next_ns() const override { return next_ns_; }
    std::uint32_t rate() const override { return rate_; }

    const Wire &wire() const { return wire_; }

  private:
    static constexpr std::int64_t period_ns = 5'000'000;

    void look(std::int64_t time_ns) {
        Input input{};
        now_ns_ = time_ns;
        frob_sim_advance(sim_, time_ns);
        frob_sim_read(sim_, &input);
        wire_.sense(input, time_ns);
        wire_.advance(time_ns);
        pass_on();
    }

    // Passes the robot's current command to the body, and the robot's bytes to the client.
    void pass_on() {
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
