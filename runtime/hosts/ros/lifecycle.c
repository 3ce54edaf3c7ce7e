#include "lifecycle.h"

#include <stdio.h>
#include <string.h>
#include <sys/socket.h>

#include <lifecycle_msgs/msg/state.h>
#include <lifecycle_msgs/msg/transition.h>
#include <lifecycle_msgs/msg/transition_description.h>
#include <lifecycle_msgs/msg/transition_event.h>
#include <lifecycle_msgs/srv/change_state.h>
#include <lifecycle_msgs/srv/get_available_states.h>
#include <lifecycle_msgs/srv/get_available_transitions.h>
#include <lifecycle_msgs/srv/get_state.h>
#include <rcl/error_handling.h>
#include <rosidl_runtime_c/string_functions.h>

#include "late.h"
#include "messages.h"

#define MACHINE(function) LATE("rcl_lifecycle", function)
#define MESSAGE(function) LATE("lifecycle_msgs__rosidl_generator_c", function)

static bool start_machine(struct lifecycle *l, rcl_node_t *node)
{
    static const char package[] = "lifecycle_msgs";
    rcl_lifecycle_state_machine_options_t options =
        MACHINE(rcl_lifecycle_get_default_state_machine_options)();
    const rosidl_service_type_support_t *transitions =
        late_service_type(package, "GetAvailableTransitions");
    options.initialize_default_states = true;
    options.enable_com_interface = true;
    options.allocator = rcl_get_default_allocator();
    l->machine = MACHINE(rcl_lifecycle_get_zero_initialized_state_machine)();
    return MACHINE(rcl_lifecycle_state_machine_init)(
               &l->machine, node, late_message_type(package, "TransitionEvent"),
               late_service_type(package, "ChangeState"), late_service_type(package, "GetState"),
               late_service_type(package, "GetAvailableStates"), transitions, transitions,
               &options) == RCL_RET_OK;
}

bool lifecycle_start(struct lifecycle *l, bool is_managed, rcl_node_t *node, int socket,
                     void (*rest)(void *context), void *context, char *why, size_t room)
{
    memset(l, 0, sizeof *l);
    pthread_mutex_init(&l->lock, NULL);
    l->is_managed = is_managed;
    l->is_active = !is_managed;
    l->socket = socket;
    l->rest = rest;
    l->context = context;
    if (!is_managed)
        return true;
    if (late_library("rcl_lifecycle") == NULL) {
        snprintf(why, room, "the ROS 2 package rcl_lifecycle is not installed: install it");
        return false;
    }
    return late_messages("lifecycle_msgs", why, room) && start_machine(l, node);
}

size_t lifecycle_services(const struct lifecycle *l)
{
    return l->is_managed ? LIFECYCLE_SERVICES : 0;
}

const rcl_service_t *lifecycle_service(const struct lifecycle *l, size_t service)
{
    const rcl_lifecycle_com_interface_t *c = &l->machine.com_interface;
    const rcl_service_t *const each[LIFECYCLE_SERVICES] = { &c->srv_change_state, &c->srv_get_state,
                                                            &c->srv_get_available_states,
                                                            &c->srv_get_available_transitions,
                                                            &c->srv_get_transition_graph };
    return each[service];
}

/* ---- State changes */

/* Sends the state to the supervisor. This message must not be lost, so the call waits for room in
 * the socket. */
static void tell_supervisor(const struct lifecycle *l, bool resets)
{
    struct ros_state message;
    memset(&message, 0, sizeof message);
    message.head.size = (uint32_t)sizeof message;
    message.head.kind = ROS_STATE;
    message.is_active = l->is_active;
    message.is_final =
        l->machine.current_state->id == lifecycle_msgs__msg__State__PRIMARY_STATE_FINALIZED;
    message.resets = resets;
    if (send(l->socket, &message, sizeof message, MSG_NOSIGNAL) < 0)
        return; /* the supervisor has ended */
}

/* Starts or stops publishing the supervisor's velocities. */
static void set_active(struct lifecycle *l, bool is_active)
{
    pthread_mutex_lock(&l->lock);
    if (l->is_active && !is_active)
        l->rest(l->context);
    l->is_active = is_active;
    pthread_mutex_unlock(&l->lock);
}

