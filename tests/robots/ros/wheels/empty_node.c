/* An rcl node without topics, whose memory figures.py compares with that of a program's node. It
 * ends when its standard input ends. */
#include <stdio.h>
#include <string.h>

#include <rcl/rcl.h>

int main(int argc, char **argv)
{
    rcl_init_options_t init = rcl_get_zero_initialized_init_options();
    rcl_node_options_t options = rcl_node_get_default_options();
    rcl_context_t context = rcl_get_zero_initialized_context();
    rcl_node_t node = rcl_get_zero_initialized_node();
    char text[8];
    if (rcl_init_options_init(&init, rcl_get_default_allocator()) != RCL_RET_OK ||
        rcl_init(argc, (char const *const *)argv, &init, &context) != RCL_RET_OK ||
        rcl_node_init(&node, "empty", "", &context, &options) != RCL_RET_OK)
        return 1;
    puts("started");
    fflush(stdout);
    return fgets(text, sizeof text, stdin) != NULL;
}
