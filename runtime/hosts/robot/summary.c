#include "summary.h"

#include <stdio.h>
#include <stdlib.h>

#include "../common/streams.h"
#include <frob/result.h>

static void print_result(const struct run *s)
{
    size_t room = frob_result_room(s->program);
    char *buffer = (char *)malloc(room);
    struct frob_text text;
    printf("finished after: %.3f s\n", (double)s->ended_ns * 1e-9);
    if (buffer == NULL)
        return;
    text = frob_text_in(buffer, room);
    frob_result_write(&text, s->program, s->output);
    printf("result: %s\n", text.data);
    free(buffer);
}

bool summary_print(const struct run *s)
{
    const char *who = s->driver->describe(s->device);
    printf("robot: %s\n", who[0] != '\0' ? who : s->driver->robot);
    printf("time run: %.3f s\n", (double)s->instant_ns * 1e-9);
    printf("steps: %llu\n", (unsigned long long)s->steps);
    printf("overruns: %llu\n", (unsigned long long)s->overruns);
    printf("late steps: %llu\n", (unsigned long long)s->late_steps);
    printf("longest step: %.3f ms\n", (double)s->longest_ns * 1e-6);
    printf("stale readings: %lu\n", (unsigned long)s->robot.stale);
    printf("connections: %lu\n", (unsigned long)s->robot.connections);
    cameras_print(&s->cameras);
    if (s->options->record != NULL)
        printf("log: %s\n", s->options->record);
    if (s->ended)
        print_result(s);
    claims_print(&s->claims, stdout, "");
    return streams_flush();
}
