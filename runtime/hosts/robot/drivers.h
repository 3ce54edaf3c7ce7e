/* drivers.h -- the drivers that are built into this host. */
#ifndef FROB_HOST_ROBOT_DRIVERS_H
#define FROB_HOST_ROBOT_DRIVERS_H

#include "drivers/driver.h"

/* The driver of a robot; NULL if there is none. */
const struct frob_driver *find_driver(const char *robot);

/* The names of the robots, with commas. */
extern const char driver_names[];

#endif
