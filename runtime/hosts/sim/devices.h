/* devices.h -- the simulated lidars and inertial measurement units that the program uses. */
#ifndef FROB_SIM_DEVICES_H
#define FROB_SIM_DEVICES_H

#include <frob/program.h>
#include <sim.h>

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

struct devices {
    const struct frob_program *program;
    struct frob_sim *sim;
    /* For each control on the console: the number of its lidar or inertial measurement unit in the
     * simulation; -1 for other controls. */
    int *numbers;
};

/* Opens the devices that the program's console names. Prints a line on standard error and returns
 * false if memory runs out or the world lacks a device. The caller must call devices_close in this
 * case, too. */
bool devices_open(struct devices *d, const struct frob_program *program, struct frob_sim *sim);

/* Sets the events of all devices in a robot's input for this instant. */
void devices_give(const struct devices *d, size_t robot, int64_t now_ns, void *input);

void devices_close(struct devices *d);

#endif
