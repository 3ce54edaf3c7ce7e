#include "drivers/scout/sonar.h"

void frob_scout_sonar_add(struct frob_scout_sonar *sonar, const struct frob_scout_state *state,
                          int64_t now_ns, int64_t round_ns)
{
    for (size_t i = 0; i < FROB_SCOUT_SONARS; i++) {
        if (state->sonar_in[i] == sonar->reading_in[i] && now_ns - sonar->new_ns[i] < round_ns)
            continue;
        sonar->reading_in[i] = state->sonar_in[i];
        sonar->new_ns[i] = now_ns;
        sonar->is_new[i] = true;
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
