#include "many.h"

#include <errno.h>
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { MOST_SETTINGS = 64 };

struct job {
    const char *key;
    uint64_t seed;
    const char *settings[MOST_SETTINGS];
    size_t count;
};

/* Splits a line in place. */
static bool read_job(char *line, struct job *job)
{
    char *cell = strtok(line, "\t\n"), *end;
    job->key = cell;
    job->count = 0;
    cell = cell == NULL ? NULL : strtok(NULL, "\t\n");
    if (cell == NULL)
        return false;
    job->seed = strtoull(cell, &end, 10);
    while ((cell = strtok(NULL, "\t\n")) != NULL && job->count < MOST_SETTINGS)
        job->settings[job->count++] = cell;
    return *end == '\0' && cell == NULL;
}

static uint64_t checksum(const char *text)
{
    uint64_t hash = UINT64_C(14695981039346656037);
    for (; *text != '\0'; text++)
        hash = (hash ^ (unsigned char)*text) * UINT64_C(1099511628211);
    return hash;
}

/* Writes a line with `key`, the text of `said` up to its line feed, and a checksum. */
static bool write_line(const char *key, char *said)
{
    const size_t room = strlen(key) + strlen(said) + 2;
    char *line = (char *)malloc(room);
    bool ok = line != NULL;
    if (ok) {
        said[strcspn(said, "\n")] = '\0';
        snprintf(line, room, "%s\t%s", key, said);
        ok = printf("%s\t%016" PRIx64 "\n", line, checksum(line)) > 0 && fflush(stdout) == 0;
        if (!ok)
            fprintf(stderr, "error: cannot write the result of a run: %s\n", strerror(errno));
    }
    free(line);
    return ok;
}

/* Sets the judge's parameters that have the same names as the program's. */
static bool set_judge(struct trial *trial, const struct job *job, struct params *params)
{
    char why[PARAMS_WHY];
    if (!params_open(params, trial->judge, NULL, 0))
        return false;
    for (size_t i = 0; i < job->count; i++)
        params_read(params, job->settings[i], why);
    if (trial->judge->param_count > 0)
        trial->params = params->values;
    return true;
}

static bool one_run(struct trial *trial, const struct options *options,
                    const struct frob_program *program, many_open_world *open_world,
                    const struct job *job)
{
    struct options one = *options;
    struct params params, judged;
    struct frob_sim *sim = NULL;
    char *said = NULL;
    size_t size = 0;
    FILE *file = open_memstream(&said, &size);
    bool ok = file != NULL && params_open(&params, program, job->settings, job->count);
    one.seed = job->seed;
    if (ok) {
        ok = set_judge(trial, job, &judged) && (sim = open_world(&one, program)) != NULL &&
             trial_run(trial, &one, &params, sim, file);
        if (sim != NULL)
            frob_sim_close(sim);
        params_close(&judged);
        params_close(&params);
    }
    if (file != NULL)
        ok = fclose(file) == 0 && ok;
    ok = ok && write_line(job->key, said);
    free(said);
    return ok;
}

bool many_runs(struct trial *trial, const struct options *options,
               const struct frob_program *program, many_open_world *open_world)
{
    FILE *list = fopen(options->runs, "r");
    char *line = NULL;
    size_t room = 0;
    bool ok = list != NULL;
    if (!ok)
        fprintf(stderr, "error: cannot read %s: %s\n", options->runs, strerror(errno));
    while (ok && getline(&line, &room, list) > 0) {
        struct job job;
        ok = read_job(line, &job);
        if (!ok)
            fprintf(stderr, "error: %s has a line that does not describe a run\n", options->runs);
        ok = ok && one_run(trial, options, program, open_world, &job);
    }
    free(line);
    if (list != NULL)
        fclose(list);
    return ok;
}
