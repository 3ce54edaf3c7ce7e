/* What the fuzzers of wire formats share. A fuzzer checks a run of bytes; it
 * gets those that libFuzzer made, and those bytes mixed with good frames and
 * garbled in many ways, from seeds that the bytes give: flipped bits, lost
 * bytes, doubled bytes, garbage.
 *
 * After FUZZ_BYTES bytes (of the environment) the process ends well, with a
 * line that says how many they were. */
#ifndef FUZZ_H
#define FUZZ_H

#include <stddef.h>
#include <stdint.h>

enum { FUZZ_FRAME = 256 };

/* Of each fuzzer: feeds the bytes to the receiver under test and to a slow
 * search written for the purpose, and aborts where the two differ. */
void fuzz_check(const uint8_t *bytes, size_t count);

/* Of each fuzzer: writes a good frame with random content; gives its size. */
size_t fuzz_frame(uint64_t *seed, uint8_t bytes[FUZZ_FRAME]);

/* Ends the process as a failure, after saying what is wrong. */
void fuzz_fail(const char *what);

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t count);

#endif
