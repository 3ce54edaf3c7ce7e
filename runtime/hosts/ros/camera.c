#include "camera.h"

#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/prctl.h>
#include <unistd.h>

#include <frob/camera.h>
#include <rcl/error_handling.h>
#include <rcl/graph.h>
#include <rcl/rcl.h>
#include <rmw/qos_profiles.h>
#include <sensor_msgs/msg/compressed_image.h>
#include <sensor_msgs/msg/image.h>

#include "hosts/camera/source.h"

#define WAIT_NS INT64_C(1000000000)

/* The first argument of this executable in a camera process. It is followed by the pipe, the topic,
 * the name of the node, `--`, and the arguments for ROS. */
#define CAMERA_OPTION "--ros-camera"

enum { FAULT = 2, PIPE_SIZE = 1048576, NAME = 256 };

static const char scheme[] = SOURCE_TOPIC, ros_option[] = "--ros-args", node_rule[] = "__node:=";

/* ---- The program's side */

/* Returns the source in an argument of `--camera`: the part after `LABEL=`. */
static const char *source_in(const char *argument)
{
    const char *found = strstr(argument, scheme);
    if (found == NULL || (found != argument && found[-1] != '='))
        return NULL;
    return found + strlen(scheme);
}

/* Replaces this process with a camera process. If the ROS arguments name a node, they mean the
 * program's node, so the camera's node gets that name followed by `_camera`. */
static void become_camera(int pipe, const char *topic, int argc, char **argv,
                          const struct frob_program *program)
{
    char **own = (char **)calloc((size_t)argc + 8, sizeof *own), number[16], name[NAME];
    size_t count = 0;
    bool is_for_ros = false;
    if (own == NULL)
        _exit(FAULT);
    signal(SIGINT, SIG_IGN);
    prctl(PR_SET_PDEATHSIG, SIGTERM);
    snprintf(number, sizeof number, "%d", pipe);
    snprintf(name, sizeof name, "%s_camera", program->name);
    own[count++] = argv[0];
    own[count++] = (char *)(uintptr_t)CAMERA_OPTION;
    own[count++] = number;
    own[count++] = (char *)(uintptr_t)topic;
    own[count++] = name;
    own[count++] = (char *)(uintptr_t)"--";
    for (int i = 1; i < argc; i++) {
        const char *rule = i + 1 < argc ? strstr(argv[i + 1], node_rule) : NULL;
        is_for_ros = is_for_ros || strcmp(argv[i], ros_option) == 0;
        if (!is_for_ros)
            continue;
        if (strcmp(argv[i], "--") == 0)
            break;
        if (rule != NULL)
            snprintf(name, sizeof name, "%.200s_camera", rule + strlen(node_rule));
        if (rule != NULL)
            i++;
        else
            own[count++] = argv[i];
    }
    execv("/proc/self/exe", own);
    _exit(FAULT);
}

/* Starts a camera process. Returns the source of its frames for the host; NULL on failure. */
static char *start_camera(const char *label, size_t length, const char *topic, int argc,
                          char **argv, const struct frob_program *program)
{
    const size_t room = length + strlen(topic) + 40;
    char *source = (char *)malloc(room);
    int ends[2];
    pid_t process;
    if (source == NULL || pipe(ends) != 0) {
        fprintf(stderr, "error: cannot start the camera: %s\n", strerror(errno));
        return NULL;
    }
    fcntl(ends[1], F_SETPIPE_SZ, PIPE_SIZE);
    fflush(NULL);
    process = fork();
    if (process == 0) {
        close(ends[0]);
        become_camera(ends[1], topic, argc, argv, program);
    }
    close(ends[1]);
    if (process < 0) {
        fprintf(stderr, "error: cannot start the camera: %s\n", strerror(errno));
        return NULL;
    }
    snprintf(source, room, "%.*s%s%s#%d", (int)length, label, scheme, topic, ends[0]);
    return source;
}

static bool add(struct camera_sources *sources, char *source)
{
    if (source == NULL)
        sources->argv = NULL;
    else
        sources->argv[sources->argc++] = source;
    return source != NULL;
}

/* Starts one camera per label, even if several of the program's controls have the same label. */
static bool add_all(struct camera_sources *sources, int argc, char **argv,
                    const struct frob_program *program)
{
    for (size_t i = 0; i < program->control_count; i++) {
        const struct frob_control *control = &program->console[i];
        const size_t length = frob_camera_label(control);
        size_t first = 0;
        char label[80], topic[NAME];
        if (length == 0 || length > 60)
            continue;
        while (frob_camera_label(&program->console[first]) != length ||
               strncmp(program->console[first].label, control->label, length) != 0)
            first++;
        if (first < i)
            continue;
        snprintf(topic, sizeof topic, "%.*s/image_raw", (int)length, control->label);
        if (strcmp(topic, "camera/image_raw") == 0)
            snprintf(topic, sizeof topic, "image_raw");
        snprintf(label, sizeof label, "%.*s=", (int)length, control->label);
        sources->argv[sources->argc++] = (char *)(uintptr_t)"--camera";
        if (!add(sources, start_camera(label, length + 1, topic, argc, argv, program)))
            return false;
    }
    return true;
}

