/* scout/sonar.h -- which of a Scout's sonar readings are new.
 *
 * A state has the last reading of every transducer and does not say which are
 * new. The transducers take turns, so a reading is taken for new if it is
 * another than before, or if a whole round and somewhat more has passed since the
 * last. Never sooner: an old reading that is taken for new puts what was heard
 * where the robot was a round ago to where it is now. */
#ifndef FROB_DRIVERS_SCOUT_SONAR_H
#define FROB_DRIVERS_SCOUT_SONAR_H

#include "drivers/scout/state.h"

#ifdef __cplusplus
extern "C" {
#endif

/* All zero at the start. */
struct frob_scout_sonar {
    uint8_t reading_in[FROB_SCOUT_SONARS]; /* the last, inches */
    bool is_new[FROB_SCOUT_SONARS];        /* not yet taken */
    int64_t new_ns[FROB_SCOUT_SONARS];     /* when it was last new */
};

/* Takes the readings of a state that arrived at `now_ns`. A round of all
 * transducers takes `round_ns`. */
void frob_scout_sonar_add(struct frob_scout_sonar *sonar, const struct frob_scout_state *state,
                          int64_t now_ns, int64_t round_ns);

/* Is there a new echo from this transducer? If so, gives its distance in
 * metres, once. A reading of 255 inches is none: nothing came back. */
bool frob_scout_sonar_take(struct frob_scout_sonar *sonar, size_t transducer, double *distance_m);

#ifdef __cplusplus
}
#endif
#endif
