/* Tests the parts of a real camera that do no I/O: splitting a stream into frames, for any
 * content in any pieces; and processing a frame. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

#include "../drivers/check.h"
#include "hosts/camera/answer.h"
#include "hosts/camera/buffers.h"
#include "hosts/camera/chunks.h"
#include "hosts/camera/decode.h"
#include "hosts/camera/pair.h"
#include "hosts/camera/splitter.h"
#include "hosts/camera/yuyv.h"

static int failures = 0; /* failures of the current test */

#define CHECK(holds)                                                      \
    do {                                                                  \
        if (!(holds)) {                                                   \
            printf("     line %d does not hold: %s\n", __LINE__, #holds); \
            failures++;                                                   \
        }                                                                 \
    } while (0)

static void done(const char *name)
{
    check(failures == 0, name);
    failures = 0;
}

static uint8_t *load(const char *name, size_t *size)
{
    FILE *file = fopen(name, "rb");
    uint8_t *bytes = (uint8_t *)malloc(1 << 22);
    *size = fread(bytes, 1, 1 << 22, file);
    fclose(file);
    return bytes;
}

static uint32_t random_state = 1;

static uint32_t random_below(uint32_t n)
{
    random_state ^= random_state << 13;
    random_state ^= random_state >> 17;
    random_state ^= random_state << 5;
    return random_state % n;
}

/* Feeds a stream in pieces of random sizes; returns the number of frames found. */
static int split(const uint8_t *bytes, size_t size, size_t raw, uint32_t most_piece)
{
    struct splitter s;
    int frames = 0;
    CHECK(splitter_open(&s, raw));
    for (size_t at = 0; at < size;) {
        size_t room, length;
        int64_t begun;
        uint8_t *space = splitter_space(&s, &room);
        size_t piece = 1 + random_below(most_piece);
        if (piece > size - at)
            piece = size - at;
        if (piece > room)
            piece = room;
        memcpy(space, bytes + at, piece);
        at += piece;
        splitter_feed(&s, piece, (int64_t)at);
        while (splitter_take(&s, &length, &begun) != NULL) {
            CHECK(begun >= 0 && begun <= (int64_t)at);
            frames++;
        }
    }
    splitter_close(&s);
    return frames;
}

static void test_whole_streams(const uint8_t *jpeg, size_t size)
{
    static uint8_t noisy[1 << 22];
    size_t length = 0;
    int starts = 0;
    CHECK(split(jpeg, size, 0, 1) == 20);
    CHECK(split(jpeg, size, 0, 1000) == 20);
    CHECK(split(jpeg, size, 0, 1 << 20) == 20);
    CHECK(split(jpeg, 1000, 300, 7) == 3);
    /* With text between the frames, as in a multipart stream. */
    for (size_t i = 0; i < size; i++) {
        if (i + 1 < size && jpeg[i] == 0xFF && jpeg[i + 1] == 0xD8) {
            memcpy(noisy + length, "\r\n--x\r\nContent-Length: 5\r\n\r\n", 29);
            length += 29;
            starts++;
        }
        noisy[length++] = jpeg[i];
    }
    CHECK(starts == 20);
    CHECK(split(noisy, length, 0, 333) == 20);
}

/* Only the truncated frame itself must be lost; the next ones must be unaffected. */
static void test_torn_stream(const uint8_t *jpeg, size_t size)
{
    static uint8_t torn[1 << 22];
    struct jpeg_scan scan = { 0, false };
    size_t first;
    CHECK(jpeg_scan(&scan, jpeg, size) == JPEG_WHOLE);
    first = scan.at;
    for (size_t cut = 2; cut < first; cut += 97) {
        memcpy(torn, jpeg, cut);
        memcpy(torn + cut, jpeg + first, size - first);
        const int frames = split(torn, cut + size - first, 0, 5000);
        /* If the cut is within a segment, the segment's length covers the start of the next
         * frame. */
        CHECK(frames == 19 || (cut < 700 && frames >= 18));
    }
}

static void test_netpbm(void)
{
    static const char two[] = "P5 2 1 255\nab P6\n#c\n1 1\n255\nxyzP5 2\n";
    static const char large[] = "P6 9999 9999 255\n";
    struct captured frame;
    uint8_t pixels[64];
    char message[256];
    memset(&frame, 0, sizeof frame);
    frame.pixels = pixels;
    CHECK(split((const uint8_t *)two, sizeof two - 1, 0, 1) == 2);
    CHECK(decode_picture((const uint8_t *)two, 13, false, &frame, message) == NULL);
    CHECK(frame.width == 2 && frame.height == 1 && frame.format == FROB_GREY8 && pixels[1] == 'b');
    CHECK(decode_picture((const uint8_t *)two, 12, false, &frame, message) != NULL);
    CHECK(decode_picture((const uint8_t *)two + 14, 17, true, &frame, message) == NULL);
    CHECK(frame.format == FROB_GREY8 && pixels[0] == (77 * 'x' + 150 * 'y' + 29 * 'z' + 128) / 256);
    CHECK(split((const uint8_t *)large, sizeof large - 1, 0, 3) == 1);
    CHECK(decode_picture((const uint8_t *)large, sizeof large - 1, false, &frame, message) != NULL);
    CHECK(decode_picture((const uint8_t *)"P6 1 1 70000\n123456", 19, false, &frame, message) !=
          NULL);
    CHECK(decode_picture((const uint8_t *)"P6 0 1 255\n", 11, false, &frame, message) != NULL);
    CHECK(decode_picture((const uint8_t *)"GIF89a", 6, false, &frame, message) != NULL);
}

/* Grey and the primary colours, according to ITU-R BT.601. */
static void test_yuyv(void)
{
    static const uint8_t bytes[] = { 16, 128, 235, 128, 81, 90, 145, 240 };
    struct captured frame;
    uint8_t pixels[12];
    memset(&frame, 0, sizeof frame);
    frame.pixels = pixels;
    frame.width = 4;
    frame.height = 1;
    frame.format = FROB_RGB8;
    CHECK(yuyv_or_grey(bytes, sizeof bytes, 0, true, &frame));
    CHECK(pixels[0] == 0 && pixels[1] == 0 && pixels[2] == 0);
    CHECK(pixels[3] == 255 && pixels[4] == 255 && pixels[5] == 255);
    CHECK(pixels[6] >= 254 && pixels[7] <= 1 && pixels[8] <= 1); /* red */
    CHECK(!yuyv_or_grey(bytes, sizeof bytes - 1, 0, true, &frame));
    frame.format = FROB_GREY8;
    CHECK(yuyv_or_grey(bytes, sizeof bytes, 8, true, &frame));
    CHECK(pixels[0] == 0 && pixels[1] == 255);
    CHECK(yuyv_or_grey(bytes, sizeof bytes, 4, false, &frame) && pixels[2] == 235);
}

static void test_chunks(void)
{
    static const char sent[] = "5\r\nhello\r\n1;x=y\r\n,\r\n6 \r\n world\r\n0\r\n\r\nrest";
    for (size_t piece = 1; piece < sizeof sent; piece++) {
        char got[64] = "";
        struct chunks c;
        size_t length = 0;
        memset(&c, 0, sizeof c);
        for (size_t at = 0; at < sizeof sent - 1; at += piece) {
            uint8_t bytes[64];
            const size_t left = sizeof sent - 1 - at, count = left < piece ? left : piece;
            ptrdiff_t data;
            memcpy(bytes, sent + at, count);
            data = chunks_take(&c, bytes, count);
            CHECK(data >= 0);
            memcpy(got + length, bytes, (size_t)data);
            length += (size_t)data;
        }
        CHECK(length == 12 && memcmp(got, "hello, world", 12) == 0);
    }
    {
        struct chunks c;
        uint8_t wrong[] = "zz\r\n", longer[] = "2\r\nabc\r\n", endless[] = "fffffffffffffffff\r\n";
        memset(&c, 0, sizeof c);
        CHECK(chunks_take(&c, wrong, 4) < 0);
        memset(&c, 0, sizeof c);
        CHECK(chunks_take(&c, longer, 8) < 0);
        memset(&c, 0, sizeof c);
        CHECK(chunks_take(&c, endless, 19) < 0);
    }
}

static void test_addresses(void)
{
    struct address a;
    struct answer answer;
    size_t length = 0;
    static const char good[] =
        "HTTP/1.1 200 OK\r\ncontent-TYPE:  Text/HTML; x\r\nTransfer-encoding: "
        "Chunked\r\n\r\nbody";
    CHECK(address_read(&a, "http://camera.local/stream?x=1") &&
          strcmp(a.host, "camera.local") == 0 && strcmp(a.port, "80") == 0 &&
          strcmp(a.path, "/stream?x=1") == 0);
    CHECK(address_read(&a, "http://[::1]:8080") && strcmp(a.host, "::1") == 0 &&
          strcmp(a.port, "8080") == 0 && a.path[0] == '\0');
    CHECK(!address_read(&a, "http://"));
    CHECK(!address_read(&a, "http://:80/"));
    CHECK(!address_read(&a, "http://x:/"));
    CHECK(!address_read(&a, "http://x:123456/"));
    CHECK(!address_read(&a, "http://user@x/"));
    CHECK(!address_read(&a, "http://[::1/"));
    CHECK(!address_read(&a, "http://x/a b"));
    CHECK(!address_read(&a, "https://x/"));
    for (size_t k = 0; k < sizeof good - 5; k++)
        CHECK(answer_read(&answer, good, k, &length) == ANSWER_MORE);
    CHECK(answer_read(&answer, good, sizeof good - 1, &length) == ANSWER_GOOD);
    CHECK(length == sizeof good - 5 && answer.status == 200 && answer.is_chunked &&
          strcmp(answer.type, "text/html") == 0);
    CHECK(answer_read(&answer, "SSH-2.0", 7, &length) == ANSWER_WRONG);
    CHECK(answer_read(&answer, "HTTP/1.1 ok fine\r\n", 18, &length) == ANSWER_WRONG);
}

/* Frames from a writer that never stops: the reader's frame must not change, and each frame
 * must be newer than the one before. */
static void test_buffers(void)
{
    struct buffers *b = buffers_make();
    uint32_t last = 0;
    pid_t writer;
    int frames = 0;
    CHECK(b != NULL && buffers_take(b) == NULL && buffers_published(b) == NULL);
    writer = fork();
    if (writer == 0) {
        for (uint32_t k = 1;; k++) {
            struct captured *frame = buffers_back(b);
            frame->number = k;
            for (int i = 0; i < 1000; i++)
                ((volatile uint8_t *)frame->pixels)[i] = (uint8_t)k;
            buffers_publish(b);
        }
    }
    while (frames < 20000) {
        const struct captured *frame = buffers_take(b);
        uint8_t seen;
        if (frame == NULL)
            continue;
        frames++;
        seen = (uint8_t)frame->number;
        CHECK(frame->number > last);
        last = frame->number;
        for (int i = 0; i < 1000; i++)
            if (((volatile uint8_t *)frame->pixels)[i] != seen) {
                CHECK(false);
                break;
            }
    }
    kill(writer, SIGKILL);
    waitpid(writer, NULL, 0);
    buffers_free(b);
}

static void publish(struct buffers *b, uint32_t number, int64_t captured_ns)
{
    struct captured *frame = buffers_back(b);
    frame->number = number;
    frame->captured_ns = captured_ns;
    buffers_publish(b);
}

/* Two cameras, with times in milliseconds. The frames of the left and right camera have these
 * periods; the right one's are exposed `late` after the left one's and arrive `delay` later. The
 * program looks every `instant`. Runs for ten seconds and counts the pairs. */
struct two {
    int period, other_period, late, delay, instant;
    double within_s;
};

static uint32_t pairs_of(const struct two *two)
{
    enum { WHILE = 10000, MS = 1000000 };
    struct buffers *both[2] = { buffers_make(), buffers_make() };
    int64_t before[2] = { -1, -1 };
    struct pair p;
    uint32_t taken = 0;
    pair_init(&p, 1.0 / 30, two->within_s);
    for (int now = 0; now < WHILE; now++) {
        const int there = now - two->late - two->delay;
        const struct captured *frames[2];
        if (now % two->period == 0)
            publish(both[0], (uint32_t)(now / two->period), (int64_t)now * MS);
        if (there >= 0 && there % two->other_period == 0)
            publish(both[1], (uint32_t)(there / two->other_period),
                    (int64_t)(now - two->delay) * MS);
        if (now % two->instant != 0 || !pair_take(&p, both, frames))
            continue;
        taken++;
        for (int i = 0; i < 2; i++) {
            CHECK(frames[i]->captured_ns > before[i]);
            before[i] = frames[i]->captured_ns;
        }
        CHECK(llabs(before[0] - before[1]) <= pair_most_ns(&p));
    }
    CHECK(p.count == taken);
    buffers_free(both[0]);
    buffers_free(both[1]);
    return taken;
}

/* Whatever the offset of the two cameras' frames, and however often the program looks, it must
 * get a pair for almost every frame of the slower camera, or at every instant if instants are
 * rarer. */
static void test_pairs(void)
{
    static const int instants[] = { 1, 10, 20, 50, 100, 400 };
    struct two two = { 32, 32, 0, 0, 0, NAN };
    for (size_t i = 0; i < sizeof instants / sizeof *instants; i++)
        for (two.late = 0; two.late < two.period; two.late += 3) {
            const int rarer = instants[i] > two.period ? instants[i] : two.period;
            two.instant = instants[i];
            CHECK(pairs_of(&two) >= (uint32_t)(10000 / rarer - 3));
        }
    {
        const struct two slower = { 33, 100, 13, 0, 20, NAN }, slow = { 200, 200, 90, 0, 20, NAN };
        const struct two delayed = { 33, 33, 5, 60, 10, NAN }, strict = { 32, 32, 7, 0, 10, 0.006 };
        const struct two close = { 32, 32, 5, 0, 10, 0.006 }, lost = { 33, 33, 5, 150, 10, NAN };
        CHECK(pairs_of(&slower) >= 10000 / 100 - 3);
        /* the buffer needs time to learn that they are slow */
        CHECK(pairs_of(&slow) >= 10000 / 200 - 30);
        CHECK(pairs_of(&delayed) >= 10000 / 33 - 5);
        CHECK(pairs_of(&strict) == 0);
        CHECK(pairs_of(&close) >= 10000 / 32 - 3);
        CHECK(pairs_of(&lost) == 0); /* the left frames have been overwritten by then */
    }
}

static int64_t clock_ns(void)
{
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return (int64_t)now.tv_sec % 100000 * 1000000000 + now.tv_nsec;
}

/* Pairs from two processes, each writing frames with the same times. */
static void test_pairs_of_processes(void)
{
    struct buffers *both[2] = { buffers_make(), buffers_make() };
    pid_t writers[2];
    struct pair p;
    const struct captured *frames[2];
    const int64_t until = clock_ns() + 60 * INT64_C(1000000000);
    int64_t before = -1;
    int pairs = 0;
    pair_init(&p, 3e-3, 1e-3);
    for (int i = 0; i < 2; i++) {
        writers[i] = fork();
        if (writers[i] == 0) {
            for (uint32_t last = 0;;) {
                const uint32_t k = (uint32_t)(clock_ns() / 3000000);
                if (k > last) {
                    publish(both[i], k, (int64_t)k * 3000000);
                    last = k;
                }
                usleep(200);
            }
        }
    }
    while (pairs < 100 && clock_ns() < until)
        if (pair_take(&p, both, frames)) {
            CHECK(frames[0]->number == frames[1]->number);
            CHECK(frames[0]->captured_ns == frames[1]->captured_ns);
            CHECK(frames[0]->captured_ns > before);
            before = frames[0]->captured_ns;
            pairs++;
        }
    CHECK(pairs == 100);
    for (int i = 0; i < 2; i++) {
        kill(writers[i], SIGKILL);
        waitpid(writers[i], NULL, 0);
        buffers_free(both[i]);
    }
}

/* Frames with bytes changed, removed or duplicated, passed through the whole pipeline under
 * sanitizers: each results in a frame or none. */
static void test_damage(const uint8_t *jpeg, size_t size)
{
    static uint8_t damaged[1 << 22];
    struct jpeg_scan scan = { 0, false };
    struct captured frame;
    struct buffers *b = buffers_make();
    int good = 0, bad = 0;
    CHECK(jpeg_scan(&scan, jpeg, size) == JPEG_WHOLE);
    frame = *buffers_back(b);
    for (int round = 0; round < 3000; round++) {
        char message[256];
        size_t length = scan.at;
        const char *fault;
        memcpy(damaged, jpeg, length);
        for (uint32_t k = random_below(4); k > 0; k--)
            damaged[random_below(round % 2 ? 640 : (uint32_t)length)] = (uint8_t)random_below(256);
        if (random_below(2) == 0)
            length = random_below((uint32_t)length);
        split(damaged, length, 0, 3000);
        fault = decode_picture(damaged, length, random_below(4) == 0, &frame, message);
        if (round % 100 == 0) /* a good frame must decode after any damaged one */
            CHECK(decode_picture(jpeg, scan.at, false, &frame, message) == NULL);
        if (fault == NULL) {
            good++;
            CHECK(frame.width > 0 &&
                  (size_t)frame.width * (size_t)frame.height * 3 <= BUFFERS_ROOM);
        } else {
            bad++;
        }
    }
    CHECK(good > 100 && bad > 1000);
    buffers_free(b);
}

/* A JPEG without its end is rejected, wherever it is cut. */
static void test_truncated(const uint8_t *jpeg, size_t size)
{
    struct jpeg_scan scan = { 0, false };
    struct buffers *b = buffers_make();
    struct captured frame = *buffers_back(b);
    char message[256];
    CHECK(jpeg_scan(&scan, jpeg, size) == JPEG_WHOLE);
    CHECK(decode_picture(jpeg, scan.at, false, &frame, message) == NULL && frame.width == 320);
    for (size_t length = 0; length + 2 < scan.at; length += 13)
        CHECK(decode_picture(jpeg, length, false, &frame, message) != NULL);
    buffers_free(b);
}

int main(int argc, char **argv)
{
    size_t size = 0;
    uint8_t *jpeg = load(argv[argc - 1], &size);
    test_whole_streams(jpeg, size);
    done("streams are cut into frames, in whatever pieces they come");
    test_torn_stream(jpeg, size);
    done("a frame that breaks off costs no other");
    test_netpbm();
    done("PPM and PGM");
    test_yuyv();
    done("YUYV");
    test_chunks();
    done("chunks");
    test_addresses();
    done("addresses and answers");
    test_buffers();
    done("frames between processes");
    test_pairs();
    done("frames of two cameras are paired");
    test_pairs_of_processes();
    done("pairs between processes");
    test_truncated(jpeg, size);
    done("a JPEG that is cut is none");
    test_damage(jpeg, size);
    done("a damaged JPEG is a frame or none");
    free(jpeg);
    return check_status();
}