struct camera_sources camera_sources_of(int argc, char **argv, const struct frob_program *program)
{
    struct camera_sources sources = {
        1, (char **)calloc((size_t)argc + 2 * program->control_count + 1, sizeof *argv)
    };
    bool is_ours = true, has_camera = false;
    if (sources.argv == NULL) {
        fprintf(stderr, "error: not enough memory\n");
        return sources;
    }
    sources.argv[0] = argv[0];
    for (int i = 1; i < argc; i++)
        has_camera =
            has_camera || strcmp(argv[i], "--camera") == 0 || strcmp(argv[i], "--help") == 0;
    if (!has_camera && !add_all(&sources, argc, argv, program))
        return sources;
    for (int i = 1; i < argc; i++) {
        const char *topic =
            i > 1 && strcmp(argv[i - 1], "--camera") == 0 ? source_in(argv[i]) : NULL;
        is_ours = is_ours && strcmp(argv[i], ros_option) != 0;
        if (!is_ours || topic == NULL)
            sources.argv[sources.argc++] = argv[i];
        else if (!add(&sources, start_camera(argv[i], (size_t)(topic - argv[i]) - strlen(scheme),
                                             topic, argc, argv, program)))
            return sources;
    }
    return sources;
}

/* ---- The camera process */

struct camera {
    int pipe;
    bool is_compressed;
    const char *topic; /* after remapping */
    rcl_context_t context;
    rcl_node_t node;
    rcl_subscription_t subscription;
    sensor_msgs__msg__Image image;
    sensor_msgs__msg__CompressedImage compressed;
    bool heard, told_bad, told_silence, told_type;
    uint8_t *row; /* one row, with red and blue swapped */
    size_t row_size;
};

static bool joined(struct camera *c, const char *name, int argc, char **argv)
{
    rcl_init_options_t init = rcl_get_zero_initialized_init_options();
    rcl_node_options_t options = rcl_node_get_default_options();
    c->context = rcl_get_zero_initialized_context();
    c->node = rcl_get_zero_initialized_node();
    return rcl_init_options_init(&init, rcl_get_default_allocator()) == RCL_RET_OK &&
           rcl_init(argc, (char const *const *)argv, &init, &c->context) == RCL_RET_OK &&
           rcl_node_init(&c->node, name, "", &c->context, &options) == RCL_RET_OK;
}

/* According to the conventions of image_transport, the topic's name determines the type. */
static bool subscribed(struct camera *c, const char *topic)
{
    static const char end[] = "/compressed";
    const size_t length = strlen(topic), tail = sizeof end - 1;
    rcl_subscription_options_t options = rcl_subscription_get_default_options();
    const rosidl_message_type_support_t *type;
    c->is_compressed = length > tail && strcmp(topic + length - tail, end) == 0;
    type = c->is_compressed ? ROSIDL_GET_MSG_TYPE_SUPPORT(sensor_msgs, msg, CompressedImage)
                            : ROSIDL_GET_MSG_TYPE_SUPPORT(sensor_msgs, msg, Image);
    options.qos = rmw_qos_profile_sensor_data;
    options.qos.depth = 1; /* only the newest image is needed */
    c->subscription = rcl_get_zero_initialized_subscription();
    if (!sensor_msgs__msg__Image__init(&c->image) ||
        !sensor_msgs__msg__CompressedImage__init(&c->compressed) ||
        rcl_subscription_init(&c->subscription, &c->node, type, topic, &options) != RCL_RET_OK)
        return false;
    c->topic = rcl_subscription_get_topic_name(&c->subscription);
    return true;
}

/* Returns false if the pipe no longer has a reader. */
static bool put(const struct camera *c, const void *bytes, size_t count)
{
    const char *from = (const char *)bytes;
    while (count > 0) {
        const ssize_t done = write(c->pipe, from, count);
        if (done < 0 && errno == EINTR)
            continue;
        if (done < 0)
            return false;
        from += done;
        count -= (size_t)done;
    }
    return true;
}

static void tell_bad(struct camera *c, const char *why, const char *what)
{
    if (!c->told_bad)
        fprintf(stderr, "warning: an image on %s is ignored: %s%s\n", c->topic, why, what);
    c->told_bad = true;
}

/* Swaps red and blue. */
static const uint8_t *exchanged(struct camera *c, const uint8_t *from, size_t size)
{
    if (c->row_size < size) {
        free(c->row);
        c->row = (uint8_t *)malloc(size);
        c->row_size = c->row != NULL ? size : 0;
    }
    for (size_t i = 0; c->row != NULL && i + 2 < size; i += 3) {
        c->row[i] = from[i + 2];
        c->row[i + 1] = from[i + 1];
        c->row[i + 2] = from[i];
    }
    return c->row;
}

