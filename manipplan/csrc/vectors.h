/* Vectors of as many doubles as fit a register, and the operations of symbolic expressions on them. The machine code of a function
   and `batch.c`, which interprets its instructions, use the same ones, so that both give the same numbers. */

#pragma once

#include <math.h>
#if defined(__AVX512F__)
#include <immintrin.h>
#define W 8
#elif defined(__AVX__)
#define W 4
#else
#define W 2
#endif
typedef double vec __attribute__((vector_size(8 * W)));
typedef double unaligned __attribute__((vector_size(8 * W), aligned(8), may_alias));
typedef long long mask __attribute__((vector_size(8 * W)));
static const vec zero = {0};
#define NEAR 1e5
#define INLINE static inline __attribute__((always_inline))

INLINE vec choose(mask m, vec a, vec b) { return (vec)(((mask)a & m) | ((mask)b & ~m)); }
INLINE vec truth(mask m) { return choose(m, zero + 1.0, zero); }
#define LANES(f, a) ({ const vec a_ = (a); vec r_; for (int l = 0; l < W; ++l) r_[l] = f(a_[l]); r_; })
#define LANES2(f, a, b) ({ const vec a_ = (a), b_ = (b); vec r_; for (int l = 0; l < W; ++l) r_[l] = f(a_[l], b_[l]); r_; })

INLINE int any(mask m) {
#if defined(__AVX512DQ__)
    return _mm512_movepi64_mask((__m512i)m) != 0;
#else
    long long all = 0;
    for (int l = 0; l < W; ++l) all |= m[l];
    return all != 0;
#endif
}

INLINE vec root(vec a) {
#if defined(__AVX512F__)
    return (vec)_mm512_sqrt_pd((__m512d)a);
#else
    return LANES(__builtin_sqrt, a);
#endif
}

INLINE vec inverse(vec a) {
#if defined(__AVX512F__)
    /* Newton's method with fused products takes less time than a division and rounds as it does, but for one unit where all
       fraction bits are ones [markstein1990]; 0 and infinity keep the first guess */
    const mask fraction = (mask){0} + 0x000FFFFFFFFFFFFFLL;
    const __m512d value = (__m512d)a, one = _mm512_set1_pd(1.0), guess = _mm512_rcp14_pd(value);
    __m512d r = guess;
    for (int k = 0; k < 3; ++k) r = _mm512_fmadd_pd(_mm512_fnmadd_pd(value, r, one), r, r);
    r = (__m512d)((mask)r - (((mask)a & fraction) == fraction));
    return choose((vec)r == (vec)r, (vec)r, (vec)guess);
#else
    return 1.0 / a;
#endif
}

/* Each operation: CasADi's name of it, and its value for a and b. The numbers of the instructions of `batch.c` are their order. */
#define OPERATIONS(X) \
    X(assign, a) X(add, a + b) X(sub, a - b) X(mul, a * b) X(div, a / b) X(neg, -a) X(sq, a * a) X(twice, a + a) \
    X(inv, inverse(a)) X(sqrt, root(a)) X(fabs, choose(a < 0.0, -a, a)) X(fmin, choose(a < b, a, b)) X(fmax, choose(a > b, a, b)) \
    X(lt, truth(a < b)) X(le, truth(a <= b)) X(eq, truth(a == b)) X(ne, truth(a != b)) X(not, truth(a == 0.0)) \
    X(and, truth((a != 0.0) & (b != 0.0))) X(or, truth((a != 0.0) | (b != 0.0))) X(if_else_zero, choose(a != 0.0, b, zero)) \
    X(sign, choose(a > 0.0, zero + 1.0, choose(a < 0.0, zero - 1.0, a))) X(floor, LANES(floor, a)) X(ceil, LANES(ceil, a)) \
    X(exp, LANES(exp, a)) X(log, LANES(log, a)) X(tan, LANES(tan, a)) X(asin, LANES(asin, a)) X(acos, LANES(acos, a)) \
    X(atan, LANES(atan, a)) X(sinh, LANES(sinh, a)) X(cosh, LANES(cosh, a)) X(tanh, LANES(tanh, a)) \
    X(pow, LANES2(pow, a, b)) X(constpow, LANES2(pow, a, b)) X(atan2, LANES2(atan2, a, b))
#define X(name, value) INLINE vec op_##name(vec a, vec b) { (void)b; return value; }
OPERATIONS(X)
#undef X

/* Sine and cosine: x = k π/2 + r in three parts of π/2 [cody1980], then the minimax polynomials of the Cephes library for
   |r| <= π/4; for |x| < NEAR: beyond it this loses digits. */
INLINE void sine_cosine(vec x, vec *s, vec *c) {
    const vec magic = zero + 0x1.8p52;
    vec turns = x * 0x1.45f306dc9c883p-1 + magic;
    const mask k = (mask)turns;
    turns -= magic;
    vec r = x - turns * 0x1.921fb544p+0;
    r -= turns * 0x1.0b4611a6p-34;
    r -= turns * 0x1.3198a2e037073p-69;
    const vec z = r * r;
    const vec ps = ((((1.58962301576546568060e-10 * z - 2.50507477628578072866e-8) * z + 2.75573136213857245213e-6) * z
        - 1.98412698295895385996e-4) * z + 8.33333333332211858878e-3) * z - 1.66666666666666307295e-1;
    const vec pc = ((((-1.13585365213876817300e-11 * z + 2.08757008419747316778e-9) * z - 2.75573141792967388112e-7) * z
        + 2.48015872888517045348e-5) * z - 1.38888888888730564116e-3) * z + 4.16666666666665929218e-2;
    const vec sine = r + r * z * ps, cosine = 1.0 - 0.5 * z + z * z * pc;
    const mask odd = -(k & 1);
    *s = (vec)((mask)choose(odd, cosine, sine) ^ ((k & 2) << 62));
    *c = (vec)((mask)choose(odd, sine, cosine) ^ (((k + 1) & 2) << 62));
}

/* The same for an angle of any size. */
INLINE void far_sine_cosine(vec x, vec *s, vec *c) {
    sine_cosine(x, s, c);
    const mask far = ~((x < NEAR) & (x > -NEAR));
    if (__builtin_expect(any(far), 0)) {
        *s = choose(far, LANES(sin, x), *s);
        *c = choose(far, LANES(cos, x), *c);
    }
}

/* Whether a number of this row of doubles (W count) may be far from zero, or is not finite. */
INLINE int some_far(const double *q, long count) {
    vec squares = zero;
    for (long i = 0; i < count; ++i) {
        const vec some = *(const unaligned *)(q + i * W);
        squares += some * some;
    }
    return any(~(squares < NEAR * NEAR));
}

/* The value or, where it is far from zero and `turns` tells that full turns do not count, the same angle in [-π, π]; *bad = 1
   where it is not finite. */
static double tamed(double value, long turns, int *bad) {
    if (__builtin_fabs(value) < NEAR) return value;
    if (!(__builtin_fabs(value) < INFINITY)) *bad = 1;
    return turns ? atan2(sin(value), cos(value)) : value;
}
