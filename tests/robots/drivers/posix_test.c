/* Tests the POSIX serial line on pseudo-terminals. */
#include "check.h"

#include "hal/posix/clock.h"
#include "hal/posix/serial.h"

#include <asm/ioctls.h>
#include <asm/termbits.h>
#include <dirent.h>
#include <fcntl.h>
#include <netinet/in.h>
#include <stdlib.h>
#include <string.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

/* Declared here because <sys/ioctl.h> would include the conflicting termios. */
extern int ioctl(int fd, unsigned long request, ...);

static int other; /* the other end of the line */
static char device[128];
static char message[512];

static void plug(void)
{
    other = posix_openpt(O_RDWR | O_NOCTTY | O_NONBLOCK);
    grantpt(other);
    unlockpt(other);
    snprintf(device, sizeof device, "%s", ptsname(other));
}

static unsigned rate_of_line(void)
{
    struct termios2 settings;
    return ioctl(other, TCGETS2, &settings) == 0 ? settings.c_ospeed : 0;
}

static int open_files(void)
{
    int count = 0;
    DIR *files = opendir("/proc/self/fd");
    while (files != NULL && readdir(files) != NULL)
        count++;
    closedir(files);
    return count;
}

static int64_t now(void)
{
    return frob_now_ns(&frob_posix_clock);
}

static void bytes_pass(void)
{
    static const uint8_t all[] = { 0x00, 0x03, 0x0A, 0x0D, 0x11, 0x13, 0x1A, 0x7F, 0xFF };
    struct frob_posix_line line;
    struct frob_serial s;
    uint8_t bytes[32];
    size_t count = 9;
    int64_t started;
    plug();
    check(frob_posix_open(&line, device, 9600, message, sizeof message) == FROB_OK, "opens");
    s = frob_posix_serial(&line);
    check(s.operations->read(s.port, bytes, sizeof bytes, &count) == FROB_OK && count == 0,
          "no bytes are no failure");
    check(s.operations->write(s.port, all, sizeof all) == FROB_OK &&
              read(other, bytes, sizeof bytes) == (ssize_t)sizeof all &&
              memcmp(bytes, all, sizeof all) == 0,
          "every byte passes as it is");
    check(write(other, all, sizeof all) == (ssize_t)sizeof all &&
              s.operations->wait(s.port, now() + 1000000000) == FROB_OK &&
              s.operations->read(s.port, bytes, sizeof bytes, &count) == FROB_OK &&
              count == sizeof all && memcmp(bytes, all, sizeof all) == 0,
          "in both directions");
    started = now();
    check(s.operations->wait(s.port, started + 20000000) == FROB_TIMEOUT &&
              now() - started >= 20000000,
          "waiting ends at its time");
    write(other, "junk", 4);
    s.operations->wait(s.port, now() + 1000000000);
    check(s.operations->discard(s.port) == FROB_OK &&
              s.operations->read(s.port, bytes, sizeof bytes, &count) == FROB_OK && count == 0,
          "what has arrived can be forgotten");
    close(other);
    started = now();
    s.operations->wait(s.port, started + 1000000000);
    check(now() - started < 900000000, "a line that hangs up ends waiting");
    check(s.operations->read(s.port, bytes, sizeof bytes, &count) == FROB_LOST &&
              s.operations->wait(s.port, now() + 1000000000) == FROB_LOST &&
              s.operations->write(s.port, all, 1) == FROB_LOST &&
              s.operations->set_rate(s.port, 9600) == FROB_LOST,
          "a line that has hung up is lost");
    frob_posix_close(&line);
}

static void a_full_line(void)
{
    static uint8_t much[65536];
    struct frob_posix_line line;
    struct frob_serial s;
    int64_t started, took;
    plug();
    frob_posix_open(&line, device, 9600, message, sizeof message);
    s = frob_posix_serial(&line);
    started = now();
    check(s.operations->write(s.port, much, sizeof much) == FROB_TIMEOUT, "a full line times out");
    took = now() - started;
    check(took >= FROB_WRITE_PATIENCE_NS && took < 50 * FROB_WRITE_PATIENCE_NS,
          "after its patience");
    started = now();
    frob_posix_close(&line);
    check(now() - started < INT64_C(5000000000), "closing does not wait for it for long");
    close(other);
}

static void rates(void)
{
    static const uint32_t tried[] = { 9600, 57600, 115200, 12345, 250000, 1000000 };
    struct frob_posix_line line;
    struct frob_serial s;
    bool all = true;
    plug();
    frob_posix_open(&line, device, 38400, message, sizeof message);
    check(rate_of_line() == 38400, "opens with a rate");
    s = frob_posix_serial(&line);
    for (size_t i = 0; i < sizeof tried / sizeof tried[0]; i++)
        all = all && s.operations->set_rate(s.port, tried[i]) == FROB_OK &&
              rate_of_line() == tried[i];
    check(all, "takes any rate");
    frob_posix_close(&line);
    close(other);
}

