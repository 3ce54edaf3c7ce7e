// The firmware of a Pioneer (P2OS to ARCOS) on the simulated robot: the handshake, the motion
// commands, the server information packets (SIPs), and the watchdog. The watchdog stops the robot
// when no packet has arrived for two seconds; the robot resumes its previous speeds when the next
// packet arrives.
#pragma once

#include <array>
#include <cstdint>
#include <string>

#include <frob/pioneer.h>

#include "firmware.h"
#include "p2os_packet.h"
#include "pioneer_motion.h"
#include "sim.h"

namespace frob::serve {

// The units of a model's measurements, from its parameter file.
struct PioneerModel {
    const char *subclass;
    double distance_mm; // one unit of XPOS and YPOS
    double range_mm;    // one unit of a sonar's range
};

class PioneerFirmware : public Firmware {
  public:
    // The caller owns the simulation, and must not use it while this object exists.
    PioneerFirmware(frob_sim *sim, const PioneerModel &model, std::uint32_t rate);

    // The model of this subclass; nullptr if it is not simulated.
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
    double heading() const; // in rad, relative to the heading at the last SETO

    // Whether a packet that the client can request is never sent, sent once, or sent with each SIP.
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
    std::int64_t heard_ns_ = 0; // time of the last packet
    std::int64_t sip_ns_ = 0;   // time of the next SIP
    std::int64_t servo_ns_ = 0; // time of the next motor update
    bool tripped_ = false;

    bool motors_ = false, sonar_on_ = true;
    PioneerMotion motion_;
    double left_m_ = 0.0, right_m_ = 0.0; // distances that the wheels have travelled
    Asked encoders_ = Asked::no, io_ = Asked::no;
    int digital_out_ = 0;
    double origin_x_ = 0.0, origin_y_ = 0.0, origin_heading_ = 0.0;

    struct Echo {
        bool fresh = false; // not yet reported in a SIP
        double range_m = 5.0;
        std::int64_t at_ns = 0; // time of the transducer's last result
    };
    std::array<Echo, 16> echoes_{};
};

} // namespace frob::serve
