/* main.c -- runs two wheels from C, each with its own controller.
 *
 * The caller owns the states and the time: it resets each state once, then calls a step at each
 * instant, passing the time in seconds since the previous one. The two wheels share
 * no data, so each could have its own thread. */
#include "wheel.h"

#include <stdio.h>

enum { WHEELS = 2, STEPS = 150 };

/* A wheel with its motor. Its speed slowly approaches 0.1 m/s per volt. */
static double speed_after(double dt, double speed, double volts)
{
    return speed + dt * 2.0 * (0.1 * volts - speed);
}

int main(void)
{
    const double wanted[WHEELS] = { 0.5, 0.8 };
    struct wheel_state controllers[WHEELS];
    double speed[WHEELS] = { 0.0, 0.0 };
    const double dt = 0.02;

    for (int i = 0; i < WHEELS; i++)
        wheel_reset(&controllers[i]);
    for (int step = 0; step <= STEPS; step++)
        for (int i = 0; i < WHEELS; i++) {
            const struct wheel_input in = { wanted[i], speed[i] };
            struct wheel_output out;
            wheel_step(&controllers[i], dt, &in, &out);
            if (step % 50 == 0)
                printf("%.1f s, wheel %d: %.3f m/s, %.2f V%s\n", step * dt, i, speed[i],
                       out.voltage, out.settled ? ", settled" : "");
            speed[i] = speed_after(dt, speed[i], out.voltage);
        }
    return 0;
}
