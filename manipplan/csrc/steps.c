/* The arithmetic of the steps of a descent: sums over quadrature points, joint limits, curvature of rows, and the numbers of a
   quadratic program. All arrays belong to the caller; matrices are stored by rows.

   A path of n joints has unknowns z (f, n). Sums are added up in one order, the same on every processor. */

#include <math.h>
#include <string.h>

/* line + values z: (m, n) with line (m, n) and values (m, f). */
void manipplan_points(long m, long n, long f, const double *line, const double *values, const double *z, double *out) {
    memcpy(out, line, (size_t)(m * n) * sizeof *out);
    for (long i = 0; i < m; i++, out += n, values += f)
        for (long a = 0; a < f; a++)
            for (long j = 0; j < n; j++) out[j] += values[a] * z[a * n + j];
}

/* Add to the gradient (f, n) of Σ_i w_i e(q_i, q'_i) by z the part of one point: q and q' change with z by values and slopes (f),
   and each (2n) holds the derivatives of e by q and q'. */
static void add_slope(long n, long f, double weight, const double *values, const double *slopes, const double *each, double *out) {
    for (long a = 0; a < f; a++, out += n) {
        double by_q = weight * values[a], by_slope = weight * slopes[a];
        for (long j = 0; j < n; j++) out[j] += by_q * each[j] + by_slope * each[n + j];
    }
}

/* The gradient (f, n), with values and slopes (m, f), and each (m, 2n). */
void manipplan_gradient(long m, long n, long f, const double *weight, const double *values, const double *slopes,
                        const double *each, double *out) {
    memset(out, 0, (size_t)(f * n) * sizeof *out);
    for (long i = 0; i < m; i++) add_slope(n, f, weight[i], values + i * f, slopes + i * f, each + i * 2 * n, out);
}

/* The gradient and the Hessian (f n, f n), with the gradients and after each of them the Hessian of e (m, 2n + 4n²). `work`:
   f f n n + 6 n n numbers. */
void manipplan_derivatives(long m, long n, long f, const double *weight, const double *values, const double *slopes,
                           const double *each, double *work, double *gradient, double *out) {
    long square = n * n, size = f * n;
    double *total = work, *qq = work + f * f * square, *qv = qq + square, *vq = qv + square, *vv = vq + square;
    double *first = vv + square, *second = first + square;
    memset(gradient, 0, (size_t)size * sizeof *gradient);
    memset(total, 0, (size_t)(f * f * square) * sizeof *total);
    for (long i = 0; i < m; i++, each += 4 * square, values += f, slopes += f) {
        add_slope(n, f, weight[i], values, slopes, each, gradient);
        each += 2 * n;
        for (long j = 0; j < n; j++)
            for (long k = 0; k < n; k++) {
                qq[j * n + k] = weight[i] * each[j * 2 * n + k], qv[j * n + k] = weight[i] * each[j * 2 * n + n + k];
                vq[j * n + k] = weight[i] * each[(n + j) * 2 * n + k], vv[j * n + k] = weight[i] * each[(n + j) * 2 * n + n + k];
            }
        for (long a = 0; a < f; a++) {
            double value = values[a], slope = slopes[a];
            for (long t = 0; t < square; t++) first[t] = value * qq[t] + slope * vq[t], second[t] = value * qv[t] + slope * vv[t];
            for (long b = a; b < f; b++) {
                double *block = total + (a * f + b) * square, other = values[b], bend = slopes[b];
                for (long t = 0; t < square; t++) block[t] += other * first[t] + bend * second[t];
            }
        }
    }
    for (long a = 0; a < f; a++)
        for (long b = a; b < f; b++)
            for (long j = 0; j < n; j++)
                for (long k = 0; k < n; k++) {
                    double entry = total[(a * f + b) * square + j * n + k];
                    out[(a * n + j) * size + b * n + k] = out[(b * n + k) * size + a * n + j] = entry;
                }
}

/* Largest violation of lower and upper limits (n) by points (r, n); 0 when there is none. */
double manipplan_violation(long r, long n, const double *point, const double *lower, const double *upper) {
    double most = 0;
    for (long i = 0; i < r; i++, point += n)
        for (long j = 0; j < n; j++) {
            double below = lower[j] - point[j], above = point[j] - upper[j];
            if (below > most) most = below;
            if (above > most) most = above;
        }
    return most;
}

/* Rows value + jacobian p >= 0 of the limits that points (r, n) are nearer to than change (r): those of the lower limits, then
   those of the upper ones. directions (r, f): change of the points with z; jacobian (…, f n). Returns their number. */
