"""Real roots of a polynomial with rational coefficients, counted by Sturm's theorem in exact arithmetic, so none is missed."""

from collections.abc import Sequence
from fractions import Fraction
from itertools import pairwise
from math import gcd

#: Width of the interval that encloses a root: a square root of it keeps 64-bit accuracy.
WIDTH = Fraction(1, 2**120)

Polynomial = list[Fraction]


def real_roots(coefficients: Sequence[Fraction], lower: Fraction, upper: Fraction) -> list[Fraction]:
    """All real roots in [lower, upper], ascending, each to within 2⁻¹²⁰ and listed once whatever its multiplicity.

    Args:
        coefficients: from the constant term up; not all zero.
        lower: start of the interval.
        upper: end of the interval, at least `lower`.
    """
    p = _primitive(coefficients)
    if len(p) < 2 or lower > upper:
        return []
    chain = _sturm_chain(_square_free(p))
    roots = [lower] if not _value(chain[0], lower) else []
    work = [(lower, upper)]  # Sturm counts the roots in (a, b]
    while work:
        a, b = work.pop()
        count = _changes(chain, a) - _changes(chain, b)
        if count == 1:
            roots.append(_refined(chain[0], a, b))
        elif count > 1:
            middle = (a + b) / 2
            work += [(a, middle), (middle, b)]
    return sorted(roots)


def add(*polynomials: Sequence[Fraction]) -> Polynomial:
    """The sum."""
    size = max(len(p) for p in polynomials)
    return [sum((p[i] for p in polynomials if i < len(p)), Fraction(0)) for i in range(size)]


def multiply(*polynomials: Sequence[Fraction]) -> Polynomial:
    """The product."""
    result = [Fraction(1)]
    for p in polynomials:
        new = [Fraction(0)] * (len(result) + len(p) - 1)
        for i, a in enumerate(result):
            for j, b in enumerate(p):
                new[i + j] += a * b
        result = new
    return result


def scale(factor: int, p: Sequence[Fraction]) -> Polynomial:
    """`factor` times p."""
    return [factor * a for a in p]


def derivative(p: Sequence[Fraction]) -> Polynomial:
    """p'."""
    return [i * a for i, a in enumerate(p)][1:] or [Fraction(0)]


def evaluate(p: Sequence[Fraction], x: Fraction) -> Fraction:
    """p(x)."""
    result = Fraction(0)
    for a in reversed(p):
        result = result * x + a
    return result


def _primitive(p: Sequence[Fraction]) -> list[int]:
    """A positive multiple with integer coefficients that have no common factor, without leading zeros."""
    kept = list(p)
    while kept and not kept[-1]:
        kept.pop()
    common = 1
    for a in kept:
        common = common * a.denominator // gcd(common, a.denominator)
    whole = [int(a * common) for a in kept]
    shared = gcd(*whole) if whole else 1
    return [a // shared for a in whole]


def _remainder(p: list[int], d: list[int]) -> list[int]:
    """A positive multiple of the remainder of p divided by d."""
    rest = [Fraction(a) for a in p]
    while len(rest) >= len(d):
        factor = rest[-1] / d[-1]
        shift = len(rest) - len(d)
        for i, a in enumerate(d):
            rest[shift + i] -= factor * a
        rest.pop()
    return _primitive(rest)


def _square_free(p: list[int]) -> list[int]:
    """p divided by its greatest common divisor with p': the same roots, each simple."""
    a, b = p, _primitive([Fraction(i * c) for i, c in enumerate(p)][1:])
    while b:
        a, b = b, _remainder(a, b)
    if len(a) == 1:
        return p
    rest, quotient = [Fraction(c) for c in p], [Fraction(0)] * (len(p) - len(a) + 1)
    for shift in reversed(range(len(quotient))):
        quotient[shift] = rest[shift + len(a) - 1] / a[-1]
        for i, c in enumerate(a):
            rest[shift + i] -= quotient[shift] * c
    return _primitive(quotient)


def _sturm_chain(p: list[int]) -> list[list[int]]:
    chain = [p, _primitive([Fraction(i * c) for i, c in enumerate(p)][1:])]
    while len(chain[-1]) > 1:
        chain.append([-c for c in _remainder(chain[-2], chain[-1])])
    return chain


def _value(p: list[int], x: Fraction) -> int:
    """p(x) times the positive power denominator(x)^degree."""
    result, power = 0, 1
    for a in reversed(p):
        result = result * x.numerator + a * power
        power *= x.denominator
    return result


def _changes(chain: list[list[int]], x: Fraction) -> int:
    signs = [value > 0 for value in (_value(p, x) for p in chain) if value]
    return sum(a != b for a, b in pairwise(signs))


def _refined(p: list[int], a: Fraction, b: Fraction) -> Fraction:
    """The one root of the square-free p in (a, b]."""
    end = _value(p, b)
    if not end:
        return b
    while b - a > WIDTH:
        middle = _rounded((a + b) / 2, b - a)
        value = _value(p, middle)
        if not value:
            return middle
        a, b = (a, middle) if (value > 0) == (end > 0) else (middle, b)
    return (a + b) / 2


def _rounded(x: Fraction, width: Fraction) -> Fraction:
    """A fraction with a small denominator within an eighth of `width` of x."""
    digits = 8 * (width.denominator // width.numerator + 1)
    digits = 1 << digits.bit_length()
    return Fraction(round(x * digits), digits)
