#include "control.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

static const char *const words[] = { "at",   "stop",  "take", "pause", "go",
                                     "step", "speed", "key",  "touch", "hold" };

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

/* Returns the number after the first word of a request; NAN if there is none, or if more text
 * follows it. */
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
        return "this page can only watch: to send events, start the run with `--view=control`";
    control->events += (now - control->since_s) * CONTROL_EVENTS;
    control->since_s = now;
    if (control->events > CONTROL_EVENTS)
        control->events = CONTROL_EVENTS;
    if (control->events < 1.0)
        return "too many events: the maximum is 100 per second";
    if (!ring_send(control->ring, event))
        return "the event queue is full, so this event was dropped";
    control->events -= 1.0;
    return NULL;
}

static const char *key(struct control *control, const char *request)
{
    const double code = number_after(request);
    struct ring_event event = { RING_KEY, 0, 0.0, 0.0 };
    if (!(code >= 0 && code <= 0x10ffff && code == floor(code)))
        return "this is not a key code";
    event.id = (uint32_t)code;
    return send(control, &event);
}

/* Executes `touch NUMBER X Y` or `hold NUMBER X`. */
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
        return "this is not a valid console event";
    event.id = (uint32_t)numbers[0];
    event.x = numbers[1];
    event.y = holds ? now_s() : numbers[2];
    return send(control, &event);
}

static const char *pace(struct control *control, const char *request)
{
    if (!ring_permits(control->ring, RING_PACES))
        return "only simulated runs can be paused or change speed";
    if (strcmp(request, "pause") == 0 || strcmp(request, "go") == 0) {
        control->paused = request[0] == 'p';
        ring_pause(control->ring, control->paused);
    } else if (strcmp(request, "step") == 0 && control->paused) {
        ring_step(control->ring);
    } else if (begins_with(request, "speed")) {
        const double speed = number_after(request);
        if (!(speed >= 0.1 && speed <= RING_MOST_SPEED))
            return "the speed must be between 0.1 and 1000000";
        control->speed = speed;
        ring_set_speed(control->ring, speed);
    } else {
        return "this is not a valid request for a run in progress";
    }
    return NULL;
}

const char *control_in_time(const char **request)
{
    char *end;
    double age_ms;
    if (!begins_with(*request, "at"))
        return NULL;
    age_ms = now_s() * 1000.0 - strtod(*request + 2, &end);
    if (*end != ' ' || !(age_ms > -1.0))
        return "this is not a valid request for a run in progress";
    *request = end + 1;
    return age_ms > CONTROL_LATE_MS ? CONTROL_TOO_LATE : NULL;
}

bool control_was_late(struct control *control)
{
    const uint32_t before = control->late;
    control->late = ring_late(control->ring);
    return control->late != before;
}

const char *control_do(struct control *control, const char *request, bool operates)
{
    if (control->ring == NULL || ring_has_ended(control->ring))
        return "this run is over";
    if (strcmp(request, "stop") == 0) {
        ring_stop(control->ring);
        control->stopping = true;
        return NULL;
    }
    if (strcmp(request, "take") == 0)
        return NULL;
    if (!operates)
        return "another page is operating this run";
    if (ring_silence_s(control->ring) * 1000.0 > CONTROL_LATE_MS)
        return "the run is not responding, so the request was ignored";
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

static const char *fate_of(const struct ring *ring, bool host_has_ended)
{
    static const char *const fates[] = { "goes on", "stopping", "at rest", "told", "not reached" };
    return host_has_ended && !ring_has_ended(ring) ? "gone" : fates[ring_fate(ring)];
}

void control_beat(const struct control *control, bool host_has_ended, struct buffer *message)
{
    buffer_format(message, "{\"is\":\"beat\",\"time\":%.0f", floor(now_s() * 1000.0));
    if (control->ring != NULL) {
        buffer_format(message,
                      ",\"fate\":\"%s\",\"silence\":", fate_of(control->ring, host_has_ended));
        buffer_number(message, ring_silence_s(control->ring));
    }
    buffer_text(message, "}");
}
