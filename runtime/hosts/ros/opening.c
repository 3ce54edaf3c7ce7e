#include "opening.h"

#include <errno.h>
#include <poll.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

#include "device.h"
#include "messages.h"
#include "node.h"

/* Maximum time for the node to join the ROS 2 system, and to end. */
enum { START_MS = 20000, END_MS = 1000 };

/* ---- The supervisor's side */

/* Replaces this process with the node: `PROGRAM --ros-node SOCKET STAMPED --ros-args ARGUMENT…`. */
static void become_node(const struct line *line, const double *settings, int own)
{
    char number[16], stamped[2] = "0";
    char **argv = (char **)calloc(line->argument_count + 6, sizeof *argv);
    size_t count = 0;
    const int fd = dup(own); /* without close-on-exec */
    if (argv == NULL || fd < 0)
        _exit(1);
    snprintf(number, sizeof number, "%d", fd);
    stamped[0] = settings[ROS_STAMPED] != 0.0 ? '1' : '0';
    argv[count++] = program_invocation_name;
    argv[count++] = (char *)(uintptr_t)ROS_NODE_OPTION;
    argv[count++] = number;
    argv[count++] = stamped;
    if (line->argument_count > 0)
        argv[count++] = (char *)(uintptr_t)ros_opening.option;
    for (size_t i = 0; i < line->argument_count; i++)
        argv[count++] = (char *)(uintptr_t)line->arguments[i];
    execv("/proc/self/exe", argv);
    _exit(1);
}

/* Waits until the node reports that it has joined the ROS 2 system. Leaves that message in the
 * socket, for the driver. */
static enum frob_status wait_until_started(int socket, char *message, size_t room)
{
    struct pollfd wait = { socket, POLLIN, 0 };
    struct ros_refused first;
    ssize_t got;
    if (poll(&wait, 1, START_MS) == 0) {
        snprintf(message, room, "the ROS 2 node has not started within %d s", START_MS / 1000);
        return FROB_TIMEOUT;
    }
    memset(&first, 0, sizeof first);
    got = recv(socket, &first, sizeof first, MSG_PEEK | MSG_DONTWAIT);
    if (got >= (ssize_t)sizeof first.head && first.head.kind == ROS_STARTED)
        return FROB_OK;
    if (got == (ssize_t)sizeof first && first.head.kind == ROS_REFUSED)
        snprintf(message, room, "%s", first.reason);
    else
        snprintf(message, room, "the ROS 2 node could not start");
    return FROB_NOT_FOUND;
}

/* Waits for the process to end, after its socket was closed. */
static void close_node(struct line *line)
{
    static const struct timespec pause = { 0, 1000000 };
    pid_t gone = 0;
    if (line->process == 0)
        return;
    for (int ms = 0; gone == 0 && ms < END_MS; ms++) {
        gone = waitpid(line->process, NULL, WNOHANG);
        if (gone == 0)
            nanosleep(&pause, NULL);
    }
    if (gone == 0) {
        kill(line->process, SIGKILL);
        while (waitpid(line->process, NULL, 0) < 0 && errno == EINTR)
            continue;
    }
    line->process = 0;
}

static enum frob_status open_node(struct line *line, const double *settings, char *message,
                                  size_t room)
{
    int sockets[2];
    enum frob_status status;
    if (socketpair(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC, 0, sockets) != 0) {
        snprintf(message, room, "cannot start the ROS 2 node: %s", strerror(errno));
        return FROB_LOST;
    }
    fflush(NULL);
    line->process = fork();
    if (line->process == 0)
        become_node(line, settings, sockets[1]);
    close(sockets[1]);
    if (line->process < 0) {
        snprintf(message, room, "cannot start the ROS 2 node: %s", strerror(errno));
        line->process = 0;
        close(sockets[0]);
        return FROB_LOST;
    }
    status = wait_until_started(sockets[0], message, room);
    if (status == FROB_OK)
        frob_posix_adopt(&line->port, sockets[0]);
    else
        close(sockets[0]);
    if (status != FROB_OK)
        close_node(line);
    return status;
}

const struct line_opening ros_opening = {
    .option = "--ros-args",
    .usage =
        "  --ros-args ARG... [--]\n"
        "                     arguments for ROS 2, up to `--`, such as `-r odom:=NAME` to remap\n"
        "                     a topic, or `-r __node:=NAME` to rename the node\n",
    .lost = "the process of the ROS 2 node has ended",
    .open = open_node,
    .close = close_node,
    .give = ros_device_give,
};

/* ---- The node's side */

bool ros_is_node(int argc, char **argv, const struct frob_program *program, int *status)
{
    struct node_options options;
    if (argc < 4 || strcmp(argv[1], ROS_NODE_OPTION) != 0)
        return false;
    options.program = program;
    options.socket = (int)strtol(argv[2], NULL, 10);
    options.stamped = argv[3][0] == '1';
    options.argc = argc - 3;
    options.argv = argv + 3;
    *status = node_run(&options);
    return true;
}
