/* Searches Linux's /proc for the process that has a device open. */
#include "hal/posix/parts.h"

#include <dirent.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/types.h>
#include <unistd.h>

static bool is_number(const char *text)
{
    for (; *text >= '0' && *text <= '9'; text++)
        continue;
    return *text == '\0';
}

static bool has_open(const char *pid, const char *device)
{
    char folder[64], path[320], target[4096];
    struct dirent *entry;
    DIR *fds;
    bool found = false;
    snprintf(folder, sizeof folder, "/proc/%.16s/fd", pid);
    fds = opendir(folder);
    if (fds == NULL)
        return false;
    while (!found && (entry = readdir(fds)) != NULL) {
        ssize_t length;
        snprintf(path, sizeof path, "%s/%.200s", folder, entry->d_name);
        length = readlink(path, target, sizeof target - 1);
        if (length > 0) {
            target[length] = '\0';
            found = strcmp(target, device) == 0;
        }
    }
    closedir(fds);
    return found;
}

static void describe(const char *pid, char *name, size_t room)
{
    char path[64], command[64] = "a program";
    FILE *file;
    snprintf(path, sizeof path, "/proc/%.16s/comm", pid);
    file = fopen(path, "r");
    if (file != NULL) {
        if (fgets(command, sizeof command, file) != NULL)
            command[strcspn(command, "\n")] = '\0';
        fclose(file);
    }
    snprintf(name, room, "%s (process %.16s)", command, pid);
}

bool frob_posix_holder(const char *device, char *name, size_t room)
{
    char real[4096], self[32];
    struct dirent *entry;
    DIR *processes;
    bool found = false;
    if (realpath(device, real) == NULL)
        return false;
    snprintf(self, sizeof self, "%ld", (long)getpid());
    processes = opendir("/proc");
    if (processes == NULL)
        return false;
    while (!found && (entry = readdir(processes)) != NULL) {
        if (is_number(entry->d_name) && strcmp(entry->d_name, self) != 0 &&
            has_open(entry->d_name, real)) {
            describe(entry->d_name, name, room);
            found = true;
        }
    }
    closedir(processes);
    return found;
}
