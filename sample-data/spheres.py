# SPDX-License-Identifier: GPL-3.0-or-later
"""The scenes `hertz` and `adhesive` of `generate`: two colliding Lennard-Jones spheres."""

import math
import random
import shutil
from pathlib import Path

from lammps_runs import (Refused, add_dump_options, add_output_options, dump_name, frames_written, name_run,
                         not_negative, positive, random_orientation, refuse_run, run_lammps, table, told, whole_steps)

HERE = Path(__file__).resolve().parent
DENSITY = 1.08932  # of the fcc lattice, atoms / sigma^3
PRESETS = {
    "tiny": {"radius": 5.0, "dump_interval": 0.25},
    "small": {"radius": 10.0, "dump_interval": 0.25},
    "paper": {"radius": 29.205, "dump_interval": 1.0},
}
SCENES = {
    "hertz": {"attraction": 0.0, "velocity": 0.1, "help": "the bodies only repel each other (4/r^12)"},
    "adhesive": {"attraction": 1.0, "velocity": 0.1, "help": "full Lennard-Jones potential everywhere"},
}
DESCRIPTION = "Two fcc spheres collide head-on along x; {help}. Units are lj (sigma, tau)."


# ---- what is asked for -----------------------------------------------------------------------------------------------


def add_options(parser, scene):
    add_output_options(parser)

    add = parser.add_argument_group("bodies").add_argument
    add("--preset", choices=PRESETS, default="tiny", help="size: radius 5, 10 or 29.205 (default: tiny)")
    add("--long", action="store_true", help="allow the paper preset with attraction (many hours)")
    add("--radius", type=positive, help="atoms farther from the centre are left out (default: by preset)")
    add("--attraction", type=float, default=scene["attraction"], metavar="L",
        help="strength 0..1 of the r^-6 term between the bodies (default: %(default)g)")
    add("--seed", type=int, default=1, help="of the orientations and thermal velocities (default: %(default)s)")
    add("--aligned", action="store_true", help="do not rotate the spheres")
    add("--temperature", type=not_negative, default=1e-6, help="before the collision (default: %(default)g)")

    add = parser.add_argument_group("collision").add_argument
    add("--velocity", type=positive, default=scene["velocity"], help="relative speed (default: %(default)g)")
    add("--gap", type=positive,
        help="distance of the centres minus two radii at first (default: 1.5 without attraction, else cutoff + 0.1)")
    add("--cutoff", type=positive, default=5.0, help="of the potential (default: %(default)g)")
    add("--timestep", type=positive, default=2.0**-7, help="in tau (default: %(default)g)")
    add("--duration", type=positive, metavar="TAU",
        help="(default: until 20 tau after separation, or three oscillations of a bound pair)")
    add("--limit", type=positive, metavar="TAU", help="without --duration, stop here at the latest (default: generous)")
    add("--include", type=Path, metavar="FILE", help="more LAMMPS commands, read just before the collision")

    add = add_dump_options(parser, "TAU", "fx fy fz mass mol c_pe (potential energy) ...", "id type x y z vx vy vz")
    add("--dump-interval", type=positive, metavar="TAU", help="(default: 0.25; paper: 1)")


def complete(args):
    """Fill in the defaults that depend on other options, and refuse what cannot be run."""
    size = f"{args.radius:g}" if args.radius else args.preset
    for name, value in PRESETS[args.preset].items():
        if getattr(args, name) is None:
            setattr(args, name, value)
    args.interaction = "hertz" if args.attraction == 0 else "adhesive"
    if args.gap is None:
        args.gap = 1.5 if args.attraction == 0 else args.cutoff + 0.1
    if args.limit is None:
        args.limit = math.ceil(100 * args.radius + 20 * args.gap / args.velocity)
    name_run(args, f"{args.interaction}-{size}")
    refuse(args)


def refuse(args):
    if not 0 <= args.attraction <= 1:
        raise Refused(f"--attraction {args.attraction:g}: must be 0 to 1")
    if args.attraction > 0 and args.gap <= args.cutoff:
        raise Refused(f"--gap {args.gap:g}: must be above the cutoff {args.cutoff:g}, or the bodies start with a force")
    if args.gap < 1.1:
        raise Refused(f"--gap {args.gap:g}: must be 1.1 or more, or the bodies start with a force")
    if args.cutoff < 1.5:
        raise Refused(f"--cutoff {args.cutoff:g}: must be 1.5 or more")
    if args.preset == "paper" and args.attraction > 0 and not args.long:
        raise Refused("preset paper with attraction takes many hours; say --long if that is what you want")
    refuse_run(args)


# ---- the bodies ------------------------------------------------------------------------------------------------------


def headline(args):
    atoms = atoms_in_ball(args.radius)
    return f"{args.interaction}, radius {args.radius:g}, 2 x {atoms} atoms, speed {args.velocity:g}"


