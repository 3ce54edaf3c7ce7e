// Tests the simulated Pioneer's firmware with the bytes that real clients send, and with the
// driver, in virtual time.
#include "../sim/check.h"

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "core/robot.h"
#include "drivers/pioneer/pioneer.h"
#include "hal/fake/fake.h"
#include "serve/paced_line.h"
#include "serve/pioneer_firmware.h"

using namespace frob::serve;

namespace
{

constexpr std::int64_t ms = 1'000'000;

struct Closer {
    void operator()(frob_sim *sim) const { frob_sim_close(sim); }
};

std::unique_ptr<frob_sim, Closer> open_world()
{
    char message[1024];
    frob_sim_settings settings{};
    settings.seed = 1;
    settings.served = 1;
    std::unique_ptr<frob_sim, Closer> sim(
        frob_sim_open("hall.toml", &settings, message, sizeof message));
    if (!sim)
        std::printf("FAIL the world: %s\n", message);
    return sim;
}

double driven(const frob_sim *sim)
{
    return frob_sim_summarize(sim).distance_m;
}

// A client that sends bytes and stores the answers.
struct Client {
    std::unique_ptr<frob_sim, Closer> sim = open_world();
    PioneerFirmware firmware;
    std::int64_t now = 0;
    std::vector<Bytes> packets;

    explicit Client(const char *model = "p3dx")
        : firmware(sim.get(), *PioneerFirmware::find_model(model), 9600)
    {
    }

    void wait(std::int64_t time)
    {
        for (const std::int64_t end = now + time; now < end; now += 10 * ms) {
            firmware.advance(now);
            keep(firmware.take_output());
        }
    }

    // Like `wait`, but sends a PULSE twice a second for the watchdog.
    void live(std::int64_t time)
    {
        for (; time > 0; time -= 500 * ms) {
            send({ 0xFA, 0xFB, 3, 0, 0, 0 });
            wait(std::min(time, 500 * ms));
        }
    }

    void send(const Bytes &bytes)
    {
        firmware.advance(now);
        for (const std::uint8_t byte : bytes)
            firmware.receive(byte);
        keep(firmware.take_output());
    }

    void keep(const Bytes &bytes)
    {
        for (std::size_t i = 0; i + 3 < bytes.size(); i += bytes[i + 2] + 3u)
            packets.emplace_back(bytes.begin() + static_cast<long>(i),
                                 bytes.begin() + static_cast<long>(i) + bytes[i + 2] + 3);
    }

    void shake_hands()
    {
        send({ 0xFA, 0xFB, 3, 0, 0, 0 });
        send({ 0xFA, 0xFB, 3, 1, 0, 1 });
        send({ 0xFA, 0xFB, 3, 2, 0, 2 });
        send({ 0xFA, 0xFB, 3, 1, 0, 1 }); // OPEN
    }

    void command(std::uint8_t number, int argument)
    {
        const int magnitude = argument < 0 ? -argument : argument;
        send(P2osBody(number).u8(argument < 0 ? 0x1B : 0x3B).u16(magnitude).packet());
    }

