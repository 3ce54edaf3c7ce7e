/* A fake camera: a preloaded library that implements the calls by which a program accesses
 * /dev/video7 (open, ioctl, mmap, poll), as Video4Linux does.
 *
 *   FAKE_FORM    the pixel format: YUYV, MJPG or GREY
 *   FAKE_SIZE    its only size, such as 64x48
 *   FAKE_FRAMES  a file: frames of 64 x 48 one after the other; JPEGs begin with FF D8
 *   FAKE_STATE   a file with the state of the camera: good, unplugged, busy, silent, frozen,
 *                damaged, short, hanging; read at each call */
#define _GNU_SOURCE
#include <dlfcn.h>
#include <errno.h>
#include <fcntl.h>
#include <linux/videodev2.h>
#include <poll.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <time.h>
#include <unistd.h>

enum { COUNT = 4, ROOM = 1 << 16, PERIOD_NS = 30000000 };

static int camera = -1; /* its file descriptor; -1: closed */
static uint8_t *buffers[COUNT];
static bool queued[COUNT];
static uint32_t sequence;
static int64_t due_ns;
static uint8_t *frames;
static size_t frames_size, at;

static bool is(const char *state)
{
    char text[32] = "";
    FILE *file = fopen(getenv("FAKE_STATE"), "r");
    if (file != NULL) {
        if (fscanf(file, "%31s", text) != 1)
            text[0] = '\0';
        fclose(file);
    }
    return strcmp(text, state) == 0;
}

static int64_t now_ns(void)
{
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return (int64_t)now.tv_sec * 1000000000 + now.tv_nsec;
}

static void sleep_ns(int64_t ns)
{
    const struct timespec pause = { (time_t)(ns / 1000000000), (long)(ns % 1000000000) };
    if (ns > 0)
        nanosleep(&pause, NULL);
}

static int fail(int fault)
{
    errno = fault;
    return -1;
}

static uint32_t form(void)
{
    const char *f = getenv("FAKE_FORM");
    return v4l2_fourcc(f[0], f[1], f[2], f[3]);
}

static void size(unsigned *width, unsigned *height)
{
    sscanf(getenv("FAKE_SIZE"), "%ux%u", width, height);
}

static void load(void)
{
    FILE *file = fopen(getenv("FAKE_FRAMES"), "rb");
    frames = (uint8_t *)malloc(1 << 22);
    frames_size = fread(frames, 1, 1 << 22, file);
    fclose(file);
    at = 0;
}

/* Copies the next frame into the buffer; returns its size. A frozen camera repeats the same
 * frame. */
static size_t fill(uint8_t *buffer)
{
    size_t length = form() == V4L2_PIX_FMT_GREY ? 64 * 48 : 64 * 48 * 2;
    const size_t from = at;
    if (form() == V4L2_PIX_FMT_MJPEG)
        for (length = 2; from + length + 1 < frames_size &&
                         !(frames[from + length] == 0xFF && frames[from + length + 1] == 0xD8);)
            length++;
    if (from + length > frames_size)
        length = frames_size - from;
    memcpy(buffer, frames + from, length);
    if (!is("frozen"))
        at = from + 2 * length > frames_size ? 0 : from + length;
    return is("short") ? length / 2 : length;
}

static int dequeue(struct v4l2_buffer *buffer)
{
    struct timespec now;
    if (now_ns() < due_ns || is("silent"))
        return fail(EAGAIN);
    due_ns = now_ns() + PERIOD_NS;
    for (uint32_t i = 0; i < COUNT; i++) {
        if (!queued[i])
            continue;
        queued[i] = false;
        memset(buffer, 0, sizeof *buffer);
        buffer->index = i;
        buffer->bytesused = (uint32_t)fill(buffers[i]);
        buffer->sequence = sequence++;
        buffer->flags =
            V4L2_BUF_FLAG_TIMESTAMP_MONOTONIC | (is("damaged") ? V4L2_BUF_FLAG_ERROR : 0);
        clock_gettime(CLOCK_MONOTONIC, &now);
        buffer->timestamp.tv_sec = now.tv_sec;
        buffer->timestamp.tv_usec = now.tv_nsec / 1000;
        return 0;
    }
    return fail(EAGAIN);
}

