// main.cc -- runs the same two wheels from C++. A controller is an object, and its state
// is a member that can be copied like any other.
#include "wheel.h"

#include <array>
#include <cstdio>

class Wheel
{
  public:
    explicit Wheel(double wanted) : wanted_(wanted) { wheel_reset(&controller_); }

    wheel_output step(double dt)
    {
        const wheel_input in{ wanted_, speed_ };
        wheel_output out;
        wheel_step(&controller_, dt, &in, &out);
        return out;
    }

    // The speed slowly approaches 0.1 m/s per volt.
    void turn(double dt, double volts) { speed_ += dt * 2.0 * (0.1 * volts - speed_); }

    double speed() const { return speed_; }

  private:
    wheel_state controller_;
    double wanted_;
    double speed_ = 0.0;
};

int main()
{
    std::array<Wheel, 2> wheels{ Wheel(0.5), Wheel(0.8) };
    const double dt = 0.02;
    for (int step = 0; step <= 150; step++) {
        int number = 0;
        for (Wheel &wheel : wheels) {
            const wheel_output out = wheel.step(dt);
            if (step % 50 == 0)
                std::printf("%.1f s, wheel %d: %.3f m/s, %.2f V%s\n", step * dt, number,
                            wheel.speed(), out.voltage, out.settled ? ", settled" : "");
            wheel.turn(dt, out.voltage);
            number++;
        }
    }
}