/* Writes an image as PPM or PGM. Returns false if the pipe no longer has a reader. */
static bool pass_image(struct camera *c)
{
    const sensor_msgs__msg__Image *m = &c->image;
    const char *encoding = m->encoding.data;
    const bool is_grey = strcmp(encoding, "mono8") == 0, is_bgr = strcmp(encoding, "bgr8") == 0;
    const size_t size = (size_t)m->width * (is_grey ? 1 : 3);
    char head[64];
    bool ok;
    if (!is_grey && !is_bgr && strcmp(encoding, "rgb8") != 0) {
        tell_bad(c, "its encoding is not rgb8, bgr8 or mono8, but ", encoding);
        return true;
    }
    if (m->width == 0 || m->height == 0 || m->step < size ||
        m->data.size < (size_t)m->step * (m->height - 1) + size) {
        tell_bad(c, "its data is shorter than its width and height require", "");
        return true;
    }
    snprintf(head, sizeof head, "%s\n%u %u\n255\n", is_grey ? "P5" : "P6", (unsigned)m->width,
             (unsigned)m->height);
    ok = put(c, head, strlen(head));
    for (uint32_t y = 0; ok && y < m->height; y++) {
        const uint8_t *row = m->data.data + (size_t)m->step * y;
        if (is_bgr)
            row = exchanged(c, row, size);
        ok = row != NULL && put(c, row, size);
    }
    return ok;
}

static bool pass_compressed(struct camera *c)
{
    const sensor_msgs__msg__CompressedImage *m = &c->compressed;
    if (m->data.size < 2 || m->data.data[0] != 0xff || m->data.data[1] != 0xd8) {
        tell_bad(c, "it is not a JPEG; its format is ", m->format.data);
        return true;
    }
    return put(c, m->data.data, m->data.size);
}

/* Reports a topic without a publisher, and a publisher with a different type; each only once. */
static void look_at_topic(struct camera *c)
{
    rcutils_allocator_t allocator = rcutils_get_default_allocator();
    rcl_topic_endpoint_info_array_t nodes = rcl_get_zero_initialized_topic_endpoint_info_array();
    const char *type =
        c->is_compressed ? "sensor_msgs/msg/CompressedImage" : "sensor_msgs/msg/Image";
    if (c->heard || rcl_get_publishers_info_by_topic(&c->node, &allocator, c->topic, false,
                                                     &nodes) != RCL_RET_OK) {
        rcl_reset_error();
        return;
    }
    if (nodes.size == 0 && !c->told_silence) {
        c->told_silence = true;
        fprintf(
            stderr,
            "warning: no node publishes %s (%s). Start the camera's node, or name its topic with "
            "`--camera ros:TOPIC`\n",
            c->topic, type);
    }
    for (size_t i = 0; i < nodes.size && !c->told_type; i++) {
        if (strcmp(nodes.info_array[i].topic_type, type) == 0)
            continue;
        c->told_type = true;
        fprintf(stderr, "warning: the node %s publishes %s on %s, but the camera needs %s\n",
                nodes.info_array[i].node_name, nodes.info_array[i].topic_type, c->topic, type);
    }
    if (rcl_topic_endpoint_info_array_fini(&nodes, &allocator) != RCL_RET_OK)
        rcl_reset_error();
}

static int pass_all(struct camera *c)
{
    rcl_wait_set_t set = rcl_get_zero_initialized_wait_set();
    void *message = c->is_compressed ? (void *)&c->compressed : (void *)&c->image;
    if (rcl_wait_set_init(&set, 1, 0, 0, 0, 0, 0, &c->context, rcl_get_default_allocator()) !=
        RCL_RET_OK)
        return FAULT;
    for (int waited = 0;; waited++) {
        bool has_one = false;
        if (rcl_wait_set_clear(&set) != RCL_RET_OK ||
            rcl_wait_set_add_subscription(&set, &c->subscription, NULL) != RCL_RET_OK)
            return FAULT;
        if (rcl_wait(&set, WAIT_NS) != RCL_RET_OK)
            rcl_reset_error();
        while (rcl_take(&c->subscription, message, NULL, NULL) == RCL_RET_OK)
            has_one = true;
        rcl_reset_error(); /* there are no more messages */
        c->heard = c->heard || has_one;
        if (has_one && !(c->is_compressed ? pass_compressed(c) : pass_image(c)))
            return 0;
        if (!c->heard && waited >= 2)
            look_at_topic(c);
    }
}

bool camera_is_node(int argc, char **argv, int *status)
{
    static struct camera camera;
    if (argc < 6 || strcmp(argv[1], CAMERA_OPTION) != 0)
        return false;
    signal(SIGPIPE, SIG_IGN);
    camera.pipe = (int)strtol(argv[2], NULL, 10);
    if (joined(&camera, argv[4], argc - 5, argv + 5) && subscribed(&camera, argv[3])) {
        *status = pass_all(&camera);
    } else {
        fprintf(stderr, "error: cannot receive the images of %s: %s\n", argv[3],
                rcl_get_error_string().str);
        *status = FAULT;
    }
    return true;
}
