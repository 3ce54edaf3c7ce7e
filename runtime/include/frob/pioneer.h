/* frob/pioneer.h -- what a Pioneer senses and does, as C structs: the types of
 * module Pioneer. */
#ifndef FROB_PIONEER_H
#define FROB_PIONEER_H

#include <stdbool.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

struct frob_vec2 {
    double x;
    double y;
};

struct frob_pose {
    struct frob_vec2 position; /* m */
    double heading;            /* rad */
};

/* Event Distance: tag 0 is NoEvent, 1 is Event f0. */
struct frob_event_distance {
    uint8_t tag;
    double f0; /* m */
};

struct frob_pioneer_sonar {
    struct frob_event_distance s0;
    struct frob_event_distance s1;
    struct frob_event_distance s2;
    struct frob_event_distance s3;
    struct frob_event_distance s4;
    struct frob_event_distance s5;
    struct frob_event_distance s6;
    struct frob_event_distance s7;
    struct frob_event_distance s8;
    struct frob_event_distance s9;
    struct frob_event_distance s10;
    struct frob_event_distance s11;
    struct frob_event_distance s12;
    struct frob_event_distance s13;
    struct frob_event_distance s14;
    struct frob_event_distance s15;
};

struct frob_pioneer_input {
    struct frob_pose odometry;
    double leftWheel;  /* m/s */
    double rightWheel; /* m/s */
    struct frob_pioneer_sonar sonar;
    bool frontBumper;
    bool rearBumper;
    bool leftStall;
    bool rightStall;
    double battery; /* V */
    bool motorsOn;
};

struct frob_pioneer_output {
    double forward; /* m/s */
    double turn;    /* rad/s, counter-clockwise */
};

#ifdef __cplusplus
}
#endif
#endif
