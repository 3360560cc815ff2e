# SPDX-License-Identifier: GPL-3.0-or-later
"""Collision laws against another integrator and another formulation: SciPy's LSODA on (t; delta, v, a) with the
equations as they are printed (Yoshida, Kokubo & Tanaka 2024, eqs 9-12, 17-20, B1, B2), at the particles of their Table II
and the velocities of their Figure 8."""

import math
import unittest

import lammps  # noqa: F401: finds the helpers of tests/cli
import running

try:
    from scipy.integrate import LSODA, solve_ivp
except ImportError:
    running.skip("no scipy (Debian: apt install python3-scipy)")

PARTICLES = {29.6: (113637, 53.2), 58.9: (914443, 58.4), 88.4: (3120599, 63.7), 147: (14434147, 65.5)}
VELOCITIES = (0.04, 0.06, 0.08, 0.1, 0.12, 0.15, 0.2, 0.3, 0.5)
GAMMA, NU, SPACING = 3.17, 0.25, 1.091
SIGMA = GAMMA / SPACING
AGREE = 1e-8
NEAR_POLE = 1e-5  # relative distance from beta = 0.02 and 50, where the printed law is infinite


def crack(beta):
    """Right-hand side of B2."""
    beta = min(max(beta, 0.02 * (1 + NEAR_POLE)), 50 * (1 - NEAR_POLE))
    if beta <= 0.29:
        return 0.15 / (beta * math.log(0.98 / (1 - beta)))
    if beta < 1:
        x = 1 / beta - 1
        return (0.1035 * x + 0.3421) * x**1.1160
    if beta < 3.7:
        x = beta - 1
        return -(0.2112 * x + 0.3939) * x**1.1403
    return -0.24 * beta / math.log(0.98 / (1 - 1 / beta))


class Pair:
    """Two equal spheres."""

    def __init__(self, radius):
        self.radius = radius
        self.count, self.modulus = PARTICLES[radius]
        self.r, self.m = radius / 2, self.count / 2
        self.a0 = (9 * math.pi * GAMMA * self.r**2 / self.modulus)**(1 / 3)

    def arguments(self, law, velocities, **parameters):
        values = {"R": self.radius, "m": self.count, "E": self.modulus, "gamma": GAMMA,
                  "v": velocities} | parameters
        return ["predict", "--law", law, *(x for k, v in values.items() for x in ("-p", f"{k}={v}"))]

    def elastic(self, delta, a):
        return 2 * self.modulus * a * (delta - a * a / (3 * self.r))

    def pressure(self, a):
        return 2 * self.modulus * a / (math.pi * self.r) - math.sqrt(4 * GAMMA * self.modulus / (math.pi * a))

    def stress_relaxation(self, c, b, zeta):
        """T(a) of eqs 17 and 18."""

        def relaxation(a):
            p = b * self.pressure(a) / self.modulus
            return c * self.radius * (math.exp(min(p**zeta, 200)) if p > 0 else 1)

        return relaxation

    def beta(self, delta, a):
        return self.modulus / (4 * math.pi * a * self.r**2) * (a * a - delta * self.r)**2 / GAMMA


def bounce(rates, start, parted, time):
    """Speed at which the spheres part, None if they stay: to the greatest compression, then until `parted` falls
    through zero or they are at rest again."""
    settings = {"method": "LSODA", "rtol": 1e-12, "atol": [1e-13, 1e-14, 1e-13][:len(start)]}

    def rest(_, y):
        return y[1]

    rest.terminal = parted.terminal = True
    loading = solve_ivp(rates, (0, time), start, events=[rest], **settings)
    if not len(loading.t_events[0]):
        return None
    turn = loading.y_events[0][0]
    turn[1] = -1e-300
    unloading = solve_ivp(rates, (0, time), turn, events=[parted, rest], **settings)
    return -unloading.y_events[0][0][1] if len(unloading.t_events[0]) else None


