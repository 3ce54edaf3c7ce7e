// The firmware of a Pioneer (P2OS to ARCOS) on the simulated robot: the
// handshake, the commands that move it, its information packets, and its
// watchdog, which stops the robot when no packet has come for two seconds and
// takes up the old speeds again when one comes.
#pragma once

#include <array>
#include <cstdint>
#include <string>

#include <frob/pioneer.h>

#include "firmware.h"
#include "p2os_packet.h"
#include "pioneer_motion.h"
#include "sim.h"

namespace frob::serve
{

// What a model's counters count, as its parameter file has it.
struct PioneerModel {
    const char *subclass;
    double distance_mm; // one unit of XPOS and YPOS
    double range_mm;    // one unit of a sonar's range
};

class PioneerFirmware : public Firmware
{
  public:
    // The simulation is the caller's, and nobody else's while this is used.
    PioneerFirmware(frob_sim *sim, const PioneerModel &model, std::uint32_t rate);

    // The model of that subclass; null if it is not simulated.
    static const PioneerModel *find_model(const std::string &subclass);

    void advance(std::int64_t time_ns) override;
    void receive(std::uint8_t byte) override;
    void forget() override { reader_.forget(); }
    std::int64_t next_ns() const override;
    std::uint32_t rate() const override { return rate_; }

    bool in_session() const { return session_; }
    bool watchdog_tripped() const { return tripped_; }

  private:
    void handshake(const P2osCommand &command);
    void obey(const P2osCommand &command);
    void close_session();
    void drive();
    void look();
    void listen();
    void send_sip();
    void send_config();
    void send_encoders();
    void send_io();
    bool has_room() const;
    double heading() const; // since SETO

    // A packet that is sent once, with each SIP, or not, as its command says.
    enum class Asked { no, once, stream };
    static Asked asked(int n) { return n <= 0 ? Asked::no : n == 1 ? Asked::once : Asked::stream; }

    frob_sim *sim_;
    PioneerModel model_;
    std::uint32_t first_rate_, rate_;
    P2osReader reader_;
    std::int64_t now_ns_ = 0;
    frob_pioneer_input sensed_{};

    bool session_ = false, open_ = false;
    int expected_sync_ = 0;
    std::int64_t handshake_ns_ = 0;
    std::int64_t heard_ns_ = 0; // the last packet
    std::int64_t sip_ns_ = 0;   // when the next SIP is due
    std::int64_t servo_ns_ = 0; // when the motors are looked after next
    bool tripped_ = false;

    bool motors_ = false, sonar_on_ = true;
    PioneerMotion motion_;
    double left_m_ = 0.0, right_m_ = 0.0; // the wheels' ways, by the encoders
    Asked encoders_ = Asked::no, io_ = Asked::no;
    int digital_out_ = 0;
    double origin_x_ = 0.0, origin_y_ = 0.0, origin_heading_ = 0.0;

    struct Echo {
        bool fresh = false; // to be in the next SIP
        double range_m = 5.0;
        std::int64_t at_ns = 0; // when the transducer last had a result
    };
    std::array<Echo, 16> echoes_{};
};

} // namespace frob::serve
