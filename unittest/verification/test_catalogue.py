#!/usr/bin/env python3
"""Tests of the catalogue itself: that it complains where it has to, and that the exact solutions are those of others."""

import math
import sys
import unittest

sys.dont_write_bytecode = True

import catalogue
import histories
import lattice
import methods
import profiles
import shock
from catalogue import Case, Figure, Result


class Scene:
    """A scene with one figure, to be below 0.1."""
    FIGURES = [Figure("error", "error", order=True)]

    def __init__(self, known=(), least=None):
        self.known, self.least = dict(known), least

    def gates(self, case):
        return {"error": 0.1}

    def misses(self, case):
        return self.known

    def order_gates(self, cases):
        return {"error": self.least} if self.least else {}


def ran(n, value, **more):
    return Result(Case(f"some-{n}", methods.METHODS[0], n, **more), {"error": value})


class Judging(unittest.TestCase):
    def count(self, scene, *results):
        return len(catalogue.complaints(scene, list(results))[0])

    def test_gates(self):
        self.assertEqual(self.count(Scene(), ran(10, 0.05), ran(20, -0.05)), 0)
        self.assertEqual(self.count(Scene(), ran(10, 0.2)), 1)
        self.assertEqual(self.count(Scene(), ran(10, -0.2)), 1)
        self.assertEqual(self.count(Scene(), ran(10, math.nan)), 1)

    def test_known_miss_has_to_be_missed(self):
        self.assertEqual(self.count(Scene({"error": "why"}), ran(10, 0.2)), 0)
        self.assertEqual(self.count(Scene({"error": "why"}), ran(10, 0.05)), 1)
        for value in (0.2, 0.05):
            self.assertEqual(self.count(Scene({"error": catalogue.Chance("why")}), ran(10, value)), 0)

    def test_crash(self):
        crashed = Result(Case("some-10", methods.METHODS[0], 10), {}, "ERROR")
        self.assertEqual(self.count(Scene(), crashed), 1)
        crashed.case.may_fail = "why"
        self.assertEqual(self.count(Scene(), crashed), 0)
        self.assertEqual(self.count(Scene(), ran(10, 0.05, may_fail="why")), 1)
        self.assertEqual(self.count(Scene(), ran(10, 0.05, may_fail=catalogue.Chance("why"))), 0)

    def test_order(self):
        second = [ran(n, 1 / n**2) for n in (10, 20, 40)]
        self.assertAlmostEqual(catalogue.order(second, "error"), 2.0, 12)
        self.assertEqual(self.count(Scene(least=1.9), *second), 0)
        self.assertEqual(self.count(Scene(least=2.1), *second), 1)
        self.assertEqual(self.count(Scene(least=1.9), ran(10, 0.01)), 1)    # one resolution has no order
        self.assertEqual(self.count(Scene(least=1.9), *second, ran(80, math.nan)), 2)    # its gate, and the order


class Exact(unittest.TestCase):
    """Against an independent solver of the jump conditions, to the digits it was noted with."""

    def test_copper_piston(self):
        first, second = shock.piston(shock.COPPER, 20.0)
        for value, want, places in ((first.rho, 8938.934, 3), (first.stress / 1e9, 0.199030, 6), (first.u, 4.7198, 4),
                                    (first.speed, 4722.18, 2), (second.rho, 8973.453, 3),
                                    (second.stress / 1e9, 0.741592, 6), (second.speed, 3976.96, 2), (second.e, 213.53, 2)):
            self.assertAlmostEqual(value, want, places)

    def test_aluminium_impact(self):
        first, second = shock.piston(shock.ALUMINIUM, 400.0)
        for value, want, places in ((first.stress / 1e9, 0.635885, 5), (first.speed, 6490.46, 2),
                                    (second.rho, 2985.620, 3), (second.stress / 1e9, 6.636147, 6),
                                    (second.speed, 5908.78, 2), (second.e, 81270.97, 2)):
            self.assertAlmostEqual(value, want, places)

    def test_noh(self):
        _, behind = shock.piston(shock.IRON_FLUID, 200.0)
        for value, want, places in ((behind.rho, 8267.66, 2), (behind.stress / 1e9, 6.215645, 6), (behind.e, 20000, 5),
                                    (behind.speed, 3959.01, 2)):
            self.assertAlmostEqual(value, want, places)

    def test_tube(self):
        tube = shock.tube(shock.IRON_FLUID, 707714.084)
        for value, want, places in ((tube.left.stress / 1e9, 10.0, 6), (tube.star_right.stress / 1e9, 4.950243, 6),
                                    (tube.star_left.u, 162.0607, 4), (tube.star_left.rho, 7542.0177, 3),
                                    (tube.star_right.rho, 8191.1483, 3), (tube.star_left.e, 669039.38, 1),
                                    (tube.star_right.speed, 3891.161, 3), (tube.fan[0][0], -4065.326, 2),
                                    (tube.fan[-1][0], -3870.426, 2)):
            self.assertAlmostEqual(value, want, places)

    def test_lattice_sums(self):
        for h, want in ((1.2, 0.991), (1.3, 1.011), (1.5, 1.007), (2.0, 0.999)):
            self.assertAlmostEqual(lattice.row_sum(h), want, 3)
        self.assertAlmostEqual(lattice.frequency(1e-4, 1.3, True), 1.0, 7)


class Profiles(unittest.TestCase):
    def test_distances(self):
        xs, ys = [0.0, 1.0, 2.0], [1.0, 1.0, 0.0]
        self.assertAlmostEqual(profiles.l1(xs, ys, lambda x: 1.0, 0.0, 2.0), 0.25, 6)
        self.assertAlmostEqual(profiles.front(xs, ys, 0.25), 1.75, 12)
        self.assertAlmostEqual(profiles.mean(xs, ys, 1.0, 2.0), 0.5, 6)


class Histories(unittest.TestCase):
    def test_largest(self):
        self.assertEqual(histories.largest([2.0, -3.0, math.inf]), math.inf)
        for k in range(3):
            values = [3.0, 1.0, 2.0]
            values[k] = math.nan
            self.assertTrue(math.isnan(histories.largest(values)))
            self.assertTrue(math.isnan(histories.largest(map(abs, values))))

    def test_drift(self):
        self.assertAlmostEqual(histories.drift([2.0, 2.1, 1.8]), 0.1, 12)
        self.assertTrue(math.isnan(histories.drift([2.0, math.nan, 1.8])))

    def test_crossings(self):
        self.assertEqual(histories.crossings([0.0, 1.0, 2.0], [1.0, -1.0, 3.0]), [0.5, 1.25])
        self.assertEqual(histories.crossings([0.0, 1.0, 2.0], [1.0, -1.0, 3.0], 2), [1.25])

    def test_slope(self):
        self.assertAlmostEqual(histories.slope([1.0, 3.5, 4.0, 7.0]), 1.85, 12)
        self.assertAlmostEqual(histories.slope([1.0, 4.0, 9.0], [1.0, 2.0, 4.0]), 37 / 14, 12)

    def test_closest(self):
        shot = {"x": [0.0, 1.0, 1.6, 3.0], "y": [0.0, 0.0, 0.8, 0.0]}
        self.assertAlmostEqual(histories.closest(shot, 2.0), 0.5, 12)
        self.assertEqual(histories.closest(shot, 0.5), math.inf)


if __name__ == "__main__":
    unittest.main()
