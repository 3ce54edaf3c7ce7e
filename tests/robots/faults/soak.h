// A host that drives a robot while the line between them fails, in phases: first no faults, then
// faults drawn from the seed, then no faults again.
//
// It checks all the time that
//   - the driver finds each valid packet at its last byte;
//   - the robot stops once the readings are stale and the line to the robot is clean;
//   - the program sees only possible values, and so does the robot.
// After each phase of faults the robot must drive again as commanded.
#pragma once

#include <cmath>
#include <cstdio>
#include <deque>
#include <string>

#include "bench.h"
#include "faults.h"

struct SoakResult {
    std::string failure; // empty if every check succeeded
    double simulated_s = 0;
    double slowest_resume_s = 0;
    double longest_unwanted_s = 0; // longest time that the robot moved although readings were stale
    unsigned faults = 0, connections = 0, stale = 0;
    unsigned limited = 0; // number of times that a damaged command set a limit, which a new
                          // connection removed
};

template <class Kind>
class Soak
{
  public:
    explicit Soak(std::uint64_t seed) : seed_(seed)
    {
        b_.to_driver.seed(random_next(&seed_));
        b_.to_robot.seed(random_next(&seed_));
        b_.acted = [this] { look(); };
        b_.sent = [this](const std::vector<std::uint8_t> &bytes) { expect(bytes); };
        b_.tick_ns = 8 * ms;
        Kind::prepare(b_);
        reconnect();
    }

    SoakResult run(double for_s)
    {
        const std::int64_t end_ns = b_.time.now_ns + static_cast<std::int64_t>(for_s * 1e9);
        const std::int64_t start_ns = b_.time.now_ns;
        while (b_.time.now_ns < end_ns && result_.failure.empty()) {
            well();
            ++result_.faults;
            begin_faults();
            drive(20 * ms + static_cast<std::int64_t>(random_below(&seed_, 3000)) * ms);
            end_faults();
        }
        well();
        frob_robot_close(&b_.robot);
        result_.simulated_s = static_cast<double>(b_.time.now_ns - start_ns) * 1e-9;
        result_.stale = b_.robot.stale;
        result_.connections = b_.robot.connections;
        return result_;
    }

  private:
    static constexpr std::int64_t patience_ns = 200 * ms; // the same as in Bench::start

    // The host: runs 30 steps a second, and reconnects a quarter of a second after a connection has
    // failed.
    void drive(std::int64_t for_ns)
    {
        const std::int64_t until_ns = b_.time.now_ns + for_ns;
        while (b_.time.now_ns < until_ns && result_.failure.empty()) {
            if (b_.state == FROB_ROBOT_READY) {
                typename Kind::Output output{};
                frob_robot_sense(&b_.robot, &b_.input);
                if (!Kind::sane(b_.input))
                    fail("the program sees what cannot be");
                output.forward = forward_;
                output.turn = turn_;
                frob_robot_command(&b_.robot, &output);
            } else if (b_.state == FROB_ROBOT_FAILED) {
                if (failed_ns_ == 0)
                    failed_ns_ = b_.time.now_ns;
                if (b_.time.now_ns - failed_ns_ >= 250 * ms && !hung_up_)
                    reconnect();
            }
            b_.run(std::min(until_ns, b_.time.now_ns + second / 30));
        }
    }

    void reconnect()
    {
        frob_fake_line_open(&b_.line, &b_.time);
        b_.line.rate = static_cast<std::uint32_t>(b_.rate);
        failed_ns_ = 0;
        expected_.clear();
        ++session_;
        b_.start();
    }

    // Without faults the robot must soon drive as commanded.
    void well()
    {
        const std::int64_t start_ns = b_.time.now_ns;
        while (result_.failure.empty()) {
            drive(100 * ms);
            const auto output = b_.wire.output();
            if (b_.state == FROB_ROBOT_READY && std::fabs(output.forward - forward_) < 0.01 &&
                std::fabs(output.turn - turn_) < 0.05)
                break;
            if (b_.time.now_ns - start_ns > 10 * second)
                fail("driving does not go on after the faults");
        }
        result_.slowest_resume_s = std::max(result_.slowest_resume_s,
                                            static_cast<double>(b_.time.now_ns - start_ns) * 1e-9);
        // Then it drives for a while with another command.
        forward_ = 0.05 * (1 + random_below(&seed_, 6)) * (random_below(&seed_, 4) == 0 ? -1 : 1);
        turn_ = 0.2 * random_below(&seed_, 4);
        drive(static_cast<std::int64_t>(200 + random_below(&seed_, 1500)) * ms);
    }

    unsigned rate(unsigned most)
    {
        // Choose low rates as often as high ones.
        return random_below(&seed_, 3) == 0 ? most >> random_below(&seed_, 10) : 0;
    }

    Faults::Rates draw()
    {
        Faults::Rates rates;
        rates.dropped = rate(20000);
        rates.doubled = rate(20000);
        rates.flipped = rate(20000);
        rates.garbage = rate(20000);
        rates.cut = rate(200);
        return rates;
    }

