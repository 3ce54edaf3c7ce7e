#include "what_if.h"

#include "../../common/child.h"
#include "../../common/load.h"

#include <dirent.h>
#include <errno.h>
#include <fcntl.h>
#include <poll.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

/* ---- A folder to compile in */

/* Joins both parts of a path; the caller must free the result. */
static char *path_in(const char *folder, const char *file)
{
    struct buffer path = { 0 };
    buffer_format(&path, "%s/%s", folder, file);
    return path.data;
}

static const char *without_folder(const char *path)
{
    const char *slash = strrchr(path, '/');
    return slash == NULL ? path : slash + 1;
}

/* Returns the folder that contains a file, with symbolic links resolved; the caller must free
 * it. */
static char *folder_of(const char *file)
{
    struct buffer folder = { 0 };
    char *whole;
    buffer_bytes(&folder, file, (size_t)(without_folder(file) - file));
    whole = realpath(folder.length == 0 ? "." : folder.data, NULL);
    buffer_free(&folder);
    return whole;
}

static bool write_file(const char *path, const char *text)
{
    FILE *file = fopen(path, "wb");
    bool ok = file != NULL && fputs(text, file) >= 0;
    return file != NULL && fclose(file) == 0 && ok;
}

static bool link_to(const char *from, const char *folder, const char *name)
{
    char *path = path_in(folder, name), *target = path_in(from, name);
    bool ok = path != NULL && target != NULL && symlink(target, path) == 0;
    free(target);
    free(path);
    return ok;
}

/* Writes the edited program to the folder, with symbolic links to everything next to the
 * original. */
static bool fill(const char *folder, const char *file, const char *text)
{
    char *from = folder_of(file), *path = path_in(folder, without_folder(file));
    DIR *beside = from == NULL ? NULL : opendir(from);
    bool ok = beside != NULL && path != NULL && write_file(path, text);
    for (struct dirent *entry; ok && (entry = readdir(beside)) != NULL;)
        if (entry->d_name[0] != '.' && strcmp(entry->d_name, without_folder(file)) != 0)
            ok = link_to(from, folder, entry->d_name);
    if (beside != NULL)
        closedir(beside);
    free(path);
    free(from);
    return ok;
}

static void clear(const char *folder)
{
    DIR *all = opendir(folder);
    for (struct dirent *entry; all != NULL && (entry = readdir(all)) != NULL;) {
        char *path = path_in(folder, entry->d_name);
        if (path != NULL)
            unlink(path);
        free(path);
    }
    if (all != NULL)
        closedir(all);
    rmdir(folder);
}

/* ---- Compiling */

/* Appends the available input. Returns true at the end of the stream. */
static bool read_some(int number, struct buffer *text)
{
    char block[4096];
    const ssize_t length = read(number, block, sizeof block);
    if (length > 0)
        buffer_bytes(text, block, (size_t)length);
    return length == 0 || (length < 0 && errno != EINTR);
}

/* Reads two streams to their ends at the same time, so that neither blocks the writer. */
static void read_both(int first, struct buffer *first_text, int second, struct buffer *second_text)
{
    struct pollfd both[] = { { first, POLLIN, 0 }, { second, POLLIN, 0 } };
    struct buffer *const texts[] = { first_text, second_text };
    while (both[0].fd >= 0 || both[1].fd >= 0) {
        if (poll(both, 2, -1) < 0 && errno != EINTR)
            return;
        for (size_t i = 0; i < 2; i++)
            if (both[i].fd >= 0 && both[i].revents != 0 && read_some(both[i].fd, texts[i]))
                both[i].fd = -1; /* poll ignores this stream from now on */
    }
}

static void close_both(const int *ends)
{
    close(ends[0]);
    close(ends[1]);
}

/* Runs the command with additional arguments. Appends its standard output and its standard error to
 * separate buffers. Returns its exit status, or -1 if it has none. */