static int answer(unsigned long request, void *argument)
{
    struct v4l2_capability *can = (struct v4l2_capability *)argument;
    struct v4l2_fmtdesc *offer = (struct v4l2_fmtdesc *)argument;
    struct v4l2_format *wanted = (struct v4l2_format *)argument;
    struct v4l2_requestbuffers *asked = (struct v4l2_requestbuffers *)argument;
    struct v4l2_buffer *buffer = (struct v4l2_buffer *)argument;
    while (is("hanging"))
        sleep_ns(PERIOD_NS);
    if (is("unplugged"))
        return fail(ENODEV);
    switch (request) {
    case VIDIOC_QUERYCAP:
        memset(can, 0, sizeof *can);
        strcpy((char *)can->card, "A camera");
        can->capabilities = V4L2_CAP_VIDEO_CAPTURE | V4L2_CAP_STREAMING;
        return 0;
    case VIDIOC_ENUM_FMT:
        if (offer->index > 0)
            return fail(EINVAL);
        offer->pixelformat = form();
        return 0;
    case VIDIOC_S_FMT:
        if (is("busy"))
            return fail(EBUSY);
        size(&wanted->fmt.pix.width, &wanted->fmt.pix.height);
        wanted->fmt.pix.bytesperline = 0;
        return 0;
    case VIDIOC_S_PARM: return 0;
    case VIDIOC_REQBUFS: asked->count = COUNT; return 0;
    case VIDIOC_QUERYBUF:
        buffer->length = ROOM;
        buffer->m.offset = buffer->index * ROOM;
        return 0;
    case VIDIOC_QBUF: queued[buffer->index] = true; return 0;
    case VIDIOC_STREAMON: due_ns = now_ns(); return 0;
    case VIDIOC_STREAMOFF: return 0;
    case VIDIOC_DQBUF: return dequeue(buffer);
    }
    return fail(ENOTTY);
}

/* ---- The overridden functions */

int open(const char *path, int flags, ...)
{
    static int (*real)(const char *, int, ...);
    va_list arguments;
    int mode;
    if (real == NULL)
        *(void **)&real = dlsym(RTLD_NEXT, "open");
    va_start(arguments, flags);
    mode = (flags & O_CREAT) != 0 ? va_arg(arguments, int) : 0;
    va_end(arguments);
    if (strcmp(path, "/dev/video7") != 0)
        return real(path, flags, mode);
    if (is("unplugged"))
        return fail(ENOENT);
    if (frames == NULL)
        load();
    camera = real("/dev/null", O_RDWR);
    return camera;
}

int close(int file)
{
    static int (*real)(int);
    if (real == NULL)
        *(void **)&real = dlsym(RTLD_NEXT, "close");
    if (file == camera)
        camera = -1;
    return real(file);
}

int ioctl(int file, unsigned long request, ...)
{
    static int (*real)(int, unsigned long, ...);
    va_list arguments;
    void *argument;
    va_start(arguments, request);
    argument = va_arg(arguments, void *);
    va_end(arguments);
    if (real == NULL)
        *(void **)&real = dlsym(RTLD_NEXT, "ioctl");
    return file >= 0 && file == camera ? answer(request, argument) : real(file, request, argument);
}

void *mmap(void *where, size_t length, int protection, int flags, int file, off_t offset)
{
    static void *(*real)(void *, size_t, int, int, int, off_t);
    void *memory;
    if (real == NULL)
        *(void **)&real = dlsym(RTLD_NEXT, "mmap");
    if (file < 0 || file != camera)
        return real(where, length, protection, flags, file, offset);
    memory = real(NULL, length, protection, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    buffers[offset / ROOM] = (uint8_t *)memory;
    return memory;
}

int poll(struct pollfd *files, nfds_t count, int wait_ms)
{
    static int (*real)(struct pollfd *, nfds_t, int);
    int64_t left_ns;
    if (real == NULL)
        *(void **)&real = dlsym(RTLD_NEXT, "poll");
    if (count != 1 || files[0].fd < 0 || files[0].fd != camera)
        return real(files, count, wait_ms);
    if (is("unplugged")) {
        files[0].revents = POLLERR | POLLHUP;
        return 1;
    }
    left_ns = due_ns - now_ns();
    if (is("silent") || left_ns > wait_ms * INT64_C(1000000)) {
        sleep_ns(wait_ms * INT64_C(1000000));
        return 0;
    }
    sleep_ns(left_ns);
    files[0].revents = POLLIN;
    return 1;
}
