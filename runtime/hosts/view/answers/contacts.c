/* A simulated robot's contacts with objects. */
#include "answers.h"

#include "../../common/truth.h"

#include <string.h>

/* Maximum number of reported contacts. */
#define CONTACTS 1000

static struct truth truth_at(const struct recording *recording, size_t k)
{
    struct truth truth;
    memcpy(&truth, recording_truth(recording, k), sizeof truth);
    return truth;
}

void answer_contacts(const struct view *view, struct buffer *answer)
{
    const struct recording *recording = &view->recording;
    size_t found = 0;
    bool touched = false;
    buffer_text(answer, "{\"is\":\"contacts\",\"all\":[");
    for (size_t k = 0; recording->truth_size > 0 && k < recording->count; k++) {
        const struct truth truth = truth_at(recording, k);
        const bool touches = truth.touches != 0.0;
        if (touches && !touched && found++ < CONTACTS) {
            buffer_text(answer, found == 1 ? "[" : ",[");
            buffer_number(answer, view_seconds_at(view, k));
            buffer_text(answer, ",");
            buffer_number(answer, truth.x_m);
            buffer_text(answer, ",");
            buffer_number(answer, truth.y_m);
            buffer_text(answer, "]");
        }
        touched = touches;
    }
    buffer_format(answer, "],\"count\":%lu}", (unsigned long)found);
}
