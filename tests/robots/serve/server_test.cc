// Tests the server between a client and the firmware: pauses, clients that leave in the middle of a
// packet, and clients that connect while another one controls the robot.
#include "../sim/check.h"

#include <string>

#include <arpa/inet.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include "serve/server.h"
#include "serve/tcp_port.h"

using namespace frob::serve;

namespace
{

constexpr std::int64_t ms = 1'000'000;

// A firmware that stores the bytes it receives; each command is enclosed by semicolons.
class Kept : public Firmware
{
  public:
    void advance(std::int64_t) override {}
    void receive(std::uint8_t byte) override { text += static_cast<char>(byte); }
    void forget() override { text += text.empty() || text.back() == ';' ? "" : ";"; }
    std::int64_t next_ns() const override { return 0; }
    std::uint32_t rate() const override { return 9600; }
    std::string text;
};

// A connection whose other end is the test.
class Plug : public Connection
{
  public:
    std::string device() const override { return ""; }
    int descriptor() const override { return -1; }
    bool connected() const override { return there; }
    Bytes read() override { return std::exchange(bytes, {}); }
    void write(const Bytes &) override {}
    std::uint32_t rate() const override { return 0; }
    Bytes bytes;
    bool there = true;
};

void pauses()
{
    Kept robot;
    Server server(robot, true);
    auto line = std::make_unique<Plug>();
    Plug &client = *line;
    std::int64_t now = 0;
    const auto say = [&](const std::string &text, std::int64_t for_ms) {
        client.bytes.assign(text.begin(), text.end());
        for (const std::int64_t end = now + for_ms * ms; now < end; now += ms)
            server.advance(now);
    };
    server.plug(std::move(line));
    say("ab", 90);
    say("cd", 150);
    check::that(robot.text == "abcd", "a pause of 90 ms is within a packet");
    say("ef", 10);
    check::that(robot.text == "abcd;ef", "one of 150 ms ends it");
    client.there = false;
    say("gh", 1);
    client.there = true;
    say("ij", 20);
    check::that(robot.text == "abcd;efgh;ij",
                "so does a client that leaves, when all it said is through");
}

int call(const std::string &device)
{
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    address.sin_port =
        htons(static_cast<std::uint16_t>(std::stoi(device.substr(device.rfind(':') + 1))));
    const int caller = socket(AF_INET, SOCK_STREAM, 0);
    if (connect(caller, reinterpret_cast<sockaddr *>(&address), sizeof address) != 0)
        return -1;
    return caller;
}

void second_client()
{
    std::string told;
    TcpPort port(0, [&](const std::string &text) { told += text; });
    const int first = call(port.device());
    port.read();
    const int second = call(port.device());
    char byte = 0;
    port.read();
    check::that(port.connected() && recv(second, &byte, 1, 0) == 0, "a second client is refused");
    check::that(told.rfind("refused a second client, from port ", 0) == 0, "and why is told");
    check::that(send(first, "x", 1, 0) == 1 && port.read() == Bytes{ 'x' }, "the first goes on");
    send(first, "y", 1, 0);
    close(first);
    const int third = call(port.device());
    check::that(port.read() == Bytes{ 'y' } && !port.connected(),
                "it leaves, all it said is heard");
    port.read();
    check::that(port.connected() && send(third, "z", 1, 0) == 1 && port.read() == Bytes{ 'z' },
                "who comes then is let in");
    close(second);
    close(third);
}

} // namespace

int main()
{
    pauses();
    second_client();
    return check::status();
}