def atoms_in_ball(radius):
    """Number of fcc lattice points within the radius of one of them."""
    half = (4 / DENSITY) ** (1 / 3) / 2
    squared = (radius / half) ** 2
    reach = math.isqrt(int(squared))
    count = 0
    for i in range(-reach, reach + 1):
        for j in range(-math.isqrt(int(squared - i * i)), math.isqrt(int(squared - i * i)) + 1):
            k = math.isqrt(int(squared - i * i - j * j))  # of -k..k, those with i + j + k even
            count += k + 1 if (i + j + k) % 2 == 0 else k
    return count


def axis_and_degrees(quaternion):
    w, *axis = quaternion
    length = math.hypot(*axis)
    if length == 0:
        return "1 0 0", "0"
    return " ".join(repr(x / length) for x in axis), repr(math.degrees(2 * math.atan2(length, w)))


# ---- LAMMPS ----------------------------------------------------------------------------------------------------------


def variables(args, orientations, seed):
    """What collision.lmp is told."""
    (axis1, angle1), (axis2, angle2) = (axis_and_degrees(q) for q in orientations)
    same = ("radius", "attraction", "velocity", "gap", "cutoff", "temperature", "timestep", "columns", "format")
    values = {name: getattr(args, name) for name in same}
    values |= {
        "seed": seed,
        "axis1": axis1, "angle1": angle1, "axis2": axis2, "angle2": angle2,
        "duration": math.ceil(args.duration / args.timestep) if args.duration else 0,
        "max_steps": math.ceil(args.limit / args.timestep),
        "atom_style": "molecular" if "mol" in args.columns.split() else "atomic",
        "dump_style": "custom/gz" if args.gz else "custom",
        "dump_file": dump_name(args),
        "dump_every": whole_steps(args, "dump_interval"),
        "dump_from": whole_steps(args, "dump_from"),
        "sort": "off" if args.unsorted else "id",
        "extra": "include include.lmp" if args.include else "print -",
    }
    return values


# ---- scene.toml ------------------------------------------------------------------------------------------------------


def scene_toml(args, orientations, counts, said):
    head = {
        "schema": 1, "name": args.name, "dump": dump_name(args), "units": "lj", "interaction": args.interaction,
        "timestep": args.timestep, "sigma": 1.0, "cutoff": args.cutoff, "shift": True,
        "bodies": "type",
    }
    parts = ["# What this run is; mdana reads it beside the dump. Written by sample-data/generate.\n" + table(
        None, head, {"sigma": "length scale of the potential", "shift": "zero at the cutoff", "bodies": "how atoms are told apart"})]
    parts.append(table("[masses]  # by atom type", {"1": 1.0, "2": 1.0}))
    for number, (atoms, orientation) in enumerate(zip(counts, orientations), 1):
        body = {"name": str(number), "type": number, "atoms": atoms, "radius": args.radius,
                "radius_definition": "cut", "orientation": orientation}
        parts.append(table("[[body]]", body, {"radius": "atoms farther from the centre were left out",
                                              "orientation": "unit quaternion w x y z"}))
    if args.attraction == 1:
        parts.append(table("[material]  # Yoshida, Kokubo & Tanaka 2024, Sec. III", {"gamma": 3.17, "nu": 0.25}))
    elif args.attraction > 0:
        parts.append(table("[material]  # gamma is not known for this attraction", {"nu": 0.25}))
    parts.append(table("[generator]", generator(args, said)))
    return "\n".join(parts)


def generator(args, said):
    steps, end = told(said, r"^== over at step (\d+): (.*)$")
    names = ("velocity", "gap", "temperature", "attraction", "seed", "aligned", "dump_interval", "dump_from",
             "columns", "format", "ranks")
    return {
        "command": args.command,
        **{name: getattr(args, name) for name in names},
        "sorted": not args.unsorted,
        "steps": int(steps),
        "end": end,
        "lammps_version": told(said, r"^LAMMPS \((.*)\)")[0],
    }


# ---- the run ---------------------------------------------------------------------------------------------------------


def make(args, directory):
    """Make the run in the directory; return its number of frames."""
    rng = random.Random(args.seed)
    orientations = [[1.0, 0.0, 0.0, 0.0] if args.aligned else random_orientation(rng) for _ in range(2)]
    values = variables(args, orientations, rng.randrange(1, 900_000_000))
    shutil.copyfile(HERE / "collision.lmp", directory / "collision.lmp")
    if args.include:
        shutil.copyfile(args.include, directory / "include.lmp")
    said = run_lammps(directory, args.ranks, "collision.lmp", values)
    counts = [int(count) for count in told(said, r"^== colliding: (\d+) \+ (\d+) atoms$")]
    (directory / "scene.toml").write_text(scene_toml(args, orientations, counts, said))
    return frames_written(args, values, said)
