# SPDX-License-Identifier: GPL-3.0-or-later
"""What a case is: atoms to relax, and what is known of its dislocations."""

from dataclasses import dataclass, field
from typing import Callable

import numpy as np


@dataclass
class Line:
    """A dislocation line. Burgers vector in a/6, for a right-handed turn about the line in the order of its corners."""

    burgers: tuple
    corners: np.ndarray  # of a polygon [sigma]
    closed: bool = False
    axes: np.ndarray = None  # of the crystal that burgers belongs to, if not the case's
    role: str = ""
    circuit: float = 3.5  # radius of the Burgers circuits that prove it
    parted: dict = field(default_factory=dict)  # at a part of the way (0 to 1): what is in the circuit there instead

    def __post_init__(self):
        self.corners = np.asarray(self.corners, float)
        self.burgers = [int(part) for part in self.burgers]

    def segments(self):
        ends = np.roll(self.corners, -1, axis=0) - self.corners
        return ends if self.closed else ends[:-1]

    def length(self):
        return float(np.linalg.norm(self.segments(), axis=1).sum())


@dataclass
class Case:
    about: str
    axes: np.ndarray  # rows: the laboratory's x, y, z in cube axes
    places: np.ndarray  # [sigma]
    lines: list
    tolerance: dict
    held: np.ndarray = None  # mask of atoms that stay where they are
    dropped: np.ndarray = None  # mask of atoms that are left out in the end
    steps: int = 300  # of the minimiser at most
    found: str = ""  # what is otherwise than built
    net: bool = False  # only the sum of the Burgers vectors within the lines' circuits is known
    measure: Callable = None  # (places, labels): moves the lines to where they are found after relaxation
    grain: Callable = None  # (place): axes of the crystal there, if there are several

    def __post_init__(self):
        nothing = np.zeros(len(self.places), bool)
        self.held = nothing if self.held is None else self.held
        self.dropped = nothing if self.dropped is None else self.dropped

    def axes_at(self, place):
        return self.grain(place) if self.grain else self.axes
