/* services.h -- the services with which other nodes read and set the parameters of the node, and
 * the topic /parameter_events. */
#ifndef FROB_HOST_ROS_SERVICES_H
#define FROB_HOST_ROS_SERVICES_H

#include "parameters.h"

#include <pthread.h>

#include <rcl/rcl.h>

enum { SERVICES = 6 };

struct services {
    struct parameters parameters; /* guarded by the lock */
    pthread_mutex_t lock;
    const rcl_node_t *node;
    int socket; /* socket to the supervisor */
    rcl_service_t each[SERVICES];
    rcl_publisher_t events;
};

/* Offers the services. `parameters` must be filled in. Returns NULL, or the name of a service or
 * topic that rcl refuses. */
const char *services_start(struct services *services, const rcl_node_t *node, int socket);

/* Answers the requests to a service. */
void services_take(struct services *services, size_t service);

/* Sends the supervisor a value that the ROS arguments set. */
void services_set_initial(void *services, struct parameter *parameter, double value);

/* Handles a new value that the operator has set with a control on the program's console. */
void services_note(struct services *services, size_t control, double value);

/* Returns false if rcl reports an error. */
bool services_end(struct services *services, rcl_node_t *node);

#endif
