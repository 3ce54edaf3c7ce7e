/* The main program of an executable that drives a robot: `frobc build` links it with a compiled
 * program, and `frobc run --device` starts it.
 *
 * Exit status: 0; 2 for wrong usage, arithmetic that the program was not compiled for
 * (<frob/arithmetic.h>), or a device that cannot be opened; 4 if the run was ended by a signal or a
 * fault, after the robot was stopped. */
#include "../common/params.h"
#include "../common/streams.h"
#include "drivers.h"
#include "options.h"
#include "supervisor.h"

#include <stdio.h>
#include <stdlib.h>

#include <frob/arithmetic.h>

#include "core/robot.h"

enum { DONE = 0, WRONG_USE = 2 };

/* The compiled program. */
extern const struct frob_program frob_program;

int main(int argc, char **argv)
{
    struct options options;
    struct params params;
    int status = WRONG_USE;
    const struct frob_driver *driver = find_driver(frob_program.robot);
    /* Check both the program and the code that limits its commands. */
    const unsigned faults = frob_program.arithmetic() | frob_arithmetic_faults();
    streams_open();
    if (driver == NULL) {
        fprintf(stderr,
                "error: %s is a program for %s, which has no driver; the drivers are for %s\n",
                frob_program.name, frob_program.robot[0] != '\0' ? frob_program.robot : "no robot",
                driver_names);
        return WRONG_USE;
    }
    if (frob_program.input_size < driver->input_size ||
        frob_program.output_size < driver->output_size || driver->output_size > FROB_OUTPUT_MOST ||
        driver->setting_count > SETTINGS_MOST) {
        fprintf(stderr,
                "error: %s was compiled with another version of <frob/%s.h>; compile it again\n",
                frob_program.name, driver->robot);
        return WRONG_USE;
    }
    if (faults != 0) {
        fprintf(stderr, "error: %s must not drive a robot: its arithmetic %s\n", frob_program.name,
                frob_arithmetic_reason(faults));
        return WRONG_USE;
    }
    switch (read_options(argc, argv, &frob_program, driver, &options)) {
    case OPTIONS_RUN:
        if (params_open(&params, &frob_program, options.params, options.param_count))
            status = supervise(&params, driver, &options);
        params_close(&params);
        break;
    case OPTIONS_SHOWN: status = DONE; break;
    case OPTIONS_WRONG: break;
    }
    free(options.params);
    return status;
}
