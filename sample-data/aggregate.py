# SPDX-License-Identifier: GPL-3.0-or-later
"""The scene `aggregate` of `generate`: two colliding aggregates of adhesive grains (Arakawa et al. 2024)."""

import math
import random
import shutil
from pathlib import Path

from lammps_runs import (Refused, add_dump_options, add_output_options, dump_name, frames_written, name_run,
                         positive, random_orientation, refuse_run, run_lammps, table, told, whole_steps)

HERE = Path(__file__).resolve().parent
PRESETS = {"tiny": 8.0, "small": 20.0}  # radius in grain radii
SCENES = {"aggregate": {"help": "two aggregates of adhesive elastic grains (dust)"}}
DESCRIPTION = """\
Two aggregates made by close packing and particle extraction collide head-on along x. Units are nano (ag, nm, ns).
Defaults are values in common use for grains of water ice, not those of a paper. LAMMPS breaks a contact at an overlap of
-0.397 delta0 instead of JKR's -0.825 delta0: use the compression; the return phase is not that of Arakawa et al. 2024."""
LIMIT = "LAMMPS breaks contacts at -0.397 delta0, not at JKR's -0.825: use the compression, not the return phase"
LARGEST_FILLING = math.pi / math.sqrt(18)  # of equal spheres that touch


# ---- what is asked for -----------------------------------------------------------------------------------------------


def add_options(parser, _scene):
    add_output_options(parser)

    add = parser.add_argument_group("aggregates").add_argument
    add("--preset", choices=PRESETS, default="tiny", help="size: radius 8 or 20 (default: tiny)")
    add("--radius", type=positive, metavar="R", help="grains whose centre is farther out are left out, in grain radii")
    add("--filling-factor", type=positive, default=0.4, metavar="PHI",
        help="a grain is taken out at random until phi R^3 are left (default: %(default)g)")
    add("--seed", type=int, default=1, help="of the grains taken out and the orientations (default: %(default)s)")

    add = parser.add_argument_group("grains").add_argument
    add("--grain-radius", type=positive, default=100.0, metavar="NM", help="(default: %(default)g)")
    add("--density", type=positive, default=1000.0, metavar="KG/M3", help="(default: %(default)g)")
    add("--gamma", type=positive, default=100.0, metavar="MJ/M2",
        help="surface energy of one surface, in mJ/m^2 (default: %(default)g)")
    add("--modulus", type=positive, default=7.0, metavar="GPA", help="Young's modulus (default: %(default)g)")
    add("--poisson", type=positive, default=0.25, metavar="NU", help="Poisson's ratio (default: %(default)g)")
    add("--rolling", type=positive, default=0.8, metavar="NM",
        help="xi_c, displacement where rolling becomes inelastic (default: %(default)g)")

    add = parser.add_argument_group("collision").add_argument
    add("--velocity", type=positive, default=20.0, metavar="M/S", help="relative speed (default: %(default)g)")
    add("--gap", type=positive, default=2.2, metavar="R",
        help="distance of the centres minus two radii at first, in grain radii (default: %(default)g)")
    add("--timestep", type=positive, metavar="NS", help="(default: 0.036 sqrt(m/k) of a contact, 0.01 for these grains)")
    add("--duration", type=positive, metavar="NS", help="(default: half as long after the turn as before it)")
    add("--limit", type=positive, metavar="NS", help="without --duration, stop here at the latest (default: generous)")
    add("--include", type=Path, metavar="FILE", help="more LAMMPS commands, read just before the collision")

    add = add_dump_options(parser, "NS", "fx fy fz omegax omegay omegaz ...", "id type x y z vx vy vz radius mass")
    add("--dump-interval", type=positive, metavar="NS", help="(default: about 0.02 radii at the relative speed)")
    add("--contacts-every", type=int, default=1, metavar="N",
        help="contacts at every Nth frame into contacts.dump.gz; 0: none (default: %(default)s)")


def complete(args):
    """Fill in the defaults that depend on other options, and refuse what cannot be run."""
    size = f"{args.radius:g}" if args.radius else args.preset
    args.radius = args.radius or PRESETS[args.preset]
    crossing = args.radius * args.grain_radius / args.velocity
    if args.timestep is None:
        contact = contact_of(args)
        args.timestep = float(f"{0.036 * math.sqrt(grain_mass(args) / contact['stiffness']):.0e}")
    if args.dump_interval is None:
        args.dump_interval = max(round(0.02 * crossing / args.timestep / 10) * 10, 1) * args.timestep
    if args.limit is None:
        args.limit = 5 * crossing + 5 * args.gap * args.grain_radius / args.velocity
    name_run(args, f"aggregate-{size}")
    refuse(args)


