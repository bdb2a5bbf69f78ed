/* Roots of polynomials of degree four: eigenvalues of the companion matrix, by the QR algorithm with shifts. */

#pragma once

#include <math.h>

enum { DEGREE = 4, MOST_QR_STEPS = 200 };

typedef struct { double re, im; } Complex;

static inline Complex plus(Complex a, Complex b) { return (Complex){a.re + b.re, a.im + b.im}; }
static inline Complex minus(Complex a, Complex b) { return (Complex){a.re - b.re, a.im - b.im}; }
static inline Complex product(Complex a, Complex b) { return (Complex){a.re * b.re - a.im * b.im, a.re * b.im + a.im * b.re}; }
static inline Complex conjugate(Complex a) { return (Complex){a.re, -a.im}; }
static inline double modulus(Complex a) { return hypot(a.re, a.im); }

static Complex square_root(Complex a) {
    double size = modulus(a), re = sqrt(0.5 * (size + fabs(a.re))), im = re > 0 ? 0.5 * fabs(a.im) / re : 0.0;
    return a.re >= 0 ? (Complex){re, copysign(im, a.im)} : (Complex){im, copysign(re, a.im)};
}

/* Scale rows and columns by powers of two until each row is about as long as its column. */
static void balance(double h[DEGREE][DEGREE]) {
    for (int round = 0, again = 1; again && round < 100; round++) {
        again = 0;
        for (int i = 0; i < DEGREE; i++) {
            double across = 0, down = 0, factor = 1;
            for (int j = 0; j < DEGREE; j++)
                if (j != i) across += fabs(h[i][j]), down += fabs(h[j][i]);
            if (!(across > 0 && down > 0 && across < INFINITY && down < INFINITY)) continue;
            double whole = across + down;
            while (down < across / 2) factor *= 2, down *= 4;
            while (down >= across * 2) factor /= 2, down /= 4;
            if (!((across + down) / factor < 0.95 * whole)) continue;
            again = 1;
            for (int j = 0; j < DEGREE; j++) h[i][j] /= factor;
            for (int j = 0; j < DEGREE; j++) h[j][i] *= factor;
        }
    }
}

/* One QR step with the shift to rows and columns first ... last of a Hessenberg matrix. */
static void qr_step(Complex h[DEGREE][DEGREE], int first, int last, Complex shift) {
    Complex c[DEGREE], s[DEGREE];
    for (int i = first; i <= last; i++) h[i][i] = minus(h[i][i], shift);
    for (int k = first; k < last; k++) {
        double size = hypot(modulus(h[k][k]), modulus(h[k + 1][k]));
        c[k] = size > 0 ? (Complex){h[k][k].re / size, h[k][k].im / size} : (Complex){1, 0};
        s[k] = size > 0 ? (Complex){h[k + 1][k].re / size, h[k + 1][k].im / size} : (Complex){0, 0};
        for (int j = k; j <= last; j++) {
            Complex a = h[k][j], b = h[k + 1][j];
            h[k][j] = plus(product(conjugate(c[k]), a), product(conjugate(s[k]), b));
            h[k + 1][j] = minus(product(c[k], b), product(s[k], a));
        }
    }
    for (int k = first; k < last; k++)
        for (int i = first; i <= (k + 2 < last ? k + 2 : last); i++) {
            Complex a = h[i][k], b = h[i][k + 1];
            h[i][k] = plus(product(a, c[k]), product(b, s[k]));
            h[i][k + 1] = minus(product(b, conjugate(c[k])), product(a, conjugate(s[k])));
        }
    for (int i = first; i <= last; i++) h[i][i] = plus(h[i][i], shift);
}

/* The eigenvalue of rows and columns k, k + 1 that is nearer to the last entry. */
static Complex near_shift(Complex h[DEGREE][DEGREE], int k) {
    Complex half = minus(h[k][k], h[k + 1][k + 1]), below = product(h[k][k + 1], h[k + 1][k]);
    half = (Complex){half.re / 2, half.im / 2};
    Complex root = square_root(plus(product(half, half), below));
    if (half.re * root.re + half.im * root.im < 0) root = (Complex){-root.re, -root.im};
    Complex far = plus(half, root);
    double square = far.re * far.re + far.im * far.im;
    if (!(square > 0)) return h[k + 1][k + 1];
    Complex step = product(below, conjugate(far));
    return minus(h[k + 1][k + 1], (Complex){step.re / square, step.im / square});
}

/* The roots of x⁴ + a[3] x³ + a[2] x² + a[1] x + a[0]. Returns their number: 0 where an entry is not finite. */
static int quartic_roots(const double a[DEGREE], Complex roots[DEGREE]) {
    double companion[DEGREE][DEGREE] = {{0}};
    Complex h[DEGREE][DEGREE];
    for (int i = 0; i < DEGREE; i++) {
        if (!(fabs(a[i]) < INFINITY)) return 0;
        companion[i][DEGREE - 1] = -a[i];
        if (i) companion[i][i - 1] = 1;
    }
    balance(companion);
    for (int i = 0; i < DEGREE; i++)
        for (int j = 0; j < DEGREE; j++) h[i][j] = (Complex){companion[i][j], 0};
    int last = DEGREE - 1;
    for (int step = 1; last > 0; step++) {
        int first = last;
        while (first > 0) {
            double beside = modulus(h[first][first]) + modulus(h[first - 1][first - 1]);
            if (modulus(h[first][first - 1]) <= 2.3e-16 * beside) break;
            first--;
        }
        if (first == last) {
            last--;
            continue;
        }
        if (step > MOST_QR_STEPS) return 0;
        Complex shift = near_shift(h, last - 1);
        if (step % 11 == 10) shift = (Complex){shift.re + modulus(h[last][last - 1]), shift.im};  /* leaves a cycle */
        qr_step(h, first, last, shift);
    }
    for (int i = 0; i < DEGREE; i++) roots[i] = h[i][i];
    return DEGREE;
}
