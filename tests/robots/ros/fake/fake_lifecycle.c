#include "fake_ros.h"

#include <stdlib.h>
#include <string.h>

static rcl_lifecycle_state_t states[4];
static rcl_lifecycle_transition_t transitions[7] = {
    { "configure", 1, &states[0], &states[1] }, { "shutdown", 5, &states[0], &states[3] },
    { "cleanup", 2, &states[1], &states[0] },   { "activate", 3, &states[1], &states[2] },
    { "shutdown", 6, &states[1], &states[3] },  { "deactivate", 4, &states[2], &states[1] },
    { "shutdown", 7, &states[2], &states[3] },
};
static rcl_lifecycle_state_t states[4] = { { "unconfigured", 1, &transitions[0], 2 },
                                           { "inactive", 2, &transitions[2], 3 },
                                           { "active", 3, &transitions[5], 2 },
                                           { "finalized", 4, NULL, 0 } };

rcl_ret_t rcl_lifecycle_state_machine_init(rcl_lifecycle_state_machine_t *machine, rcl_node_t *node,
                                           const rosidl_message_type_support_t *event,
                                           const rosidl_service_type_support_t *change,
                                           const rosidl_service_type_support_t *state,
                                           const rosidl_service_type_support_t *all,
                                           const rosidl_service_type_support_t *possible,
                                           const rosidl_service_type_support_t *graph,
                                           const rcl_lifecycle_state_machine_options_t *options)
{
    (void)node;
    (void)event;
    (void)change;
    (void)state;
    (void)all;
    (void)possible;
    (void)graph;
    (void)options;
    machine->current_state = &states[0];
    machine->transition_map.states = states;
    machine->transition_map.states_size = 4;
    machine->transition_map.transitions = transitions;
    machine->transition_map.transitions_size = 7;
    strcpy(machine->com_interface.srv_change_state.name, "~/change_state");
    return RCL_RET_OK;
}

rcl_ret_t rcl_lifecycle_state_machine_fini(rcl_lifecycle_state_machine_t *machine, rcl_node_t *node)
{
    (void)machine;
    (void)node;
    return RCL_RET_OK;
}

const rcl_lifecycle_transition_t *
rcl_lifecycle_get_transition_by_id(const rcl_lifecycle_state_t *state, uint8_t id)
{
    for (unsigned i = 0; i < state->valid_transition_size; i++)
        if (state->valid_transitions[i].id == id)
            return &state->valid_transitions[i];
    return NULL;
}

const rcl_lifecycle_transition_t *
rcl_lifecycle_get_transition_by_label(const rcl_lifecycle_state_t *state, const char *label)
{
    for (unsigned i = 0; i < state->valid_transition_size; i++)
        if (strcmp(state->valid_transitions[i].label, label) == 0)
            return &state->valid_transitions[i];
    return NULL;
}

/* There are no intermediate states. */
rcl_ret_t rcl_lifecycle_trigger_transition_by_id(rcl_lifecycle_state_machine_t *machine, uint8_t id,
                                                 bool publishes)
{
    (void)publishes;
    machine->current_state = rcl_lifecycle_get_transition_by_id(machine->current_state, id)->goal;
    return RCL_RET_OK;
}

rcl_ret_t rcl_lifecycle_trigger_transition_by_label(rcl_lifecycle_state_machine_t *machine,
                                                    const char *label, bool publishes)
{
    (void)machine;
    (void)label;
    (void)publishes;
    return RCL_RET_OK;
}

bool fake_lifecycle_request(lifecycle_msgs__srv__ChangeState_Request *request,
                            bool (*has)(const char *fault))
{
    static const char *const names[] = { "configure",  "activate",  "deactivate", "cleanup",
                                         "configure2", "activate2", "shutdown" };
    static bool done[7];
    for (size_t i = 0; i < 7; i++) {
        if (done[i] || !has(names[i]))
            continue;
        done[i] = true;
        request->transition.label.data = strndup(names[i], strcspn(names[i], "2"));
        return true;
    }
    return false;
}

rcl_lifecycle_state_machine_options_t rcl_lifecycle_get_default_state_machine_options(void)
{
    rcl_lifecycle_state_machine_options_t options;
    memset(&options, 0, sizeof options);
    return options;
}

rcl_lifecycle_state_machine_t rcl_lifecycle_get_zero_initialized_state_machine(void)
{
    rcl_lifecycle_state_machine_t machine;
    memset(&machine, 0, sizeof machine);
    return machine;
}

#define SEQUENCE_INIT(type)                                              \
    bool type##__Sequence__init(type##__Sequence *sequence, size_t size) \
    {                                                                    \
        sequence->data = (type *)calloc(size + 1, sizeof(type));         \
        sequence->size = size;                                           \
        return sequence->data != NULL;                                   \
    }
SEQUENCE_INIT(lifecycle_msgs__msg__State)
SEQUENCE_INIT(lifecycle_msgs__msg__TransitionDescription)

const rosidl_message_type_support_t fake_lifecycle_msgs_TransitionEvent = {
    "lifecycle_msgs/msg/TransitionEvent"
};

FAKE_SERVICE(lifecycle_msgs, ChangeState)
FAKE_SERVICE(lifecycle_msgs, GetState)
FAKE_SERVICE(lifecycle_msgs, GetAvailableStates)
FAKE_SERVICE(lifecycle_msgs, GetAvailableTransitions)
