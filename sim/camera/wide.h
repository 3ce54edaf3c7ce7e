// Compiles selected loops for newer processors, too.
//
// On platforms that can select a version when the program is loaded, FROB_WIDE in front of a
// function compiles it twice: for every x86-64 processor, and for those with AVX2. The results are
// the same, because neither version reorders or fuses floating-point operations.
#pragma once

#include <cstddef> // defines __GLIBC__ with glibc

#if defined(__x86_64__) && defined(__GLIBC__) && !defined(__SANITIZE_ADDRESS__)
#define FROB_WIDE __attribute__((target_clones("avx2", "default")))
#else
#define FROB_WIDE
#endif
