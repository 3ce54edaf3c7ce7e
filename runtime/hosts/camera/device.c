/* Reads a camera of this computer through Video4Linux (linux/videodev2.h). The driver fills buffers
 * that are mapped into this process; the newest one is decoded in place. */
#include "decode.h"
#include "source.h"
#include "yuyv.h"

#include <errno.h>
#include <fcntl.h>
#include <linux/videodev2.h>
#include <poll.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/ioctl.h>
#include <sys/mman.h>
#include <unistd.h>

enum { BUFFERS_MOST = 4, WIDTH = 320, HEIGHT = 240 };

struct device {
    int file;
    struct v4l2_pix_format form;
    struct {
        uint8_t *bytes;
        size_t size;
    } buffers[BUFFERS_MOST];
    unsigned count;
    bool has_sequence;
    uint32_t sequence; /* number of the last frame */
};

static int request(const struct device *d, unsigned long what, void *argument)
{
    int result;
    do {
        result = ioctl(d->file, what, argument);
    } while (result < 0 && errno == EINTR);
    return result;
}

static enum source_result gone(struct source *s, const char *what)
{
    if (errno == ENODEV || errno == EIO)
        return source_fail(s, SOURCE_FAULT, "the camera was disconnected (%s): plug it in again",
                           strerror(errno));
    return source_fail(s, SOURCE_FAULT, "%s: %s", what, strerror(errno));
}

/* ---- Opening */

static bool is_camera(struct source *s, const struct device *d)
{
    struct v4l2_capability can;
    uint32_t caps;
    memset(&can, 0, sizeof can);
    if (request(d, VIDIOC_QUERYCAP, &can) != 0) {
        source_fail(s, SOURCE_FAULT,
                    "it is not a camera (%s): use a device that `ls /dev/video*` lists",
                    strerror(errno));
        return false;
    }
    caps = (can.capabilities & V4L2_CAP_DEVICE_CAPS) != 0 ? can.device_caps : can.capabilities;
    if ((caps & V4L2_CAP_VIDEO_CAPTURE) == 0 || (caps & V4L2_CAP_STREAMING) == 0) {
        source_fail(s, SOURCE_FAULT,
                    "this device of `%.32s` delivers no frames: many cameras have two devices, so "
                    "use the other one",
                    (const char *)can.card);
        return false;
    }
    return true;
}

/* Chooses the format to request: uncompressed for small frames, compressed for large ones, which
 * would otherwise exceed the bandwidth of USB. */
static uint32_t choose(const struct source *s, const struct device *d, int width)
{
    static const uint32_t small[] = { V4L2_PIX_FMT_YUYV, V4L2_PIX_FMT_MJPEG, V4L2_PIX_FMT_JPEG,
                                      V4L2_PIX_FMT_GREY };
    static const uint32_t large[] = { V4L2_PIX_FMT_MJPEG, V4L2_PIX_FMT_JPEG, V4L2_PIX_FMT_YUYV,
                                      V4L2_PIX_FMT_GREY };
    static const uint32_t grey[] = { V4L2_PIX_FMT_GREY, V4L2_PIX_FMT_YUYV, V4L2_PIX_FMT_MJPEG,
                                     V4L2_PIX_FMT_JPEG };
    const uint32_t *wanted = s->options->settings[CAMERA_GREY] > 0.0 ? grey
                             : width <= 640                          ? small
                                                                     : large;
    size_t best = 4;
    struct v4l2_fmtdesc offered;
    for (uint32_t i = 0; i < 64; i++) {
        memset(&offered, 0, sizeof offered);
        offered.index = i;
        offered.type = V4L2_BUF_TYPE_VIDEO_CAPTURE;
        if (request(d, VIDIOC_ENUM_FMT, &offered) != 0)
            break;
        for (size_t k = 0; k < best; k++)
            if (wanted[k] == offered.pixelformat)
                best = k;
    }
    return best < 4 ? wanted[best] : 0;
}

static bool set_form(struct source *s, struct device *d)
{
    const double *set = s->options->settings;
    const int width = set[CAMERA_WIDTH] > 0.0 ? (int)set[CAMERA_WIDTH] : WIDTH;
    const int height = set[CAMERA_HEIGHT] > 0.0 ? (int)set[CAMERA_HEIGHT] : HEIGHT;
    struct v4l2_format form;
    const uint32_t wanted = choose(s, d, width);
    memset(&form, 0, sizeof form);
    form.type = V4L2_BUF_TYPE_VIDEO_CAPTURE;
    form.fmt.pix.width = (uint32_t)width;
    form.fmt.pix.height = (uint32_t)height;
    form.fmt.pix.pixelformat = wanted;
    form.fmt.pix.field = V4L2_FIELD_ANY;
    if (wanted == 0) {
        source_fail(s, SOURCE_FAULT,
                    "it supports none of the formats YUYV, MJPEG and grey; use ffmpeg to write its "
                    "frames to a pipe as raw frames");
        return false;
    }
    if (request(d, VIDIOC_S_FMT, &form) != 0) {
        if (errno == EBUSY)
            source_fail(s, SOURCE_FAULT, "another program uses it: end that program first");
        else
            gone(s, "its driver rejects the requested frame format");
        return false;
    }
    d->form = form.fmt.pix;
    if (d->form.pixelformat != wanted ||
        (set[CAMERA_WIDTH] > 0.0 &&
         (d->form.width != (uint32_t)width || d->form.height != (uint32_t)height))) {
        source_fail(
            s, SOURCE_FAULT,
            "it cannot deliver frames of %d x %d, only of %u x %u: set width and height to that "
            "size",
            width, height, d->form.width, d->form.height);
        return false;
    }
    return true;
}

