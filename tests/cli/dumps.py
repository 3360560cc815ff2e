# SPDX-License-Identifier: GPL-3.0-or-later
"""LAMMPS text dumps without mdana: a reader, a writer, and small dumps whose answers are known in closed form."""

import gzip
import math
import re
from dataclasses import dataclass, replace

import numpy as np

BOX = "ITEM: BOX BOUNDS ff ff ff\n-50 50\n-50 50\n-50 50\n"


@dataclass
class Frame:
    step: int
    time: float | None
    columns: list
    atoms: np.ndarray  # a row an atom
    units: str | None = "lj"
    box: str = BOX

    def __getitem__(self, names):
        """Columns by name, "x y z"."""
        return self.atoms[:, [self.columns.index(name) for name in names.split()]]

    def body(self, number):
        """The atoms of one type."""
        return replace(self, atoms=self.atoms[self["type"][:, 0] == number])

    def without(self, *names):
        keep = [k for k, name in enumerate(self.columns) if name not in names]
        return replace(self, columns=[self.columns[k] for k in keep], atoms=self.atoms[:, keep])

    def head(self):
        text = f"ITEM: UNITS\n{self.units}\n" if self.units else ""
        text += f"ITEM: TIME\n{self.time!r}\n" if self.time is not None else ""
        text += f"ITEM: TIMESTEP\n{self.step}\nITEM: NUMBER OF ATOMS\n{len(self.atoms)}\n{self.box}"
        return text + f"ITEM: ATOMS {' '.join(self.columns)}\n"

    def rows(self):
        whole = [name in ("id", "type", "mol", "ix", "iy", "iz") for name in self.columns]
        return "".join(" ".join(str(int(v)) if w else format(float(v), ".17g") for v, w in zip(row, whole)) + "\n"
                       for row in self.atoms)

    def text(self):
        return self.head() + self.rows()


def read_text(path):
    data = path.read_bytes()
    return (gzip.decompress(data) if data[:2] == b"\x1f\x8b" else data).decode()


def split(text):
    """The frames of a dump, each as text: a header up to ITEM: ATOMS, and the lines up to the next ITEM."""
    frames = re.findall(r"ITEM: (?!ATOMS)(?:[^\n]*\n)+?ITEM: ATOMS[^\n]*\n(?:[^I\n][^\n]*\n)*", text)
    assert "".join(frames) == text, "not all of the dump was understood"
    return frames


def parse(text):
    """One frame."""
    lines = text.splitlines()
    time = units = box = None
    k = 0
    while not lines[k].startswith("ITEM: ATOMS"):
        if lines[k] == "ITEM: UNITS":
            units = lines[k + 1]
        elif lines[k] == "ITEM: TIME":
            time = float(lines[k + 1])
        elif lines[k] == "ITEM: TIMESTEP":
            step = int(lines[k + 1])
        elif lines[k] == "ITEM: NUMBER OF ATOMS":
            count = int(lines[k + 1])
        elif lines[k].startswith("ITEM: BOX"):
            box = "\n".join(lines[k:k + 4]) + "\n"
        k += 1
    columns = lines[k].split()[2:]
    atoms = np.array(" ".join(lines[k + 1:]).split(), dtype=float)
    return Frame(step, time, columns, atoms.reshape(count, len(columns)), units, box)


def read(path):
    return [parse(text) for text in split(read_text(path))]


def write(path, frames):
    text = "".join(frame.text() for frame in frames)
    path.write_bytes(gzip.compress(text.encode()) if path.suffix == ".gz" else text.encode())
    return path


# ---- what the numbers of a frame should be ---------------------------------------------------------------------------


def mean(rows):
    """Exactly rounded mean of each column."""
    return np.array([math.fsum(column) for column in rows.T]) / len(rows)


def centres(frame, columns="x y z"):
    """Means of bodies 1 and 2, which is their centres of mass as all masses are the same."""
    return mean(frame.body(1)[columns]), mean(frame.body(2)[columns])


def five_point(times, samples, order):
    """Derivative of each column: of the quartic through the five samples about each (at the ends: the five first or
    last)."""
    result = np.empty_like(samples)
    for i, t in enumerate(times):
        first = min(max(i - 2, 0), len(times) - 5)
        window = slice(first, first + 5)
        quartic = np.polyfit(times[window] - t, samples[window], 4)  # highest power first
        result[i] = quartic[4 - order] * math.factorial(order)
    return result


def along(vectors, directions):
    return np.sum(vectors * directions, axis=1) / np.linalg.norm(directions, axis=1)


# ---- dumps with a known answer ---------------------------------------------------------------------------------------

CORNERS = np.array([[x, y, z] for x in (-0.5, 0.5) for y in (-0.5, 0.5) for z in (-0.5, 0.5)])
COLUMNS = "id type x y z vx vy vz fx fy fz".split()
DIRECTION = np.array([2.0, -3.0, 6.0]) / 7  # of the centre line: along no axis


def two_cubes(step, time, distance, speed=0.0, force=0.0, masses=(1.0, 1.0), units="lj"):
    """Eight atoms a body at the corners of a unit cube; the centres are `distance` apart, their distance grows with
    `speed`, and body 2 is pushed away from body 1 with `force` (in sum)."""
    share = masses[1] / sum(masses), -masses[0] / sum(masses)  # of the motion: the common centre of mass rests
    rows = []
    for body, (part, sign) in enumerate(zip(share, (-1, 1)), 1):
        centre, velocity = -part * distance * DIRECTION, -part * speed * DIRECTION
        for k, corner in enumerate(CORNERS, 1):
            rows.append([8 * (body - 1) + k, body, *(centre + corner), *velocity, *(sign * force / 8 * DIRECTION)])
    return Frame(step, time, COLUMNS, np.array(rows), units)


