#include "drivers.h"

#include <string.h>

#include "drivers/create/create.h"
#include "drivers/pioneer/pioneer.h"
#include "drivers/scout/scout.h"

static const struct frob_driver *const drivers[] = { &frob_pioneer_driver, &frob_scout_driver,
                                                     &frob_create_driver };

const char driver_names[] = "pioneer, scout, create";

const struct frob_driver *find_driver(const char *robot)
{
    for (size_t i = 0; i < sizeof drivers / sizeof drivers[0]; i++)
        if (strcmp(drivers[i]->robot, robot) == 0)
            return drivers[i];
    return NULL;
}
