#include "line.h"

#include <string.h>

#define RETRY_NS INT64_C(100000000)
#define BY_ID "/dev/serial/by-id"

void line_init(struct line *line, const char *device, uint32_t rate)
{
    memset(line, 0, sizeof *line);
    line->device = device;
    line->rate = rate;
    line->port.fd = -1;
}

void line_init_opening(struct line *line, const struct line_opening *opening,
                       const char *const *arguments, size_t argument_count, const double *settings,
                       const struct params *params)
{
    line_init(line, NULL, 0);
    line->opening = opening;
    line->arguments = arguments;
    line->argument_count = argument_count;
    line->settings = settings;
    line->params = params;
}

enum frob_status line_open(struct line *line, char *message, size_t room)
{
    enum frob_status status;
    if (line->opening != NULL)
        return line->opening->open(line, line->settings, message, room);
    status = frob_posix_open(&line->port, line->device, line->rate, message, room);
    if (status == FROB_OK &&
        !frob_posix_lasting_name(BY_ID, line->device, line->lasting, sizeof line->lasting))
        line->lasting[0] = '\0';
    return status;
}

bool line_reopen(struct line *line, int64_t now_ns)
{
    const char *device = line->lasting[0] != '\0' ? line->lasting : line->device;
    if (now_ns < line->retry_ns)
        return false;
    line->retry_ns = now_ns + RETRY_NS;
    if (line->opening != NULL) {
        char message[512];
        return line->opening->open(line, line->settings, message, sizeof message) == FROB_OK;
    }
    /* Prefers the persistent name, because the old path may now belong to another
     * device. */
    return frob_posix_reopen(&line->port, device, line->rate) == FROB_OK;
}

void line_close(struct line *line)
{
    frob_posix_close(&line->port);
    if (line->opening != NULL)
        line->opening->close(line);
    line->retry_ns = 0;
}

bool line_is_open(const struct line *line)
{
    return line->port.fd >= 0;
}
