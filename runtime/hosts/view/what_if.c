#include "what_if.h"

#include "../common/load.h"

#include <dirent.h>
#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

/* {1 A folder to compile in} */

/* In two parts; to be freed. */
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

/* The folder that a file is in, without symbolic links; to be freed. */
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

/* The edited program, and links to all that is beside it. */
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

/* {1 Compiling} */

static void read_all(int number, struct buffer *text)
{
    char block[4096];
    ssize_t length;
    while ((length = read(number, block, sizeof block)) > 0 || (length < 0 && errno == EINTR))
        if (length > 0)
            buffer_bytes(text, block, (size_t)length);
}

/* Runs the command on a file; what it prints is appended. Its exit status, or -1. */
static int run(what_if_command command, const char *file, struct buffer *said)
{
    size_t count = 0;
    int ends[2], status = -1;
    const char **arguments;
    pid_t child;
    while (command[count] != NULL)
        count++;
    arguments = (const char **)calloc(count + 1, sizeof *arguments);
    if (arguments == NULL || pipe(ends) != 0) {
        free(arguments);
        return -1;
    }
    memcpy(arguments, command, count * sizeof *arguments);
    arguments[count - 1] = file;
    child = fork();
    if (child == 0) {
        int null = open("/dev/null", O_RDONLY);
        dup2(null, STDIN_FILENO);
        dup2(ends[1], STDOUT_FILENO);
        dup2(ends[1], STDERR_FILENO);
        close(ends[0]);
        close(ends[1]);
        execv(arguments[0], (char *const *)arguments);
        _exit(127);
    }
    close(ends[1]);
    if (child > 0) {
        read_all(ends[0], said);
        while (waitpid(child, &status, 0) < 0 && errno == EINTR)
            ;
    }
    close(ends[0]);
    free(arguments);
    return child > 0 && WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

/* Appends a text, without a folder in it. */
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

static const struct frob_program *compile(what_if_command command, const char *name,
                                          const char *text, struct buffer *why)
{
    const char *temporary = getenv("TMPDIR");
    const struct frob_program *program = NULL;
    struct buffer folder = { 0 }, said = { 0 };
    char *file;
    buffer_format(&folder, "%s/frob-view-XXXXXX", temporary != NULL ? temporary : "/tmp");
    if (folder.failed || mkdtemp(folder.data) == NULL) {
        buffer_format(why, "no folder to compile in can be made: %s", strerror(errno));
        buffer_free(&folder);
        return NULL;
    }
    file = path_in(folder.data, without_folder(name));
    if (file == NULL || !fill(folder.data, name, text)) {
        buffer_format(why, "cannot write the program: %s", strerror(errno));
    } else if (run(command, file, &said) != 0 || said.failed || said.length == 0) {
        add_without(why, said.length > 0 ? said.data : "the compiler cannot be run", folder.data);
    } else {
        /* The last line is the path; warnings stand before it. */
        char *line;
        said.data[strcspn(said.data, "\n") == said.length ? said.length : said.length - 1] = '\0';
        line = strrchr(said.data, '\n');
        program = frob_load(line == NULL ? said.data : line + 1);
        if (program == NULL)
            buffer_text(why, "the compiled program cannot be loaded");
    }
    clear(folder.data);
    free(file);
    buffer_free(&said);
    buffer_free(&folder);
    return program;
}

/* {1 Running} */

/* Are inputs and outputs the same, so that what was recorded is what it takes and gives? */
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

bool what_if_start(struct what_if *what_if, const struct signals *recorded,
                   const struct recording *recording, what_if_command command,
                   const char *file, const char *text, struct buffer *why)
{
    const struct frob_program *program;
    bool ok = false;
    what_if_end(what_if);
    program = compile(command, file, text, why);
    if (program == NULL)
        return false;
    if (!signals_start(&what_if->signals, program, frob_load_columns())) {
        buffer_text(why, "not enough memory for the program's signals");
    } else if (!fits(recorded, &what_if->signals)) {
        buffer_text(why, "its input or output is another, so it cannot be run on this recording");
    } else if (!replay_start(&what_if->replay, &what_if->signals, recording)) {
        buffer_text(why, "not enough memory for the program's states");
    } else {
        series_start(&what_if->series, &what_if->replay);
        while (!replay_is_whole(&what_if->replay))
            replay_advance(&what_if->replay);
        ok = true;
    }
    what_if->is_there = ok;
    if (!ok) {
        replay_end(&what_if->replay);
        signals_end(&what_if->signals);
        memset(what_if, 0, sizeof *what_if);
    }
    return ok;
}

void what_if_end(struct what_if *what_if)
{
    if (what_if->is_there) {
        series_end(&what_if->series);
        replay_end(&what_if->replay);
        signals_end(&what_if->signals);
    }
    memset(what_if, 0, sizeof *what_if);
}