static void refuse(const struct lifecycle *l, const char *wanted)
{
    const rcl_lifecycle_state_t *state = l->machine.current_state;
    fprintf(stderr, "warning: the transition `%s` is not possible in the state `%s`", wanted,
            state->label);
    for (unsigned i = 0; i < state->valid_transition_size; i++)
        fprintf(stderr, "%s`%s`", i == 0 ? "; possible: " : ", ",
                state->valid_transitions[i].label);
    fputc('\n', stderr);
}

/* Returns the transition that the request names by its label or, without a label, by its number;
 * NULL if it is not possible now. */
static const rcl_lifecycle_transition_t *wanted(struct lifecycle *l,
                                                const lifecycle_msgs__msg__Transition *request)
{
    const rcl_lifecycle_state_t *state = l->machine.current_state;
    const rcl_lifecycle_transition_t *found;
    char name[80];
    const bool has_label = request->label.data != NULL && request->label.data[0] != '\0';
    found = has_label ? MACHINE(rcl_lifecycle_get_transition_by_label)(state, request->label.data)
                      : MACHINE(rcl_lifecycle_get_transition_by_id)(state, request->id);
    if (found != NULL)
        return found;
    rcl_reset_error();
    snprintf(name, sizeof name, "%u", (unsigned)request->id);
    refuse(l, has_label ? request->label.data : name);
    return NULL;
}

static bool change(struct lifecycle *l, const lifecycle_msgs__msg__Transition *request)
{
    const rcl_lifecycle_transition_t *transition = wanted(l, request);
    unsigned id;
    if (transition == NULL)
        return false;
    id = transition->id;
    if (id == lifecycle_msgs__msg__Transition__TRANSITION_DEACTIVATE ||
        id == lifecycle_msgs__msg__Transition__TRANSITION_ACTIVE_SHUTDOWN)
        set_active(l, false);
    if (MACHINE(rcl_lifecycle_trigger_transition_by_id)(&l->machine, (uint8_t)id, true) !=
            RCL_RET_OK ||
        MACHINE(rcl_lifecycle_trigger_transition_by_label)(&l->machine, "transition_success",
                                                           true) != RCL_RET_OK) {
        fprintf(stderr, "error: the state of the node did not change: %s\n",
                rcl_get_error_string().str);
        rcl_reset_error();
        return false;
    }
    if (id == lifecycle_msgs__msg__Transition__TRANSITION_ACTIVATE)
        set_active(l, true);
    tell_supervisor(l, id == lifecycle_msgs__msg__Transition__TRANSITION_CONFIGURE);
    return true;
}

/* ---- Answers */

static bool set_state(lifecycle_msgs__msg__State *message, const rcl_lifecycle_state_t *state)
{
    message->id = state->id;
    return rosidl_runtime_c__String__assign(&message->label, state->label);
}

static bool set_transitions(lifecycle_msgs__msg__TransitionDescription__Sequence *answer,
                            const rcl_lifecycle_transition_t *transitions, size_t count)
{
    if (!MESSAGE(lifecycle_msgs__msg__TransitionDescription__Sequence__init)(answer, count))
        return false;
    for (size_t i = 0; i < count; i++) {
        lifecycle_msgs__msg__TransitionDescription *d = &answer->data[i];
        d->transition.id = (uint8_t)transitions[i].id;
        if (!rosidl_runtime_c__String__assign(&d->transition.label, transitions[i].label) ||
            !set_state(&d->start_state, transitions[i].start) ||
            !set_state(&d->goal_state, transitions[i].goal))
            return false;
    }
    return true;
}

/* Space for a request or response of any of the services. */
union message {
    lifecycle_msgs__srv__ChangeState_Request change_request;
    lifecycle_msgs__srv__ChangeState_Response change_response;
    lifecycle_msgs__srv__GetState_Request state_request;
    lifecycle_msgs__srv__GetState_Response state_response;
    lifecycle_msgs__srv__GetAvailableStates_Request states_request;
    lifecycle_msgs__srv__GetAvailableStates_Response states_response;
    lifecycle_msgs__srv__GetAvailableTransitions_Request transitions_request;
    lifecycle_msgs__srv__GetAvailableTransitions_Response transitions_response;
};

