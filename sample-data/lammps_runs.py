# SPDX-License-Identifier: GPL-3.0-or-later
"""What the scenes of `generate` share: checks of options, runs of LAMMPS, lines of scene.toml."""

import argparse
import json
import math
import os
import re
import shutil
import subprocess
import sys
from pathlib import Path


class Refused(Exception):
    """The run cannot be made; the message says why."""


def number(text, fits, kind):
    value = float(text)
    if not (math.isfinite(value) and fits(value)):
        raise argparse.ArgumentTypeError(f"{text} is not a {kind} number")
    return value


def positive(text):
    return number(text, lambda value: value > 0, "positive")


def not_negative(text):
    return number(text, lambda value: value >= 0, "non-negative")


def add_output_options(parser):
    add = parser.add_argument
    add("-o", dest="output", metavar="DIR", type=Path, help="run directory to make (default: e.g. hertz-tiny)")
    add("--force", action="store_true", help="replace an existing run directory")


def add_dump_options(parser, time, more, columns):
    """Returns what adds a further option of the dump."""
    add = parser.add_argument_group("dump").add_argument
    add("--dump-from", type=not_negative, default=0.0, metavar=time, help="no frames before (default: %(default)g)")
    add("--columns", default=columns, help=f"of the dump; also {more} (default: '%(default)s')")
    add("--format", default="%.10g", metavar="FLOAT", help="of real numbers (default: %(default)s)")
    add("--unsorted", action="store_true", help="leave the atoms in the order LAMMPS has them (default: by id)")
    add("--gz", action=argparse.BooleanOptionalAction, default=True, help="compress the dump (default)")
    machine = parser.add_argument_group("machine").add_argument
    machine("--ranks", type=int, default=1, metavar="N", help="MPI ranks (default: %(default)s)")
    return add


def name_run(args, default):
    if args.output is None:
        args.output = Path(default)
    args.name = args.output.resolve().name


def refuse_run(args):
    """What no scene can be run with."""
    if args.ranks < 1:
        raise Refused(f"--ranks {args.ranks}: must be 1 or more")
    if args.include and not args.include.is_file():
        raise Refused(f"--include {args.include}: no such file")
    if args.output.exists() and not args.force:
        raise Refused(f"{args.output} exists; --force replaces it")
    if args.output.exists() and not (args.output / "scene.toml").is_file():
        raise Refused(f"{args.output} has no scene.toml, so it is not a run and is not replaced")


def whole_steps(args, option):
    steps = getattr(args, option) / args.timestep
    if abs(steps - round(steps)) > 1e-9 * max(steps, 1) or (round(steps) == 0 and option == "dump_interval"):
        flag = "--" + option.replace("_", "-")
        raise Refused(f"{flag} {getattr(args, option):g}: must be a multiple of the time step {args.timestep:g}")
    return round(steps)


def random_orientation(rng):
    """Uniform unit quaternion w x y z (Shoemake 1992)."""
    u, angle1, angle2 = rng.random(), 2 * math.pi * rng.random(), 2 * math.pi * rng.random()
    a, b = math.sqrt(1 - u), math.sqrt(u)
    return [b * math.cos(angle2), a * math.sin(angle1), a * math.cos(angle1), b * math.sin(angle2)]


def dump_name(args):
    return "dump.lammpstrj.gz" if args.gz else "dump.lammpstrj"


def lammps_command(ranks):
    lammps = shutil.which("lmp")
    if not lammps:
        raise Refused("no LAMMPS: 'lmp' is not in the PATH (Debian: apt install lammps)")
    if ranks == 1:
        return [lammps]
    mpirun = shutil.which("mpirun")
    if not mpirun:
        raise Refused("--ranks needs 'mpirun' in the PATH")
    version = subprocess.run([mpirun, "--version"], capture_output=True, text=True, check=False).stdout
    open_mpi = ["--oversubscribe"] + ["--allow-run-as-root"] * (os.geteuid() == 0) if "Open MPI" in version else []
    return [mpirun, *open_mpi, "-n", str(ranks), lammps]


def run_lammps(directory, ranks, script, values):
    """Run the script in the directory; show its lines that begin with '== '; return all that it said."""
    command = lammps_command(ranks) + ["-in", script]
    for name, value in values.items():
        command += ["-var", name, str(value)]
    said = []
    environment = os.environ | {"OMP_NUM_THREADS": "1"}
    with subprocess.Popen(command, cwd=directory, env=environment, text=True,
                          stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.STDOUT) as process:
        try:
            for line in process.stdout:
                said.append(line.rstrip())
                if line.startswith("== "):
                    print("  " + line[3:], end="", flush=True)
        except BaseException:
            process.terminate()
            raise
    errors = [line for line in said if line.startswith("ERROR")]
    if errors or process.returncode != 0:
        raise Refused("LAMMPS failed: " + " ".join((errors or said[-3:])[:3] or [f"exit {process.returncode}"]))
    return "\n".join(said)


def told(said, pattern):
    """The groups of the pattern in what LAMMPS said."""
    found = re.search(pattern, said, re.MULTILINE)
    if not found:
        raise Refused(f"LAMMPS did not come to its end (no line '{pattern}')")
    return found.groups()


def frames_written(args, values, said):
    """Number of frames of the dump, of which there must be one; warns if the collision was not over."""
    steps, end = told(said, r"^== over at step (\d+): (.*)$")
    frames = int(steps) // values["dump_every"] - math.ceil(values["dump_from"] / values["dump_every"]) + 1
    if frames < 1:
        raise Refused(f"no frame was written: the collision was over before --dump-from {args.dump_from:g}")
    if end == "limit":
        print("generate: warning: stopped by --limit before the collision was over", file=sys.stderr)
    return frames


def toml(value):
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, (list, tuple)):
        return "[" + ", ".join(toml(item) for item in value) + "]"
    return repr(value) if isinstance(value, (int, float)) else json.dumps(str(value))


def table(header, values, comments=None):
    lines = [header] if header else []
    for name, value in values.items():
        comment = (comments or {}).get(name)
        lines.append(f"{name} = {toml(value)}" + (f"  # {comment}" if comment else ""))
    return "\n".join(lines) + "\n"
