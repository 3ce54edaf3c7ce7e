/* frob-view -- shows a recorded or live run of a program on a web page.
 *
 *   frob-view [--why-nan] [--print] [--port N] [--source FILE]... [--library FILE]... [--world FILE]
 *             [--param NAME=VALUE]... [--at SECONDS] [--compare OTHER.csv] [--ring N] PROGRAM.so RUN.csv [COMMAND...]
 *
 * If --ring is given, N is the number of an open file descriptor, and frob-view shows the run of
 * its parent process (../common/ring.h); RUN.csv is then the file in which the run is recorded, or
 * `-`. COMMAND, to which frob-view appends the path of an edited program, compiles that program in
 * the same way as PROGRAM.so, and prints the path of the result. frob-view prints the page's
 * address, and opens it in a browser unless --print is given. It ends on SIGINT or SIGTERM and, for
 * a live run, when the run is over and no page is open. Exit status: 0, or 2 if a file cannot be
 * read or is not a recording, or if the port is not available. */
#include "../common/dialect.h"
#include "../common/load.h"
#include "../common/streams.h"
#include "answers/nan.h"
#include "server/browser.h"
#include "server/server.h"
#include "server/token.h"

#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

enum { DONE = 0, WRONG_USE = 2 };

struct options {
    bool print, why_nan;
    int port;
    int ring; /* -1: none */
    struct view_files files;
    const char *program;
};

/* Data for `tell`, which prints the page's address when the server is ready. */
struct start {
    const struct options *options;
    const char *token;
};

static void add_source(struct view_files *files, const char *name, bool is_own)
{
    files->sources[files->source_count++] = name;
    files->own_count += is_own ? 1 : 0;
}

/* Reads the two commands, separated by `--`, that build an edited program and run it in the
 * simulator. Each becomes an array that ends with NULL. */
static void read_commands(struct options *o, char **at)
{
    if (*at == NULL)
        return;
    o->files.commands.build = (what_if_command)at;
    while (*at != NULL && strcmp(*at, "--") != 0)
        at++;
    if (*at != NULL) {
        *at = NULL;
        o->files.commands.drive = (what_if_command)(at + 1);
    }
}

static bool read_options(struct options *o, int argc, char **argv)
{
    int i = 1;
    o->ring = -1;
    o->files.sources = (const char **)calloc((size_t)argc, sizeof *o->files.sources);
    o->files.params = (const char **)calloc((size_t)argc, sizeof *o->files.params);
    o->files.dialect.columns =
        (const char **)calloc((size_t)argc, sizeof *o->files.dialect.columns);
    for (; o->files.sources != NULL && o->files.params != NULL && i < argc &&
           strncmp(argv[i], "--", 2) == 0;
         i++) {
        if (strcmp(argv[i], "--print") == 0)
            o->print = true;
        else if (strcmp(argv[i], "--why-nan") == 0)
            o->why_nan = true;
        else if (strcmp(argv[i], "--port") == 0 && i + 1 < argc)
            o->port = atoi(argv[++i]);
        else if (strcmp(argv[i], "--ring") == 0 && i + 1 < argc)
            o->ring = atoi(argv[++i]);
        else if (strcmp(argv[i], "--source") == 0 && i + 1 < argc)
            add_source(&o->files, argv[++i], true);
        else if (strcmp(argv[i], "--library") == 0 && i + 1 < argc)
            add_source(&o->files, argv[++i], false);
        else if (strcmp(argv[i], "--param") == 0 && i + 1 < argc)
            o->files.params[o->files.param_count++] = argv[++i];
        else if (strcmp(argv[i], "--world") == 0 && i + 1 < argc)
            o->files.world = argv[++i];
        else if (strcmp(argv[i], "--compare") == 0 && i + 1 < argc)
            o->files.other = argv[++i];
        else if (strcmp(argv[i], "--at") == 0 && i + 1 < argc)
            o->files.at = strtod(argv[++i], NULL);
        else if (!dialect_option(&o->files.dialect, argc, argv, &i))
            break;
    }
    if (o->files.sources == NULL || o->files.params == NULL || i + 2 > argc || o->port < 0 ||
        o->port > 65535) {
        fprintf(stderr, "usage: frob-view [--print] [--port N] [--source FILE]... "
                        "[--library FILE]... [--world FILE] PROGRAM.so RUN.csv\n");
        return false;
    }
    o->program = argv[i];
    o->files.recording = o->ring >= 0 && strcmp(argv[i + 1], "-") == 0 ? NULL : argv[i + 1];
    read_commands(o, argv + i + 2);
    return true;
}

/* Redirects the standard streams to /dev/null, so that programs that read the run's output do not
 * wait until the last page is closed. */
static void leave_streams(void)
{
    int null = open("/dev/null", O_RDWR);
    for (int number = STDIN_FILENO; null >= 0 && number <= STDERR_FILENO; number++)
        dup2(null, number);
}

static bool tell(void *context, int port)
{
    const struct start *start = (const struct start *)context;
    char address[128];
    snprintf(address, sizeof address, "http://127.0.0.1:%d/#%s", port, start->token);
    printf("view: %s%s\n", address, start->options->ring >= 0 ? "" : " (press Ctrl-C to end)");
    if (!streams_flush())
        return false;
    if (!start->options->print)
        browser_open(address);
    if (start->options->ring >= 0)
        leave_streams();
    return true;
}

int main(int argc, char **argv)
{
    struct options options = { 0 };
    struct view view = { 0 };
    struct ring ring = { 0 };
    char token[TOKEN_LENGTH + 1];
    struct start start = { &options, token };
    const struct frob_program *program;
    int status = WRONG_USE;
    streams_open();
    if (!read_options(&options, argc, argv))
        return WRONG_USE;
    program = frob_load(options.program);
    if (program == NULL)
        return WRONG_USE;
    if (options.ring >= 0 && !ring_attach(&ring, options.ring)) {
        fprintf(stderr, "error: --ring %d: there is no run in progress\n", options.ring);
    } else if (!token_make(token)) {
        fprintf(stderr, "error: cannot read random numbers from /dev/urandom\n");
    } else if (view_start(&view, program, frob_load_columns(), frob_load_origins(), &options.files,
                          options.ring >= 0 ? &ring : NULL)) {
        /* Spends 20 ms on reading and replaying before serving, so that a run of a few minutes is
         * complete when the page connects. */
        if (options.why_nan) {
            view_say(&view);
            status = nan_print(&view) && streams_flush() ? DONE : WRONG_USE;
        } else {
            view_advance(&view, 0.02);
            view_say(&view);
            status = server_run(&view, options.port, token, tell, &start) ? DONE : WRONG_USE;
            browser_forget();
        }
    }
    view_end(&view);
    ring_close(&ring);
    free(options.files.sources);
    free(options.files.params);
    free(options.files.dialect.columns);
    return status;
}