static bool answer_change(struct lifecycle *l, const union message *request,
                          union message *response)
{
    response->change_response.success = change(l, &request->change_request.transition);
    return true;
}

static bool answer_state(struct lifecycle *l, const union message *request, union message *response)
{
    (void)request;
    return set_state(&response->state_response.current_state, l->machine.current_state);
}

static bool answer_states(struct lifecycle *l, const union message *request,
                          union message *response)
{
    const rcl_lifecycle_transition_map_t *map = &l->machine.transition_map;
    lifecycle_msgs__msg__State__Sequence *states = &response->states_response.available_states;
    bool ok = MESSAGE(lifecycle_msgs__msg__State__Sequence__init)(states, map->states_size);
    (void)request;
    for (unsigned i = 0; ok && i < map->states_size; i++)
        ok = set_state(&states->data[i], &map->states[i]);
    return ok;
}

/* Answers with the transitions that are possible now. */
static bool answer_transitions(struct lifecycle *l, const union message *request,
                               union message *response)
{
    const rcl_lifecycle_state_t *state = l->machine.current_state;
    (void)request;
    return set_transitions(&response->transitions_response.available_transitions,
                           state->valid_transitions, state->valid_transition_size);
}

static bool answer_graph(struct lifecycle *l, const union message *request, union message *response)
{
    const rcl_lifecycle_transition_map_t *map = &l->machine.transition_map;
    (void)request;
    return set_transitions(&response->transitions_response.available_transitions, map->transitions,
                           map->transitions_size);
}

#define SERVICE_FUNCTIONS(Name, name)                                                             \
    static bool init_##name(union message *request, union message *response)                      \
    {                                                                                             \
        return MESSAGE(lifecycle_msgs__srv__##Name##_Request__init)(&request->name##_request) &&  \
               MESSAGE(lifecycle_msgs__srv__##Name##_Response__init)(&response->name##_response); \
    }                                                                                             \
    static void fini_##name(union message *request, union message *response)                      \
    {                                                                                             \
        MESSAGE(lifecycle_msgs__srv__##Name##_Request__fini)(&request->name##_request);           \
        MESSAGE(lifecycle_msgs__srv__##Name##_Response__fini)(&response->name##_response);        \
    }

SERVICE_FUNCTIONS(ChangeState, change)
SERVICE_FUNCTIONS(GetState, state)
SERVICE_FUNCTIONS(GetAvailableStates, states)
SERVICE_FUNCTIONS(GetAvailableTransitions, transitions)

/* In the order of lifecycle_service. */
static const struct {
    bool (*init)(union message *request, union message *response);
    void (*fini)(union message *request, union message *response);
    bool (*answer)(struct lifecycle *l, const union message *request, union message *response);
} table[LIFECYCLE_SERVICES] = {
    { init_change, fini_change, answer_change },
    { init_state, fini_state, answer_state },
    { init_states, fini_states, answer_states },
    { init_transitions, fini_transitions, answer_transitions },
    { init_transitions, fini_transitions, answer_graph },
};

void lifecycle_take(struct lifecycle *l, size_t service)
{
    const rcl_service_t *from = lifecycle_service(l, service);
    bool taken = true;
    while (taken) {
        union message request, response;
        rmw_request_id_t id;
        memset(&request, 0, sizeof request);
        memset(&response, 0, sizeof response);
        taken = table[service].init(&request, &response) &&
                rcl_take_request(from, &id, &request) == RCL_RET_OK;
        if (!taken)
            rcl_reset_error(); /* there are no more requests */
        else if (!table[service].answer(l, &request, &response) ||
                 rcl_send_response(from, &id, &response) != RCL_RET_OK)
            rcl_reset_error();
        table[service].fini(&request, &response);
    }
}

bool lifecycle_end(struct lifecycle *l, rcl_node_t *node)
{
    return !l->is_managed ||
           MACHINE(rcl_lifecycle_state_machine_fini)(&l->machine, node) == RCL_RET_OK;
}