long manipplan_limits(long r, long n, long f, const double *point, const double *directions, const double *lower,
                      const double *upper, const double *change, double *value, double *jacobian) {
    long count = 0;
    for (int sign = 1; sign >= -1; sign -= 2)
        for (long i = 0; i < r; i++)
            for (long j = 0; j < n; j++) {
                double distance = sign > 0 ? point[i * n + j] - lower[j] : upper[j] - point[i * n + j];
                if (!(distance < change[i])) continue;
                double *row = jacobian + count * f * n;
                memset(row, 0, (size_t)(f * n) * sizeof *row);
                for (long a = 0; a < f; a++) row[a * n + j] = sign * directions[i * f + a];
                value[count++] = distance;
            }
    return count;
}

/* Add to total (f n, f n) the sum of λ_i ∇²d_i over r rows with multipliers λ (r), gradient (r, n) and hessian (r, n, n) of d_i by
   q. q and q' change with z by values and slopes (r, f); speed, bend (r, n): q' and q''. Where the distance has a minimum along
   the path (moves), its place shifts: ∇²(min d) = ∇²d - (∂_s ∇d) (∂_s ∇d)ᵀ / ∂²_s d for ∂²_s d above `least`. `work`: f n. */
void manipplan_curvature(long r, long n, long f, const double *multiplier, const double *values, const double *slopes,
                         const double *speed, const double *bend, const double *gradient, const double *hessian,
                         const signed char *moves, double least, double *work, double *total) {
    long size = f * n;
    for (long i = 0; i < r; i++, values += f, slopes += f, speed += n, bend += n, gradient += n, hessian += n * n) {
        for (long a = 0; a < f; a++)
            for (long j = 0; j < n; j++)
                for (long b = 0; b < f; b++) {
                    double share = multiplier[i] * values[a] * values[b], *row = total + (a * n + j) * size + b * n;
                    for (long k = 0; k < n; k++) row[k] += share * hessian[j * n + k];
                }
        if (!moves[i]) continue;
        double second = 0;
        for (long j = 0; j < n; j++) {
            double turned = 0;
            for (long k = 0; k < n; k++) turned += hessian[j * n + k] * speed[k];
            second += speed[j] * turned + gradient[j] * bend[j];
            for (long a = 0; a < f; a++) work[a * n + j] = slopes[a] * gradient[j] + values[a] * turned;
        }
        if (!(second > least)) continue;
        double share = multiplier[i] / second;
        for (long t = 0; t < size; t++)
            for (long u = 0; u < size; u++) total[t * size + u] -= share * work[t] * work[u];
    }
}

/* Round numbers so that the largest absolute value has about `bits` bits. */
static void keep_bits(long count, double *number, long bits) {
    double largest = 0;
    int exponent;
    for (long i = 0; i < count; i++) {
        double size = fabs(number[i]);
        largest = size > largest ? size : largest;
    }
    frexp(largest, &exponent);
    double spacing = ldexp(1.0, exponent - (int)bits), inverse = 1 / spacing;
    if (largest > 0 && isfinite(inverse))
        for (long i = 0; i < count; i++) number[i] = rint(number[i] * inverse) * spacing;
}

/* The rows value + jacobian p >= 0, of r with k entries each, that some p with |p_i| <= radius makes smaller than `spacing`. Their
   numbers go to `chosen`, minus their values, on a grid of that spacing, to `least`, and their entries, rounded to `bits`, to `rows`.
   Returns how many there are. */
long manipplan_within(long r, long k, const double *value, const double *jacobian, double radius, double spacing, long bits,
                      long *chosen, double *least, double *rows) {
    long count = 0;
    for (long i = 0; i < r; i++, jacobian += k) {
        double sum = 0;
        for (long t = 0; t < k; t++) sum += fabs(jacobian[t]);
        if (!(value[i] < radius * sum + spacing)) continue;
        memcpy(rows + count * k, jacobian, (size_t)k * sizeof *rows);
        least[count] = -rint(value[i] / spacing) * spacing;
        chosen[count++] = i;
    }
    keep_bits(count * k, rows, bits);
    return count;
}

/* Whether the eigenvalues of the symmetric part of a matrix (k, k) are all above a share of its Frobenius norm, which is at least
   the largest absolute one: by a Cholesky factorisation. The symmetric part goes to `out`. `work`: k k numbers. */
int manipplan_is_convex(long k, const double *matrix, double share, double *work, double *out) {
    double squares = 0;
    for (long i = 0; i < k; i++)
        for (long j = 0; j < k; j++) {
            double both = (matrix[i * k + j] + matrix[j * k + i]) / 2;
            out[i * k + j] = both, squares += both * both;
        }
    double least = share * sqrt(squares);
    for (long i = 0; i < k; i++)
        for (long j = 0; j <= i; j++) {
            double sum = out[i * k + j] - (i == j ? least : 0);
            for (long t = 0; t < j; t++) sum -= work[i * k + t] * work[j * k + t];
            if (i == j && !(sum > 0)) return 0;
            work[i * k + j] = i == j ? sqrt(sum) : sum / work[j * k + j];
        }
    return 1;
}