def spring_bounce(stiffness=50.0, harder=4.0, speed=0.25, touch=10.0, mass=4.0, frames_a_quarter=16):
    """A bounce with loss in closed form: bodies of eight atoms of mass 1 (so m* = 4) fly freely, touch at the distance
    `touch`, are loaded with F = k delta and unloaded with F = h k (delta - d0), which joins it at the turn. Frames fall
    on the touch, the turn and the separation. Returns frames, F_max, delta_max and the energy lost."""
    w1 = math.sqrt(stiffness / mass)
    w2 = math.sqrt(harder) * w1
    depth, top = speed / w1, stiffness * speed / w1
    depth2, speed2 = top / (harder * stiffness), top / (harder * stiffness) * w2
    quarter1, quarter2 = math.pi / 2 / w1, math.pi / 2 / w2
    dt = quarter1 / frames_a_quarter
    frames = []
    for k in range(-20, 20 + frames_a_quarter + round(quarter2 / dt)):
        t = k * dt
        if k <= 0:
            delta, force, v = speed * t, 0.0, speed
        elif k <= frames_a_quarter:
            delta, v = depth * math.sin(w1 * t), speed * math.cos(w1 * t)
            force = stiffness * delta
        elif t <= quarter1 + quarter2 * (1 + 1e-9):
            phase = w2 * (t - quarter1)
            delta, v = depth - depth2 * (1 - math.cos(phase)), -speed2 * math.sin(phase)
            force = top * math.cos(phase)
        else:
            delta = depth - depth2 - speed2 * (t - quarter1 - quarter2)
            force, v = 0.0, -speed2
        frames.append(two_cubes(1000 + k, t - -20 * dt, touch - delta, -v, force))
    lost = mass / 2 * (speed**2 - speed2**2)
    return frames, top, depth, lost


def hertz_bounce(modulus=60.0, radius=5.0, depth=1.0, frames=41, units="lj"):
    """Bodies whose distance goes down by `depth` below two radii and up again, with the force of Hertz's law
    4/3 E* sqrt(R/2) delta^1.5 at every frame. (The motion is not what the force would make of it: only a command that
    takes the force from the atoms' forces may be asked.)"""
    result = []
    for k in range(frames):
        turn = math.cos(2 * math.pi * k / (frames - 1))  # 1, -1, 1
        delta = -depth * turn
        force = 4 / 3 * modulus * math.sqrt(radius / 2) * max(delta, 0.0)**1.5
        result.append(two_cubes(k, 0.25 * k, 2 * radius - delta, 0.0, force, units=units))
    return result


def andrews_force(delta, top, modulus, strength, reduced):
    """Force of two elastic, perfectly plastic spheres (Arakawa et al. 2024, eqs 23, 26, 68): on loading up to `top`, and
    below `top` on the return."""
    yield_delta = (math.pi / 2 * strength / modulus)**2 * reduced
    if delta <= 0:
        return 0.0
    if delta >= top or top <= yield_delta:
        if delta <= yield_delta:
            return 4 / 3 * modulus * math.sqrt(reduced) * delta**1.5
        return math.pi * reduced * strength * (delta - yield_delta / 3)
    end = top - yield_delta
    x = max(delta - end, 0.0)
    return 2 * modulus * math.sqrt(reduced) * (end * math.sqrt(x) + 2 / 3 * x**1.5)


def andrews_path(modulus, strength, reduced, mass, speed, dt, before, last, substeps=20):
    """(delta, d delta/dt) every dt from -before*dt on, up to `last` frames; delta = 0 falls on no frame. Runge-Kutta of
    fourth order."""
    shift = 0.37 * dt
    path = [(speed * (k * dt - shift), speed) for k in range(1 - before, 1)]
    delta, v, top, h = path[-1][0], speed, 0.0, dt / substeps
    while len(path) < last:
        for _ in range(substeps):
            def rate(x, u):
                return u, -andrews_force(x, top if u < 0 else max(top, x), modulus, strength, reduced) / mass
            a = rate(delta, v)
            b = rate(delta + h / 2 * a[0], v + h / 2 * a[1])
            c = rate(delta + h / 2 * b[0], v + h / 2 * b[1])
            d = rate(delta + h * c[0], v + h * c[1])
            delta += h / 6 * (a[0] + 2 * b[0] + 2 * c[0] + d[0])
            v += h / 6 * (a[1] + 2 * b[1] + 2 * c[1] + d[1])
            top = max(top, delta)
        path.append((delta, v))
    return path


def rigid_aggregates(path, dt, radius, grains, mass, scale=(1.0, 1.0, 1.0), units="lj", reach=0.8, seed=1):
    """Two aggregates of `grains` grains at random places within reach*radius, the second the mirror image of the first,
    which move as a whole: X = 2 radius - delta. `mass` of an aggregate. `scale` multiplies masses, lengths and times."""
    random = np.random.default_rng(seed)
    places = random.normal(size=(grains, 3))
    places *= (reach * radius * random.random((grains, 1))**(1 / 3)) / np.linalg.norm(places, axis=1, keepdims=True)
    places -= places.mean(axis=0)
    m, length, time = scale
    frames = []
    for k, (delta, v) in enumerate(path):
        half, rows = radius - delta / 2, []
        for body, sign in ((1, -1), (2, 1)):
            for i, place in enumerate(places):
                x = sign * (half * DIRECTION - place)
                u = -sign * v / 2 * DIRECTION
                rows.append([grains * (body - 1) + i + 1, body, mass / grains * m, *(x * length), *(u * length / time)])
        frames.append(Frame(k, k * dt * time, "id type mass x y z vx vy vz".split(), np.array(rows), units))
    return frames
