// soak SEED COUNT SECONDS [ROBOT...]: drives each robot for SECONDS simulated seconds with each of
// COUNT seeds, on a faulty line; see soak.h. A failure report names the seed; the same seed gives
// the same run.
#include <cstdlib>
#include <cstring>
#include <ctime>

#include "pioneer_kind.h"
#include "soak.h"

// The simulator's functions, implemented by the bench's body.
void frob_sim_advance(frob_sim *, std::int64_t) {}
void frob_sim_read(frob_sim *sim, void *input)
{
    *static_cast<frob_pioneer_input *>(input) = sim->body;
}
void frob_sim_command(frob_sim *sim, std::int64_t, const void *output)
{
    sim->output = *static_cast<const frob_pioneer_output *>(output);
}

static bool sane_pose(const frob_pose &pose)
{
    return std::isfinite(pose.position.x) && std::isfinite(pose.position.y) &&
           std::fabs(pose.heading) < 3.2;
}

struct ScoutSoak : ScoutKind {
    static constexpr unsigned overlapped = 0;
    static constexpr double most_m_s = 1.01, watchdog_s = 1;
    static constexpr int hearing_ms = 500;
    static void prepare(Bench<ScoutSoak, Faults> &) {}
    static bool is_reading(const std::vector<std::uint8_t> &bytes) { return bytes.size() == 48; }
    static bool doubts(const frob_scout &d) { return d.odometry.refused > 0; }
    static bool limited(const Wire &) { return false; }
    static bool sane(const frob_scout_input &i)
    {
        return sane_pose(i.odometry) && std::fabs(i.leftWheel) < 10 && std::fabs(i.rightWheel) < 10;
    }
};

struct CreateSoak : CreateKind {
    static constexpr unsigned overlapped = 0;
    static constexpr double most_m_s = 0.5, watchdog_s = 0;
    static constexpr int hearing_ms = 500;
    static void prepare(Bench<CreateSoak, Faults> &) {}
    // If a request for a stream was damaged, the robot sends other frames.
    static bool is_reading(const std::vector<std::uint8_t> &bytes)
    {
        static constexpr std::uint8_t ids[] = {
            7,  9,  10, 11, 12, 13, 14, 17, 18, 21, 22, 25, 26,
            28, 29, 30, 31, 35, 43, 44, 46, 47, 48, 49, 50, 51
        };
        std::size_t at = 2;
        if (bytes.size() != 70 || bytes[0] != 19)
            return false;
        for (const std::uint8_t id : ids) {
            if (bytes[at] != id)
                return false;
            at += id < 22 || id == 35 ? 2 : 3;
        }
        return true;
    }
    static bool doubts(const frob_create &d) { return d.odometry.refused > 0; }
    static bool limited(const Wire &) { return false; }
    static bool sane(const frob_create_input &i)
    {
        return sane_pose(i.odometry) && std::fabs(i.leftWheel) < 10 &&
               std::fabs(i.rightWheel) < 10 && i.charge >= 0 && i.charge <= 1;
    }
};

struct PioneerSoak : PioneerKind {
    // Garbage right behind a valid packet can look like the start of a packet, or form one together
    // with the start of a valid packet: 252 bytes, at most six SIPs.
    static constexpr unsigned overlapped = 6;
    static constexpr double most_m_s = 2.2, watchdog_s = 2;
    static constexpr int hearing_ms = 3500;
    static void prepare(Bench<PioneerSoak, Faults> &b)
    {
        b.settings[FROB_PIONEER_BAUD] = 38400;
        b.settings[FROB_PIONEER_SWITCH_BAUD] = 0;
        b.rate = 38400;
    }
    static bool is_reading(const std::vector<std::uint8_t> &bytes)
    {
        return bytes.size() > 30 && (bytes[3] & 0xF0) == 0x30;
    }
    static bool doubts(const frob_pioneer &) { return false; }
    static bool limited(const Wire &wire) { return wire.limited(); }
    static bool sane(const frob_pioneer_input &i) { return sane_pose(i.odometry); }
};

template <class Kind>
static bool soak(const char *robot, std::uint64_t first, unsigned count, double for_s)
{
    const std::clock_t started = std::clock();
    SoakResult all;
    unsigned failures = 0;
    for (unsigned i = 0; i < count; ++i) {
        Soak<Kind> run(first + i);
        const SoakResult one = run.run(for_s);
        if (!one.failure.empty()) {
            std::printf("%s, seed %llu: %s\n", robot, static_cast<unsigned long long>(first + i),
                        one.failure.c_str());
            ++failures;
        }
        all.simulated_s += one.simulated_s;
        all.faults += one.faults;
        all.connections += one.connections;
        all.stale += one.stale;
        all.limited += one.limited;
        all.slowest_resume_s = std::max(all.slowest_resume_s, one.slowest_resume_s);
        all.longest_unwanted_s = std::max(all.longest_unwanted_s, one.longest_unwanted_s);
    }
    const double took_s = static_cast<double>(std::clock() - started) / CLOCKS_PER_SEC;
    std::printf("%s faults on the line of the %s: %u seeds from %llu\n",
                failures == 0 ? "ok" : "FAIL", robot, count,
                static_cast<unsigned long long>(first));
    std::printf("   %.0f s simulated, %.0f in a second of the processor; %u phases of faults, %u "
                "connections, stale %u "
                "times\n   slowest to drive again %.2f s, longest motion while stale %.2f s; %u "
                "times a damaged command "
                "set a limit\n",
                all.simulated_s, all.simulated_s / took_s, all.faults, all.connections, all.stale,
                all.slowest_resume_s, all.longest_unwanted_s, all.limited);
    return failures == 0;
}

int main(int argc, char **argv)
{
    if (argc < 4) {
        std::fputs("usage: soak SEED COUNT SECONDS [ROBOT...]\n", stderr);
        return 2;
    }
    const std::uint64_t seed = std::strtoull(argv[1], nullptr, 10);
    const auto count = static_cast<unsigned>(std::strtoul(argv[2], nullptr, 10));
    const double for_s = std::strtod(argv[3], nullptr);
    const auto asked = [&](const char *robot) {
        bool named = argc == 4;
        for (int i = 4; i < argc; ++i)
            named = named || std::strcmp(argv[i], robot) == 0;
        return named;
    };
    bool ok = true;
    if (asked("scout"))
        ok = soak<ScoutSoak>("scout", seed, count, for_s) && ok;
    if (asked("create"))
        ok = soak<CreateSoak>("create", seed, count, for_s) && ok;
    if (asked("pioneer"))
        ok = soak<PioneerSoak>("pioneer", seed, count, for_s) && ok;
    return ok ? 0 : 1;
}
