/* Finds the persistent name of an adapter, which stays the same when it is plugged in again. */
#include "hal/posix/serial.h"

#include <dirent.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

bool frob_posix_lasting_name(const char *folder, const char *device, char *name, size_t room)
{
    char path[1024], wanted[4096], real[4096];
    struct stat status;
    struct dirent *entry;
    bool found = false;
    DIR *links;
    if (lstat(device, &status) != 0 || S_ISLNK(status.st_mode) || realpath(device, wanted) == NULL)
        return false;
    links = opendir(folder);
    if (links == NULL)
        return false;
    while (!found && (entry = readdir(links)) != NULL) {
        snprintf(path, sizeof path, "%.512s/%.256s", folder, entry->d_name);
        found = realpath(path, real) != NULL && strcmp(real, wanted) == 0;
    }
    closedir(links);
    return found && (size_t)snprintf(name, room, "%s", path) < room;
}