def refuse(args):
    if args.filling_factor > LARGEST_FILLING:
        raise Refused(f"--filling-factor {args.filling_factor:g}: must be at most {LARGEST_FILLING:.4f}, of close packing")
    if grains_asked(args) < 2:
        raise Refused(f"--radius {args.radius:g}: fewer than two grains are left")
    if args.gap <= 2:
        raise Refused(f"--gap {args.gap:g}: must be above 2, or grains of the two aggregates may touch at the start")
    if args.poisson > 0.5:
        raise Refused(f"--poisson {args.poisson:g}: must be at most 0.5")
    if args.contacts_every < 0:
        raise Refused(f"--contacts-every {args.contacts_every}: must be 0 or more")
    refuse_run(args)


# ---- a contact of two grains -----------------------------------------------------------------------------------------
# Units nano: 1 GPa = 1000, 1 mJ/m^2 = 1, 1000 kg/m^3 = 0.001.


def grain_mass(args):
    return 4 / 3 * math.pi * args.grain_radius**3 * args.density * 1e-6


def contact_of(args):
    """JKR contact of two grains, and Wada's tangential constants (Wada et al. 2007; physics by dimension)."""
    modulus, reduced_radius = args.modulus * 1e3, args.grain_radius / 2
    reduced_modulus = modulus / (2 * (1 - args.poisson**2))
    shear = modulus / (2 * (1 + args.poisson))
    a0 = (9 * math.pi * args.gamma * reduced_radius**2 / reduced_modulus)**(1 / 3)
    pull = 3 * math.pi * args.gamma * reduced_radius
    return {
        "reach": a0**2 / (3 * reduced_radius),                      # delta0
        "stiffness": 1.2 * reduced_modulus * a0,                    # dF/d(delta) at equilibrium, (6/5) E* a0
        "slide": shear * a0**2 / (8 * math.pi * pull),              # k_s xi_s/(2 F_c), xi_s = (2 - nu) a0/(16 pi)
        "roll": 4 * pull / reduced_radius,
        "roll_max": 2 * args.rolling / reduced_radius,
        "twist": 8 / 3 * shear * a0**3,                             # (16/3) G' a0^3, 1/G' = 2/G
        "twist_max": shear * a0**3 / (12 * math.pi * pull),         # k_t phi_t/(2 F_c), phi_t = 1/(16 pi)
    }


# ---- close packing and particle extraction ---------------------------------------------------------------------------


def grains_asked(args):
    return round(args.filling_factor * args.radius**3)


def close_packed(radius, spacing, rng):
    """Points of an fcc lattice of that nearest distance within the radius of a random point."""
    half = spacing / math.sqrt(2)
    centre = [2 * half * rng.random() for _ in range(3)]
    cells = [range(math.ceil((c - radius) / half), math.floor((c + radius) / half) + 1) for c in centre]
    return [point for i in cells[0] for j in cells[1] for k in cells[2] if (i + j + k) % 2 == 0
            for point in [[half * n - c for n, c in zip((i, j, k), centre)]] if math.hypot(*point) <= radius]