/* Requests the frame rate and returns the actual one. Some drivers have a fixed rate and reject the
 * request. */
static double set_rate(const struct source *s, const struct device *d)
{
    struct v4l2_streamparm p;
    const struct v4l2_fract *period = &p.parm.capture.timeperframe;
    memset(&p, 0, sizeof p);
    p.type = V4L2_BUF_TYPE_VIDEO_CAPTURE;
    p.parm.capture.timeperframe.numerator = 1000;
    p.parm.capture.timeperframe.denominator =
        (uint32_t)(1000.0 * s->options->settings[CAMERA_RATE] + 0.5);
    if (request(d, VIDIOC_S_PARM, &p) != 0 || period->numerator == 0)
        return 0.0;
    return (double)period->denominator / period->numerator;
}

static bool give_back(const struct device *d, uint32_t index)
{
    struct v4l2_buffer buffer;
    memset(&buffer, 0, sizeof buffer);
    buffer.type = V4L2_BUF_TYPE_VIDEO_CAPTURE;
    buffer.memory = V4L2_MEMORY_MMAP;
    buffer.index = index;
    return request(d, VIDIOC_QBUF, &buffer) == 0;
}

static bool map_buffers(struct device *d)
{
    struct v4l2_requestbuffers asked;
    memset(&asked, 0, sizeof asked);
    asked.count = BUFFERS_MOST;
    asked.type = V4L2_BUF_TYPE_VIDEO_CAPTURE;
    asked.memory = V4L2_MEMORY_MMAP;
    if (request(d, VIDIOC_REQBUFS, &asked) != 0 || asked.count == 0)
        return false;
    for (; d->count < asked.count && d->count < BUFFERS_MOST; d->count++) {
        struct v4l2_buffer buffer;
        void *bytes;
        memset(&buffer, 0, sizeof buffer);
        buffer.type = V4L2_BUF_TYPE_VIDEO_CAPTURE;
        buffer.memory = V4L2_MEMORY_MMAP;
        buffer.index = d->count;
        if (request(d, VIDIOC_QUERYBUF, &buffer) != 0)
            return false;
        bytes = mmap(NULL, buffer.length, PROT_READ | PROT_WRITE, MAP_SHARED, d->file,
                     (off_t)buffer.m.offset);
        if (bytes == MAP_FAILED)
            return false;
        d->buffers[d->count].bytes = (uint8_t *)bytes;
        d->buffers[d->count].size = buffer.length;
        if (!give_back(d, buffer.index)) {
            d->count++;
            return false;
        }
    }
    return true;
}

static void leave(struct device *d)
{
    int type = V4L2_BUF_TYPE_VIDEO_CAPTURE;
    if (d->count > 0)
        request(d, VIDIOC_STREAMOFF, &type);
    for (unsigned i = 0; i < d->count; i++)
        munmap(d->buffers[i].bytes, d->buffers[i].size);
    close(d->file);
    free(d);
}

static bool open_device(struct source *s)
{
    struct device *d = (struct device *)calloc(1, sizeof *d);
    int type = V4L2_BUF_TYPE_VIDEO_CAPTURE;
    double rate;
    if (d == NULL) {
        source_fail(s, SOURCE_FAULT, "not enough memory");
        return false;
    }
    d->file = open(s->options->source, O_RDWR | O_NONBLOCK | O_CLOEXEC);
    if (d->file < 0) {
        source_fail(s, SOURCE_FAULT, "it cannot be opened: %s%s", strerror(errno),
                    errno == ENOENT   ? "; plug it in, or use a device that `ls /dev/video*` lists"
                    : errno == EACCES ? "; join the group `video` with `sudo adduser $USER video`, "
                                        "then log out and in again"
                    : errno == EBUSY  ? "; another program uses it"
                                      : "");
        free(d);
        return false;
    }
    if (!is_camera(s, d) || !set_form(s, d)) {
        leave(d);
        return false;
    }
    rate = set_rate(s, d);
    if (!map_buffers(d) || request(d, VIDIOC_STREAMON, &type) != 0) {
        gone(s, "its driver cannot start delivering frames");
        leave(d);
        return false;
    }
    s->state = d;
    snprintf(s->what, sizeof s->what, "%.4s at %.3g Hz", (const char *)&d->form.pixelformat, rate);
    return true;
}

