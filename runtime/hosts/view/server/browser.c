#include "browser.h"

#include <fcntl.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <errno.h>
#include <sys/wait.h>
#include <unistd.h>

static char file_name[512];

static bool is_set(const char *name)
{
    const char *value = getenv(name);
    return value != NULL && value[0] != '\0';
}

static bool write_page(const char *address)
{
    const char *folder = getenv("XDG_RUNTIME_DIR");
    int length =
        snprintf(file_name, sizeof file_name, "%s/frob-view-%ld.html", folder, (long)getpid());
    int number = length < (int)sizeof file_name
                     ? open(file_name, O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0600)
                     : -1;
    FILE *file = number < 0 ? NULL : fdopen(number, "w");
    bool ok = file != NULL;
    if (ok) {
        ok = fprintf(file,
                     "<!DOCTYPE html><title>Frob</title>"
                     "<meta http-equiv=\"refresh\" content=\"0; url=%s\">\n",
                     address) > 0;
        ok = fclose(file) == 0 && ok;
    }
    if (!ok)
        fprintf(stderr, "warning: cannot open a browser: cannot write %s: %s\n", file_name,
                strerror(errno));
    return ok;
}

/* Starts the browser in the background. Its output is discarded, because it is of no use to Frob
 * users. */
static void start_browser(void)
{
    pid_t child = fork();
    if (child == 0) {
        int null = open("/dev/null", O_RDWR);
        if (fork() != 0)
            _exit(0);
        for (int number = 0; null >= 0 && number <= 2; number++)
            dup2(null, number);
        execlp("xdg-open", "xdg-open", file_name, (char *)NULL);
        _exit(1);
    }
    if (child > 0)
        waitpid(child, NULL, 0);
}

void browser_open(const char *address)
{
    if ((is_set("DISPLAY") || is_set("WAYLAND_DISPLAY")) && is_set("XDG_RUNTIME_DIR") &&
        write_page(address))
        start_browser();
}

void browser_forget(void)
{
    if (file_name[0] != '\0')
        unlink(file_name);
}
