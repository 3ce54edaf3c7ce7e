// Tests Scout and Create as `frobc serve` runs them, in the simulator, with their drivers at the
// other end of the line, in virtual time.
#include <string>

#include "bench.h"
#include "body_firmware.h"
#include "check.h"
#include "sim.h"

static frob_sim *open_hall(const char *robot)
{
    char message[1024] = "";
    frob_sim_settings settings{};
    settings.seed = 1;
    settings.served = 1;
    settings.robot = robot;
    frob_sim *sim = frob_sim_open("hall.toml", &settings, message, sizeof message);
    if (!sim)
        std::printf("%s\n", message);
    return sim;
}

// The interface that the bench expects of a wire, implemented by the firmware with its simulated
// body.
template <class Kind>
class Served
{
  public:
    Served() : sim_(open_hall(Kind::driver().robot)), firmware_(sim_, Kind::driver().rate) {}
    ~Served() { frob_sim_close(sim_); }
    Served(const Served &) = delete;
    Served &operator=(const Served &) = delete;

    void receive(const std::uint8_t *bytes, std::size_t count)
    {
        for (std::size_t i = 0; i < count; ++i)
            firmware_.receive(bytes[i]);
    }
    void sense(const typename Kind::Input &, std::int64_t) {}
    void advance(std::int64_t now_ns)
    {
        firmware_.advance(now_ns);
        const auto bytes = firmware_.take_output();
        to_client.insert(to_client.end(), bytes.begin(), bytes.end());
    }
    typename Kind::Output output() const { return firmware_.wire().output(); }
    frob_sim_summary summary() const { return frob_sim_summarize(sim_); }

    std::vector<std::uint8_t> to_client;

  private:
    frob_sim *sim_;
    frob::serve::BodyFirmware<typename Kind::Wire, typename Kind::Input> firmware_;
};

struct ScoutServed : ScoutKind {
    using Wire = Served<ScoutKind>;
};
struct CreateServed : CreateKind {
    using Wire = Served<CreateKind>;
};

static void scout_drives_to_a_wall()
{
    Bench<ScoutServed> b;
    double nearest = 100;
    b.start();
    b.run(b.time.now_ns + second);
    check(b.state == FROB_ROBOT_READY, "served scout: connects");
    for (int i = 0; i < 1500 && nearest > 0.6; ++i) {
        b.drive(0.3, 0, second / 30);
        if (b.input.sonar[0].tag == FROB_EVENT_FLOAT_EVENT)
            nearest = b.input.sonar[0].f0;
    }
    b.drive(0, 0, second);
    check(nearest <= 0.6 && nearest > 0.4, "served scout: sees a wall ahead in time");
    check(b.wire.summary().collisions == 0, "served scout: and stops before it");
    check_near(b.input.odometry.position.x, b.wire.summary().distance_m, 0.1,
               "served scout: its odometry is about the way it made");
}

static void create_drives_against_a_wall()
{
    Bench<CreateServed> b;
    bool bumped = false;
    b.start();
    b.run(b.time.now_ns + second);
    check(b.state == FROB_ROBOT_READY, "served create: connects");
    for (int i = 0; i < 1200 && !bumped; ++i) {
        b.drive(0.4, 0, second / 30);
        bumped = b.input.bumpLeft || b.input.bumpRight;
    }
    check(bumped, "served create: its bumper is pressed at a wall");
    check_near(b.input.odometry.position.x, b.wire.summary().distance_m, 0.1,
               "served create: its odometry is about the way it made");
    check(*std::max_element(b.input.light, b.input.light + 6) > 100,
          "served create: light comes back");
    b.drive(-0.2, 0, second);
    check(!b.input.bumpLeft && !b.input.bumpRight, "served create: backs away");
}

int main()
{
    scout_drives_to_a_wall();
    create_drives_against_a_wall();
    return check_status();
}