    std::size_t count(std::uint8_t type) const
    {
        std::size_t n = 0;
        for (const Bytes &packet : packets)
            n += packet[3] == type ? 1 : 0;
        return n;
    }
};

void handshake()
{
    Client c;
    c.send({ 0x57, 0x4D, 0x53, 0x32, 0x0D }); // AriaCoda's bytes for a radio modem
    c.send({ 0xFA, 0xFB, 3, 0, 0, 0 });
    check::that(c.packets.size() == 1 && c.packets[0] == Bytes({ 0xFA, 0xFB, 3, 0, 0, 0 }),
                "junk before the handshake; SYNC0 is echoed");
    c.send({ 0xFA, 0xFB, 3, 2, 0, 2 });
    check::that(c.packets.size() == 1, "SYNC2 before SYNC1 has no answer");
    c.send({ 0xFA, 0xFB, 3, 1, 0, 1 });
    c.send({ 0xFA, 0xFB, 3, 2, 0, 2 });
    const std::string answer(c.packets.back().begin(), c.packets.back().end());
    check::that(answer.find(std::string("FrobSim\0Pioneer\0p3dx\0", 21)) == 4,
                "SYNC2 is answered with name, class and subclass");
    c.wait(500 * ms);
    check::that(c.count(0x32) == 0, "no SIPs before OPEN");
    c.send({ 0xFA, 0xFB, 6, 1, 0x3B, 1, 0, 2, 0x3B }); // OPEN 1, as AriaCoda sends it
    c.wait(1000 * ms);
    check::that(c.count(0x32) == 9 || c.count(0x32) == 10, "then ten a second");
    Client late;
    late.send({ 0xFA, 0xFB, 3, 0, 0, 0 });
    late.wait(11'000 * ms);
    late.send({ 0xFA, 0xFB, 3, 1, 0, 1 });
    check::that(late.packets.size() == 1, "a handshake is forgotten after ten seconds");
}

// Checks that the limits are where AriaCoda reads them in the packet, and that the packet is
// complete.
void config(const Client &c)
{
    Bytes body;
    for (const Bytes &packet : c.packets)
        if (packet[3] == 0x20)
            body.assign(packet.begin() + 4, packet.end() - 2);
    std::size_t at = 0;
    const auto texts = [&](int n) {
        while (n > 0 && at < body.size())
            n -= body[at++] == 0 ? 1 : 0;
    };
    const auto u16 = [&](std::size_t from) {
        return from + 1 < body.size() ? body[from] | body[from + 1] << 8 : -1;
    };
    texts(3); // type, subclass, serial number
    at += 11;
    texts(1); // name
    check::that(u16(at + 10) == 16570 && u16(at + 12) == 2000, "the config packet's watchdog");
    check::that(u16(at + 23) == 300 && u16(at + 25) == 750, "its greatest turn and speed");
    check::that(u16(at + 27) == 100 && u16(at + 37) == 300 && u16(at + 43) == 30,
                "its accelerations and gains");
    at += 47 + 6 + 4;
    check::that(u16(at) == 132, "its ticks per millimetre");
    at += 4;
    texts(1); // firmware
    check::that(body.size() == at + 21, "it is there to its last field");
}

void clients()
{
    Client c;
    c.shake_hands();
    for (int i = 0; i < 5; ++i) {
        c.command(18, 1);
        c.wait(210 * ms);
    }
    check::that(c.count(0x20) == 5, "each CONFIG is answered");
    config(c);
    c.command(4, 1);
    c.command(11, 200);
    c.wait(1500 * ms);
    const double before = driven(c.sim.get());
    check::that(before > 0.1, "VEL drives");
    c.send({ 0xFA, 0xFB, 4, 7, 0x3B, 0x07, 0x3B }); // Player's SETO has a type and no value
    c.wait(200 * ms);
    check::that((c.packets.back()[4] | c.packets.back()[5] << 8) < 200,
                "SETO without its value sets odometry to zero");
    c.command(4, 0);
    c.wait(1500 * ms);
    const double stopped = driven(c.sim.get());
    c.command(11, 200);
    c.wait(1000 * ms);
    check::near(driven(c.sim.get()), stopped, 1e-3, "without motors VEL does nothing");
    c.send({ 0xFA, 0xFB, 3, 2, 0, 2 }); // CLOSE
    const std::size_t count = c.packets.size();
    c.wait(1000 * ms);
    check::that(c.packets.size() == count && !c.firmware.in_session(), "CLOSE ends it all");
}

// The bytes that AriaCoda sends on a serial port, in order.
void aria()
{
    Client c;
    c.send({ 0x57, 0x4D, 0x53, 0x32, 0x0D });
    for (const std::uint8_t sync : { 0, 1, 2 }) {
        c.send(P2osBody(sync).packet());
        c.wait(120 * ms);
    }
    c.command(1, 1); // OPEN 1
    c.send(P2osBody(0).packet());
    for (int i = 0; i < 5; ++i) {
        c.command(18, 1);
        c.wait(210 * ms);
    }
    check::that(c.count(0x20) >= 1 && c.count(0x32) >= 8, "AriaCoda: config and SIPs come");
    c.command(62, 0);
    c.command(4, 1);
    c.command(6, 750);
    c.command(10, 100);
    for (int i = 0; i < 8; ++i) {
        c.command(11, 200);
        c.send(P2osBody(0).packet());
        c.wait(500 * ms);
    }
    check::that(!c.firmware.watchdog_tripped() && c.count(0x33) > 30,
                "AriaCoda: a pulse each half second keeps it driving");
    check::near(driven(c.sim.get()), 0.2 * (4.0 - 0.33), 0.03, "AriaCoda: it drives");
    c.command(4, 0);
    c.command(2, 1); // CLOSE 1
    check::that(!c.firmware.in_session(), "AriaCoda: CLOSE with an argument");
}

// The bytes that Player's p2os driver sends.
void player()
{
    Client c;
    for (const std::uint8_t sync : { 0, 1, 2 }) {
        c.send(P2osBody(sync).packet());
        c.wait(500 * ms);
    }
    c.send(P2osBody(1).packet());
    c.send(P2osBody(0).packet());
    c.command(28, 0);
    c.wait(300 * ms);
    check::that(c.count(0x32) >= 2 && c.packets.back()[3 + 19] == 0,
                "Player: sonars are off at first");
    c.command(28, 1);
    c.command(4, 0);
    c.send({ 0xFA, 0xFB, 4, 7, 0x3B, 0x07, 0x3B }); // SETO with a type and no value
    c.wait(400 * ms);
    check::that(c.packets.back()[3 + 19] > 0, "Player: then they are on");
    c.command(11, 200);
    c.wait(1000 * ms);
    check::near(driven(c.sim.get()), 0.0, 1e-6, "Player: without motor power it stands");
    c.command(4, 1);
    c.command(11, 200);
    c.command(21, 10);
    c.wait(1500 * ms);
    check::that(driven(c.sim.get()) > 0.1, "Player: with motor power it drives");
}

void watchdog()
{
    Client c;
    c.shake_hands();
    c.command(4, 1);
    c.command(11, 300);
    c.wait(1900 * ms);
    check::that(!c.firmware.watchdog_tripped(), "the watchdog waits for two seconds");
    c.wait(2000 * ms);
    const double stopped = driven(c.sim.get());
    c.wait(2000 * ms);
    check::that(c.firmware.watchdog_tripped(), "then it trips");
    check::near(driven(c.sim.get()), stopped, 0.002, "and the robot stands");
    c.send({ 0xFA, 0xFB, 3, 0, 0, 0 }); // PULSE
    c.wait(1500 * ms);
    check::that(driven(c.sim.get()) > stopped + 0.2, "a PULSE makes it take up the old speed");
    c.command(11, 0);
    c.wait(3000 * ms);
    c.command(29, 0);
    c.command(32, 10 | 10 << 8); // VEL2: 200 mm/s each
    const double before = driven(c.sim.get());
    c.wait(1500 * ms);
    check::near(driven(c.sim.get()) - before, 0.2 * (1.5 - 0.34), 0.03, "VEL2 drives the wheels");
}

void sonars()
{
    Client c;
    c.shake_hands();
    c.wait(2000 * ms);
    std::vector<int> seen(16);
    bool partial = true;
    for (const Bytes &packet : c.packets) {
        if (packet[3] != 0x32)
            continue;
        const int n = packet[3 + 19];
        partial = partial && n < 16;
        for (int i = 0; i < n; ++i)
            ++seen[packet[static_cast<std::size_t>(3 + 20 + 3 * i)]];
    }
    bool each = true;
    for (const int n : seen)
        each = each && n >= 4 && n <= 7;
    check::that(partial, "a SIP has only the sonars that were fired since the last");
    check::that(each, "each is in one of three or so, about three times a second");
    c.packets.clear();
    c.command(28, 0);
    c.wait(500 * ms);
    check::that(c.packets.back()[3 + 19] == 0, "SONAR 0 turns them off");
}

void pacing()
{
    PacedLine line(true);
    std::uint8_t byte = 0;
    std::int64_t at = 0;
    line.push({ 1, 2 }, 0, 9600);
    check::that(!line.take(1 * ms, byte, at), "at 9600 bits per second a byte takes 1.04 ms");
    check::that(line.take(2 * ms, byte, at) && byte == 1 && at == 1'041'666, "the first");
    check::that(line.take(3 * ms, byte, at) && byte == 2 && at == 2'083'332, "the second");
    check::that(line.next_ns() == std::numeric_limits<std::int64_t>::max(), "then none");
}

// The driver on a fake line, with the firmware at the other end. Both directions are paced, and
// garble bytes at the wrong rate.
struct Drive {
    std::unique_ptr<frob_sim, Closer> sim = open_world();
    PioneerFirmware firmware;
    PacedLine to_robot{ true }, to_driver{ true };
    frob_fake_clock clock{};
    frob_fake_line line{};
    frob_pioneer device{};
    frob_robot robot{};
    double settings[FROB_PIONEER_SETTING_COUNT];

    explicit Drive(const char *model)
        : firmware(sim.get(), *PioneerFirmware::find_model(model), 9600)
    {
        frob_fake_line_open(&line, &clock);
        line.rate = 9600;
        for (std::size_t i = 0; i < FROB_PIONEER_SETTING_COUNT; ++i)
            settings[i] = frob_pioneer_driver.settings[i].initial;
        const frob_serial serial = frob_fake_serial(&line);
        const frob_clock time = frob_fake_time(&clock);
        frob_robot_start(&robot, &frob_pioneer_driver, &device, settings, &serial, &time, 200 * ms);
    }

    void run(std::int64_t time, double forward, double turn)
    {
        frob_pioneer_output out{};
        out.forward = forward;
        out.turn = turn;
        for (const std::int64_t end = clock.now_ns + time; clock.now_ns < end; clock.now_ns += ms) {
            if (frob_robot_poll(&robot) == FROB_ROBOT_READY && clock.now_ns / ms % 20 == 0)
                frob_robot_command(&robot, &out);
            exchange();
        }
    }

    void exchange()
    {
        std::uint8_t byte = 0;
        std::int64_t at = 0;
        Bytes bytes(256);
        bytes.resize(frob_fake_receive(&line, bytes.data(), bytes.size()));
        if (line.rate == firmware.rate())
            to_robot.push(bytes, clock.now_ns, line.rate);
        while (to_robot.take(clock.now_ns, byte, at)) {
            firmware.advance(at);
            firmware.receive(byte);
        }
        firmware.advance(clock.now_ns);
        to_driver.push(firmware.take_output(), clock.now_ns, firmware.rate());
        while (to_driver.take(clock.now_ns, byte, at))
            if (line.rate == firmware.rate())
                frob_fake_send(&line, &byte, 1, 0);
    }
};

void driver(const char *model)
{
    const std::string of = std::string(", ") + model;
    Drive d(model);
    frob_pioneer_input in{};
    d.run(1500 * ms, 0.0, 0.0);
    check::that(d.robot.state == FROB_ROBOT_READY && d.firmware.rate() == 38400,
                "the driver connects and switches the rate" + of);
    frob_robot_sense(&d.robot, &in);
    d.run(4000 * ms, 0.3, 0.2);
    d.run(2000 * ms, 0.0, 0.0);
    frob_robot_sense(&d.robot, &in);
    const frob_sim_summary s = frob_sim_summarize(d.sim.get());
    check::near(s.distance_m, 1.2, 0.02, "it drives as far as it should" + of);
    // An arc of 0.8 rad and 1.2 m, distorted a little by the ramps of 0.3 m/s^2 and 100 deg/s^2.
    check::near(in.odometry.heading, 0.8, 0.05, "odometry turns" + of);
    check::near(std::hypot(in.odometry.position.x, in.odometry.position.y), 1.17, 0.03,
                "odometry moves" + of);
    check::near(in.battery, 12.8, 1e-9, "the battery" + of);
    check::that(in.motorsOn && in.leftWheel == 0.0 && in.rightWheel == 0.0, "it stands" + of);
    double range = 0.0, age = 0.0;
    check::that(frob_pioneer_echo(&d.device, 0, &range, &age) && range < 5.0 && age < 0.5,
                "sonar 0 hears the wall" + of);
    check::that(d.device.has_config && d.device.config.watchdog == 2000, "the config packet" + of);
}

// The newest packet of a type, starting at its type; empty if there is none.
Bytes newest(const Client &c, std::uint8_t type)
{
    for (std::size_t i = c.packets.size(); i-- > 0;)
        if ((c.packets[i][3] & (type == 0x32 ? 0xFE : 0xFF)) == type)
            return Bytes(c.packets[i].begin() + 3, c.packets[i].end());
    return {};
}

int s16(const Bytes &body, std::size_t at)
{
    return static_cast<std::int16_t>(body.at(at) | body.at(at + 1) << 8);
}

double heading_deg(const Client &c)
{
    return s16(newest(c, 0x32), 5) * 360.0 / 4096;
}
double speed_mm_s(const Client &c)
{
    return (s16(newest(c, 0x32), 7) + s16(newest(c, 0x32), 9)) / 2.0;
}

// Commands with distances and headings instead of speeds: MOVE, HEAD, DHEAD, DCHEAD.
void motions()
{
    Client c("p3dx-sh");
    c.shake_hands();
    c.command(4, 1);
    c.command(8, 500);
    c.live(6000 * ms);
    check::near(s16(newest(c, 0x32), 1), 500, 10, "MOVE goes so many millimetres");
    check::that(newest(c, 0x32)[0] == 0x32, "and rests there");
    c.command(8, -200);
    c.live(4000 * ms);
    check::near(s16(newest(c, 0x32), 1), 300, 10, "MOVE goes back too");
    c.command(12, 90);
    c.live(4000 * ms);
    check::near(heading_deg(c), 90, 1, "HEAD turns to a heading");
    check::near(s16(newest(c, 0x32), 14) * 360.0 / 4096, 90, 0.1,
                "which a SIP has as its setpoint");
    c.command(13, -120);
    c.live(4000 * ms);
    check::near(heading_deg(c), -30, 1, "DHEAD turns by an angle");
    c.command(22, 20);
    c.command(22, 30);
    c.live(4000 * ms);
    check::near(heading_deg(c), 20, 1, "DCHEAD turns from the last setpoint");
    c.command(12, 180);
    c.live(300 * ms);
    c.command(21, 0);
    c.live(2000 * ms);
    check::that(std::abs(heading_deg(c)) < 90, "RVEL ends turning to a heading");
}

// SETV, SETRV, SETA and SETRA.
void limits()
{
    Client c("p3dx-sh");
    c.shake_hands();
    c.command(4, 1);
    c.command(6, 100);
    c.command(11, 400);
    c.live(2000 * ms);
    check::near(speed_mm_s(c), 100, 2, "SETV limits VEL");
    c.command(5, -50);
    c.command(29, 0);
    c.live(1000 * ms);
    check::near(speed_mm_s(c), 50, 10, "SETA below zero is how it brakes");
    c.live(2000 * ms);
    c.command(5, 40);
    c.command(11, 100);
    c.live(1000 * ms);
    check::near(speed_mm_s(c), 40, 8, "above zero, how it speeds up");
    c.command(55, 0);
    c.live(500 * ms);
    check::near(speed_mm_s(c), 0, 1, "E_STOP does not heed it");
    c.command(10, 20);
    c.command(21, 90);
    c.live(1500 * ms);
    const double before = heading_deg(c);
    c.live(1000 * ms);
    check::near(heading_deg(c) - before, 20, 2, "SETRV limits RVEL");
    c.command(23, -10);
    c.command(21, 0);
    c.live(1000 * ms);
    const double braking = heading_deg(c);
    c.live(1000 * ms);
    check::near(heading_deg(c) - braking, 5, 2, "SETRA is how it ends a turn");
}

// Packets on request: encoders, and inputs and outputs.
void asked()
{
    Client c("p3dx-sh");
    c.shake_hands();
    c.command(4, 1);
    c.command(8, 300);
    c.live(4000 * ms);
    check::that(c.count(0x90) == 0 && c.count(0xF0) == 0, "nothing that is not asked for");
    c.command(19, 1);
    c.live(500 * ms);
    const Bytes one = newest(c, 0x90);
    check::that(c.count(0x90) == 1 && one.size() == 11, "ENCODER 1 is answered once");
    const int left = s16(one, 1) & 0xFFFF, left_high = s16(one, 3);
    check::near((left_high * 65536.0 + left) / 132, 300, 10, "with the counts of the wheels' way");
    c.command(19, 2);
    c.live(1000 * ms);
    check::that(c.count(0x90) >= 9, "ENCODER 2 with every SIP");
    c.command(19, 0);
    const std::size_t streamed = c.count(0x90);
    c.live(500 * ms);
    check::that(c.count(0x90) == streamed, "until ENCODER 0");
    c.command(30, 0x0F05);
    c.command(30, 0x01FE);
    c.command(40, 1);
    c.live(500 * ms);
    const Bytes io = newest(c, 0xF0);
    check::that(c.count(0xF0) == 1 && io.size() == 1 + 5 + 3 + 19 + 2 && io[1] == 4 && io[6] == 2 &&
                    io[7] == 0x04 && io[9] == 9,
                "IOREQUEST 1 has what DIGOUT has set, by its mask");
}

} // namespace

int main()
{
    motions();
    limits();
    asked();
    handshake();
    clients();
    aria();
    player();
    watchdog();
    sonars();
    pacing();
    driver("p3dx");
    driver("p3dx-sh");
    driver("p2dx");
    return check::status();
}
