"""Exact solutions for plane waves in an elastic-plastic Mie-Grueneisen solid. Nothing but Python.

Pressure, stress and energy in SI units, stress positive in compression here. The material is that of doc/theory.rst:
P = (1 - Gamma eta/2) P_H + Gamma rho e, P_H cubic; hypoelastic deviator, perfect plasticity (von Mises).

In uniaxial strain S_xx = -(4/3) mu ln(rho/rho0) until |S_xx| = 2 Y/3, that is until rho_y = rho0 exp(Y/(2 mu)). A
piston drives two jumps, each with the conservation laws of Rankine and Hugoniot."""

import math
from dataclasses import dataclass


@dataclass(frozen=True)
class Solid:
    rho0: float
    C: float
    S: float
    Gamma: float
    mu: float = 0.0
    Y: float = 0.0

    def pressure(self, rho, e):
        eta, a = rho / self.rho0 - 1, self.rho0 * self.C ** 2
        s = self.S - 1
        hugoniot = a * (eta + (1 + 2 * s) * eta ** 2 + (2 * s + 3 * s * s) * eta ** 3) if eta > 0 else a * eta
        return (1 - 0.5 * self.Gamma * eta) * hugoniot + self.Gamma * rho * e

    def sound(self, rho, e):
        """Bulk sound speed: c^2 = dP/drho at constant e + P/rho^2 dP/de, the first by a central difference."""
        d = 1e-6 * rho
        slope = (self.pressure(rho + d, e) - self.pressure(rho - d, e)) / (2 * d)
        return math.sqrt(slope + self.pressure(rho, e) * self.Gamma / rho)


@dataclass(frozen=True)
class State:
    rho: float
    stress: float
    e: float
    u: float = 0.0          # against the material at rest
    speed: float = 0.0      # of the jump that leads here


def jump(solid, before, rho, deviator):
    """The state of density rho behind a jump from `before`; deviator: what is added to the pressure there."""
    volume = 1 / before.rho - 1 / rho    # lost, per mass
    e = before.e
    for _ in range(200):    # sigma depends on e through Gamma only: a contraction
        stress = solid.pressure(rho, e) + deviator
        e = before.e + 0.5 * (stress + before.stress) * volume
    rise = stress - before.stress
    flux = math.sqrt(rise / volume)
    return State(rho, stress, e, before.u + rise / flux, before.u + flux / before.rho)


def bisect(function, low, high):
    """Where an increasing function vanishes."""
    for _ in range(200):
        middle = 0.5 * (low + high)
        low, high = (low, middle) if function(middle) > 0 else (middle, high)
    return 0.5 * (low + high)


def piston(solid, u):
    """(precursor, plateau) that a piston of velocity u drives into the solid at rest; one state twice without strength."""
    rest = State(solid.rho0, 0.0, 0.0)
    first = rest
    if solid.Y > 0:
        first = jump(solid, rest, solid.rho0 * math.exp(solid.Y / (2 * solid.mu)), 2 * solid.Y / 3)
    low = first.rho * (1 + 1e-12)
    plateau = lambda rho: jump(solid, first, rho, 2 * solid.Y / 3)
    return first, plateau(bisect(lambda rho: plateau(rho).u - u, low, 1.6 * solid.rho0))


# ---- shock tube ---------------------------------------------------------------------------------------------

@dataclass
class Tube:
    """Fluid at rest on both sides, high pressure on the left: rarefaction to the left, shock to the right."""
    left: State
    right: State
    star_left: State
    star_right: State       # its speed is that of the shock
    fan: list               # (x/t, State) from head to tail


def isentrope(solid, left, pressure, steps=4000):
    """States of the rarefaction from `left` down to a pressure, as (u - c, State); Runge-Kutta in the density."""
    def rates(rho, e):    # d(u)/d(rho), d(e)/d(rho) along the wave
        return -solid.sound(rho, e) / rho, solid.pressure(rho, e) / rho ** 2

    rho, u, e, fan = left.rho, 0.0, left.e, []
    end = bisect(lambda r: solid.pressure(r, left.e) - pressure, 0.5 * left.rho, left.rho)    # surely past the end
    step = 1.2 * (end - left.rho) / steps
    while solid.pressure(rho, e) > pressure:
        fan.append((u - solid.sound(rho, e), State(rho, solid.pressure(rho, e), e, u)))
        du1, de1 = rates(rho, e)
        du2, de2 = rates(rho + step / 2, e + step / 2 * de1)
        du3, de3 = rates(rho + step / 2, e + step / 2 * de2)
        du4, de4 = rates(rho + step, e + step * de3)
        rho, u, e = rho + step, u + step / 6 * (du1 + 2 * du2 + 2 * du3 + du4), e + step / 6 * (de1 + 2 * de2 + 2 * de3 + de4)
    return fan, State(rho, solid.pressure(rho, e), e, u)


def tube(solid, e_left):
    """Both sides with the density rho0, left with the energy e_left."""
    left = State(solid.rho0, solid.pressure(solid.rho0, e_left), e_left)
    right = State(solid.rho0, 0.0, 0.0)
    behind = lambda rho: jump(solid, right, rho, 0.0)
    fan, _ = isentrope(solid, left, 1e-3 * left.stress)
    pressures = [state.stress for _, state in fan]

    def velocity(pressure):
        """u on the isentrope, between the states of the fan."""
        k = next(k for k in range(1, len(fan)) if pressures[k] <= pressure)
        share = (pressures[k - 1] - pressure) / (pressures[k - 1] - pressures[k])
        blend = lambda name: (1 - share) * getattr(fan[k - 1][1], name) + share * getattr(fan[k][1], name)
        return k, State(blend("rho"), pressure, blend("e"), blend("u"))

    def excess(rho):
        state = behind(rho)
        return state.u - velocity(min(state.stress, left.stress * (1 - 1e-9)))[1].u

    rho = bisect(excess, solid.rho0 * (1 + 1e-9), 1.15 * solid.rho0)
    right_star = behind(rho)
    k, left_star = velocity(right_star.stress)
    tail = left_star.u - solid.sound(left_star.rho, left_star.e)
    return Tube(left, right, left_star, right_star, fan[:k] + [(tail, left_star)])


def tube_at(tube, speed):
    """The state where x/t = speed."""
    if speed <= tube.fan[0][0]:
        return tube.left
    if speed <= tube.fan[-1][0]:
        k = next(k for k in range(1, len(tube.fan)) if tube.fan[k][0] >= speed)
        (a, first), (b, second) = tube.fan[k - 1], tube.fan[k]
        share = (speed - a) / (b - a)
        blend = lambda name: (1 - share) * getattr(first, name) + share * getattr(second, name)
        return State(blend("rho"), blend("stress"), blend("e"), blend("u"))
    if speed <= tube.star_left.u:
        return tube.star_left
    return tube.star_right if speed <= tube.star_right.speed else tube.right


COPPER = Solid(8930.0, 3940.0, 1.49, 2.0, 45e9, 90e6)
ALUMINIUM = Solid(2785.0, 5328.0, 1.338, 2.0, 27.6e9, 300e6)
IRON_FLUID = Solid(7850.0, 3600.0, 1.8, 1.8)
