#include "host.h"

#include "../common/params.h"
#include "../common/streams.h"
#include "options.h"
#include "supervisor.h"

#include <stdio.h>
#include <stdlib.h>

#include <frob/arithmetic.h>

#include "core/robot.h"

enum { DONE = 0, WRONG_USE = 2 };

int host_run(int argc, char **argv, const struct frob_program *program,
             const struct frob_driver *driver, const struct line_opening *opening)
{
    struct options options;
    struct params params;
    int status = WRONG_USE;
    /* Checks not only the program's arithmetic but also this host's, because the host limits the
     * program's commands. */
    const unsigned faults = program->arithmetic() | frob_arithmetic_faults();
    streams_open();
    if (program->input_size < driver->input_size || program->output_size < driver->output_size ||
        driver->output_size > FROB_OUTPUT_MOST || driver->setting_count > SETTINGS_MOST) {
        fprintf(stderr,
                "error: %s was compiled with another version of <frob/%s.h>; compile it again\n",
                program->name, driver->robot);
        return WRONG_USE;
    }
    if (faults != 0) {
        fprintf(stderr, "error: %s must not drive a robot: its arithmetic %s\n", program->name,
                frob_arithmetic_reason(faults));
        return WRONG_USE;
    }
    switch (read_options(argc, argv, program, driver, opening, &options)) {
    case OPTIONS_RUN:
        if (params_open(&params, program, options.params, options.param_count))
            status = supervise(&params, driver, &options);
        params_close(&params);
        break;
    case OPTIONS_SHOWN: status = DONE; break;
    case OPTIONS_WRONG: break;
    }
    free(options.params);
    return status;
}
