#include "control.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

static const char *const words[] = { "stop",  "take", "pause", "go",  "step",
                                     "speed", "key",  "touch", "hold" };

static bool begins_with(const char *request, const char *word)
{
    const size_t length = strlen(word);
    return strncmp(request, word, length) == 0 &&
           (request[length] == '\0' || request[length] == ' ');
}

bool control_is(const char *request)
{
    for (size_t i = 0; i < sizeof words / sizeof words[0]; i++)
        if (begins_with(request, words[i]))
            return true;
    return false;
}

void control_start(struct control *control, struct ring *ring)
{
    memset(control, 0, sizeof *control);
    control->ring = ring;
    control->speed = 1.0;
    control->events = CONTROL_EVENTS;
}

/* The number after a word; NAN if there is none, or more than it. */
static double number_after(const char *request)
{
    const char *blank = strchr(request, ' ');
    char *end;
    double x;
    if (blank == NULL || blank[1] < '0' || blank[1] > '9')
        return NAN;
    x = strtod(blank + 1, &end);
    return *end == '\0' ? x : (double)NAN;
}

static double now_s(void)
{
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return (double)now.tv_sec + (double)now.tv_nsec / 1e9;
}

static const char *send(struct control *control, const struct ring_event *event)
{
    const double now = now_s();
    if (!ring_permits(control->ring, RING_SENDS))
        return "this robot is only looked at: `--view=control` lets a page do more";
    control->events += (now - control->since_s) * CONTROL_EVENTS;
    control->since_s = now;
    if (control->events > CONTROL_EVENTS)
        control->events = CONTROL_EVENTS;
    if (control->events < 1.0)
        return "these are too many events: a hundred in a second is the most";
    if (!ring_send(control->ring, event))
        return "so many events wait already that this one is dropped";
    control->events -= 1.0;
    return NULL;
}

static const char *key(struct control *control, const char *request)
{
    const double code = number_after(request);
    struct ring_event event = { RING_KEY, 0, 0.0, 0.0 };
    if (!(code >= 0 && code <= 0x10ffff && code == floor(code)))
        return "this is no key";
    event.id = (uint32_t)code;
    return send(control, &event);
}

/* touch NUMBER X Y, hold NUMBER X. */
static const char *touch(struct control *control, const char *request)
{
    const bool holds = begins_with(request, "hold");
    struct ring_event event = { holds ? RING_HOLD : RING_TOUCH, 0, 0.0, 0.0 };
    double numbers[3] = { NAN, NAN, 0.0 };
    const char *at = strchr(request, ' ');
    for (size_t i = 0; i < (holds ? 2 : 3) && at != NULL && *at == ' '; i++) {
        char *end;
        numbers[i] = strtod(at + 1, &end);
        at = end == at + 1 ? NULL : end;
    }
    if (at == NULL || *at != '\0' || !isfinite(numbers[1]) || !isfinite(numbers[2]) ||
        !(numbers[0] >= 0.0 && numbers[0] <= 1e6 && numbers[0] == floor(numbers[0])))
        return "this is nothing on a console";
    event.id = (uint32_t)numbers[0];
    event.x = numbers[1];
    event.y = holds ? now_s() : numbers[2];
    return send(control, &event);
}

static const char *pace(struct control *control, const char *request)
{
    if (!ring_permits(control->ring, RING_PACES))
        return "only a simulated run can be paused or made faster";
    if (strcmp(request, "pause") == 0 || strcmp(request, "go") == 0) {
        control->paused = request[0] == 'p';
        ring_pause(control->ring, control->paused);
    } else if (strcmp(request, "step") == 0 && control->paused) {
        ring_step(control->ring);
    } else if (begins_with(request, "speed")) {
        const double speed = number_after(request);
        if (!(speed >= 0.1 && speed <= 100.0))
            return "a speed is from 0.1 to 100";
        control->speed = speed;
        ring_set_speed(control->ring, speed);
    } else {
        return "this is no request, or not while the run goes on";
    }
    return NULL;
}

const char *control_do(struct control *control, const char *request, bool operates)
{
    if (control->ring == NULL)
        return "this run is over";
    if (strcmp(request, "stop") == 0) {
        ring_stop(control->ring);
        control->stopping = true;
        return NULL;
    }
    if (strcmp(request, "take") == 0)
        return NULL;
    if (!operates)
        return "another page operates this run";
    if (begins_with(request, "touch") || begins_with(request, "hold"))
        return touch(control, request);
    return begins_with(request, "key") ? key(control, request) : pace(control, request);
}

void control_state(const struct control *control, bool operates, struct buffer *message)
{
    const struct ring *ring = control->ring;
    buffer_format(message,
                  "{\"is\":\"run\",\"operates\":%s,\"paces\":%s,\"sends\":%s,\"stopping\":%s,"
                  "\"paused\":%s,\"speed\":",
                  operates ? "true" : "false", ring_permits(ring, RING_PACES) ? "true" : "false",
                  ring_permits(ring, RING_SENDS) ? "true" : "false",
                  control->stopping ? "true" : "false", control->paused ? "true" : "false");
    buffer_number(message, control->speed);
    buffer_text(message, "}");
}
