"""How waves travel on a square lattice of particles: the sums of the kernel gradient, and the frequencies that follow.

With the cubic spline (support 2 h) and a plane wave along a row of the lattice (reference: in wave's ABOUT)."""

import math


def spline_gradient(r, h):
    """W'(r) of the cubic spline in two dimensions."""
    q, alpha = r / h, 10.0 / (7.0 * math.pi * h * h)
    if q >= 2.0:
        return 0.0
    return alpha / h * (-3.0 * q + 2.25 * q * q if q <= 1.0 else -0.75 * (2.0 - q) ** 2)


def partners(h):
    """(x, y, dW/dx) of the neighbours of a particle at the origin, spacing 1."""
    reach = int(2 * h) + 1
    for x in range(-reach, reach + 1):
        for y in range(-reach, reach + 1):
            r = math.hypot(x, y)
            if 0 < r < 2 * h:
                yield x, y, spline_gradient(r, h) * x / r


def wave_factor(k, h):
    """omega over c k of a longitudinal wave with plain gradients; k times the spacing, h in spacings.

    grad of exp(i k x) is i k exp(i k x) times this factor. Both the strain rate and the force carry it once."""
    return -sum(gradient * math.sin(k * x) for x, _, gradient in partners(h)) / k


def row_sum(h):
    """The same for infinitely long waves, the factor that gradient correction divides by: M of doc/theory.rst."""
    return -sum(gradient * x for x, _, gradient in partners(h))


def frequency(k, h, corrected):
    """omega over c k."""
    return wave_factor(k, h) / (row_sum(h) if corrected else 1.0)


def leapfrog(omega_dt):
    """Frequency times step of a leapfrog for an oscillator with omega times step."""
    return 2.0 * math.asin(0.5 * omega_dt)
