#include "drivers/pioneer/model.h"

/* Radians per unit of THPOS, which has 4096 units per turn; 1024 on the Pioneer 1. */
#define FINE 0.0015339807878856412
#define COARSE 0.006135923151542565

static const struct frob_p2os_model models[] = {
    /* subclass    angle   distance  speed   range  differ.  vel2  mm/s   deg/s  rate sonars flags */
    { "pion1x", COARSE, 0.05066, 2.5332, 0.1734, 0.003333, 4.0, 400.0, 100.0, 0, 7, 0 },
    { "pion1m", COARSE, 0.05066, 2.5332, 0.1734, 0.003333, 4.0, 400.0, 100.0, 0, 7, 0 },
    { "psos1x", COARSE, 0.05066, 2.5332, 0.1734, 0.003333, 4.0, 400.0, 100.0, 0, 7, 0 },
    { "psos1m", COARSE, 0.05066, 2.5332, 0.1734, 0.003333, 4.0, 400.0, 100.0, 0, 7, 0 },
    { "pionat", COARSE, 0.07, 2.5332, 0.1734, 0.003333, 4.0, 500.0, 100.0, 0, 7, 0 },
    { "p2dx", FINE, 0.84, 1.0, 0.268, 0.0056, 20.0, 2200.0, 500.0, 38400, 16, 0 },
    { "p2de", FINE, 0.969, 1.0, 0.268, 0.0056, 20.0, 2200.0, 500.0, 38400, 16, 0 },
    { "p2d8", FINE, 0.485, 1.0, 1.0, 0.0056, 20.0, 2200.0, 500.0, 38400, 16, 1 },
    { "p2d8+", FINE, 0.485, 1.0, 1.0, 0.0056, 20.0, 2200.0, 500.0, 38400, 16, 1 },
    { "p2at", FINE, 1.32, 1.0, 0.268, 0.0034, 20.0, 1200.0, 300.0, 38400, 16, 0 },
    { "p2at8", FINE, 1.32, 1.0, 1.0, 0.0034, 20.0, 1200.0, 300.0, 38400, 16, 1 },
    { "p2at8+", FINE, 0.465, 1.0, 1.0, 0.0034, 20.0, 1200.0, 300.0, 38400, 16, 1 },
    { "p3at", FINE, 0.465, 1.0, 1.0, 0.0034, 20.0, 1200.0, 300.0, 38400, 16, 1 },
    { "p3at-sh", FINE, 1.0, 1.0, 1.0, 0.0034, 20.0, 1200.0, 300.0, 38400, 16, 1 },
    { "p3dx", FINE, 0.485, 1.0, 1.0, 0.0056, 20.0, 2200.0, 500.0, 38400, 16, 1 },
    { "p3dx-sh", FINE, 1.0, 1.0, 1.0, 0.0056, 20.0, 2200.0, 500.0, 38400, 16, 1 },
    { "amigo", FINE, 0.5083, 0.6154, 1.0, 0.011, 20.0, 1000.0, 300.0, 38400, 8, 1 },
    { "amigo-sh", FINE, 1.0, 1.0, 1.0, 0.011, 20.0, 1000.0, 300.0, 38400, 8, 1 },
};

static char small(char c)
{
    return c >= 'A' && c <= 'Z' ? (char)(c - 'A' + 'a') : c;
}

const struct frob_p2os_model *frob_p2os_models(size_t *count)
{
    *count = sizeof models / sizeof models[0];
    return models;
}

const struct frob_p2os_model *frob_p2os_find_model(const char *subclass)
{
    for (size_t i = 0; i < sizeof models / sizeof models[0]; i++) {
        const char *a = models[i].subclass, *b = subclass;
        while (*a != '\0' && *a == small(*b)) {
            a++;
            b++;
        }
        if (*a == '\0' && *b == '\0')
            return &models[i];
    }
    return NULL;
}
