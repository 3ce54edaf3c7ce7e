// Tests the simulated robots with the messages that real client libraries send them.
#include <cstring>
#include <initializer_list>
#include <string>
#include <vector>

#include "check.h"
#include "create_wire.h"
#include "scout_wire.h"

using frob::sim::CreateWire;
using frob::sim::ScoutWire;
using Bytes = std::vector<std::uint8_t>;

constexpr std::int64_t ms = 1000000;

template <class Wire>
static Bytes ask(Wire &wire, const Bytes &bytes)
{
    wire.to_client.clear();
    wire.receive(bytes.data(), bytes.size());
    return wire.to_client;
}

// The answer of a Create after a sensor refresh, at most two refreshes later.
static Bytes answer(CreateWire &robot, const Bytes &bytes, std::int64_t &now_ns)
{
    ask(robot, bytes);
    now_ns += 30 * ms;
    robot.advance(now_ns);
    return robot.to_client;
}

// pycreate2 0.8.0: Start, Safe, four songs, drive direct, Sensors 100, stop.
static void pycreate2()
{
    CreateWire robot;
    frob_create_input body{};
    body.bumpRight = true;
    body.battery = 15;
    robot.sense(body, 0);
    ask(robot, { 145, 0, 100, 0, 100 });
    check(robot.left_mm_s() == 0, "pycreate2: nothing moves before Start");
    ask(robot, { 128 });
    ask(robot, { 145, 0, 100, 0, 100 });
    check(robot.mode() == CreateWire::Mode::passive && robot.left_mm_s() == 0,
          "pycreate2: nothing moves in Passive");
    ask(robot, { 131 });
    for (std::uint8_t song = 0; song < 4; ++song)
        ask(robot, { 140, song, 3, 145, 32, 137, 32, 131, 32, 141, song });
    ask(robot, { 0x91, 0x00, 0x64, 0x00, 0xC8 });
    check(robot.mode() == CreateWire::Mode::safe && robot.right_mm_s() == 100 &&
              robot.left_mm_s() == 200,
          "pycreate2: notes that are opcodes play, drive direct drives");
    std::int64_t now_ns = 0;
    const Bytes all = answer(robot, { 142, 100 }, now_ns);
    check(all.size() == 80 && all[0] == 1, "pycreate2: group 100 has 80 bytes, bumps first");
    // Packets 7 to 34 are 42 bytes with the unused 32 and 33; then comes the mode.
    check(all.size() == 80 && all[17] == 0x3A && all[18] == 0x98 && all[40] == 2,
          "pycreate2: voltage and mode are where it reads them");
    ask(robot, { 0x91, 0, 0, 0, 0 });
    check(robot.left_mm_s() == 0, "pycreate2: stop");
}

// A request for an empty stream ends the stream; the bits of the light bumpers have a threshold.
static void streams_and_lights()
{
    CreateWire robot;
    frob_create_input body{};
    body.light[0] = 9;
    body.light[5] = 10;
    robot.sense(body, 0);
    ask(robot, { 128 });
    std::int64_t now_ns = 0;
    check(answer(robot, { 142, 45 }, now_ns) == Bytes{ 0x20 }, "faint light sets no bit");
    ask(robot, { 148, 1, 7 });
    robot.advance(100 * ms);
    check(!robot.to_client.empty(), "a stream");
    ask(robot, { 148, 0 });
    robot.advance(200 * ms);
    check(robot.to_client.empty(), "STREAM of no packets ends it");
    ask(robot, { 150, 1 });
    robot.advance(300 * ms);
    check(robot.to_client.empty(), "and there is none to resume");
}

