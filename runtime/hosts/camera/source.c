#include "source.h"

#include <stdio.h>
#include <string.h>
#include <sys/stat.h>
#include <time.h>

const struct source_kind *source_kind_of(const char *name)
{
    struct stat status;
    if (strncmp(name, "http://", 7) == 0)
        return &source_http;
    if (strncmp(name, SOURCE_TOPIC, strlen(SOURCE_TOPIC)) == 0)
        return &source_topic;
    if (stat(name, &status) != 0)
        return strncmp(name, "/dev/", 5) == 0 ? &source_device : &source_stream;
    if (S_ISDIR(status.st_mode))
        return &source_folder;
    return S_ISCHR(status.st_mode) ? &source_device : &source_stream;
}

enum source_result source_fail(struct source *s, enum source_result result, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(s->fault, sizeof s->fault, format, arguments);
    va_end(arguments);
    return result;
}

int64_t source_now_ns(void)
{
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return (int64_t)now.tv_sec * 1000000000 + now.tv_nsec;
}

void source_sleep_until_ns(int64_t until_ns)
{
    struct timespec until;
    until.tv_sec = (time_t)(until_ns / 1000000000);
    until.tv_nsec = (long)(until_ns % 1000000000);
    if (until_ns > 0)
        clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &until, NULL);
}
