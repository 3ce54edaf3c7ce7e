/* lifecycle.h -- the state machine of a managed node (`--lifecycle`), which other nodes configure,
 * activate and deactivate.
 *
 * The node publishes velocities only while it is active. On deactivation, it immediately publishes
 * a velocity of zero, without waiting for the supervisor, and then informs the supervisor of the
 * new state. A node that is not managed is always active. */
#ifndef FROB_HOST_ROS_LIFECYCLE_H
#define FROB_HOST_ROS_LIFECYCLE_H

#include <pthread.h>
#include <stdbool.h>
#include <stddef.h>

#include <rcl/rcl.h>
#include <rcl_lifecycle/rcl_lifecycle.h>

enum { LIFECYCLE_SERVICES = 5 };

struct lifecycle {
    bool is_managed;
    rcl_lifecycle_state_machine_t machine;
    int socket;                  /* socket to the supervisor */
    void (*rest)(void *context); /* publishes zero */
    void *context;
    pthread_mutex_t lock; /* guards `is_active`; held while a velocity is published */
    bool is_active;
};

/* Starts in the state `unconfigured` if the node is managed. Returns false on failure. Then `why`
 * contains the reason, or is empty if rcl reports the error. */
bool lifecycle_start(struct lifecycle *l, bool is_managed, rcl_node_t *node, int socket,
                     void (*rest)(void *context), void *context, char *why, size_t room);

/* Number of services that the node waits for: LIFECYCLE_SERVICES or 0. */
size_t lifecycle_services(const struct lifecycle *l);
const rcl_service_t *lifecycle_service(const struct lifecycle *l, size_t service);

/* Answers the requests to a service. */
void lifecycle_take(struct lifecycle *l, size_t service);

/* Returns false if rcl reports an error. */
bool lifecycle_end(struct lifecycle *l, rcl_node_t *node);

#endif
