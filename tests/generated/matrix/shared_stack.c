/* The smallest program with which gcc 11 to 13 for aarch64 (-Os) go wrong as they did
 * with generated C: `v` of the one function and `v` of the other are never needed at
 * the same time and get the same place on the stack; the zeros of the second are there
 * already; and what it is read for comes before these, which are of another type.
 * Prints what is wrong; the exit status is 1 then. */
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

/* What is read before it is written shows. */
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