// libcreate: a stream of its packets, in frames whose checksum includes the header.
static void libcreate()
{
    static const Bytes ids = { 7,  8,  9,  10, 11, 12, 13, 14, 15, 17, 18, 21, 22, 23, 24, 25,
                               26, 35, 43, 44, 45, 46, 47, 48, 49, 50, 51, 52, 53, 54, 55, 58 };
    CreateWire robot;
    Bytes request = { 148, static_cast<std::uint8_t>(ids.size()) };
    request.insert(request.end(), ids.begin(), ids.end());
    robot.sense({}, 0);
    ask(robot, { 128 });
    ask(robot, { 132 });
    ask(robot, request);
    robot.advance(14 * ms);
    check(robot.to_client.empty(), "libcreate: no frame before 15 ms");
    robot.advance(15 * ms);
    unsigned sum = 0;
    for (const std::uint8_t byte : robot.to_client)
        sum += byte;
    check(robot.to_client.size() > 3 && robot.to_client[0] == 19 &&
              robot.to_client[1] == robot.to_client.size() - 3 && robot.to_client[2] == 7 &&
              (sum & 0xFF) == 0,
          "libcreate: a frame of its packets, whose bytes make zero");
    robot.to_client.clear();
    robot.advance(150 * ms);
    check(robot.to_client.size() % 9 == 0 && !robot.to_client.empty(),
          "libcreate: nine frames in 135 ms");
    ask(robot, { 150, 0 });
    robot.advance(300 * ms);
    check(robot.to_client.empty(), "libcreate: a stream that pauses");
    ask(robot, { 150, 1 });
    robot.advance(330 * ms);
    check(!robot.to_client.empty(), "libcreate: goes on");
    ask(robot, { 137, 0x00, 0xC8, 0x80, 0x00 });
    check(robot.left_mm_s() == 200 && robot.right_mm_s() == 200, "libcreate: drive straight on");
    ask(robot, { 137, 0x00, 0xC8, 0xFF, 0xFF });
    check(robot.left_mm_s() == 200 && robot.right_mm_s() == -200,
          "libcreate: turn clockwise in place");
    ask(robot, { 137, 0x00, 0xC8, 0x01, 0xF4 });
    check(robot.left_mm_s() < 200 && robot.right_mm_s() > 200,
          "libcreate: a positive radius turns left");
    ask(robot, { 146, 0x00, 0xFF, 0xFF, 0x01 });
    check(robot.right_mm_s() == 500 && robot.left_mm_s() == -500, "libcreate: drive PWM");
}

// pyroombaadapter 0.3.0: packets one by one, and DRIVE instead of wheels.
static void pyroombaadapter()
{
    CreateWire robot;
    frob_create_input body{};
    body.battery = 16;
    body.cliffSignals[1] = 1500;
    robot.sense(body, 0);
    ask(robot, { 173 });
    ask(robot, { 128 });
    ask(robot, { 131 });
    std::int64_t now_ns = 0;
    check(answer(robot, { 142, 35 }, now_ns) == Bytes{ 2 }, "pyroombaadapter: the mode alone");
    check(answer(robot, { 142, 22 }, now_ns) == (Bytes{ 0x3E, 0x80 }),
          "pyroombaadapter: the voltage alone, high byte first");
    check(answer(robot, { 142, 29 }, now_ns) == (Bytes{ 0x05, 0xDC }) &&
              answer(robot, { 142, 28 }, now_ns) == (Bytes{ 0, 0 }),
          "pyroombaadapter: a cliff's signal alone");
    check(answer(robot, { 149, 2, 43, 35 }, now_ns) == (Bytes{ 0, 0, 2 }),
          "pyroombaadapter: a list of packets");
    ask(robot, { 137, 0, 58, 0, 1 });
    check(robot.left_mm_s() == -58 && robot.right_mm_s() == 58,
          "pyroombaadapter: turn counter-clockwise in place");
}

// A client that writes a query, discards its received data, and then reads, gets the answer.
static void answers_come_later()
{
    bool early = false, late = false;
    for (int phase = 0; phase < 150; ++phase) {
        CreateWire robot;
        const std::int64_t asked_ns = 30 * ms + phase * ms / 10;
        ask(robot, { 128 });
        robot.sense({}, asked_ns);
        ask(robot, { 142, 35 });
        robot.advance(asked_ns + 999000);
        early = early || !robot.to_client.empty();
        robot.advance(asked_ns + 16 * ms);
        late = late || robot.to_client != Bytes{ 1 };
    }
    check(!early, "a Create's answer is not there within a millisecond");
    check(!late, "it is there after the next refresh of the sensors");
    CreateWire robot;
    ask(robot, { 128 });
    ask(robot, { 142, 35 });
    robot.receive(Bytes{ 142, 21 }.data(), 2);
    robot.advance(15 * ms);
    check(robot.to_client == (Bytes{ 1, 0 }),
          "two questions in one cycle are answered together, in order");
}

