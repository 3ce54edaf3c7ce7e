#include "answers.h"
#include "kept.h"

#include "../../common/truth.h"

#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

/* ---- Starting */

const char *view_without_folder(const char *path)
{
    const char *slash = strrchr(path, '/');
    return slash == NULL ? path : slash + 1;
}

static bool read_source(struct source *source, const char *path)
{
    struct buffer text = { 0 };
    char block[4096];
    size_t length;
    FILE *file = fopen(path, "rb");
    source->name = view_without_folder(path);
    if (file != NULL) {
        while ((length = fread(block, 1, sizeof block, file)) > 0)
            buffer_bytes(&text, block, length);
        if (ferror(file)) {
            fclose(file);
            file = NULL;
        }
    }
    if (file == NULL) {
        fprintf(stderr, "error: cannot read %s: %s\n", path, strerror(errno));
        buffer_free(&text);
        return false;
    }
    fclose(file);
    buffer_text(&text, "");
    source->text = text.data;
    return source->text != NULL;
}

/* Reads the recording to compare with, if there is one. */
static bool view_compare(struct view *view)
{
    if (view->files->other == NULL)
        return true;
    if (!compare_start(&view->other, &view->signals, view->files->other, &view->files->dialect))
        return false;
    compare_find_difference(&view->other, &view->recording);
    return true;
}

bool view_start(struct view *view, const struct frob_program *program,
                const struct frob_column *columns, const struct frob_origin *origins,
                const struct view_files *files, struct ring *ring)
{
    memset(view, 0, sizeof *view);
    view->program = program;
    view->origins = origins;
    view->files = files;
    view->sources = (struct source *)calloc(files->source_count + 1, sizeof *view->sources);
    if (view->sources == NULL || !signals_start(&view->signals, program, columns)) {
        fprintf(stderr, "error: not enough memory for the program's signals\n");
        return false;
    }
    for (size_t i = 0; i < files->source_count; i++) {
        if (!read_source(&view->sources[i], files->sources[i]))
            return false;
        view->sources[i].is_library = i >= files->own_count;
        view->source_count++;
    }
    if (files->world != NULL && !read_source(&view->world, files->world))
        return false;
    if (ring != NULL
            ? !live_start(&view->live, ring, files->recording, &view->signals, &view->recording)
            : !recording_read(&view->recording, &view->signals, files->recording, &files->dialect))
        return false;
    if (!recording_set(&view->recording, files->params, files->param_count))
        return false;
    if (!replay_start(&view->replay, &view->signals, &view->recording, &view->recording.params)) {
        fprintf(stderr, "error: not enough memory for the program's states\n");
        return false;
    }
    series_start(&view->series, &view->replay);
    if (files->other != NULL) {
        /* A comparison requires the whole recording. */
        while (recording_read_on(&view->recording))
            continue;
        return view_compare(view);
    }
    return true;
}

double view_start_time(const struct view *view)
{
    const double origin = (double)view->recording.origin / 1e9, at = view->files->at;
    return origin != 0.0 && at >= origin ? at - origin : at;
}

void view_end(struct view *view)
{
    live_end(&view->live);
    what_if_end(&view->other);
    series_end(&view->series);
    replay_end(&view->replay);
    recording_free(&view->recording);
    signals_end(&view->signals);
    for (size_t i = 0; i < view->source_count; i++)
        free(view->sources[i].text);
    free(view->sources);
    free(view->world.text);
}

static double now(void)
{
    struct timespec time;
    clock_gettime(CLOCK_MONOTONIC, &time);
    return (double)time.tv_sec + (double)time.tv_nsec / 1e9;
}

bool view_advance(struct view *view, double seconds)
{
    const double end = now() + seconds;
    const bool diverged = view->replay.diverged;
    while (recording_read_on(&view->recording))
        if (now() >= end)
            return true;
    while (!replay_is_whole(&view->replay)) {
        replay_advance(&view->replay);
        if (now() >= end)
            break;
    }
    if (view->replay.diverged != diverged)
        series_forget(&view->series);
    return !replay_is_whole(&view->replay);
}

/* Minimum interval between two pieces of news: about the duration of one display frame. */
#define NEWS_S 0.016

bool view_is_reading(const struct view *view)
{
    return view->recording.reader != NULL;
}

bool view_is_live(const struct view *view)
{
    return view->live.ring != NULL;
}

enum view_work view_work(struct view *view, double seconds)
{
    const bool had_ended = view->live.has_ended, was_whole = replay_is_whole(&view->replay);
    const bool was_reading = view_is_reading(view);
    bool is_whole;
    if (view_is_live(view) && !had_ended) {
        view->has_news |= live_take(&view->live, 1000);
        view->has_news |= view->live.has_ended;
    }
    is_whole = !view_advance(view, seconds);
    view->has_news |= is_whole && !was_whole;
    if (!view_is_live(view) &&
        ((was_reading && !view_is_reading(view)) || (is_whole && !was_whole)))
        view_say(view);
    if (!is_whole || view->live.is_behind)
        return VIEW_GOES_ON;
    return view_is_live(view) && (!view->live.has_ended || view->has_news) ? VIEW_LOOKS
                                                                           : VIEW_RESTS;
}

