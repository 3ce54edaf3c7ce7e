/* The smallest program that gcc 11 to 13 for aarch64 (-Os) miscompile as they did generated C. The
 * variables `v` of the two functions are never live at the same time, so they share a place on the
 * stack. The compiler assumes that the second one already contains its zeros, and moves a read of
 * it ahead of the stores to the first one, which have a different type. Prints what is wrong; the
 * exit status is then 1. */
#if defined(__GNUC__) && !defined(__clang__) && defined(__aarch64__) && !defined(STRICT)
#pragma GCC optimize("no-strict-aliasing")
#endif
#include <stdint.h>
#include <stdio.h>

struct a {
    uint8_t tag;
    double f0;
    uint8_t t0, t1, t2;
};

struct b {
    uint8_t tag;
    double f0, f1, f2;
    int32_t i0, i1, i2;
    uint8_t t0;
};

struct state {
    double before;
    struct a a;
    struct b b;
    double sum;
};

void reset(struct state *self);
void look(struct b *rest, struct state *self);
void litter(void);

static inline struct a a_nothing(void)
{
    struct a v = { 0, 0.0, 0, 0, 0 };
    return v;
}

static inline struct b b_nothing(void)
{
    struct b v = { 0, 0.0, 0.0, 0.0, 0, 0, 0, 0 };
    return v;
}

__attribute__((noinline)) void look(struct b *rest, struct state *self)
{
    __asm__ volatile("" : : "r"(rest), "r"(self) : "memory");
}

__attribute__((noinline)) void reset(struct state *self)
{
    struct b rest[3];
    self->a = a_nothing();
    self->b = b_nothing();
    look(rest, self);
    self->sum = rest[1].f0;
}

/* Fills the stack, so that reads of uninitialized memory change the result. */
__attribute__((noinline)) void litter(void)
{
    char below[4096];
    for (int i = 0; i < 4096; i++)
        below[i] = (char)0xa5;
    __asm__ volatile("" : : "r"(below) : "memory");
}

int main(void)
{
    static struct state s;
    litter();
    reset(&s);
    if (s.a.tag != 0 || s.a.f0 != 0.0 || s.b.tag != 0 || s.b.f0 != 0.0) {
        puts("a struct was read before it was written");
        return 1;
    }
    return 0;
}