def rotated(points, quaternion):
    w, x, y, z = quaternion
    rows = [[1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
            [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
            [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)]]
    return [[sum(a * b for a, b in zip(row, point)) for row in rows] for point in points]


def aggregate(args, orientation, rng):
    """Grain centres about the origin. Neighbours are 2 r - delta0 apart, where their force is zero."""
    radius = args.radius * args.grain_radius
    packed = close_packed(radius, 2 * args.grain_radius - contact_of(args)["reach"], rng)
    asked = grains_asked(args)
    if asked > len(packed):
        raise Refused(f"--filling-factor {args.filling_factor:g}: close packing about this point has {len(packed)} grains "
                      f"within {args.radius:g} radii, not {asked}; take less or another --seed")
    return rotated(rng.sample(packed, asked), orientation)


def write_grains(args, bodies, path):
    """The data file that aggregate.lmp reads."""
    apart = (args.radius + args.gap / 2) * args.grain_radius
    grains = [(body, [x + side * apart, y, z]) for body, side, points in zip((1, 2), (-1, 1), bodies)
              for x, y, z in points]
    lines = ["Two aggregates. Written by sample-data/generate.", "", f"{len(grains)} atoms", "2 atom types", ""]
    wide = 2 * apart
    lines += [f"{-wide!r} {wide!r} {axis}lo {axis}hi" for axis in "xyz"]
    lines += ["", "Atoms # sphere", ""]
    lines += [f"{number} {body} {2 * args.grain_radius!r} {args.density * 1e-6!r} " + " ".join(map(repr, point))
              for number, (body, point) in enumerate(grains, 1)]
    path.write_text("\n".join(lines) + "\n")


# ---- LAMMPS ----------------------------------------------------------------------------------------------------------


def variables(args):
    """What aggregate.lmp is told."""
    contact = contact_of(args)
    every = whole_steps(args, "dump_interval")
    return {name: contact[name] for name in ("slide", "roll", "roll_max", "twist", "twist_max", "reach")} | {
        **{name: getattr(args, name) for name in ("velocity", "gamma", "poisson", "timestep", "columns", "format")},
        "radius": args.grain_radius,
        "modulus": args.modulus * 1e3,
        "duration": math.ceil(args.duration / args.timestep) if args.duration else 0,
        "max_steps": math.ceil(args.limit / args.timestep),
        "dump_style": "custom/gz" if args.gz else "custom",
        "dump_file": dump_name(args),
        "dump_every": every,
        "dump_from": whole_steps(args, "dump_from"),
        "sort": "off" if args.unsorted else "id",
        "contact_style": "local/gz" if args.gz else "local",
        "contact_file": contacts_name(args),
        "contact_every": every * args.contacts_every,
        "extra": "include include.lmp" if args.include else "print -",
    }


def contacts_name(args):
    return "contacts.dump.gz" if args.gz else "contacts.dump"


# ---- scene.toml ------------------------------------------------------------------------------------------------------


def scene_toml(args, orientations, counts, said):
    head = {"schema": 1, "name": args.name, "dump": dump_name(args), "units": "nano", "interaction": "aggregate",
            "timestep": args.timestep, "bodies": "type"}
    parts = ["# What this run is; mdana reads it beside the dump. Written by sample-data/generate.\n"
             f"# {LIMIT}.\n" + table(None, head, {"bodies": "how grains are told apart"})]
    for number, (grains, orientation) in enumerate(zip(counts, orientations), 1):
        body = {"name": str(number), "type": number, "atoms": grains, "radius": args.radius * args.grain_radius,
                "radius_definition": "cut", "orientation": orientation}
        parts.append(table("[[body]]", body, {"radius": "grains whose centre was farther out were left out",
                                              "orientation": "unit quaternion w x y z"}))
    parts.append(table("[aggregate]", {"filling_factor": args.filling_factor},
                       {"filling_factor": "grains (r/R)^3, close packing less random grains"}))
    grains = {"radius": args.grain_radius, "density": args.density * 1e-6, "surface_energy": args.gamma,
              "modulus": args.modulus * 1e3, "poisson_ratio": args.poisson, "rolling_displacement": args.rolling}
    parts.append(table("[grains]", grains, {"surface_energy": "of one surface", "modulus": "Young's",
                                            "rolling_displacement": "xi_c, where rolling becomes inelastic"}))
    parts.append(table("[generator]", generator(args, said)))
    return "\n".join(parts)


def generator(args, said):
    steps, end = told(said, r"^== over at step (\d+): (.*)$")
    names = ("velocity", "gap", "seed", "dump_interval", "dump_from", "contacts_every", "columns", "format", "ranks")
    return {
        "command": args.command,
        **{name: getattr(args, name) for name in names},
        "sorted": not args.unsorted,
        "steps": int(steps),
        "end": end,
        "lammps_version": told(said, r"^LAMMPS \((.*)\)")[0],
    }


# ---- the run ---------------------------------------------------------------------------------------------------------


def headline(args):
    return (f"aggregate, radius {args.radius:g} grain radii, filling factor {args.filling_factor:g}, "
            f"2 x {grains_asked(args)} grains, speed {args.velocity:g} m/s\n  {LIMIT}")


def make(args, directory):
    """Make the run in the directory; return its number of frames."""
    rng = random.Random(args.seed)
    orientations = [random_orientation(rng) for _ in range(2)]
    write_grains(args, [aggregate(args, orientation, rng) for orientation in orientations], directory / "grains.data")
    values = variables(args)
    shutil.copyfile(HERE / "aggregate.lmp", directory / "aggregate.lmp")
    if args.include:
        shutil.copyfile(args.include, directory / "include.lmp")
    said = run_lammps(directory, args.ranks, "aggregate.lmp", values)
    counts = [int(count) for count in told(said, r"^== colliding: (\d+) \+ (\d+) grains$")]
    (directory / "scene.toml").write_text(scene_toml(args, orientations, counts, said))
    return frames_written(args, values, said)