static std::string text_of(const Bytes &bytes)
{
    return { bytes.begin(), bytes.end() };
}

static void restarts()
{
    CreateWire robot;
    ask(robot, { 128 });
    ask(robot, { 132 });
    ask(robot, { 145, 0, 100, 0, 100 });
    ask(robot, { 148, 1, 35 });
    ask(robot, { 7 });
    check(robot.mode() == CreateWire::Mode::off && robot.left_mm_s() == 0,
          "opcode 7 stops the robot");
    robot.advance(999 * ms);
    check(robot.to_client.empty(), "at first it is silent, and its stream has ended");
    robot.advance(1000 * ms);
    check(text_of(robot.to_client).rfind("bl-start\r\nSTR730\r\nbootloader id: ", 0) == 0,
          "then its bootloader speaks");
    ask(robot, { 128 });
    ask(robot, { 7 });
    check(robot.mode() == CreateWire::Mode::off, "and it hears nothing");
    robot.advance(3000 * ms);
    check(text_of(robot.to_client).rfind("Roomba by iRobot!\r\n", 0) == 0, "then the robot");
    ask(robot, { 128 });
    std::int64_t now_ns = 3000 * ms;
    check(answer(robot, { 142, 35 }, now_ns) == Bytes{ 1 }, "and it can be started");
}

static void create_in_safe_mode()
{
    CreateWire robot;
    frob_create_input body{};
    robot.sense(body, 0);
    ask(robot, { 128 });
    ask(robot, { 131 });
    ask(robot, { 145, 0, 100, 0, 100 });
    body.cliffs[2] = true;
    robot.sense(body, 10 * ms);
    check(robot.mode() == CreateWire::Mode::passive && robot.left_mm_s() == 0,
          "create: a cliff ends Safe");
    ask(robot, { 131 });
    ask(robot, { 145, 0xFF, 0x9C, 0xFF, 0x9C });
    robot.sense(body, 20 * ms);
    check(robot.mode() == CreateWire::Mode::safe, "create: and may be backed away from");
    body.rightDrop = true;
    robot.sense(body, 30 * ms);
    ask(robot, { 131 });
    check(robot.mode() == CreateWire::Mode::passive, "create: lifted, it does not enter Safe");
    ask(robot, { 132 });
    ask(robot, { 145, 0, 100, 0, 100 });
    robot.sense(body, 3600000 * ms);
    robot.advance(3600000 * ms);
    check(robot.left_mm_s() == 100, "create: Full has neither these stops nor a watchdog");
}

static Bytes scout_packet(std::uint8_t type, const Bytes &data)
{
    Bytes packet = { 1, static_cast<std::uint8_t>(data.size() + 2), 0, type };
    packet.insert(packet.end(), data.begin(), data.end());
    unsigned sum = 0;
    for (const std::uint8_t byte : packet)
        sum += byte;
    packet.push_back(static_cast<std::uint8_t>(sum));
    packet.push_back(0x5C);
    return packet;
}