/* Opens a device without permission; if this process is root, as another user. */
static bool denied(void)
{
    int status = 0;
    pid_t pid;
    chmod(device, 0600);
    fflush(stdout);
    pid = fork();
    if (pid == 0) {
        struct frob_posix_line line;
        bool right;
        if (geteuid() == 0 && (setgid(65534) != 0 || setuid(65534) != 0))
            _exit(2);
        else if (geteuid() != 65534)
            chmod(device, 0);
        right = frob_posix_open(&line, device, 9600, message, sizeof message) == FROB_DENIED &&
                strstr(message, "permission denied") != NULL &&
                strstr(message, "sudo adduser $USER ") != NULL;
        _exit(right ? 0 : 1);
    }
    waitpid(pid, &status, 0);
    return WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

static void refusals(void)
{
    struct frob_posix_line line;
    int status = 0;
    pid_t pid;
    plug();
    check(denied(), "permission denied tells which group to join");
    chmod(device, 0620);
    frob_posix_open(&line, device, 9600, message, sizeof message);
    fflush(stdout);
    pid = fork();
    if (pid == 0) {
        struct frob_posix_line second;
        char holder[64];
        snprintf(holder, sizeof holder, "posix_test (process %ld)", (long)getppid());
        close(line.fd);
        _exit(frob_posix_open(&second, device, 9600, message, sizeof message) == FROB_IN_USE &&
                      strstr(message, holder) != NULL
                  ? 0
                  : 1);
    }
    waitpid(pid, &status, 0);
    check(status == 0, "a line in use names who holds it");
    frob_posix_close(&line);
    close(other);
    check(frob_posix_open(&line, "/dev/null", 9600, message, sizeof message) == FROB_UNSUPPORTED &&
              line.fd == -1,
          "/dev/null is no serial line");
    check(frob_posix_open(&line, "no/such", 9600, message, sizeof message) == FROB_NOT_FOUND &&
              line.fd == -1,
          "a device that is not there");
}

static void lasting_names(void)
{
    char folder[] = "by_id_XXXXXX", path[256], name[512];
    plug();
    check(mkdtemp(folder) != NULL, "a folder of names");
    snprintf(path, sizeof path, "%s/usb-FTDI_1234-if00-port0", folder);
    check(symlink(device, path) == 0 &&
              frob_posix_lasting_name(folder, device, name, sizeof name) && strcmp(name, path) == 0,
          "the name that an adapter keeps");
    check(!frob_posix_lasting_name(folder, path, name, sizeof name), "not of a name that it keeps");
    check(!frob_posix_lasting_name(folder, "/dev/null", name, sizeof name) &&
              !frob_posix_lasting_name("no/folder", device, name, sizeof name),
          "not of other devices, not without names");
    unlink(path);
    rmdir(folder);
    close(other);
}

static void no_leaks(void)
{
    struct frob_posix_line line;
    int before = open_files();
    for (int i = 0; i < 50; i++) {
        plug();
        frob_posix_open(&line, device, 9600, message, sizeof message);
        close(other);
        frob_posix_close(&line);
        frob_posix_open(&line, device, 9600, message, sizeof message);
        frob_posix_open(&line, "/dev/null", 9600, message, sizeof message);
        frob_posix_open(&line, "tcp:127.0.0.1:1", 9600, message, sizeof message);
    }
    check(open_files() == before, "fifty lines that come and go leave nothing open");
}

/* A server that does not answer because its queue is full. The line must be reopened once the
 * server answers, and each attempt before that must end soon. */
static void tcp_again(void)
{
    struct sockaddr_in address;
    socklen_t size = sizeof address;
    struct frob_posix_line line;
    struct frob_serial serial;
    int server = socket(AF_INET, SOCK_STREAM, 0), queued[8], accepted;
    int64_t began_ns;
    enum frob_status status;
    memset(&address, 0, sizeof address);
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    bind(server, (const struct sockaddr *)&address, sizeof address);
    listen(server, 0);
    getsockname(server, (struct sockaddr *)&address, &size);
    snprintf(device, sizeof device, "tcp:127.0.0.1:%d", ntohs(address.sin_port));
    status = frob_posix_open(&line, device, 9600, message, sizeof message);
    accepted = accept(server, NULL, NULL);
    check(status == FROB_OK && accepted >= 0, "connects over TCP");
    frob_posix_close(&line);
    close(accepted);
    for (int i = 0; i < 8; i++) {
        queued[i] = socket(AF_INET, SOCK_STREAM | SOCK_NONBLOCK, 0);
        connect(queued[i], (const struct sockaddr *)&address, sizeof address);
    }
    began_ns = frob_now_ns(&frob_posix_clock);
    status = frob_posix_reopen(&line, device, 9600);
    check(status == FROB_NOT_FOUND && line.fd < 0 &&
              frob_now_ns(&frob_posix_clock) - began_ns < INT64_C(1500000000),
          "a server that does not answer is given up soon");
    for (int i = 0; i < 8; i++)
        close(queued[i]);
    close(server);
    server = socket(AF_INET, SOCK_STREAM, 0);
    accepted = 1;
    setsockopt(server, SOL_SOCKET, SO_REUSEADDR, &accepted, sizeof accepted);
    bind(server, (const struct sockaddr *)&address, sizeof address);
    listen(server, 1);
    check(frob_posix_reopen(&line, device, 9600) == FROB_OK, "and found when it is back");
    serial = frob_posix_serial(&line);
    check(serial.operations->set_rate(serial.port, 38400) == FROB_UNSUPPORTED,
          "the rate behind TCP is not ours to change");
    frob_posix_close(&line);
    close(server);
}

int main(void)
{
    tcp_again();
    bytes_pass();
    a_full_line();
    rates();
    refusals();
    lasting_names();
    no_leaks();
    return check_status();
}