def free_radius(pair, velocity, relaxation, method=LSODA, tolerance=1e-12):
    """e of a contact whose radius follows the crack law, None if it stays; T_vis = relaxation(a)."""

    def rates(_, y):
        delta, v, a = y
        a = max(a, 1e-9)
        t = relaxation(a)
        force = pair.elastic(delta, a) + 2 * t * pair.modulus / NU**2 * a * v
        return [v, -force / pair.m, crack(pair.beta(delta, a)) * 2 * pair.modulus * GAMMA / (SIGMA**2 * t)]

    a = (0.08 * math.pi * GAMMA * pair.r**2 / pair.modulus)**(1 / 3) * (1 + 1e-7)
    solver = method(rates, 0, [0.0, velocity, a], 200 * pair.radius, rtol=tolerance,
                    atol=[0.1 * tolerance, 0.01 * tolerance, 0.1 * tolerance])
    turned = False
    while solver.status == "running":
        solver.step()
        delta, v, a = solver.y
        if turned and v > 0:
            return None
        turned = turned or v < 0
        if turned and pair.beta(delta, a) > 49.9:  # the rest takes no time
            return -v / velocity
    return None


def jkr_radius(pair, delta):
    """a of the JKR curve, by bisection free: the larger root of 3 s^4 - 2 s = d, a = a0 s^2."""
    d = delta / (pair.a0**2 / (3 * pair.r))
    s = 1 + max(d, 0)**0.25
    for _ in range(60):
        slope = 12 * s**3 - 2
        change = (3 * s**4 - 2 * s - d) / slope if slope > 0 else 0
        s -= change
        if abs(change) < 1e-15 * s:
            break
    return pair.a0 * max(s, 6**(-1 / 3))**2


def on_curve(pair, velocity, strength, alpha, beta):
    """e of a contact on the JKR curve with F_dis = D E* v^alpha a^beta, None if it stays."""
    least = -0.75**(2 / 3) * pair.a0**2 / (3 * pair.r)

    def rates(_, y):
        delta, v = y
        a = jkr_radius(pair, max(delta, least))
        lost = math.copysign(strength * pair.modulus * abs(v)**alpha * a**beta, v)
        return [v, -(pair.elastic(max(delta, least), a) + lost) / pair.m]

    def parted(_, y):
        return y[0] - least

    speed = bounce(rates, [0.0, velocity], parted, 200 * pair.radius)
    return None if speed is None else speed / velocity


class CollisionLaws(running.Case):
    def compare(self, pair, velocities, oracle, law, **parameters):
        bounced = 0
        for v in velocities:
            found = self.document(*pair.arguments(law, v, **parameters), "--tolerance", "1e-10")
            wanted = oracle(v)
            what = f"{law}, R = {pair.radius}, v = {v}"
            self.assertEqual(found["outcome"], "stick" if wanted is None else "bounce", what)
            if wanted is not None:
                bounced += 1
                self.assertAlmostEqual(found["e"], wanted, delta=AGREE, msg=what)
        return bounced

    def test_krijt(self):
        bounced = 0
        for radius in PARTICLES:
            pair, t = Pair(radius), 0.075 * radius / 147
            bounced += self.compare(pair, VELOCITIES, lambda v: free_radius(pair, v, lambda a: t), "krijt",
                                    nu=NU, T_vis=t, spacing=SPACING)
        self.assertGreater(bounced, 20)

    def test_stress(self):
        bounced = 0
        for radius in PARTICLES:
            pair = Pair(radius)
            relaxation = pair.stress_relaxation(2.1e-4, 6.2, 4)
            bounced += self.compare(pair, VELOCITIES, lambda v: free_radius(pair, v, relaxation), "stress",
                                    nu=NU, C=2.1e-4, B=6.2, zeta=4, spacing=SPACING)
        self.assertGreater(bounced, 5)

    def test_power(self):
        bounced = 0
        for radius in PARTICLES:
            pair = Pair(radius)
            bounced += self.compare(pair, VELOCITIES, lambda v: on_curve(pair, v, 118, 3, 1.5), "power",
                                    D=118, alpha=3, beta=1.5)
        self.assertGreater(bounced, 20)


if __name__ == "__main__":
    running.main()
