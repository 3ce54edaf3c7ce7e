#include "strangers.h"

#include <libwebsockets.h>

#include <string.h>

void strangers_remove(struct strangers *strangers, struct lws *wsi)
{
    size_t i = 0;
    while (i < strangers->count && strangers->each[i] != wsi)
        i++;
    if (i == strangers->count)
        return;
    strangers->count--;
    memmove(strangers->each + i, strangers->each + i + 1,
            (strangers->count - i) * sizeof strangers->each[0]);
}

void strangers_end_one(struct strangers *strangers)
{
    if (strangers->count == 0)
        return;
    lws_set_timeout(strangers->each[0], PENDING_TIMEOUT_USER_REASON_BASE, LWS_TO_KILL_ASYNC);
    strangers_remove(strangers, strangers->each[0]);
}

void strangers_add(struct strangers *strangers, struct lws *wsi)
{
    if (strangers->count == STRANGERS)
        strangers_end_one(strangers);
    strangers->each[strangers->count++] = wsi;
}

void strangers_hear(struct strangers *strangers, struct lws *wsi)
{
    const size_t count = strangers->count;
    strangers_remove(strangers, wsi);
    if (strangers->count < count)
        strangers->each[strangers->count++] = wsi;
}
