/* Measures the time from a frame's source until a program can take it, and the time until a
 * camera delivers frames again after a failure (runtime/hosts/camera). Prints JSON, one object a
 * line.
 *
 *   frames on-the-way PIPE RAW JPEGS
 *       Frames of 320 by 240 in colour: raw frames and JPEGs of two files, through an existing
 *       pipe, and the JPEGs from their file; excludes the time for decoding.
 *   frames again COUNT AT_A_TIME
 *       Unplugs /dev/video7 and plugs it in again; then freezes it and lets it continue. Needs
 *       tests/robots/camera/fake_camera.c preloaded, and its variables except FAKE_STATE. */
#include "hosts/camera/capture.h"
#include "hosts/camera/decode.h"
#include "hosts/camera/splitter.h"

#include <fcntl.h>
#include <math.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

enum { WIDTH = 320, HEIGHT = 240, RAW = WIDTH * HEIGHT * 3, COUNT = 300, WARM = 20 };

static void fail(const char *what)
{
    fprintf(stderr, "frames: %s\n", what);
    exit(1);
}

static int by_size(const void *a, const void *b)
{
    const double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

static void row(const char *measure, double value, double aim, const char *unit)
{
    printf("{\"program\": \"camera\", \"measure\": \"%s\", \"compiler\": \"gcc\", "
           "\"value\": %.3f, \"reference\": %g, \"ratio\": %.3f, \"unit\": \"%s\"}\n",
           measure, value, aim, value / aim, unit);
    fflush(stdout);
}

static void rows(const char *measure, double *took, int count, double aim, const char *unit)
{
    char text[96];
    qsort(took, (size_t)count, sizeof *took, by_size);
    snprintf(text, sizeof text, "%s, median", measure);
    row(text, took[count / 2], aim, unit);
    snprintf(text, sizeof text, "%s, 99 %%", measure);
    row(text, took[(int)ceil(count * 0.99) - 1], aim, unit);
}

/* ---- The capturing process */

struct camera_process {
    struct buffers *buffers;
    pid_t process;
    int socket;
};

static struct camera_process begin(const struct camera_options *options)
{
    struct camera_process p;
    const pid_t parent = getpid();
    int sockets[2];
    p.buffers = buffers_make();
    if (p.buffers == NULL || socketpair(AF_UNIX, SOCK_SEQPACKET, 0, sockets) != 0)
        fail("no memory, or no sockets");
    p.process = fork();
    if (p.process == 0) {
        const struct capture_way way = { p.buffers, p.buffers, NULL };
        close(sockets[0]);
        capture_run(options, &way, sockets[1], parent);
    }
    close(sockets[1]);
    p.socket = sockets[0];
    buffers_begin(p.buffers);
    return p;
}

static void end(struct camera_process *p)
{
    close(p->socket);
    waitpid(p->process, NULL, 0);
    buffers_free(p->buffers);
}

/* Returns the next frame that was captured at this time or later; NULL if none arrives within
 * `seconds`. */
static const struct captured *await(struct camera_process *p, int64_t time_ns, int seconds)
{
    const int64_t until = source_now_ns() + seconds * INT64_C(1000000000);
    while (source_now_ns() < until) {
        const struct captured *frame = buffers_take(p->buffers);
        if (frame != NULL && frame->captured_ns >= time_ns)
            return frame;
        buffers_wait(p->buffers, 100);
    }
    return NULL;
}

static const struct captured *take_after(struct camera_process *p, int64_t time_ns)
{
    const struct captured *frame = await(p, time_ns, 10);
    if (frame == NULL)
        fail("no frame has come");
    return frame;
}

static struct camera_options options_of(const char *source)
{
    struct camera_options options;
    camera_options_init(&options, "camera", 6);
    options.source = source;
    return options;
}

/* ---- Transit time */

struct film {
    size_t sizes[COUNT];
    uint8_t *frames[COUNT];
};

static struct film cut(const char *name, size_t raw_size)
{
    static struct film film;
    struct splitter splitter;
    FILE *file = fopen(name, "rb");
    size_t size, room, got;
    int64_t begun;
    int count = 0;
    if (file == NULL || !splitter_open(&splitter, raw_size))
        fail("no film");
    while (count < COUNT) {
        const uint8_t *frame = splitter_take(&splitter, &size, &begun);
        if (frame != NULL) {
            film.frames[count] = (uint8_t *)malloc(size);
            memcpy(film.frames[count], frame, size);
            film.sizes[count++] = size;
            continue;
        }
        uint8_t *space = splitter_space(&splitter, &room);
        got = fread(space, 1, room < 65536 ? room : 65536, file);
        if (got == 0)
            fail("the film has too few frames");
        splitter_feed(&splitter, got, 0);
    }
    splitter_close(&splitter);
    fclose(file);
    return film;
}

/* Median decoding time in milliseconds; 0 for raw frames, which are only copied. */
static double decoding(const struct film *film)
{
    struct buffers *buffers = buffers_make();
    double took[COUNT];
    char message[256];
    for (int k = 0; k < COUNT; k++) {
        const int64_t before = source_now_ns();
        if (decode_picture(film->frames[k], film->sizes[k], false, buffers_back(buffers),
                           message) != NULL)
            fail(message);
        took[k] = (double)(source_now_ns() - before) * 1e-6;
    }
    buffers_free(buffers);
    qsort(took, COUNT, sizeof *took, by_size);
    return took[COUNT / 2];
}

/* Measures the time from writing a frame's first byte until the program can take it. */
static void through_pipe(const char *measure, const char *pipe, const struct film *film,
                         const struct camera_options *options, double decoding_ms)
{
    struct camera_process p = begin(options);
    const int file = open(pipe, O_WRONLY);
    double took[COUNT];
    for (int k = 0; k < COUNT; k++) {
        const int64_t before = source_now_ns();
        for (size_t at = 0; at < film->sizes[k];) {
            const ssize_t written = write(file, film->frames[k] + at, film->sizes[k] - at);
            if (written <= 0)
                fail("the pipe is not read");
            at += (size_t)written;
        }
        take_after(&p, before);
        took[k] = (double)(source_now_ns() - before) * 1e-6 - decoding_ms;
        source_sleep_until_ns(before + 10000000);
    }
    close(file);
    end(&p);
    rows(measure, took + WARM, COUNT - WARM, 1, "ms");
}

/* Measures the time since the moment at which a frame is due, which is its timestamp. On a busy
 * machine, some frames may be skipped. */
static void from_file(const char *measure, const struct camera_options *options, double decoding_ms)
{
    struct camera_process p = begin(options);
    double took[COUNT];
    int64_t last_ns = 0;
    int count = 0;
    for (const struct captured *frame;
         count < COUNT && (frame = await(&p, last_ns + 1, 1)) != NULL;) {
        took[count++] = (double)(source_now_ns() - frame->captured_ns) * 1e-6 - decoding_ms;
        last_ns = frame->captured_ns;
    }
    end(&p);
    if (count < COUNT / 2)
        fail("most frames of the file were skipped");
    rows(measure, took + WARM, count - WARM, 1, "ms");
}

static void on_the_way(char **arguments)
{
    struct camera_options options = options_of(arguments[0]);
    struct film film = cut(arguments[1], RAW);
    double decoding_ms;
    options.settings[CAMERA_FROZEN] = 0;
    options.settings[CAMERA_WIDTH] = WIDTH;
    options.settings[CAMERA_HEIGHT] = HEIGHT;
    through_pipe("raw, by a pipe, until it is input", arguments[0], &film, &options, 0);
    film = cut(arguments[2], 0);
    decoding_ms = decoding(&film);
    options.settings[CAMERA_WIDTH] = options.settings[CAMERA_HEIGHT] = 0;
    through_pipe("JPEG, by a pipe, likewise, decoded", arguments[0], &film, &options, decoding_ms);
    options.source = arguments[2];
    options.settings[CAMERA_RATE] = 100;
    from_file("JPEG, from a file, likewise", &options, decoding_ms);
}

/* ---- Recovery */

static void write_state(const char *name, const char *state)
{
    char other[64];
    FILE *file;
    snprintf(other, sizeof other, "%s.new", name);
    file = fopen(other, "w");
    if (file == NULL || fprintf(file, "%s\n", state) < 0 || fclose(file) != 0 ||
        rename(other, name) != 0)
        fail("the state of the camera cannot be written");
}

static void pause_ms(int least, int most)
{
    source_sleep_until_ns(source_now_ns() + (least + rand() % (most - least)) * INT64_C(1000000));
}

/* Makes one camera fail and recover `count` times; stores the recovery times in seconds. */
static void fail_often(int which, const char *state, double *took, int count)
{
    const struct camera_options options = options_of("/dev/video7");
    struct camera_process p;
    char name[48];
    snprintf(name, sizeof name, "state.%d", which);
    write_state(name, "good");
    setenv("FAKE_STATE", name, 1);
    srand((unsigned)which + 1);
    p = begin(&options);
    for (int k = 0; k < count; k++) {
        int64_t well_ns;
        take_after(&p, source_now_ns());
        pause_ms(300, 800);
        write_state(name, state);
        pause_ms(1300, 2300);
        write_state(name, "good");
        well_ns = source_now_ns();
        take_after(&p, well_ns);
        took[k] = (double)(source_now_ns() - well_ns) * 1e-9;
    }
    end(&p);
    unlink(name);
}

static void again(const char *measure, const char *state, int count, int at_a_time)
{
    const int each = count / at_a_time;
    const size_t size = (size_t)(each * at_a_time) * sizeof(double);
    double *took =
        (double *)mmap(NULL, size, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    int status;
    for (int i = 0; i < at_a_time; i++)
        if (fork() == 0) {
            fail_often(i, state, took + i * each, each);
            _exit(0);
        }
    for (int i = 0; i < at_a_time; i++)
        if (wait(&status) < 0 || status != 0)
            exit(1);
    rows(measure, took, each * at_a_time, 2, "s");
}

int main(int count, char **arguments)
{
    if (count == 5 && strcmp(arguments[1], "on-the-way") == 0) {
        on_the_way(arguments + 2);
        return 0;
    }
    if (count == 4 && strcmp(arguments[1], "again") == 0) {
        again("plugged in, until it gives frames", "unplugged", atoi(arguments[2]),
              atoi(arguments[3]));
        again("frozen no more, likewise", "frozen", atoi(arguments[2]), atoi(arguments[3]));
        return 0;
    }
    fail("on-the-way PIPE RAW JPEGS, or again COUNT AT_A_TIME");
}