static int run(what_if_command command, const char *const *more, struct buffer *result,
               struct buffer *said)
{
    size_t count = 0, added = 0;
    int out[2], err[2], status = -1;
    const char **arguments;
    const pid_t viewer = getpid();
    pid_t child;
    while (command[count] != NULL)
        count++;
    while (more[added] != NULL)
        added++;
    arguments = (const char **)calloc(count + added + 1, sizeof *arguments);
    if (arguments == NULL || pipe(out) != 0) {
        free(arguments);
        return -1;
    }
    if (pipe(err) != 0) {
        close_both(out);
        free(arguments);
        return -1;
    }
    memcpy(arguments, command, count * sizeof *arguments);
    memcpy(arguments + count, more, added * sizeof *arguments);
    child = fork();
    if (child == 0) {
        int null = open("/dev/null", O_RDONLY);
        child_ends_with(viewer, SIGTERM);
        dup2(null, STDIN_FILENO);
        dup2(out[1], STDOUT_FILENO);
        dup2(err[1], STDERR_FILENO);
        close_both(out);
        close_both(err);
        execv(arguments[0], (char *const *)arguments);
        _exit(127);
    }
    close(out[1]);
    close(err[1]);
    if (child > 0) {
        read_both(out[0], result, err[0], said);
        while (waitpid(child, &status, 0) < 0 && errno == EINTR)
            ;
    }
    close(out[0]);
    close(err[0]);
    free(arguments);
    return child > 0 && WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

/* Appends a text without any occurrences of the folder's path. */
static void add_without(struct buffer *out, const char *text, const char *folder)
{
    const size_t length = strlen(folder);
    const char *found;
    while ((found = strstr(text, folder)) != NULL) {
        buffer_bytes(out, text, (size_t)(found - text));
        text = found + length + (found[length] == '/' ? 1 : 0);
    }
    buffer_text(out, text);
}

/* ---- An edited program */

/* An attempt to build the program in a temporary folder; end_attempt deletes the folder. */
struct attempt {
    struct buffer folder;
    char *file; /* path of the program */
    struct buffer *why;
};

static void end_attempt(struct attempt *a)
{
    if (a->file != NULL)
        clear(a->folder.data);
    free(a->file);
    buffer_free(&a->folder);
}

static bool begin_attempt(struct attempt *a, const char *name, const char *text, struct buffer *why)
{
    const char *temporary = getenv("TMPDIR");
    memset(a, 0, sizeof *a);
    a->why = why;
    buffer_format(&a->folder, "%s/frob-view-XXXXXX", temporary != NULL ? temporary : "/tmp");
    if (a->folder.failed || mkdtemp(a->folder.data) == NULL) {
        buffer_format(why, "cannot create a folder for compiling: %s", strerror(errno));
        return false;
    }
    a->file = path_in(a->folder.data, without_folder(name));
    if (a->file == NULL || !fill(a->folder.data, name, text)) {
        buffer_format(why, "cannot write the program: %s", strerror(errno));
        return false;
    }
    return true;
}

static const struct frob_program *compile(const struct attempt *a, what_if_command command)
{
    const struct frob_program *program = NULL;
    const char *const file[] = { a->file, NULL };
    struct buffer path = { 0 }, said = { 0 };
    if (run(command, file, &path, &said) != 0 || path.failed || path.length == 0) {
        add_without(a->why, said.length > 0 ? said.data : "cannot run the compiler",
                    a->folder.data);
    } else {
        path.data[strcspn(path.data, "\n")] = '\0';
        program = frob_load(path.data);
        if (program == NULL)
            buffer_text(a->why, "cannot load the compiled program");
    }
    buffer_free(&path);
    buffer_free(&said);
    return program;
}

/* ---- Driving again */

/* Returns the rate, in Hz, at which a simulated program ran in a recording, and sets *seconds to
 * the duration of the run. Returns 0 if the recording was not made by a simulator. */
static double rate_of(const struct recording *recording, double *seconds)
{
    const int64_t *times = recording->times;
    const size_t last = recording->count - 1;
    const int64_t apart = last == 0 ? 0 : times[1] - times[0];
    for (size_t k = 1; k <= last; k++) {
        /* Allows an error of 1 ns, because a period such as 1/3 s is not a whole number of
         * nanoseconds. */
        const int64_t error = times[k] - times[k - 1] - apart;
        if (error < -1 || error > 1)
            return 0;
    }
    *seconds = (double)(times[last] - times[0]) / 1e9;
    return apart <= 0 || times[0] != 0 ? 0 : (double)last / *seconds;
}

/* Creates options that set all of the program's parameters. Each consists of two words, `--param`
 * and NAME=VALUE; the second is stored in `text`. Returns false if memory runs out. */
static bool param_options(const struct frob_program *program, const struct buffer *settings,
                          struct buffer *text, const char **options)
{
    struct params params;
    char why[PARAMS_WHY], room[200];
    bool ok = params_open(&params, program, NULL, 0);
    const char *next;
    for (size_t at = 0; ok && at < settings->length; at += strlen(settings->data + at) + 1)
        params_read(&params, settings->data + at, why);
    for (size_t i = 0; ok && i < program->param_count; i++) {
        struct frob_text value = frob_text_in(room, sizeof room);
        params_write(&value, &program->params[i], params.values);
        buffer_format(text, "%s=%s", program->params[i].name, room);
        buffer_bytes(text, "", 1);
    }
    ok = ok && !text->failed;
    next = text->data;
    for (size_t i = 0; ok && i < program->param_count; i++, next += strlen(next) + 1) {
        options[2 * i] = "--param";
        options[2 * i + 1] = next;
    }
    params_close(&params);
    return ok;
}

/* Runs a program in the simulator for the duration of the recording, and reads the resulting
 * recording. */
static bool drive(const struct attempt *a, what_if_command command, const char *file,
                  const struct recording *recording, const struct signals *signals,
                  const struct buffer *settings, struct recording *driven)
{
    struct buffer rate = { 0 }, duration = { 0 }, record = { 0 }, params = { 0 };
    struct buffer summary = { 0 }, said = { 0 };
    const size_t count = 2 * signals->program->param_count;
    const char **arguments = (const char **)calloc(count + 8, sizeof *arguments);
    double seconds, hertz = rate_of(recording, &seconds);
    bool ok = false;
    if (hertz <= 0) {
        buffer_text(
            a->why,
            "this is not a recording of a simulated run: its instants are not evenly spaced");
        free(arguments);
        return false;
    }
    buffer_format(&rate, "%.12g", hertz);
    buffer_format(&duration, "%.9fs", seconds);
    buffer_format(&record, "%s/driven.csv", a->folder.data);
    const char *const others[] = { "--rate",   rate.data,   "--for", duration.data,
                                   "--record", record.data, file,    NULL };
    if (arguments != NULL)
        memcpy(arguments + count, others, sizeof others);
    if (rate.failed || duration.failed || record.failed || arguments == NULL ||
        !param_options(signals->program, settings, &params, arguments))
        buffer_text(a->why, "not enough memory");
    else if (run(command, arguments, &summary, &said) != 0)
        add_without(a->why, said.length > 0 ? said.data : "cannot run the simulator",
                    a->folder.data);
    else if (!recording_read(driven, signals, record.data, NULL))
        buffer_text(a->why, "the simulator recorded nothing");
    else
        ok = true;
    while (ok && recording_read_on(driven))
        continue;
    /* The name is only for messages, because the file is not read again. */
    driven->name = "the run in the simulator";
    if (record.data != NULL)
        unlink(record.data);
    free(arguments);
    buffer_free(&params);
    buffer_free(&rate);
    buffer_free(&duration);
    buffer_free(&record);
    buffer_free(&summary);
    buffer_free(&said);
    return ok;
}

/* Returns the first instant at which inputs or outputs, depending on `side`, differ between two
 * recordings of the same signals. If they do not differ, returns the length of the shorter
 * recording. */
static size_t first_difference(const struct signals *signals, enum side side,
                               const struct recording *a, const struct recording *b,
                               const struct signal **in)
{
    size_t k = 0;
    for (; k < a->count && k < b->count; k++) {
        const void *x = side == INPUT ? recording_input(a, k) : recording_output(a, k);
        const void *y = side == INPUT ? recording_input(b, k) : recording_output(b, k);
        for (size_t i = 0; i < signals->count; i++) {
            const struct signal *signal = &signals->all[i];
            if (signal->side == side && a->recorded[i] && b->recorded[i] &&
                !signal_values_equal(signal->value, x, y)) {
                *in = signal;
                return k;
            }
        }
    }
    *in = NULL;
    return k;
}

/* Checks that the simulator reproduces the recording. It does not if the world or the seed is
 * different, or if somebody pressed keys. In these cases, the run of an edited program could not be
 * compared with the recording. */
static bool repeats(const struct attempt *a, what_if_command command, const char *file,
                    const struct recording *recording, const struct signals *signals)
{
    struct recording driven = { 0 };
    const struct signal *in;
    bool ok = drive(a, command, file, recording, signals, &recording->params, &driven);
    if (ok) {
        const size_t k = first_difference(signals, INPUT, recording, &driven, &in);
        ok = in == NULL && k == recording->count;
        if (in != NULL)
            buffer_format(
                a->why,
                "the simulator does not reproduce this recording: `%s` differs at instant %lu. Run "
                "`frobc view` with the `--world` and the `--seed` of the recorded run",
                in->name, (unsigned long)k);
        else if (!ok)
            buffer_format(a->why,
                          "the simulator does not reproduce this recording: the simulated run "
                          "ends at instant %lu",
                          (unsigned long)k);
    }
    recording_free(&driven);
    return ok;
}

/* ---- Running */

/* Returns whether both programs have the same inputs and outputs, so that the recording fits the
 * edited program. */
static bool fits(const struct signals *recorded, const struct signals *edited)
{
    size_t i = 0;
    for (; i < recorded->count && i < edited->count && recorded->all[i].side <= OUTPUT; i++) {
        const struct signal *a = &recorded->all[i], *b = &edited->all[i];
        if (b->side != a->side || strcmp(a->name, b->name) != 0 ||
            a->value->kind != b->value->kind || a->value->offset != b->value->offset ||
            a->value->count != b->value->count)
            return false;
    }
    return recorded->program->input_size == edited->program->input_size &&
           (i == edited->count || edited->all[i].side > OUTPUT);
}

/* Compiles and loads the edited program, without running it. */
static bool prepare(struct what_if *what_if, const struct attempt *a,
                    const struct signals *recorded, what_if_command command)
{
    const struct frob_program *program = compile(a, command);
    if (program == NULL)
        return false;
    if (!signals_start(&what_if->signals, program, frob_load_columns()))
        buffer_text(a->why, "not enough memory for the program's signals");
    else if (!fits(recorded, &what_if->signals))
        buffer_text(a->why, "the edited program has different inputs or outputs, so it cannot be "
                            "run on this recording");
    else
        return true;
    return false;
}

/* Returns whether the edit changed the default value of the parameter that a setting sets. If so,
 * the new default overrides the setting. */
static bool is_edited(const struct frob_program *edited, const struct frob_program *recorded,
                      const char *setting)
{
    const struct frob_program *const programs[] = { edited, recorded };
    const size_t length = strcspn(setting, "=");
    char rooms[2][200] = { "", "" };
    for (size_t p = 0; p < 2; p++) {
        struct frob_text value = frob_text_in(rooms[p], sizeof rooms[p]);
        for (size_t i = 0; i < programs[p]->param_count; i++)
            if (strncmp(programs[p]->params[i].name, setting, length) == 0 &&
                programs[p]->params[i].name[length] == '\0')
                params_write(&value, &programs[p]->params[i], programs[p]->default_params);
    }
    return strcmp(rooms[0], rooms[1]) != 0;
}

/* Determines the parameters of the edited program. Returns false if a setting is not a valid
 * value. */
static bool settle(struct what_if *what_if, const struct frob_program *recorded,
                   const struct buffer *settings, const struct buffer *asked, struct buffer *why)
{
    const struct frob_program *program = what_if->signals.program;
    struct params params;
    char text[PARAMS_WHY];
    bool ok = params_open(&params, program, NULL, 0);
    for (size_t at = 0; at < settings->length; at += strlen(settings->data + at) + 1)
        if (!is_edited(program, recorded, settings->data + at))
            buffer_bytes(&what_if->settings, settings->data + at, strlen(settings->data + at) + 1);
    for (size_t at = 0; ok && at < asked->length; at += strlen(asked->data + at) + 1) {
        ok = params_read(&params, asked->data + at, text) == PARAMS_SET;
        if (!ok)
            buffer_text(why, text);
        buffer_bytes(&what_if->settings, asked->data + at, strlen(asked->data + at) + 1);
    }
    params_close(&params);
    if (what_if->settings.failed)
        buffer_text(why, "not enough memory");
    return ok && !what_if->settings.failed;
}

static bool run_over(struct what_if *what_if, struct recording *recording, struct buffer *why)
{
    if (!replay_start(&what_if->replay, &what_if->signals, recording, &what_if->settings)) {
        buffer_text(why, "not enough memory for the program's states");
        return false;
    }
    series_start(&what_if->series, &what_if->replay);
    while (!replay_is_whole(&what_if->replay))
        replay_advance(&what_if->replay);
    return true;
}

static void find_difference(struct what_if *what_if, const struct recording *recording)
{
    if (what_if->drives) {
        what_if->first = first_difference(&what_if->signals, OUTPUT, &what_if->driven, recording,
                                          &what_if->first_in);
    } else if (what_if->replay.diverged) {
        what_if->first = what_if->replay.diverged_at;
        what_if->first_in = what_if->replay.diverged_in;
    }
}

bool what_if_start(struct what_if *what_if, const struct signals *recorded,
                   struct recording *recording, const struct what_if_commands *commands,
                   const char *file, const struct what_if_edit *edit, struct buffer *why)
{
    const bool drives = edit->drives;
    struct attempt attempt;
    bool ok;
    what_if_end(what_if);
    ok = begin_attempt(&attempt, file, edit->text, why) &&
         prepare(what_if, &attempt, recorded, commands->build) &&
         settle(what_if, recorded->program, &recording->params, &edit->settings, why);
    if (ok && drives && !what_if->is_repeatable) {
        ok = repeats(&attempt, commands->drive, file, recording, recorded);
        what_if->is_repeatable = ok;
    }
    if (ok && drives)
        ok = drive(&attempt, commands->drive, attempt.file, recording, &what_if->signals,
                   &what_if->settings, &what_if->driven);
    what_if->drives = ok && drives;
    ok = ok && run_over(what_if, drives ? &what_if->driven : recording, why);
    end_attempt(&attempt);
    what_if->is_there = true;
    if (ok)
        find_difference(what_if, recording);
    else
        what_if_end(what_if);
    return ok;
}

void what_if_end(struct what_if *what_if)
{
    const bool is_repeatable = what_if->is_repeatable;
    if (what_if->is_there) {
        series_end(&what_if->series);
        replay_end(&what_if->replay);
        signals_end(&what_if->signals);
        recording_free(&what_if->driven);
        buffer_free(&what_if->settings);
    }
    memset(what_if, 0, sizeof *what_if);
    what_if->is_repeatable = is_repeatable;
}
