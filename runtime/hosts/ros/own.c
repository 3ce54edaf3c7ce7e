#include "own.h"

#include <stdio.h>
#include <string.h>

#include "acceptance.h"
#include "device.h"
#include "readings.h"
#include "topics.h"

/* A topic that the program subscribes to. */
struct own_input {
    struct ros_topic topic;
    struct topic_parts parts;
    struct topic_span span;
    int64_t taken_ns; /* time at which the newest message was sent; INT64_MIN if none was sent in
                       * this session */
    bool fresh;       /* whether a message has arrived that the program has not read */
    uint32_t number;  /* number of the newest message */
    uint32_t read;    /* number of the message that the program read last */
};

/* The state of this driver. In memory, it is followed by the inputs, the names of the outputs, the
 * newest values in a struct of the program's input, and the message to send next. */
struct own_device {
    struct ros_device base;
    bool commanded; /* whether a command has been sent since the last stop */
};

struct output_name {
    char name[ROS_NAME];
};

static const struct frob_program *program;
static size_t output_size; /* size of the topics in the program's output struct */

/* ---- Memory layout */

static size_t aligned(size_t size)
{
    return (size + 15) / 16 * 16;
}

static size_t inputs_at(void)
{
    return aligned(sizeof(struct own_device));
}

static size_t names_at(void)
{
    return inputs_at() + aligned(program->node->input_count * sizeof(struct own_input));
}

static size_t values_at(void)
{
    return names_at() + aligned(program->node->output_count * sizeof(struct output_name));
}

static size_t message_at(void)
{
    return values_at() + aligned(program->input_size);
}

static char *part(const void *device, size_t at)
{
    return (char *)(uintptr_t)device + at;
}

static struct own_input *inputs_of(const void *device)
{
    return (struct own_input *)(void *)part(device, inputs_at());
}

static struct output_name *names_of(const void *device)
{
    return (struct output_name *)(void *)part(device, names_at());
}

/* ---- Messages from the node */

static void take_name(struct ros_device *d, const struct ros_named *named)
{
    char *name;
    if (named->is_output ? named->topic >= program->node->output_count
                         : named->topic >= program->node->input_count)
        return;
    name =
        named->is_output ? names_of(d)[named->topic].name : inputs_of(d)[named->topic].topic.name;
    snprintf(name, ROS_NAME, "%s", named->name);
}

static void take_message(struct ros_device *d, const struct ros_topic_message *message)
{
    struct own_input *input;
    size_t size;
    if (message->topic >= program->node->input_count)
        return;
    input = &inputs_of(d)[message->topic];
    size = input->span.end - input->span.first;
    if (message->head.size != sizeof *message + size)
        return;
    input->number = message->number;
    if (!ros_accepts(d, &input->topic, NULL, message->stamp_ns, message->arrived_ns,
                     &input->taken_ns))
        return;
    memcpy(part(d, values_at()) + input->span.first, message + 1, size);
    input->fresh = true;
}

static void take_other(struct ros_device *d, const struct ros_head *message)
{
    if (message->kind == ROS_NAMED)
        take_name(d, (const struct ros_named *)(const void *)message);
    else if (message->kind == ROS_TOPIC)
        take_message(d, (const struct ros_topic_message *)(const void *)message);
}

/* ---- The driver */

static void start(void *device, const double *settings, const struct frob_serial *serial,
                  const struct frob_clock *clock)
{
    struct own_device *own = (struct own_device *)device;
    frob_ros_driver.start(device, settings, serial, clock);
    own->base.take_other = take_other;
    own->commanded = false;
    for (size_t i = 0; i < program->node->input_count; i++) {
        struct own_input *input = &inputs_of(device)[i];
        memset(input, 0, sizeof *input);
        input->parts = topic_parts_of(program->input, &program->node->inputs[i]);
        input->span = topic_span_of(input->parts.whole);
        input->taken_ns = input->topic.received_ns = INT64_MIN;
    }
}

static bool is_plain(const struct own_input *input)
{
    return input->parts.event == NULL;
}

/* Finds the plain topic that was updated least recently, and returns the time of its newest
 * message. Topics that are events do not count, because their messages may arrive at any time. */
