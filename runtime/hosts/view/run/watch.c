#include "watch.h"

#include <stdlib.h>

bool watch_start(struct watch *watch, const struct frob_program *program)
{
    watch->each = (struct watched *)calloc(program->claim_count + 1, sizeof *watch->each);
    return claims_open(&watch->claims, program) && watch->each != NULL;
}

void watch_end(struct watch *watch)
{
    for (size_t i = 0; watch->each != NULL && i < watch->claims.program->claim_count; i++)
        free(watch->each[i].ends);
    free(watch->each);
    claims_close(&watch->claims);
}

/* Adds the start or end of a violation. If memory runs out, leaves the list unchanged. */
static void add(struct watched *watched, size_t k)
{
    if (watched->count == watched->room) {
        const size_t room = 2 * watched->room + 16;
        size_t *ends = (size_t *)realloc(watched->ends, room * sizeof *ends);
        if (ends == NULL)
            return;
        watched->ends = ends;
        watched->room = room;
    }
    watched->ends[watched->count++] = k;
}

void watch_see(struct watch *watch, size_t k, int64_t time_ns, const void *output)
{
    struct claims *claims = &watch->claims;
    claims_see(claims, time_ns, output);
    for (size_t i = 0; i < claims->program->claim_count; i++) {
        const bool had_failed = watch->each[i].count % 2 == 1;
        if (claims->each[i].fails != had_failed)
            add(&watch->each[i], k);
    }
}