bool view_has_news(struct view *view)
{
    if (!view->has_news || (view_is_live(view) && now() < view->told + NEWS_S))
        return false;
    view->has_news = false;
    view->told = now();
    return true;
}

void view_summary(const struct view *view, struct buffer *text)
{
    if (view->recording.notes.length > 0)
        buffer_text(text, view->recording.notes.data);
    if (view->replay.diverged)
        buffer_format(text,
                      "diverged at instant %lu: `%s` differs from the recording, so the recording "
                      "is from another version of the program, or the program's C code depends on "
                      "more than its input\n",
                      (unsigned long)view->replay.diverged_at, view->replay.diverged_in->name);
}

void view_say(struct view *view)
{
    struct buffer summary = { 0 };
    view_summary(view, &summary);
    if (summary.length > view->said)
        fputs(summary.data + view->said, stderr);
    view->said = summary.length;
    buffer_free(&summary);
}

/* ---- Answers */

void answer_refusal(struct buffer *answer, const char *why)
{
    buffer_text(answer, "{\"is\":\"refused\",\"why\":");
    buffer_string(answer, why);
    buffer_text(answer, "}");
}

double view_seconds_at(const struct view *view, size_t k)
{
    return (double)view->recording.times[k] / 1e9;
}

bool view_knows(const struct view *view, const struct signal *signal)
{
    return signal->side == INPUT || signal->side == OUTPUT || view->replay.runs;
}

size_t view_instant_at(const struct view *view, double seconds)
{
    size_t low = 0, high = view->recording.count;
    while (high - low > 1) {
        size_t middle = low + (high - low) / 2;
        if (view_seconds_at(view, middle) <= seconds)
            low = middle;
        else
            high = middle;
    }
    return low;
}

void view_news(struct view *view, struct buffer *message)
{
    if (!view_is_live(view)) {
        buffer_text(message, "{\"is\":\"progress\"");
        answer_progress(view, message);
    } else {
        buffer_text(message, "{\"is\":\"live\"");
        if (view->recording.count > 0) {
            buffer_text(message, ",\"newest\":");
            answer_instant(view, view->recording.count - 1, message);
        }
        /* This comes last, because answer_instant may have run the program up to that instant. */
        answer_extent(view, message);
        answer_progress(view, message);
    }
    buffer_text(message, "}");
}

static void answer_why(struct view *view, size_t k, size_t number, struct buffer *answer)
{
    buffer_format(answer, "{\"is\":\"why\",\"k\":%lu,\"signal\":%lu", (unsigned long)k,
                  (unsigned long)number);
    why_answer(&view->replay, view->origins, &view->signals.all[number], k, answer);
    buffer_text(answer, "}");
}

static bool can_try(const struct view *view, bool drives)
{
    const struct view_files *files = view->files;
    return files->commands.build != NULL && files->own_count > 0 && view->replay.runs &&
           (!drives || (files->commands.drive != NULL && !view_is_live(view)));
}

static void answer_what_if(struct view *view, const struct what_if_edit *edit,
                           struct buffer *answer)
{
    const bool drives = edit->drives;
    struct buffer why = { 0 };
    if (*edit->text == '\0') {
        what_if_end(&view->other);
        view_compare(view);
        buffer_text(answer, "{\"is\":\"what-if\",\"there\":false}");
    } else if (!can_try(view, drives)) {
        answer_refusal(answer, drives ? "the viewer cannot simulate this run again"
                                      : "this program cannot be rerun on the recording");
    } else if (!what_if_start(&view->other, &view->signals, &view->recording,
                              &view->files->commands, view->files->sources[0], edit, &why)) {
        buffer_text(answer, "{\"is\":\"what-if\",\"there\":false,\"why\":");
        buffer_string(answer, why.length > 0 ? why.data : "");
        buffer_text(answer, "}");
    } else {
        buffer_format(answer, "{\"is\":\"what-if\",\"there\":true,\"drives\":%s",
                      drives ? "true" : "false");
        if (view->other.first_in != NULL) {
            buffer_format(answer, ",\"first\":%lu,\"signal\":", (unsigned long)view->other.first);
            buffer_string(answer, view->other.first_in->name);
        }
        buffer_text(answer, "}");
    }
    buffer_free(&why);
}

static void answer_keep(const struct view *view, const char *text, struct buffer *answer)
{
    kept_write(view->files->own_count > 0 ? view->files->sources[0] : NULL, text);
    buffer_text(answer, "{\"is\":\"keep\"}");
}

/* ---- Requests */

/* Reads a space and a number below `limit` from a request. */
static bool take_number(const char **at, size_t limit, size_t *result)
{
    char *end;
    unsigned long long number;
    if (**at != ' ' || (*at)[1] < '0' || (*at)[1] > '9')
        return false;
    errno = 0;
    number = strtoull(*at + 1, &end, 10);
    if (errno != 0 || number >= limit)
        return false;
    *at = end;
    *result = (size_t)number;
    return true;
}

