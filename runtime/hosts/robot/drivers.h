/* drivers.h -- the drivers built into this host. */
#ifndef FROB_HOST_ROBOT_DRIVERS_H
#define FROB_HOST_ROBOT_DRIVERS_H

#include "drivers/driver.h"

/* Returns the driver of a robot; NULL if there is none. */
const struct frob_driver *find_driver(const char *robot);

/* The names of the robots with built-in drivers, separated by commas. */
extern const char driver_names[];

#endif
