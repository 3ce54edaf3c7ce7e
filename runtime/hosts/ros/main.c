/* The main program of an executable that is a ROS 2 node: `frobc build --ros2` links it with a
 * compiled program, and `frobc run --ros2` starts it.
 *
 * The exit status is the same as in hosts/robot/main.c. */
#include "hosts/robot/host.h"

#include "camera.h"
#include "device.h"
#include "drawing.h"
#include "joy.h"
#include "opening.h"
#include "operated.h"
#include "overrides.h"
#include "own.h"

enum { WRONG_USE = 2 };

/* The compiled program. */
extern const struct frob_program frob_program;

int main(int argc, char **argv)
{
    struct camera_sources sources;
    struct overrides overrides;
    int status;
    if (ros_is_node(argc, argv, &frob_program, &status) || camera_is_node(argc, argv, &status))
        return status;
    overrides = overrides_of(argc, argv, &frob_program);
    if (overrides.argv == NULL)
        return WRONG_USE;
    overrides.argc = joy_settings(overrides.argc, overrides.argv, &frob_program);
    if (overrides.argc < 0)
        return WRONG_USE;
    operated_of(&frob_program);
    sources = camera_sources_of(overrides.argc, overrides.argv, &frob_program);
    if (sources.argv == NULL)
        return WRONG_USE;
    return host_run(sources.argc, sources.argv, drawing_hide(&frob_program),
                    frob_program.node != NULL ? ros_own_driver(&frob_program) : &frob_ros_driver,
                    &ros_opening);
}
