#include "bumpers.h"

#include <stdio.h>
#include <string.h>

/* The labels are those in the library's module Ros. */
static const struct {
    const char *label, *topic, *function;
} bumpers[] = {
    { "left bumper", "bumper_left", "bumpedLeft" },
    { "right bumper", "bumper_right", "bumpedRight" },
    { "back bumper", "bumper_back", "bumpedBehind" },
};

enum { BUMPERS = sizeof bumpers / sizeof bumpers[0] };

/* Returns the index of the bumper, or BUMPERS if there is none. */
static size_t find(const struct frob_control *control)
{
    size_t i = 0;
    while (i < BUMPERS &&
           (control->kind != FROB_HOLD || strcmp(control->label, bumpers[i].label) != 0))
        i++;
    return i;
}

const char *bumpers_topic(const struct frob_control *control)
{
    const size_t i = find(control);
    return i < BUMPERS ? bumpers[i].topic : NULL;
}

/* Returns whether an argument is a rule that remaps the topic:
 * `bumper_left:=TOPIC`, or `NODE:bumper_left:=TOPIC`. */
static bool is_remapped(const char *topic, const char *const *arguments, size_t count)
{
    char rule[64];
    snprintf(rule, sizeof rule, "%s:=", topic);
    for (size_t i = 0; i < count; i++) {
        const char *found = strstr(arguments[i], rule);
        if (found != NULL && (found == arguments[i] || found[-1] == ':' || found[-1] == '/'))
            return true;
    }
    return false;
}

bool bumpers_check(const struct frob_program *program, const char *const *arguments, size_t count,
                   char *message, size_t room)
{
    for (size_t i = 0; i < program->control_count; i++) {
        const size_t k = find(&program->console[i]);
        if (k == BUMPERS || is_remapped(bumpers[k].topic, arguments, count))
            continue;
        snprintf(message, room,
                 "%s: %s reads the %s of the robot (`%s`), but no topic is configured for it: add "
                 "`--ros-args -r %s:=TOPIC`, with a topic of the type std_msgs/msg/Bool",
                 program->console[i].place, program->name, bumpers[k].label, bumpers[k].function,
                 bumpers[k].topic);
        return false;
    }
    return true;
}
