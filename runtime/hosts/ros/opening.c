#include "opening.h"

#include <errno.h>
#include <linux/sockios.h>
#include <poll.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/ioctl.h>
#include <sys/socket.h>
#include <sys/uio.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

#include "hosts/common/params.h"

#include "bumpers.h"
#include "drawing.h"
#include "device.h"
#include "joy.h"
#include "messages.h"
#include "hal/posix/clock.h"
#include "node.h"
#include "topics.h"

/* Maximum times for the node to join the ROS 2 system and to exit. */
enum { START_MS = 20000, END_MS = 1000 };

/* Minimum time between two drawings. */
#define SHOW_NS INT64_C(50000000)

/* ---- The supervisor's side */

/* The options on the command line of the node's process, between the socket and the ROS
 * arguments. */
static const char stamped_option[] = "stamped", sim_time_option[] = "sim_time",
                  lifecycle_option[] = "lifecycle", joy_option[] = "joy";

/* Returns the text NAME=VALUE of a parameter. */
static char *setting_of(const struct frob_param *param, const void *values)
{
    const size_t length = strlen(param->name) + 1, room = length + strlen(param->unit) + 400;
    char *setting = (char *)malloc(room);
    struct frob_text text;
    if (setting == NULL)
        _exit(1);
    snprintf(setting, room, "%s=", param->name);
    text = frob_text_in(setting + length, room - length);
    params_write(&text, param, values);
    return setting;
}

/* Replaces this process with the node:
 * `PROGRAM --ros-node SOCKET [OPTION]... [NAME=VALUE]... -- --ros-args ARGUMENT...`. */
