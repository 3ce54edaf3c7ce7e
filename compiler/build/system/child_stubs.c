/* Starts child processes, and makes sure that they end when frobc ends. See child.mli. */
#define _GNU_SOURCE
#define CAML_INTERNALS /* for caml_convert_signal_number */

#include <caml/memory.h>
#include <caml/mlvalues.h>
#include <caml/signals.h>
#include <caml/unixsupport.h>

#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

enum life { OUTLIVES, ENDS_WITH_US, ENDS_WITH_ALL_IT_STARTED };

/* Must be called in a child of `parent`; see prctl(2). The parent may have ended before the
 * call. */
static void end_with(pid_t parent, int number)
{
    if (prctl(PR_SET_PDEATHSIG, number) != 0 || getppid() != parent)
        _exit(126);
}

/* The stack limit with which frobc was started. Its children get this limit back. */
static struct rlimit stack_before;
static int stack_is_larger;

static void put_stack_back(void)
{
    if (stack_is_larger)
        setrlimit(RLIMIT_STACK, &stack_before);
}

/* Executes the program; if that fails, writes errno to the pipe. */
static void become(char *const *arguments, const int streams[3], int report)
{
    int copies[3], error;
    put_stack_back();
    /* First copy the descriptors to numbers above 2, so that dup2 does not overwrite one that is
     * still needed. */
    for (int i = 0; i < 3; i++)
        copies[i] = fcntl(streams[i], F_DUPFD_CLOEXEC, 3);
    for (int i = 0; i < 3; i++)
        dup2(copies[i], i);
    /* execvp would pass a file that is not an executable to a shell; this must be an error. */
    if (strchr(arguments[0], '/') != NULL)
        execv(arguments[0], arguments);
    else
        execvp(arguments[0], arguments);
    error = errno;
    while (write(report, &error, sizeof error) < 0 && errno == EINTR)
        continue;
    _exit(127);
}

static int status_of(int status)
{
    return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

/* Ends the caller's process group, including the caller, but first gives a compiler time to remove
 * its temporary files. */
static void end_group(pid_t child)
{
    static const struct timespec pause = { 0, 10000000 };
    kill(-getpid(), SIGTERM);
    for (int i = 0; i < 100 && waitpid(child, NULL, WNOHANG) == 0; i++)
        nanosleep(&pause, NULL);
    kill(-getpid(), SIGKILL);
    _exit(126);
}

/* The intermediate process: it leads the process group of the program, and ends the whole group
 * when frobc has ended. It exits with the program's status. */
static void mind(pid_t frobc, char *const *arguments, const int streams[3], int report)
{
    const pid_t self = getpid();
    sigset_t awaited, before;
    pid_t child;
    setpgid(0, 0);
    sigemptyset(&awaited);
    sigaddset(&awaited, SIGCHLD);
    sigaddset(&awaited, SIGTERM);
    sigprocmask(SIG_BLOCK, &awaited, &before);
    signal(SIGCHLD, SIG_DFL);
    end_with(frobc, SIGTERM);
    child = fork();
    if (child == 0) {
        sigprocmask(SIG_SETMASK, &before, NULL);
        end_with(self, SIGKILL);
        become(arguments, streams, report);
    }
    close(report);
    if (child < 0)
        _exit(126);
    for (;;) {
        int status;
        if (sigwaitinfo(&awaited, NULL) == SIGTERM)
            end_group(child);
        else if (waitpid(child, &status, WNOHANG) == child)
            _exit(status_of(status));
    }
}

/* Takes the program with its arguments, the three streams, and a value of enum life. Returns the
 * process id. Raises Unix_error if the process or the program cannot be started. */
value frobc_child_start(value words, value files, value life)
{
    CAMLparam3(words, files, life);
    const size_t count = Wosize_val(words);
    const int streams[3] = { Int_val(Field(files, 0)), Int_val(Field(files, 1)),
                             Int_val(Field(files, 2)) };
    const pid_t frobc = getpid();
    char **arguments = calloc(count + 1, sizeof *arguments);
    int report[2], error = 0;
    pid_t child = -1;
    if (arguments == NULL || pipe2(report, O_CLOEXEC) != 0) {
        free(arguments);
        unix_error(errno, "fork", Nothing);
    }
    for (size_t i = 0; i < count; i++)
        arguments[i] = (char *)String_val(Field(words, i));
    child = fork();
    if (child == 0) {
        close(report[0]);
        if (Int_val(life) == ENDS_WITH_ALL_IT_STARTED)
            mind(frobc, arguments, streams, report[1]);
        if (Int_val(life) == ENDS_WITH_US)
            end_with(frobc, SIGKILL);
        become(arguments, streams, report[1]);
    }
    if (child < 0)
        error = errno;
    free(arguments);
    close(report[1]);
    if (child > 0) {
        ssize_t got;
        do
            got = read(report[0], &error, sizeof error);
        while (got < 0 && errno == EINTR);
    }
    close(report[0]);
    if (error != 0) {
        while (child > 0 && waitpid(child, NULL, 0) < 0 && errno == EINTR)
            continue;
        unix_error(error, "execvp", Field(words, 0));
    }
    CAMLreturn(Val_int(child));
}

value frobc_child_end_with(value parent, value name)
{
    CAMLparam2(parent, name);
    unsetenv(String_val(name));
    end_with((pid_t)Int_val(parent), SIGTERM);
    CAMLreturn(Val_unit);
}

/* The kernel reads the limit each time the main thread's stack grows, so no restart is needed. */
value frobc_child_allow_stack(value bytes)
{
    const rlim_t wanted = (rlim_t)Long_val(bytes);
    struct rlimit limit;
    if (stack_is_larger || getrlimit(RLIMIT_STACK, &stack_before) != 0)
        return Val_unit;
    limit = stack_before;
    if (limit.rlim_cur == RLIM_INFINITY || limit.rlim_cur >= wanted)
        return Val_unit;
    limit.rlim_cur =
        limit.rlim_max == RLIM_INFINITY || limit.rlim_max > wanted ? wanted : limit.rlim_max;
    stack_is_larger = setrlimit(RLIMIT_STACK, &limit) == 0;
    return Val_unit;
}

/* OCaml uses its own negative numbers for the signals that it supports. */
value frobc_child_signal_number(value signal)
{
    return Val_int(caml_convert_signal_number(Int_val(signal)));
}

value frobc_child_put_stack_back(value unit)
{
    (void)unit;
    put_stack_back();
    return Val_unit;
}