static void close_device(struct source *s)
{
    leave((struct device *)s->state);
}

/* ---- Frames */

/* Takes the newest of the driver's frames, if there is one, and returns the older ones to the
 * driver. */
static enum source_result take(struct source *s, struct device *d, struct v4l2_buffer *newest)
{
    enum source_result result = SOURCE_NOTHING;
    for (;;) {
        struct v4l2_buffer buffer;
        memset(&buffer, 0, sizeof buffer);
        buffer.type = V4L2_BUF_TYPE_VIDEO_CAPTURE;
        buffer.memory = V4L2_MEMORY_MMAP;
        if (request(d, VIDIOC_DQBUF, &buffer) != 0) {
            if (errno == EAGAIN)
                return result;
            return gone(s, "its driver cannot deliver a frame");
        }
        if (buffer.index >= d->count)
            return source_fail(s, SOURCE_FAULT, "its driver returned a buffer that does not exist");
        if (result == SOURCE_FRAME && !give_back(d, newest->index))
            return gone(s, "its driver rejects a buffer");
        if (d->has_sequence && buffer.sequence > d->sequence)
            s->lost += buffer.sequence - d->sequence - 1;
        if (result == SOURCE_FRAME)
            s->lost++;
        d->has_sequence = true;
        d->sequence = buffer.sequence;
        *newest = buffer;
        result = SOURCE_FRAME;
    }
}

static int64_t time_of(const struct v4l2_buffer *buffer)
{
    const int64_t now = source_now_ns();
    const int64_t stamp =
        (int64_t)buffer->timestamp.tv_sec * 1000000000 + (int64_t)buffer->timestamp.tv_usec * 1000;
    const bool is_monotonic =
        (buffer->flags & V4L2_BUF_FLAG_TIMESTAMP_MASK) == V4L2_BUF_FLAG_TIMESTAMP_MONOTONIC;
    return is_monotonic && stamp > 0 && stamp <= now ? stamp : now;
}

static const char *decode(const struct source *s, const struct device *d,
                          const struct v4l2_buffer *buffer, struct captured *frame,
                          char message[256])
{
    const uint8_t *bytes = d->buffers[buffer->index].bytes;
    const size_t room = d->buffers[buffer->index].size;
    const size_t size = buffer->bytesused < room ? buffer->bytesused : room;
    const bool is_grey =
        s->options->settings[CAMERA_GREY] > 0.0 || d->form.pixelformat == V4L2_PIX_FMT_GREY;
    const char *fault;
    if ((buffer->flags & V4L2_BUF_FLAG_ERROR) != 0)
        return "the driver reports a damaged frame; try another cable or hub";
    if (d->form.pixelformat == V4L2_PIX_FMT_MJPEG || d->form.pixelformat == V4L2_PIX_FMT_JPEG)
        return decode_jpeg(bytes, size, is_grey, frame, message);
    fault = decode_set_size(frame, d->form.width, d->form.height, is_grey ? FROB_GREY8 : FROB_RGB8,
                            message);
    if (fault != NULL)
        return fault;
    if (!yuyv_or_grey(bytes, size, d->form.bytesperline, d->form.pixelformat == V4L2_PIX_FMT_YUYV,
                      frame))
        return "a frame is truncated; try another cable or hub";
    return NULL;
}

static enum source_result next(struct source *s, struct captured *frame, int wait_ms)
{
    struct device *d = (struct device *)s->state;
    struct pollfd input = { d->file, POLLIN, 0 };
    struct v4l2_buffer buffer;
    enum source_result result;
    const char *fault;
    char message[256];
    if (poll(&input, 1, wait_ms) <= 0)
        return SOURCE_NOTHING;
    memset(&buffer, 0, sizeof buffer);
    result = take(s, d, &buffer);
    /* If poll reports an error and there is no frame, the device is gone. */
    if (result == SOURCE_NOTHING && (input.revents & (POLLERR | POLLHUP)) != 0)
        return source_fail(s, SOURCE_FAULT, "the camera was disconnected: plug it in again");
    if (result != SOURCE_FRAME)
        return result;
    frame->captured_ns = time_of(&buffer);
    fault = decode(s, d, &buffer, frame, message);
    if (!give_back(d, buffer.index))
        return gone(s, "its driver rejects a buffer");
    return fault == NULL ? SOURCE_FRAME : source_fail(s, SOURCE_BROKEN, "%s", fault);
}

const struct source_kind source_device = {
    open_device,
    next,
    close_device,
    true,
    "the driver has no frame; unplug the camera and plug it in again, or use another camera",
};