static int64_t sensed_ns(const void *device)
{
    const struct own_device *own = (const struct own_device *)device;
    int64_t oldest;
    if (own->base.started.node[0] == '\0')
        return INT64_MIN;
    oldest = frob_now_ns(&own->base.clock);
    for (size_t i = 0; i < program->node->input_count; i++) {
        const struct own_input *input = &inputs_of(device)[i];
        if (is_plain(input) && input->taken_ns < oldest)
            oldest = input->taken_ns;
    }
    return ros_placed_ns(&own->base, oldest);
}

static enum frob_status poll_device(void *device)
{
    struct own_device *own = (struct own_device *)device;
    const enum frob_status status = frob_ros_driver.poll(device);
    if (status != FROB_OK && status != FROB_BUSY_CONNECTING)
        return status;
    for (size_t i = 0; i < program->node->input_count; i++)
        if (is_plain(&inputs_of(device)[i]))
            ros_tell_silence(&own->base, &inputs_of(device)[i].topic,
                             "; the node does not run until one arrives");
    return sensed_ns(device) == INT64_MIN ? FROB_BUSY_CONNECTING : FROB_OK;
}

static int64_t due_ns(const void *device)
{
    (void)device;
    return INT64_MAX;
}

static void sense(void *device, void *values)
{
    for (size_t i = 0; i < program->node->input_count; i++) {
        struct own_input *input = &inputs_of(device)[i];
        const int32_t missed = (int32_t)(input->number - input->read - 1);
        char *at = (char *)values + input->span.first;
        if (input->fresh || is_plain(input))
            memcpy(at, part(device, values_at()) + input->span.first,
                   input->span.end - input->span.first);
        else
            memset(at, 0, input->span.end - input->span.first);
        if (input->fresh && input->parts.missed != NULL)
            memcpy((char *)values + input->parts.missed->offset, &missed, sizeof missed);
        if (input->fresh)
            input->read = input->number;
        input->fresh = false;
    }
}

static enum frob_status command(void *device, const void *output)
{
    struct own_device *own = (struct own_device *)device;
    struct ros_output *message = (struct ros_output *)(void *)part(device, message_at());
    memset(message, 0, sizeof *message);
    message->head.size = (uint32_t)(sizeof *message + output_size);
    message->head.kind = ROS_OUTPUT;
    message->rests = !own->commanded;
    memcpy(message + 1, output, output_size);
    own->commanded = true;
    return own->base.serial.operations->write(own->base.serial.port, (const uint8_t *)message,
                                              message->head.size);
}

static enum frob_status stop(void *device)
{
    struct own_device *own = (struct own_device *)device;
    const struct ros_head message = { (uint32_t)sizeof message, ROS_REST };
    own->commanded = false;
    return own->base.serial.operations->write(own->base.serial.port, (const uint8_t *)&message,
                                              sizeof message);
}

static void close_session(void *device)
{
    stop(device);
}

static bool stands(const void *device)
{
    (void)device;
    return true;
}

static const char *describe(const void *device)
{
    const struct own_device *own = (const struct own_device *)device;
    static char text[2000];
    size_t length;
    if (own->base.started.node[0] == '\0')
        return "";
    snprintf(text, sizeof text, "node %s", own->base.started.node);
    for (size_t i = 0; i < program->node->input_count; i++) {
        length = strlen(text);
        snprintf(text + length, sizeof text - length, "%s%s", i == 0 ? ", subscribes to " : ", ",
                 inputs_of(device)[i].topic.name);
    }
    for (size_t i = 0; i < program->node->output_count; i++) {
        length = strlen(text);
        snprintf(text + length, sizeof text - length, "%s%s", i == 0 ? ", publishes " : ", ",
                 names_of(device)[i].name);
    }
    return text;
}

const struct frob_driver *ros_own_driver(const struct frob_program *of)
{
    static struct frob_driver driver;
    program = of;
    output_size = topic_span_of(program->output).end;
    driver = frob_ros_driver;
    driver.setting_count = ROS_OWN_SETTINGS;
    driver.device_size = message_at() + sizeof(struct ros_output) + output_size;
    driver.input_size = driver.output_size = 0;
    driver.drives = NULL;
    driver.drive_count = 0;
    driver.start = start;
    driver.poll = poll_device;
    driver.due_ns = due_ns;
    driver.sensed_ns = sensed_ns;
    driver.sense = sense;
    driver.command = command;
    driver.stop = stop;
    driver.close = close_session;
    driver.stands = stands;
    driver.describe = describe;
    return &driver;
}
