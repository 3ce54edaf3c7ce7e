#include "devices.h"

#include <frob/console.h>
#include <frob/imu.h>
#include <frob/lidar.h>

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* A kind of device: how to open one, the names of the devices in the world, and what the kind is
 * called in messages and world files. */
struct kind {
    int (*open)(struct frob_sim *sim, const char *name);
    const char *(*name)(const struct frob_sim *sim, size_t number);
    const char *title, *table;
};

static const struct kind lidar = { frob_sim_open_lidar, frob_sim_lidar_name, "lidar", "lidar" };
static const struct kind imu = { frob_sim_open_imu, frob_sim_imu_name, "inertial measurement unit",
                                 "imu" };

/* Prints an error that names the table to add to the world file. */
static void tell_missing(const struct frob_sim *sim, const struct kind *kind, const char *name)
{
    fprintf(stderr, "error: the program uses %s %s, `%s`, but the robot in this world has",
            strcmp(kind->title, "lidar") == 0 ? "a" : "an", kind->title, name);
    if (kind->name(sim, 0) != NULL) {
        fprintf(stderr, " none with this name; it has");
        for (size_t i = 0; kind->name(sim, i) != NULL; i++)
            fprintf(stderr, "%s `%s`", i > 0 ? "," : "", kind->name(sim, i));
        fprintf(stderr,
                ": add `name = \"%s\"` to one of them in the world file, or write [[%s]] for each "
                "and add another one\n",
                name, kind->table);
    } else if (strcmp(name, kind->table) == 0) {
        fprintf(stderr, " none: add a table [%s] to the world file\n", kind->table);
    } else {
        fprintf(stderr, " none: add a table [%s] with name = \"%s\" to the world file\n",
                kind->table, name);
    }
}

/* Returns the length of the device's name in the control's label; 0 if the control is not
 * a lidar or an inertial measurement unit. */
static size_t name_length(const struct frob_control *control)
{
    return control->kind == FROB_IMU ? strlen(control->label) : frob_lidar_label(control);
}

/* Returns the first control that uses the same device as control `i`. */
static size_t first_user(const struct frob_program *program, size_t i)
{
    const struct frob_control *control = &program->console[i];
    const size_t length = name_length(control);
    size_t k = 0;
    while (program->console[k].kind != control->kind ||
           name_length(&program->console[k]) != length ||
           strncmp(program->console[k].label, control->label, length) != 0)
        k++;
    return k;
}

/* Returns the number of the device, or -1 if there is none. */
static int open_device(struct devices *d, const struct frob_control *control)
{
    const struct kind *kind = control->kind == FROB_IMU ? &imu : &lidar;
    const size_t length = name_length(control);
    char *name = (char *)calloc(1, length + 1);
    int number;
    if (name == NULL) {
        fprintf(stderr, "error: not enough memory for the sensors\n");
        return -1;
    }
    memcpy(name, control->label, length);
    number = kind->open(d->sim, name);
    if (number < 0)
        tell_missing(d->sim, kind, name);
    free(name);
    return number;
}

bool devices_open(struct devices *d, const struct frob_program *program, struct frob_sim *sim)
{
    bool ok = true;
    d->program = program;
    d->sim = sim;
    d->numbers = (int *)calloc(program->control_count + 1, sizeof *d->numbers);
    if (d->numbers == NULL) {
        fprintf(stderr, "error: not enough memory for the sensors\n");
        return false;
    }
    for (size_t i = 0; i < program->control_count; i++) {
        d->numbers[i] = -1;
        if (name_length(&program->console[i]) == 0)
            continue;
        if (first_user(program, i) < i)
            d->numbers[i] = d->numbers[first_user(program, i)];
        else
            d->numbers[i] = open_device(d, &program->console[i]);
        ok = ok && d->numbers[i] >= 0;
    }
    return ok;
}

/* Passes a new scan to all controls that use the lidar of control `first`. */
static void give_scan(const struct devices *d, size_t first, const struct frob_scan *scan,
                      int64_t now_ns, void *input)
{
    const struct frob_program *program = d->program;
    for (size_t i = first; i < program->control_count; i++)
        if (program->console[i].kind == FROB_LIDAR && first_user(program, i) == first)
            frob_lidar_give(&program->console[i], input, scan, now_ns);
}

/* Presses the bumpers of the robot `ros`. The bumpers are the console's hold buttons with these
 * labels. */
static void give_bumpers(const struct devices *d, size_t robot, void *input)
{
    const struct frob_sim_bumps bumps = frob_sim_bumps_robot(d->sim, robot);
    const struct {
        const char *label;
        int is_pressed;
    } each[] = { { "left bumper", bumps.left },
                 { "right bumper", bumps.right },
                 { "back bumper", bumps.back } };
    for (size_t i = 0; i < d->program->control_count; i++)
        for (size_t k = 0; k < sizeof each / sizeof each[0]; k++)
            if (d->program->console[i].kind == FROB_HOLD &&
                strcmp(d->program->console[i].label, each[k].label) == 0)
                frob_console_touch(d->program, input, i, each[k].is_pressed != 0 ? 1.0 : 0.0, 0.0);
}

void devices_give(const struct devices *d, size_t robot, int64_t now_ns, void *input)
{
    for (size_t i = 0; i < d->program->control_count; i++) {
        const struct frob_control *control = &d->program->console[i];
        if (d->numbers[i] < 0 || first_user(d->program, i) < i)
            continue;
        if (control->kind == FROB_IMU)
            frob_imu_give(control, input, frob_sim_imu(d->sim, robot, d->numbers[i], now_ns),
                          now_ns);
        else
            give_scan(d, i, frob_sim_scan(d->sim, robot, d->numbers[i], now_ns), now_ns, input);
    }
    if (strcmp(d->program->robot, "ros") == 0)
        give_bumpers(d, robot, input);
}

void devices_close(struct devices *d)
{
    free(d->numbers);
    d->numbers = NULL;
}
