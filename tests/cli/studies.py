# SPDX-License-Identifier: GPL-3.0-or-later
"""Studies of the sample's runs, their reports, and what of a report does not depend on time."""

import csv
import re
import shutil
import subprocess
import time

import running
from running import ROOT, Case, parse_json

try:
    import h5py
except ImportError:
    h5py = None

SAMPLE = ROOT / "sample-data"
NAMES = ("adhesive-tiny", "aggregate-tiny", "hertz-tiny")


def without_times(json_object):
    """Everything but what the run cost and how it was called."""
    if isinstance(json_object, dict):
        return {name: without_times(value) for name, value in json_object.items()
                if name not in ("seconds", "fit_seconds", "provenance")}
    if isinstance(json_object, list):
        return [without_times(value) for value in json_object]
    return json_object


def hdf5_contents(path):
    """Bytes of every dataset that tells no times; nothing without h5py."""
    found = {}
    if h5py:
        with h5py.File(path) as file:
            file.visititems(lambda name, item: found.update({name: item[()].tobytes()})
                            if isinstance(item, h5py.Dataset) and item.dtype.kind in "fi" and "seconds" not in name else None)
    return found


class Study(Case):
    def setUp(self):
        super().setUp()
        self.runs, self.out = self.dir / "runs", self.dir / "report"
        for name in NAMES:
            shutil.copytree(SAMPLE / name, self.runs / name)

    def study(self, **settings):
        """A study file without what takes long, unless it is asked for."""
        self.mdana("study", "init", self.runs)
        file = self.runs / "study.toml"
        text = file.read_text(encoding="utf-8")
        for name in ("accuracy", "stability", "defects"):
            text = re.sub(rf"(?m)^{name} = true", f"{name} = {'true' if settings.get(name) else 'false'}", text)
        if not settings.get("figures"):
            text = text.replace("kinds = []", 'kinds = ["force", "phase-plane"]')
        file.write_text(text, encoding="utf-8")
        return file

    def report(self, *arguments, study=None, out=None, code=0):
        return self.mdana("report", study or self.runs / "study.toml", "-o", out or self.out, *arguments, code=code)

    def plan(self, *arguments):
        lines = self.report("--dry-run", *arguments).stdout.splitlines()
        return {line.split()[0]: line.split(None, 1)[1] for line in lines}

    def results(self, out=None):
        return parse_json(((out or self.out) / "results.json").read_text(encoding="utf-8"))

    def rows(self):
        """A dictionary a run, of results.csv."""
        with open(self.out / "results.csv", newline="", encoding="utf-8") as file:
            return list(csv.DictReader(file, strict=True))

    def edit(self, name, old, new):
        scene = self.runs / name / "scene.toml"
        text = scene.read_text(encoding="utf-8")
        self.assertIn(old, text)
        scene.write_text(text.replace(old, new), encoding="utf-8")

    def files(self, out):
        """Contents of all files of a report that hold no times, the documents without them."""
        found = {}
        for path in sorted(p for p in out.rglob("*") if p.is_file()):
            name = str(path.relative_to(out))
            if name.startswith(("cache/", "shards/")) or name in ("manifest.json", ".mdana-report"):
                continue
            if path.suffix == ".h5":
                found[name] = hdf5_contents(path)
            else:
                found[name] = without_times(parse_json(path.read_text())) if path.suffix == ".json" else path.read_bytes()
        return found


class StoppedStudy(Study):
    """Reports that are ended from outside."""

    def start(self):
        return subprocess.Popen([running.program, "report", str(self.runs / "study.toml"), "-o", str(self.out), "--jobs", "1"],
                                stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)

    def wait_for_cache(self):
        """Until the process that was started has its output."""
        deadline = time.monotonic() + running.SECONDS
        while not (self.out / "cache").exists() and time.monotonic() < deadline:
            time.sleep(0.001)

    def kill_at(self, shares):
        """Kills reports after parts of the time that a whole one takes, and makes them anew: their bytes are those of one that
        nobody disturbs."""
        self.study(stability=True)
        undisturbed = self.dir / "whole"
        self.report(out=undisturbed)
        whole = self.files(undisturbed)
        started = time.monotonic()
        process = self.start()
        self.assertEqual(process.wait(timeout=running.SECONDS), 0)
        seconds = time.monotonic() - started
        for share in shares:
            with self.subTest(share):
                shutil.rmtree(self.out, ignore_errors=True)
                process = self.start()
                time.sleep(share * seconds)
                process.kill()
                process.wait(timeout=running.SECONDS)
                self.report()
                self.assertEqual(self.files(self.out).keys(), whole.keys())
                for name, content in self.files(self.out).items():
                    self.assertEqual(content, whole[name], name)
                self.assertEqual({p.name for p in (self.out / "cache").iterdir()}, {f"{name}.run" for name in NAMES} | {"hashes.json"})
