/* clones.h -- loops that are also compiled for newer processors.
 *
 * If the build defines FROB_VISION_CLONES (x86-64, with a C library that supports indirect
 * functions), a function marked with FROB_CLONES is compiled twice: for all processors, and for
 * those with AVX2. The loader chooses one of the two. Both return the same results, because neither
 * reorders or fuses floating-point operations. */
#ifndef FROB_VISION_CLONES_H
#define FROB_VISION_CLONES_H

/* `restrict`, for pointers to arrays that do not overlap. C++ compilers spell it differently. */
#ifdef __cplusplus
#define FROB_APART __restrict
#else
#define FROB_APART restrict
#endif

#ifdef FROB_VISION_CLONES
#define FROB_CLONES __attribute__((target_clones("avx2", "default")))
#else
#define FROB_CLONES
#endif

#endif
