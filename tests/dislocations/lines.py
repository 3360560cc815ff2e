# SPDX-License-Identifier: GPL-3.0-or-later
"""Cases with straight lines along z through rods, of which the outer layer is held, and through films of these rods."""

import numpy as np

import measure
from case import Case, Line
from crystal import EDGE, LAYER, fault_shifts, fcc_points, mirrored, to_lab, turn, twin_lamella
from fields import moved, straight

RADIUS, HALF = 18.0, 18.0
HELD = 2.6  # the potential reaches 2.5
OFF_ATOMS = np.array([0.21, LAYER / 2, 0.13])  # puts y = 0 between two {111} layers
ENDS = {"ends": 1.2, "relative": 0.02,
        "reason": "a line ends between the outermost atoms and one spacing (1.1) beyond them or before, "
                  "so each end is uncertain by half of it; 2 % for the bow of the lines towards the ends"}


def in_rod(places):
    return places[np.hypot(places[:, 0], places[:, 1]) < RADIUS]


def near_side(places):
    return np.hypot(places[:, 0], places[:, 1]) > RADIUS - HELD


def along_z(places, at, burgers, **more):
    low, high = places[:, 2].min(), places[:, 2].max()
    return Line(burgers, np.array([[*at, low], [*at, high]]), **more)


def follow(case, places, labels):
    for line in case.lines:
        line.corners = measure.straight(line, places, labels)


def dissociated(places, axes, total, leading, start, end):
    """Displacement of total in two partials, with a fault from start to end (x, y); and the two lines."""
    u = straight(places, start, to_lab(axes, total)) + moved(places, start, end, to_lab(axes, leading))
    trailing = np.subtract(total, leading)
    return u, [along_z(places, start, trailing, axes=axes, role="trailing"),
               along_z(places, end, leading, axes=axes, role="leading")]


def on_glide_plane(line, normal, total, width, about):
    axes = turn(line, normal)
    leading = next(s for s in fault_shifts(np.array(normal)) if np.dot(s, total) > 0)
    places = in_rod(fcc_points(axes, (RADIUS, RADIUS, HALF), OFF_ATOMS))
    u, lines = dissociated(places, axes, total, leading, (-width / 2, 0), (width / 2, 0))
    return Case(about, axes, places + u, lines, ENDS, held=near_side(places), measure=follow)


def edge():
    return on_glide_plane((1, 1, -2), (1, 1, 1), (-3, 3, 0), 10.0,
                          "edge dislocation 1/2[-110] on (111), line along [11-2], in two Shockley partials")


def screw():
    return on_glide_plane((1, -1, 0), (1, 1, 1), (3, -3, 0), 10.0,
                          "screw dislocation 1/2[1-10] on (111), in two Shockley partials")


def film(layers):
    """The rod of `edge`, relaxed, of which the layers next to the glide plane are kept."""
    case = edge()
    half = layers * LAYER
    case.about = f"{case.about}; of the relaxed rod a film of {2 * layers} layers of (111) is left, |y| < {half:.2f}"
    case.dropped = np.abs(case.places[:, 1]) > half
    return case


def film_across(half):
    """The leading partial of `edge` in the middle of a film normal to x; the fault goes from it to one surface."""
    case = edge()
    case.steps = 10
    case.lines = case.lines[1:]
    case.about = f"leading partial of: {case.about}; of the rod a film normal to [-110] is left, {half} to either side"
    case.found = "minimised in 10 steps only: further on, the partial leaves its place"
    core = case.lines[0].corners[0, 0] + 0.5  # where it settles
    case.dropped = np.abs(case.places[:, 0] - core) > half
    return case


def lomer_cottrell():
    axes = turn((1, -1, 0), (0, 0, 1))
    total, faults = np.array([3, 3, 0]), {(1, 1, 1): (1, 1, -2), (1, 1, -1): (1, 1, 2)}
    junction, lines = np.array([0.0, 3.0]), []
    origin = (-EDGE / np.sqrt(8), junction[1], 0.13)  # puts the junction between two layers of both {111}
    places = in_rod(fcc_points(axes, (RADIUS, RADIUS, HALF), origin))
    u = straight(places, junction + [0.02, 0.03], to_lab(axes, total))
    stair_rod = total.copy()
    for normal, shift in faults.items():
        away = np.cross(axes @ normal, [0, 0, 1])[:2] / np.sqrt(3)
        u += moved(places, junction, junction + 9 * away, to_lab(axes, shift))
        lines.append(along_z(places, junction + 9 * away, shift))
        stair_rod -= shift
    lines.append(along_z(places, junction, stair_rod))
    return Case("Lomer-Cottrell lock: a stair-rod and two Shockley partials on (111) and (11-1)", axes, places + u,
                lines, ENDS, held=near_side(places), measure=follow)


def twin_lamella_screw():
    axes = turn((1, -1, 0), (1, 1, 1))
    twin, half = mirrored(axes), 9 * LAYER
    places = in_rod(twin_lamella(axes, (RADIUS, RADIUS, HALF), half))
    normal, total, leading = np.array([1, 1, -1]), np.array([-3, 3, 0]), (-2, 1, -1)
    away = np.cross(twin @ normal, [0, 0, 1])[:2] / np.sqrt(3)
    across = (twin @ normal)[:2] / np.sqrt(3)
    height = (np.array([0.21, -half]) @ across) % LAYER - LAYER / 2  # between two layers, near the middle
    u, lines = dissociated(places, twin, total, leading, height * across - 4 * away, height * across + 4 * away)
    return Case("screw dislocation 1/2<110> in two Shockley partials on an inclined {111} of a twin lamella, 18 layers",
                axes, places + u, lines, ENDS, held=near_side(places), measure=follow,
                grain=lambda place: twin if abs(place[1]) < half else axes)


def twin_crossing():
    flat, half, cyclic = turn((1, -1, 0), (1, 1, 1)), 6 * LAYER, [2, 0, 1]  # to x = [1-10], z = [111]
    places = in_rod(twin_lamella(flat, (RADIUS, HALF, RADIUS), half)[:, cyclic])
    axes, twin = flat[cyclic], mirrored(flat)[cyclic]
    u = straight(places, (0.1, 0.15), to_lab(axes, (3, -3, 0)))
    lines = [along_z(places, (0.1, 0.15), (3, -3, 0))]
    return Case("edge dislocation 1/2[1-10] along [111], across a twin lamella of 12 layers whose planes hold b", axes,
                places + u, lines, ENDS, held=near_side(places), measure=follow,
                grain=lambda place: twin if abs(place[2]) < half else axes,
                found="the core has spread to 2.8 on either side along b, so partials may be told apart in it")


LINES = {
    "edge": edge, "screw": screw, "film_1.8": lambda: film(2), "film_2.7": lambda: film(3),
    "film_across_2.0": lambda: film_across(2.0), "film_across_2.5": lambda: film_across(2.5),
    "lomer_cottrell": lomer_cottrell, "twin_lamella": twin_lamella_screw, "twin_crossing": twin_crossing,
}
