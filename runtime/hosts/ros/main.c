/* The main program of an executable that is a ROS 2 node: `frobc build --ros2` links it with a
 * compiled program, and `frobc run --ros2` starts it.
 *
 * Exit status: as in hosts/robot/main.c. */
#include "hosts/robot/host.h"

#include "device.h"
#include "opening.h"

/* The compiled program. */
extern const struct frob_program frob_program;

int main(int argc, char **argv)
{
    int status;
    if (ros_is_node(argc, argv, &frob_program, &status))
        return status;
    return host_run(argc, argv, &frob_program, &frob_ros_driver, &ros_opening);
}
