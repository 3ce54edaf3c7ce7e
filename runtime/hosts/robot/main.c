/* The main program of an executable that drives a robot on a serial line: `frobc build` links it
 * with a compiled program, and `frobc run --device` starts it. Exit status: see host.h. */
#include "../common/streams.h"
#include "drivers.h"
#include "host.h"

#include <stdio.h>

enum { WRONG_USE = 2 };

/* The compiled program. */
extern const struct frob_program frob_program;

int main(int argc, char **argv)
{
    const struct frob_driver *driver = find_driver(frob_program.robot);
    if (driver == NULL) {
        streams_open();
        if (frob_program.robot[0] == '\0')
            fprintf(stderr, "error: %s is not a program for a robot; there are drivers for %s\n",
                    frob_program.name, driver_names);
        else
            fprintf(
                stderr,
                "error: %s is a program for %s, which has no driver; there are drivers for %s\n",
                frob_program.name, frob_program.robot, driver_names);
        return WRONG_USE;
    }
    return host_run(argc, argv, &frob_program, driver, NULL);
}
