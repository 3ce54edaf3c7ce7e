// rover_soak SEED COUNT SECONDS: drives the Rover for SECONDS simulated seconds with each of COUNT
// seeds, on a faulty line; see tests/robots/faults/soak.h.
#include <cstdlib>

#include "rover_kind.h"
#include "soak.h"

struct RoverSoak : RoverKind {
    // Garbage can spoil the line that it begins, and also the next one behind it.
    static constexpr unsigned overlapped = 2;
    // There is no checksum: the board may receive any number of up to six digits as a speed.
    static constexpr double most_m_s = 1e6 * 30 / 8000, watchdog_s = 0.5;
    static constexpr int hearing_ms = 700;
    static void prepare(Bench<RoverSoak, Faults> &) {}
    // An answer that looks like encoder counts may be the answer to an earlier question.
    static bool is_reading(const std::vector<std::uint8_t> &) { return false; }
    static bool doubts(const rover &d) { return d.odometry.refused > 0; }
    static bool limited(const Wire &) { return false; }
    static bool sane(const frob_rover_input &i)
    {
        bool sane = std::isfinite(i.odometry.position.x) && std::isfinite(i.odometry.position.y) &&
                    std::fabs(i.odometry.heading) < 3.2 && std::fabs(i.leftWheel) < 10 &&
                    std::fabs(i.rightWheel) < 10 && i.battery >= 0 && i.battery <= 15.1;
        for (const frob_event_float &echo : i.sonar)
            sane = sane && (echo.tag == FROB_EVENT_FLOAT_NO_EVENT || (echo.f0 > 0 && echo.f0 <= 3));
        return sane;
    }
};

int main(int argc, char **argv)
{
    if (argc != 4) {
        std::fputs("usage: rover_soak SEED COUNT SECONDS\n", stderr);
        return 2;
    }
    const std::uint64_t first = std::strtoull(argv[1], nullptr, 10);
    const auto count = static_cast<unsigned>(std::strtoul(argv[2], nullptr, 10));
    const double for_s = std::strtod(argv[3], nullptr);
    unsigned failures = 0, faults = 0, stale = 0;
    double slowest_s = 0, unwanted_s = 0;
    for (unsigned i = 0; i < count; ++i) {
        Soak<RoverSoak> run(first + i);
        const SoakResult one = run.run(for_s);
        if (!one.failure.empty()) {
            std::printf("seed %llu: %s\n", static_cast<unsigned long long>(first + i),
                        one.failure.c_str());
            ++failures;
        }
        faults += one.faults;
        stale += one.stale;
        slowest_s = std::max(slowest_s, one.slowest_resume_s);
        unwanted_s = std::max(unwanted_s, one.longest_unwanted_s);
    }
    std::printf(
        "%s faults on the line of the rover: %u seeds, %u phases of faults, stale %u times\n",
        failures == 0 ? "ok" : "FAIL", count, faults, stale);
    std::printf("   slowest to drive again %.2f s, longest motion while stale %.2f s\n", slowest_s,
                unwanted_s);
    return failures == 0 ? 0 : 1;
}
