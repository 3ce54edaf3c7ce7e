/* child.h -- child processes that end with their parent, however it ends. */
#ifndef FROB_HOST_CHILD_H
#define FROB_HOST_CHILD_H

#include <signal.h>
#include <sys/prctl.h>
#include <sys/types.h>
#include <unistd.h>

/* Must be called in a child process. `parent` is the process id of the parent, determined before
 * the fork. When the thread that forked the child ends (at the latest when its process ends), the
 * kernel sends signal `number` to the child, even after an exec. If the parent ended before this
 * call, the child exits here. */
static inline void child_ends_with(pid_t parent, int number)
{
    if (prctl(PR_SET_PDEATHSIG, number) != 0 || getppid() != parent)
        _exit(1);
}

#endif