// The messages that CARMEN's scoutlib and Jenkin's programs send when they start.
static void scout_programs()
{
    ScoutWire robot;
    frob_scout_input body{};
    body.odometry.position.x = 1;
    body.sonar[2].tag = FROB_EVENT_FLOAT_EVENT;
    body.sonar[2].f0 = 1;
    robot.sense(body, 0);
    Bytes state = ask(robot, { 0x01, 0x02, 0x00, 0x07, 0x0A, 0x5C });
    check(state.size() == 48 && state[0] == 1 && state[1] == 44 && state[3] == 7 &&
              state[47] == 0x5C,
          "scout programs: get state");
    state =
        ask(robot, scout_packet(15, { 15, 0, 2, 15, 1, 14, 3, 13, 4, 12, 5, 11, 6, 10, 7, 9, 8 }));
    check(state.size() == 48 && state[3] == 15, "scout programs: sonars on");
    robot.sense(body, 10 * ms);
    check(ask(robot, scout_packet(18, { 5 })).size() == 48,
          "scout programs: watchdog of five seconds");
    ask(robot, scout_packet(12, { 0, 0, 0, 0 }));
    state = ask(robot, scout_packet(30, { 0x84, 0x03, 0x84, 0x03 }));
    check(state.size() == 48 && state[23] == 0 && state[24] == 0 && state[27] == 0x84 &&
              state[28] == 0x03,
          "scout programs: define place and heading");
    check(state.size() == 48 && state[4 + 2] == 39, "scout programs: an echo in inches");
    body.odometry.position.x = 2;
    robot.sense(body, 20 * ms);
    state = ask(robot, scout_packet(7, {}));
    check(state.size() == 48 && state[23] == 0 && state[25] == 0x8A && state[26] == 0x01,
          "scout programs: a metre ahead is 394 tenths of an inch along the heading");
    ask(robot, { 0x01, 0x08, 0x00, 0x05, 0x64, 0x00, 0x64, 0x80, 0x00, 0x00, 0x56, 0x5C });
    check(robot.right() == 100 && robot.left() == -100, "scout programs: velocities, right first");
    robot.advance(4000 * ms);
    ask(robot, scout_packet(7, {}));
    robot.advance(8000 * ms);
    check(robot.right() == 100, "scout programs: any command feeds the watchdog");
    robot.advance(9100 * ms);
    check(robot.right() == 0, "scout programs: the watchdog");
    ask(robot, scout_packet(5, { 100, 0, 100, 0, 0, 0 }));
    ask(robot, scout_packet(9, {}));
    check(robot.right() == 0, "scout programs: stop");
    state = ask(robot, scout_packet(11, { 'h', 'i', 0 }));
    check(state.size() == 6 && state[3] == 8,
          "scout programs: speech is refused, it is the Nomad 200's");
    state = ask(robot, scout_packet(20, {}));
    check(state.size() == 6 + 20 && state[3] == 20, "scout programs: sonars alone");
    state = ask(robot, scout_packet(27, {}));
    check(state.size() == 6 + 7, "scout programs: bumpers alone");
}

static void scout_moves()
{
    ScoutWire robot;
    frob_scout_input body{};
    robot.sense(body, 0);
    ask(robot, scout_packet(2, { 100, 0, 100, 0, 0, 0 }));
    ask(robot, scout_packet(3, { 50, 0, 50, 0, 0, 0 }));
    check(robot.left() == 100 && robot.right() == 100, "scout: move relative, at the speeds set");
    Bytes answer = ask(robot, scout_packet(31, { 1, 1, 0, 10 }));
    check(answer.empty(), "scout: waiting is not answered while it moves");
    body.leftWheel = body.rightWheel = 0.254;
    for (int i = 1; i <= 60; ++i) {
        robot.sense(body, i * 10 * ms);
        robot.advance(i * 10 * ms);
    }
    check(robot.left() == 0 && robot.right() == 0, "scout: it stops where it was to go");
    check(robot.to_client.size() == 48 && robot.to_client[3] == 31,
          "scout: then the wait is answered");
    answer = ask(robot, { 0x01, 0x50, 0x00, 0x55, 0x01, 0x02, 0x00, 0x07, 0x0A, 0x5C });
    check(answer.empty(), "scout: a packet that announces much is waited for");
    const Bytes noise(300, 0x00);
    answer = ask(robot, noise);
    check(answer.size() == 48, "scout: and what it hid is found when it turns out wrong");
}

int main()
{
    pycreate2();
    streams_and_lights();
    libcreate();
    pyroombaadapter();
    answers_come_later();
    restarts();
    create_in_safe_mode();
    scout_programs();
    scout_moves();
    return check_status();
}
