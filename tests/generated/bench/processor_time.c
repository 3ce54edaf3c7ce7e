/* processor_time RUNS COMMAND... -- runs a command several times and prints two numbers: the
 * least processor time of a run in milliseconds, which the machine's other work hardly affects,
 * and the largest peak memory of a run in kilobytes. Fails if the command does. */
#define _XOPEN_SOURCE 700
#include <stdio.h>
#include <stdlib.h>
#include <sys/resource.h>
#include <sys/time.h>
#include <sys/wait.h>
#include <unistd.h>

static double milliseconds(struct timeval t)
{
    return (double)t.tv_sec * 1e3 + (double)t.tv_usec / 1e3;
}

/* Processor time of all children that have ended so far. */
static double used(void)
{
    struct rusage usage;
    getrusage(RUSAGE_CHILDREN, &usage);
    return milliseconds(usage.ru_utime) + milliseconds(usage.ru_stime);
}

int main(int argc, char **argv)
{
    double least = -1;
    if (argc < 3) {
        fprintf(stderr, "usage: %s RUNS COMMAND...\n", argv[0]);
        return 2;
    }
    for (int runs = atoi(argv[1]); runs > 0; runs--) {
        const double before = used();
        int status;
        const pid_t child = fork();
        if (child == 0) {
            execvp(argv[2], argv + 2);
            perror(argv[2]);
            _exit(127);
        }
        if (child < 0 || waitpid(child, &status, 0) < 0 || status != 0) {
            fprintf(stderr, "%s failed\n", argv[2]);
            return 1;
        }
        const double took = used() - before;
        if (least < 0 || took < least)
            least = took;
    }
    struct rusage usage;
    getrusage(RUSAGE_CHILDREN, &usage);
    printf("%.1f %ld\n", least, usage.ru_maxrss);
    return 0;
}
