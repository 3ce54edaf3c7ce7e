#include "live.h"

#include "seen.h"

#include "../../common/packed.h"

#include <frob/camera.h>

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

bool live_start(struct live *live, struct ring *ring, const char *file,
                const struct signals *signals, struct recording *recording)
{
    const struct frob_program *program = signals->program;
    memset(live, 0, sizeof *live);
    live->ring = ring;
    live->file = file;
    live->signals = signals;
    live->recording = recording;
    live->host = (long)getppid();
    if (ring->sizes.input != program->input_size || ring->sizes.output > program->output_size) {
        fprintf(stderr,
                "error: the running program is not the program that the viewer was started for\n");
        return false;
    }
    live->input = (unsigned char *)malloc(ring->sizes.input + 1);
    live->output = (unsigned char *)malloc(ring->sizes.output + 1);
    live->truth = (unsigned char *)malloc(ring->sizes.truth + 1);
    if (live->input == NULL || live->output == NULL || live->truth == NULL) {
        fprintf(stderr, "error: not enough memory for the program's input\n");
        return false;
    }
    return recording_begin(recording, signals, file != NULL ? file : "live", ring->sizes.truth);
}

void live_end(struct live *live)
{
    catching_end(live->catching);
    free(live->input);
    free(live->output);
    free(live->truth);
}

struct frames_of_event {
    struct frame_reader *frames;
    bool is_missing;
    uint32_t number;
};

/* Finds a frame by the key that replaces its address. The host wrote the frame's file before it
 * published the instant. */
static void from_key(void *context, const struct frob_image **image)
{
    struct frames_of_event *of = (struct frames_of_event *)context;
    uintptr_t key;
    memcpy(&key, image, sizeof key);
    *image = frame_reader_by_key(of->frames, key);
    if (*image == NULL && !of->is_missing) {
        of->is_missing = true;
        of->number = frames_number(key);
    }
}

static void find_frames(struct live *live)
{
    struct recording *recording = live->recording;
    for (size_t i = 0; i < recording->eye_count; i++) {
        struct frames_of_event of = { &recording->frames, false, 0 };
        frob_camera_images(recording->eyes[i], live->input, from_key, &of);
        if (of.is_missing)
            seen_lose(recording, recording->count, live->input, recording->eyes[i], of.number,
                      false);
    }
}

static void add(struct live *live, int64_t time_ns)
{
    const struct ring_sizes *sizes = &live->ring->sizes;
    find_frames(live);
    if (recording_add(live->recording, time_ns, live->input, live->output, sizes->output,
                      sizes->truth > 0 ? live->truth : NULL))
        return;
    live->full = true;
    buffer_text(&live->recording->notes,
                "not enough memory for more of this run: new instants are not stored\n");
}

/* Handles instants that were overwritten in the ring before they were read. Reads up to `most` of
 * them from the run's own recording. If that is impossible, skips them and adds a note about the
 * gap. */
static void make_up(struct live *live, size_t most)
{
    struct recording *recording = live->recording;
    const uint64_t missed = live->left, newest = ring_count(live->ring) - 1;
    if (recording->gap == NO_GAP && live->file != NULL) {
        const uint64_t end = missed + most < newest ? missed + most : newest;
        if (live->catching == NULL)
            live->catching = catching_start(live->signals, live->file);
        if (live->catching != NULL && catching_take(live->catching, recording, (size_t)end)) {
            live->left = end;
            return;
        }
    }
    live->left = newest;
    if (recording->gap != NO_GAP)
        return;
    recording->gap = recording->count;
    buffer_format(
        &recording->notes,
        "instants %llu to %llu are missing, because this viewer was stopped or too slow; "
        "from instant %lu on (as counted here), only inputs and outputs are shown%s\n",
        (unsigned long long)missed, (unsigned long long)newest - 1, (unsigned long)recording->gap,
        live->file == NULL              ? " (to avoid such gaps, run with --record)"
        : packed_by(live->file) != NULL ? " (to avoid such gaps, record to an uncompressed file)"
                                        : "");
}

static bool take(struct live *live, size_t most)
{
    const size_t before = live->recording->count;
    const bool ended = ring_has_ended(live->ring) || (long)getppid() != live->host;
    live->is_behind = true;
    for (size_t i = 0; i < most && !live->full; i++) {
        int64_t time_ns;
        switch (
            ring_read(live->ring, live->left, &time_ns, live->input, live->output, live->truth)) {
        case RING_READ:
            live->left++;
            add(live, time_ns);
            break;
        case RING_OVERWRITTEN: make_up(live, most); return live->recording->count > before;
        case RING_NOT_YET:
            live->is_behind = false;
            live->has_ended = ended;
            return live->recording->count > before;
        }
    }
    live->is_behind = !live->full;
    live->has_ended = live->full && ended;
    return live->recording->count > before;
}

bool live_take(struct live *live, size_t most)
{
    const bool has_more = take(live, most);
    ring_saw(live->ring, live->left);
    return has_more;
}
