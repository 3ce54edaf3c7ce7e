#include "drivers/scout/sonar.h"

/* An unchanged reading counts as new when more than 9/8 of a round has passed since the last new
 * one. The additional eighth allows for echoes that arrive earlier or later depending on the
 * distance, and for the delay of the state that reports them. Such a reading is assigned the time
 * at which its transducer was due to fire, so that these times do not drift. */
static bool is_new(struct frob_scout_sonar *sonar, size_t i, uint8_t reading_in, int64_t now_ns,
                   int64_t round_ns)
{
    int64_t since_ns = now_ns - sonar->new_ns[i];
    bool differs = reading_in != sonar->reading_in[i];
    if (!differs && since_ns < round_ns + round_ns / 8)
        return false;
    sonar->new_ns[i] = differs || since_ns > 2 * round_ns ? now_ns : sonar->new_ns[i] + round_ns;
    return true;
}

void frob_scout_sonar_add(struct frob_scout_sonar *sonar, const struct frob_scout_state *state,
                          int64_t now_ns, int64_t round_ns)
{
    for (size_t i = 0; i < FROB_SCOUT_SONARS; i++) {
        if (is_new(sonar, i, state->sonar_in[i], now_ns, round_ns)) {
            sonar->reading_in[i] = state->sonar_in[i];
            sonar->is_new[i] = true;
        }
    }
}

bool frob_scout_sonar_take(struct frob_scout_sonar *sonar, size_t transducer, double *distance_m)
{
    uint8_t reading_in = sonar->reading_in[transducer];
    if (!sonar->is_new[transducer])
        return false;
    sonar->is_new[transducer] = false;
    *distance_m = reading_in * 0.0254;
    return reading_in != 0 && reading_in != 255;
}