/* Reads the instant from which a path is requested; the default is the first instant. */
static bool take_first(const char **at, size_t count, size_t *first)
{
    *first = 0;
    return **at == '\0' || take_number(at, count, first);
}

static bool take_word(const char **at, const char *word)
{
    size_t length = strlen(word);
    if (strncmp(*at, word, length) != 0 || ((*at)[length] != '\0' && (*at)[length] != ' '))
        return false;
    *at += length;
    return true;
}

static bool take_newest(const char **at, size_t count, size_t *k)
{
    static const char word[] = " newest";
    if (strncmp(*at, word, sizeof word - 1) != 0)
        return false;
    *at += sizeof word - 1;
    *k = count - 1;
    return true;
}

static bool take_seconds(const char **at, double *result)
{
    char *end;
    if (**at != ' ')
        return false;
    *result = strtod(*at + 1, &end);
    if (end == *at + 1 || !isfinite(*result))
        return false;
    *at = end;
    return true;
}

/* Reads a whole request such as `what-if TEXT` or `with NAME=VALUE … drive TEXT`. Returns false
 * if it is a different request. The caller frees the settings in either case. */
static bool take_edit(const char *at, struct what_if_edit *edit)
{
    const bool has_settings = take_word(&at, "with");
    while (has_settings && *at == ' ' && at[1 + strcspn(at + 1, " =")] == '=') {
        const size_t length = strcspn(at + 1, " ");
        buffer_bytes(&edit->settings, at + 1, length);
        buffer_bytes(&edit->settings, "", 1);
        at += 1 + length;
    }
    if (has_settings && (edit->settings.length == 0 || *at++ != ' '))
        return false;
    edit->drives = take_word(&at, "drive");
    if (!edit->drives && !take_word(&at, "what-if"))
        return false;
    if (*at == ' ')
        edit->text = at + 1;
    /* The text may be missing only from a `what-if` request without settings. */
    return *at == ' ' || (*at == '\0' && !edit->drives && !has_settings);
}

void view_answer(struct view *view, const char *request, struct buffer *answer)
{
    struct what_if_edit edit = { "", { 0 }, false };
    const size_t count = view->recording.count;
    const char *at = request;
    size_t k, signal, other, width;
    double seconds, from, to;
    if (take_word(&at, "program") && *at == '\0')
        answer_program(view, answer);
    else if (take_word(&at, "keep") && *at == ' ')
        answer_keep(view, at + 1, answer);
    else if (count == 0)
        answer_refusal(answer, "there is no instant yet");
    else if (take_word(&at, "instant") && take_number(&at, count, &k) && *at == '\0')
        answer_instant(view, k, answer);
    else if (take_word(&at, "cells") && take_number(&at, count, &k) && *at == '\0')
        answer_instant(view, k, answer);
    else if (take_word(&at, "time") && take_seconds(&at, &seconds) && *at == '\0')
        answer_instant(view, view_instant_at(view, seconds), answer);
    else if (take_word(&at, "series") && take_number(&at, view->signals.count, &signal) &&
             take_seconds(&at, &from) && take_seconds(&at, &to) &&
             take_number(&at, 100001, &width) && *at == '\0' && from <= to)
        answer_series(view, signal, from, to, width, answer);
    else if (take_word(&at, "path") && take_number(&at, view->signals.count, &signal) &&
             take_number(&at, view->signals.count, &other) && take_number(&at, 100001, &width) &&
             take_first(&at, count, &k) && *at == '\0')
        answer_path(view, signal, other, width, k, answer);
    else if (take_word(&at, "way") &&
             take_number(&at, view->recording.truth_size / sizeof(struct truth), &signal) &&
             take_number(&at, 100001, &width) && take_first(&at, count, &k) && *at == '\0')
        answer_way(view, signal, width, k, answer);
    else if (take_word(&at, "why") && take_number(&at, count, &k) &&
             take_number(&at, view->signals.count, &signal) && *at == '\0' &&
             view_knows(view, &view->signals.all[signal]))
        answer_why(view, k, signal, answer);
    else if (take_word(&at, "picture") &&
             (take_newest(&at, count, &k) || take_number(&at, count, &k)) &&
             take_number(&at, FROB_IMAGE_SIDE + 1, &width) && width > 0 &&
             take_number(&at, SIZE_MAX, &other) && *at == '\0')
        answer_picture(view, k, width, other, answer);
    else if (take_word(&at, "contacts") && *at == '\0')
        answer_contacts(view, answer);
    else if (take_word(&at, "claims") && *at == '\0')
        answer_claims(view, answer);
    else if (take_word(&at, "find") && take_number(&at, count, &k) && *at == ' ')
        answer_find(view, k, at + 1, answer);
    else if (take_word(&at, "align") && (*at == '\0' || *at == ' '))
        answer_align(view, *at == ' ' ? at + 1 : at, answer);
    else if (take_edit(request, &edit))
        answer_what_if(view, &edit, answer);
    else
        answer_refusal(answer, "this is not a request");
    buffer_free(&edit.settings);
    if (answer->failed) {
        buffer_clear(answer);
        answer_refusal(answer, "not enough memory for the answer");
    }
}
