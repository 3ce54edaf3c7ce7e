#include "run.h"

#include <stdarg.h>
#include <stdio.h>

#include "hal/posix/clock.h"

int64_t run_now_ns(void)
{
    return frob_now_ns(&frob_posix_clock);
}

int64_t run_program_ns(const struct run *s, int64_t now)
{
    const struct line_opening *opening = s->line.opening;
    return opening != NULL && opening->time_ns != NULL ? opening->time_ns(s->device, now) : now;
}

bool run_follows_our_clock(const struct run *s, int64_t now)
{
    return run_program_ns(s, now) == now;
}

void run_tell(const struct run *s, const char *format, ...)
{
    va_list arguments;
    if (!s->tells)
        return;
    va_start(arguments, format);
    vfprintf(stderr, format, arguments);
    va_end(arguments);
    fputc('\n', stderr);
}

void run_end(struct run *s, int status, const char *format, ...)
{
    va_list arguments;
    if (s->over)
        return;
    s->over = true;
    s->status = status;
    va_start(arguments, format);
    vsnprintf(s->cause, sizeof s->cause, format, arguments);
    va_end(arguments);
}
