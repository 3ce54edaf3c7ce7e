/* clones.h -- loops that are worth compiling for newer processors too.
 *
 * A function with FROB_CLONES in front is there twice where the build asks for it with
 * -DFROB_VISION_CLONES (x86-64, and a C library that can choose between functions when a
 * program is loaded): for every processor, and for those with AVX2. Their results are the same, as
 * neither reorders or joins operations on floating-point numbers. */
#ifndef FROB_VISION_CLONES_H
#define FROB_VISION_CLONES_H

/* Arrays that do not overlap: `restrict`, which C++ has under another name. */
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