static void become_node(const struct line *line, const double *settings, int own)
{
    const struct frob_program *program = line->params->program;
    char number[16];
    char **argv = (char **)calloc(line->argument_count + program->param_count + 10, sizeof *argv);
    size_t count = 0;
    const int fd = dup(own); /* without close-on-exec */
    if (argv == NULL || fd < 0)
        _exit(1);
    snprintf(number, sizeof number, "%d", fd);
    argv[count++] = program_invocation_name;
    argv[count++] = (char *)(uintptr_t)ROS_NODE_OPTION;
    argv[count++] = number;
    if (program->node == NULL && settings[ROS_STAMPED] > 0.0)
        argv[count++] = (char *)(uintptr_t)stamped_option;
    if (settings[ROS_SIM_TIME] > 0.0)
        argv[count++] = (char *)(uintptr_t)sim_time_option;
    if (settings[ROS_LIFECYCLE] > 0.0)
        argv[count++] = (char *)(uintptr_t)lifecycle_option;
    if (joy_is_used())
        argv[count++] = (char *)(uintptr_t)joy_option;
    for (size_t i = 0; i < program->param_count; i++)
        argv[count++] = setting_of(&program->params[i], line->params->values);
    argv[count++] = (char *)(uintptr_t)"--";
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
        snprintf(message, room, "the ROS 2 node did not start within %d s", START_MS / 1000);
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

/* Waits for the node's process to end after its socket has been closed. */
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
    if (!bumpers_check(line->params->program, line->arguments, line->argument_count, message, room))
        return FROB_REFUSED;
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

/* Text messages are dropped if more bytes than this are waiting in the socket, so that they never
 * delay a velocity. */
enum { WAITING_MOST = 65536 };

static size_t text_room(const struct line *line)
{
    return line->settings[ROS_INSTANTS] > 0.0 ? ROS_TEXT_MOST : 0;
}

static void publish_text(const struct line *line, int64_t number, const char *text, size_t length)
{
    static bool told;
    struct ros_text head;
    struct iovec parts[2];
    struct msghdr message;
    int waiting = 0;
    memset(&head, 0, sizeof head);
    head.head.size = (uint32_t)(sizeof head + length);
    head.head.kind = ROS_TEXT;
    head.number = number;
    parts[0].iov_base = &head;
    parts[0].iov_len = sizeof head;
    parts[1].iov_base = (void *)(uintptr_t)text;
    parts[1].iov_len = length;
    memset(&message, 0, sizeof message);
    message.msg_iov = parts;
    message.msg_iovlen = 2;
    if ((ioctl(line->port.fd, SIOCOUTQ, &waiting) == 0 && waiting > WAITING_MOST) ||
        (sendmsg(line->port.fd, &message, MSG_NOSIGNAL | MSG_DONTWAIT) < 0 && errno == EAGAIN)) {
        if (!told)
            fprintf(stderr, "warning: the node is too slow to publish all instants: a bag of this "
                            "run cannot be replayed to its end\n");
        told = true;
    }
}

/* Sends the program's drawing, at most twenty times a second. */
static void show(const struct line *line, const void *output)
{
    static const struct frob_value *drawing;
    static bool is_known, told;
    static int64_t shown_ns;
    const int64_t now = frob_now_ns(&frob_posix_clock);
    struct topic_span span;
    struct ros_marks head;
    struct iovec parts[2];
    struct msghdr message;
    int waiting = 0;
    if (!is_known)
        drawing = drawing_of(line->params->program);
    is_known = true;
    if (drawing == NULL || line->settings[ROS_MARKERS] <= 0.0 || now - shown_ns < SHOW_NS)
        return;
    span = topic_span_of(drawing);
    shown_ns = now;
    if (span.end - span.first > ROS_VALUE_MOST) {
        if (!told)
            fprintf(stderr, "warning: the program draws too many marks to publish them\n");
        told = true;
        return;
    }
    memset(&head, 0, sizeof head);
    head.head.size = (uint32_t)(sizeof head + span.end - span.first);
    head.head.kind = ROS_MARKS;
    parts[0].iov_base = &head;
    parts[0].iov_len = sizeof head;
    parts[1].iov_base = (char *)(uintptr_t)output + span.first;
    parts[1].iov_len = span.end - span.first;
    memset(&message, 0, sizeof message);
    message.msg_iov = parts;
    message.msg_iovlen = 2;
    /* If the line is busy or lost, the next drawing will replace this one. */
    if (ioctl(line->port.fd, SIOCOUTQ, &waiting) == 0 && waiting <= WAITING_MOST)
        waiting = (int)sendmsg(line->port.fd, &message, MSG_NOSIGNAL | MSG_DONTWAIT);
}

static void judge(const struct line *line, size_t claim, bool fails, bool is_void, const char *fate)
{
    struct ros_claim message;
    memset(&message, 0, sizeof message);
    message.head.size = (uint32_t)sizeof message;
    message.head.kind = ROS_CLAIM;
    message.claim = (uint32_t)claim;
    message.level = (uint8_t)(is_void ? ROS_WARN : fails ? ROS_ERROR : ROS_OK);
    snprintf(message.fate, sizeof message.fate, "%s", fate);
    if (send(line->port.fd, &message, sizeof message, MSG_NOSIGNAL | MSG_DONTWAIT) < 0)
        return; /* the next verdict replaces this one */
}

const struct line_opening ros_opening = {
    .option = "--ros-args",
    .usage =
        "  --lifecycle        be a managed node: wait until other nodes configure and activate it\n"
        "  --ros-args ARG... [--]\n"
        "                     arguments for ROS 2, up to `--`, such as `-r odom:=NAME` to remap\n"
        "                     a topic, or `-r __node:=NAME` to rename the node\n",
    .lost = "the process of the ROS 2 node has ended",
    .open = open_node,
    .close = close_node,
    .give = ros_device_give,
    .time_ns = ros_device_time_ns,
    .orders = ros_device_orders,
    .publish = publish_text,
    .judge = judge,
    .show = show,
    .publish_room = text_room,
};

/* ---- The node's side */

bool ros_is_node(int argc, char **argv, const struct frob_program *program, int *status)
{
    struct node_options options;
    struct params params;
    const char *const *settings;
    size_t count = 0;
    int i = 3;
    if (argc < 4 || strcmp(argv[1], ROS_NODE_OPTION) != 0)
        return false;
    memset(&options, 0, sizeof options);
    options.program = program;
    options.socket = (int)strtol(argv[2], NULL, 10);
    for (; i < argc && strcmp(argv[i], stamped_option) == 0; i++)
        options.stamped = true;
    for (; i < argc && strcmp(argv[i], sim_time_option) == 0; i++)
        options.use_sim_time = true;
    for (; i < argc && strcmp(argv[i], lifecycle_option) == 0; i++)
        options.is_managed = true;
    for (; i < argc && strcmp(argv[i], joy_option) == 0; i++)
        options.has_joystick = true;
    settings = (const char *const *)argv + i;
    for (; i < argc && strcmp(argv[i], "--") != 0; i++)
        count++;
    options.argc = argc - i;
    options.argv = argv + i;
    *status = 2;
    if (params_open(&params, program, settings, count)) {
        options.params = params.values;
        *status = node_run(&options);
    }
    params_close(&params);
    return true;
}
