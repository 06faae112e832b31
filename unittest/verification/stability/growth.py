"""The tensile instability of a square lattice under tension: exact growth rates, and the rate of a run.

Linear stability of the semi-discrete equations (Eulerian frame) about a lattice of spacing dx under the stress T I, for the modes
whose wave numbers are 0 or pi/dx: neighbouring columns move against each other. Density and velocity gradients do not see
such a mode, since sin(k n dx) = 0, and only the change of the kernel gradients is left:

    u'' = (2 dx^2 T B / rho) s2 u,   s2 = sum_r H(r) (1 - cos k.r),

H the second derivative of the kernel along u, B = 1 (plain) or 1/sum_r (-x dW/dx) dx^2 (corrected). For u along k = pi/dx this is
the one-dimensional sqrt(2 dx T s2/rho) of the instability of J. W. Swegle, D. L. Hicks and S. W. Attaway, J. Comput. Phys. 116
(1995) 123-134, with the lattice sums of two dimensions.

Artificial stress (eps, n) makes (1 - eps f^n) dW/dr of dW/dr, f = W(r)/W(d), where d is the spacing without stress.

Viscosity: of a growing pair of columns one side always approaches, so that u'' + beta u' = gamma^2 u with the linear term of eqs 23
and 24 of Shaw and Reid (2009); `viscosity correct` leaves the share of it that belongs to the nearest neighbours in the
other columns, `weights safe` the part of that share which is along the lines of centres. Velocity gradients are zero in this
mode: `limited` and `front` have nothing to take away and leave all of it, and the switch of `balsara` is 0 and leaves none."""

import math

import histories

SUPPORT = 2.0
NORM = 10 / (7 * math.pi)
MODES = {    # number in in.tension: name, wave vector in pi/dx, direction of u
    1: ("columns against each other, along x", (1, 0), (1, 0)),
    2: ("columns against each other, along y", (1, 0), (0, 1)),
    3: ("chequerboard, along x", (1, 1), (1, 0)),
}


def kernel(q):
    """W of the cubic spline in two dimensions for h = 1 (Shaw and Reid 2009, eq. 22), with two derivatives."""
    a, b = max(0.0, 2 - q), max(0.0, 1 - q)
    return NORM * (a ** 3 / 4 - b ** 3), NORM * (-0.75 * a * a + 3 * b * b), NORM * (1.5 * a - 6 * b)


def neighbours(reach):
    """(i, j, distance) of a lattice with spacing 1."""
    n = math.ceil(reach)
    around = [(i, j, math.hypot(i, j)) for i in range(-n, n + 1) for j in range(-n, n + 1)]
    return [(i, j, r) for i, j, r in around if 0 < r < reach]


def pull(r, h, eps, n, rest):
    """dW/dr with artificial stress, and its derivative."""
    w, first, second = (value / h ** (2 + k) for k, value in enumerate(kernel(r / h)))
    f = w / (kernel(rest / h)[0] / h ** 2)
    less = 1 - eps * f ** n
    return less * first, less * second - eps * n * f ** n / w * first ** 2 if w > 0 else 0.0


def stiffness(h, mode, eps=0.0, n=4, rest=1.0):
    """s2 for dx = 1; rest: spacing without stress."""
    _, k, u = MODES[mode]
    total = 0.0
    for i, j, r in neighbours(SUPPORT * h):
        first, second = pull(r, h, eps, n, rest)
        along = ((i * u[0] + j * u[1]) / r) ** 2
        total += (second * along + first / r * (1 - along)) * (1 - math.cos(math.pi * (k[0] * i + k[1] * j)))
    return total


def slope(h):
    """What plain sums make of the gradient of x."""
    return sum(-kernel(r / h)[1] / h ** 3 * i * i / r for i, j, r in neighbours(SUPPORT * h))


def damping(h, a1, c=1.0):
    """beta of mode 1 for dx = 1, v_ij = 2 v for the columns that approach."""
    return sum(a1 * c * h * 2 * i / (r * r + 0.01 * h * h) * -kernel(r / h)[1] / h ** 3 * i / r
               for i, j, r in neighbours(SUPPORT * h) if i > 0 and i % 2)


def retained(safe=False, hbar=1.5):
    """Share of the viscosity that the correction leaves in mode 1."""
    near = [(i, (i / r) ** 2 if safe else 1.0, kernel(2 * r / hbar)[0]) for i, j, r in neighbours(hbar)]
    return sum(w * along for i, along, w in near if i % 2) / sum(w for _, _, w in near)


def linear_coefficient(words):
    """a1 of a viscosity; 0 of one that does not act in mode 1."""
    if words[0] in ("none", "balsara"):
        return 0.0
    return float(words[1]) if words[0] in ("monaghan", "limited") else 1.0


def rate(tension, h, mode=1, gradient="corrected", viscosity="none", eps=0.0):
    """Exact growth rate in c0/dx; tension over rho0 c0^2; 0 where the mode is stable."""
    rho = 1 - tension    # P = rho/rho0 - 1
    square = 2 * tension * stiffness(h, mode, eps, rest=math.sqrt(rho)) / rho / (slope(h) if gradient == "corrected" else 1.0)
    words = viscosity.split()
    if words[0] != "none" and mode != 1:
        return math.nan
    beta = damping(h, linear_coefficient(words))
    if words[0] == "correct":
        beta *= retained(safe="safe" in words)
    return math.sqrt(square + beta * beta / 4) - beta / 2 if square > 0 else 0.0


def fitted(data, low=3e-5, high=1e-3):
    """Growth rate of a run: slope of the logarithm of the mean speed while the mean displacement is between low and high
    (dx; it begins at 1e-6, so that the decaying half of the start is gone). 0 if it does not come that far."""
    points = [(t, math.log(s)) for t, s, d in zip(data["t"], data["speed"], data["moved"]) if low < d < high]
    if len(points) < 6 or not histories.largest(data["moved"]) >= high / 2:
        return 0.0
    times, logarithms = zip(*points)
    return histories.slope(logarithms, times)