    void begin_faults()
    {
        Faults::Rates in = draw(), out = draw();
        if (random_below(&seed_, 4) == 0)
            in.storm = 1 + random_below(&seed_, 100);
        if (random_below(&seed_, 8) == 0)
            out.storm = 1 + random_below(&seed_, 20);
        if (random_below(&seed_, 4) == 0)
            in.held_ns = (20 + random_below(&seed_, 500)) * ms;
        b_.to_driver.set(in);
        if (random_below(&seed_, 2) == 0)
            b_.to_robot.set(out);
        if (random_below(&seed_, 6) == 0)
            b_.line.blocked = true;
        if (random_below(&seed_, 6) == 0)
            b_.line.lost = hung_up_ = true;
    }

    void end_faults()
    {
        b_.to_driver.set({});
        b_.to_robot.set({});
        b_.line.blocked = false;
        // When a lost line comes back, it is a new one.
        if (hung_up_) {
            hung_up_ = false;
            b_.wire.to_client.clear();
        }
        clean_ns_ = b_.time.now_ns;
        // Do what a user would do with a robot that has become slow.
        if (Kind::limited(b_.wire)) {
            ++result_.limited;
            frob_robot_close(&b_.robot);
            reconnect();
        }
    }

    // A reading that is sent without faults must be found when it has arrived.
    void expect(const std::vector<std::uint8_t> &bytes)
    {
        const frob_fake_queue &queue = b_.line.to_driver;
        if (!b_.to_driver.untouched() || b_.line.lost || queue.count == 0 ||
            queue.count + 256 > FROB_FAKE_ROOM || !Kind::is_reading(bytes))
            return;
        const std::size_t last = (queue.first + queue.count - 1) % FROB_FAKE_ROOM;
        expected_.push_back({ queue.arrive_ns[last], session_ });
    }

    void look()
    {
        found();
        safe();
    }

    void found()
    {
        const bool counts = b_.state == FROB_ROBOT_READY || b_.state == FROB_ROBOT_STALE;
        while (!expected_.empty() && expected_.front().arrival_ns <= b_.polled_ns) {
            const Expected e = expected_.front();
            if (counted_session_ != e.session || !counts || b_.line.lost) {
                expected_.pop_front();
                continue;
            }
            const bool missed =
                Kind::driver().sensed_ns(&b_.device) < e.arrival_ns && !Kind::doubts(b_.device);
            missed_ = missed ? missed_ + 1 : 0;
            if (missed_ > Kind::overlapped)
                fail("a valid packet was not found");
            expected_.pop_front();
        }
        counted_session_ = counts ? session_ : 0;
    }

    void safe()
    {
        const auto output = b_.wire.output();
        const bool moves = output.forward != 0 || output.turn != 0;
        if (b_.to_robot.any() || b_.line.blocked || b_.line.lost)
            clean_ns_ = b_.time.now_ns;
        // A one-byte checksum sometimes lets a damaged command through; the next command follows
        // soon.
        if (b_.time.now_ns - clean_ns_ > 200 * ms && std::fabs(output.forward) > Kind::most_m_s)
            fail("the robot is told what it cannot do");
        const std::int64_t sensed_ns = Kind::driver().sensed_ns(&b_.device);
        const bool fresh =
            sensed_ns != INT64_MIN && b_.time.now_ns - sensed_ns <= patience_ns + 40 * ms;
        if ((b_.state == FROB_ROBOT_READY && fresh) || !moves) {
            unwanted_ns_ = 0;
            return;
        }
        if (unwanted_ns_ == 0)
            unwanted_ns_ = b_.time.now_ns;
        const double unwanted_s = static_cast<double>(b_.time.now_ns - unwanted_ns_) * 1e-9;
        result_.longest_unwanted_s = std::max(result_.longest_unwanted_s, unwanted_s);
        // A robot that waits for the rest of a packet that garbage began does not hear a
        // stop until its watchdog ends the wait; a robot that does hear stops immediately.
        const std::int64_t hearing_ns = b_.time.now_ns - clean_ns_ - Kind::hearing_ms * ms;
        if (hearing_ns > 0 && b_.time.now_ns - unwanted_ns_ > std::min(hearing_ns, 120 * ms))
            fail("the robot moves though readings are stale");
        if (Kind::watchdog_s > 0 && unwanted_s > Kind::watchdog_s + 3.5)
            fail("the robot's watchdog does not stop it");
    }

    void fail(const char *what)
    {
        char text[200];
        if (!result_.failure.empty())
            return;
        std::snprintf(text, sizeof text, "%s, %.3f s after the start", what,
                      static_cast<double>(b_.time.now_ns - second) * 1e-9);
        result_.failure = text;
    }

    struct Expected {
        std::int64_t arrival_ns;
        unsigned session;
    };

    Bench<Kind, Faults> b_;
    std::uint64_t seed_;
    SoakResult result_;
    double forward_ = 0.2, turn_ = 0;
    bool hung_up_ = false;
    std::int64_t failed_ns_ = 0, clean_ns_ = 0, unwanted_ns_ = 0;
    unsigned session_ = 0, counted_session_ = 0, missed_ = 0;
    std::deque<Expected> expected_;
};
