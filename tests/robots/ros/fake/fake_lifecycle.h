/* fake_lifecycle.h -- the part of rcl_lifecycle and lifecycle_msgs that the host uses. */
#ifndef FAKE_LIFECYCLE_H
#define FAKE_LIFECYCLE_H

typedef struct rcl_lifecycle_transition_s rcl_lifecycle_transition_t;
typedef struct {
    const char *label;
    uint8_t id;
    rcl_lifecycle_transition_t *valid_transitions;
    unsigned valid_transition_size;
} rcl_lifecycle_state_t;
struct rcl_lifecycle_transition_s {
    const char *label;
    unsigned id;
    rcl_lifecycle_state_t *start, *goal;
};
typedef struct {
    rcl_lifecycle_state_t *states;
    unsigned states_size;
    rcl_lifecycle_transition_t *transitions;
    unsigned transitions_size;
} rcl_lifecycle_transition_map_t;
typedef struct {
    rcl_service_t srv_change_state, srv_get_state, srv_get_available_states,
        srv_get_available_transitions, srv_get_transition_graph;
} rcl_lifecycle_com_interface_t;
typedef struct {
    bool initialize_default_states, enable_com_interface;
    rcl_allocator_t allocator;
} rcl_lifecycle_state_machine_options_t;
typedef struct {
    const rcl_lifecycle_state_t *current_state;
    rcl_lifecycle_transition_map_t transition_map;
    rcl_lifecycle_com_interface_t com_interface;
} rcl_lifecycle_state_machine_t;

static const char rcl_lifecycle_transition_success_label[] = "transition_success";
rcl_lifecycle_state_machine_options_t rcl_lifecycle_get_default_state_machine_options(void);
rcl_lifecycle_state_machine_t rcl_lifecycle_get_zero_initialized_state_machine(void);
rcl_ret_t rcl_lifecycle_state_machine_init(rcl_lifecycle_state_machine_t *machine, rcl_node_t *node,
                                           const rosidl_message_type_support_t *event,
                                           const rosidl_service_type_support_t *change,
                                           const rosidl_service_type_support_t *state,
                                           const rosidl_service_type_support_t *states,
                                           const rosidl_service_type_support_t *transitions,
                                           const rosidl_service_type_support_t *graph,
                                           const rcl_lifecycle_state_machine_options_t *options);
rcl_ret_t rcl_lifecycle_state_machine_fini(rcl_lifecycle_state_machine_t *machine,
                                           rcl_node_t *node);
const rcl_lifecycle_transition_t *
rcl_lifecycle_get_transition_by_id(const rcl_lifecycle_state_t *state, uint8_t id);
const rcl_lifecycle_transition_t *
rcl_lifecycle_get_transition_by_label(const rcl_lifecycle_state_t *state, const char *label);
rcl_ret_t rcl_lifecycle_trigger_transition_by_id(rcl_lifecycle_state_machine_t *machine, uint8_t id,
                                                 bool publishes);
rcl_ret_t rcl_lifecycle_trigger_transition_by_label(rcl_lifecycle_state_machine_t *machine,
                                                    const char *label, bool publishes);

enum { lifecycle_msgs__msg__State__PRIMARY_STATE_FINALIZED = 4 };
enum {
    lifecycle_msgs__msg__Transition__TRANSITION_CONFIGURE = 1,
    lifecycle_msgs__msg__Transition__TRANSITION_ACTIVATE = 3,
    lifecycle_msgs__msg__Transition__TRANSITION_DEACTIVATE = 4,
    lifecycle_msgs__msg__Transition__TRANSITION_ACTIVE_SHUTDOWN = 7
};
typedef struct {
    uint8_t id;
    rosidl_runtime_c__String label;
} lifecycle_msgs__msg__State, lifecycle_msgs__msg__Transition;
SEQUENCE(lifecycle_msgs__msg__State);
typedef struct {
    lifecycle_msgs__msg__Transition transition;
    lifecycle_msgs__msg__State start_state, goal_state;
} lifecycle_msgs__msg__TransitionDescription;
SEQUENCE(lifecycle_msgs__msg__TransitionDescription);
typedef struct {
    lifecycle_msgs__msg__Transition transition;
} lifecycle_msgs__srv__ChangeState_Request;
typedef struct {
    bool success;
} lifecycle_msgs__srv__ChangeState_Response;
typedef struct {
    int unused;
} lifecycle_msgs__srv__GetState_Request, lifecycle_msgs__srv__GetAvailableStates_Request,
    lifecycle_msgs__srv__GetAvailableTransitions_Request;
typedef struct {
    lifecycle_msgs__msg__State current_state;
} lifecycle_msgs__srv__GetState_Response;
typedef struct {
    lifecycle_msgs__msg__State__Sequence available_states;
} lifecycle_msgs__srv__GetAvailableStates_Response;
typedef struct {
    lifecycle_msgs__msg__TransitionDescription__Sequence available_transitions;
} lifecycle_msgs__srv__GetAvailableTransitions_Response;

extern const rosidl_message_type_support_t fake_lifecycle_msgs_TransitionEvent;
#define LIFECYCLE_SERVICE(Name)                                                \
    extern const rosidl_service_type_support_t fake_lifecycle_msgs_srv_##Name; \
    bool lifecycle_msgs__srv__##Name##_Request__init(void *message);           \
    bool lifecycle_msgs__srv__##Name##_Response__init(void *message);          \
    void lifecycle_msgs__srv__##Name##_Request__fini(void *message);           \
    void lifecycle_msgs__srv__##Name##_Response__fini(void *message);
LIFECYCLE_SERVICE(ChangeState)
LIFECYCLE_SERVICE(GetState)
LIFECYCLE_SERVICE(GetAvailableStates)
LIFECYCLE_SERVICE(GetAvailableTransitions)

/* Fills in the next request of another node to change the state, after the time of the fault with
 * the transition's name ("activate"; "activate2" for the second time). Returns false if none is due.
 * `has` tells whether that time has come. */
bool fake_lifecycle_request(lifecycle_msgs__srv__ChangeState_Request *request,
                            bool (*has)(const char *fault));

#endif
