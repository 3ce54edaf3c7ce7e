// Loops that are worth compiling for newer processors too.
//
// A function with FROB_WIDE in front is there twice where that can be chosen when a program is
// loaded: for every x86-64 processor, and for those with AVX2. Results are the same, since
// neither reorders or joins operations on floating-point numbers.
#pragma once

#include <cstddef> // tells which C library it is

#if defined(__x86_64__) && defined(__GLIBC__) && !defined(__SANITIZE_ADDRESS__)
#define FROB_WIDE __attribute__((target_clones("avx2", "default")))
#else
#define FROB_WIDE
#endif
