#include "drivers.h"

#include <string.h>

#include "drivers/create/create.h"
#include "drivers/pioneer/pioneer.h"
#include "drivers/scout/scout.h"

/* The driver of the program's user-defined robot; NULL if the robot is not user-defined. frobc
 * generates the definition. */
extern const struct frob_driver *const frob_own_driver;

static const struct frob_driver *const drivers[] = { &frob_pioneer_driver, &frob_scout_driver,
                                                     &frob_create_driver };

const char driver_names[] = "pioneer, scout, create";

const struct frob_driver *find_driver(const char *robot)
{
    if (frob_own_driver != NULL && strcmp(frob_own_driver->robot, robot) == 0)
        return frob_own_driver;
    for (size_t i = 0; i < sizeof drivers / sizeof drivers[0]; i++)
        if (strcmp(drivers[i]->robot, robot) == 0)
            return drivers[i];
    return NULL;
}
