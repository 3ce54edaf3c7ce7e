/* scout/sonar.h -- detects which of a Scout's sonar readings are new.
 *
 * A state contains the last reading of every transducer, but does not say which readings are new.
 * The transducers fire in turn, so a reading counts as new if it differs from the previous one, or
 * if somewhat more than a whole round has passed since the last new one. A reading must not count
 * as new too early: if an old reading is mistaken for a new one, its echo is located relative to
 * the robot's current position, although the robot received it one round ago, when it was
 * elsewhere. */
#ifndef FROB_DRIVERS_SCOUT_SONAR_H
#define FROB_DRIVERS_SCOUT_SONAR_H

#include "drivers/scout/state.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Initially all zero. */
struct frob_scout_sonar {
    uint8_t reading_in[FROB_SCOUT_SONARS]; /* last readings, in inches */
    bool is_new[FROB_SCOUT_SONARS];        /* new, and not yet taken */
    int64_t new_ns[FROB_SCOUT_SONARS];     /* time at which the last new reading arrived */
};

/* Adds the readings of a state that arrived at `now_ns`. Each transducer fires once in
 * `round_ns`. */
void frob_scout_sonar_add(struct frob_scout_sonar *sonar, const struct frob_scout_state *state,
                          int64_t now_ns, int64_t round_ns);

/* Returns whether there is a new echo from this transducer, and its distance in metres. Each echo
 * is returned once. A reading of 0 or 255 inches means that there was no echo. */
bool frob_scout_sonar_take(struct frob_scout_sonar *sonar, size_t transducer, double *distance_m);

#ifdef __cplusplus
}
#endif
#endif
