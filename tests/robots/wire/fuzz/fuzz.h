/* Shared code of the fuzzers for wire formats. A fuzzer checks sequences of bytes: those that
 * libFuzzer generates, and the same bytes mixed with good frames and garbled in many ways, with
 * seeds derived from the bytes: flipped bits, lost bytes, duplicated bytes, garbage.
 *
 * After FUZZ_BYTES bytes (an environment variable) the process exits successfully and prints the
 * number of bytes. */
#ifndef FUZZ_H
#define FUZZ_H

#include <stddef.h>
#include <stdint.h>

enum { FUZZ_FRAME = 256 };

/* Each fuzzer defines this function. It feeds the bytes to the receiver under test and to a slow
 * reference search, and aborts if they differ. */
void fuzz_check(const uint8_t *bytes, size_t count);

/* Each fuzzer defines this function. It writes a good frame with random content and returns its
 * size. */
size_t fuzz_frame(uint64_t *seed, uint8_t bytes[FUZZ_FRAME]);

/* Reports the error and ends the process as a failure. */
void fuzz_fail(const char *what);

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t count);

#endif
