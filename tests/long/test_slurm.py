# SPDX-License-Identifier: GPL-3.0-or-later
"""The job array of sample-data/cluster/sbatch.sh on a SLURM of one node that this test starts (Debian: apt install slurmctld
slurmd slurm-client munge; as root): a task that is told that its time is over is queued again and goes on."""

import os
import shutil
import socket
import subprocess
import sys
import tempfile
import time
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "cli"))
sys.dont_write_bytecode = True

import running  # noqa: E402
from studies import Study  # noqa: E402

SCRIPT = running.ROOT / "sample-data" / "cluster" / "sbatch.sh"
COPIES = 6  # runs more, of a second each: the signal must come before the last one
PATIENCE = 300  # seconds: for a job that was queued again SLURM may wait for two minutes
CONFIGURATION = """
ClusterName=one
SlurmctldHost={host}(127.0.0.1)
AuthType=auth/munge
AuthInfo=socket={place}/munge.sock
SlurmUser=root
SlurmdUser=root
SlurmctldPort={ports[0]}
SlurmdPort={ports[1]}
SlurmctldPidFile={place}/slurmctld.pid
SlurmdPidFile={place}/slurmd.pid
StateSaveLocation={place}/state
SlurmdSpoolDir={place}/spool
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
JobAcctGatherType=jobacct_gather/none
SelectType=select/cons_tres
SelectTypeParameters=CR_Core
MpiDefault=none
ReturnToService=2
SchedulerParameters=sched_interval=1,bf_interval=1,batch_sched_delay=0
NodeName={host} NodeAddr=127.0.0.1 CPUs={cores} RealMemory=1000 State=UNKNOWN
PartitionName=all Nodes=ALL Default=YES MaxTime=INFINITE State=UP
"""


def free_ports(count):
    sockets = [socket.socket() for _ in range(count)]
    for s in sockets:
        s.bind(("127.0.0.1", 0))
    ports = [s.getsockname()[1] for s in sockets]
    for s in sockets:
        s.close()
    return ports


class Node:
    """munged, slurmctld and slurmd with all their files in one directory."""

    def __init__(self, place):
        self.place, self.processes = place, []
        for name in ("state", "spool"):
            (place / name).mkdir(parents=True)
        self.conf = place / "slurm.conf"
        self.conf.write_text(CONFIGURATION.format(place=place, host=socket.gethostname().split(".")[0], ports=free_ports(2),
                                                  cores=os.cpu_count()))
        key = place / "munge.key"
        key.write_bytes(os.urandom(128))
        key.chmod(0o600)
        place.chmod(0o755)
        self.environment = os.environ | {"SLURM_CONF": str(self.conf)}

    def start(self):
        """Whether the node is idle; else why not."""
        munge = [f"--{what}={self.place}/munge.{ending}" for what, ending in
                 (("key-file", "key"), ("socket", "sock"), ("pid-file", "pid"), ("log-file", "log"), ("seed-file", "seed"))]
        for command in (["munged", "-F", "--force", *munge], ["slurmctld", "-D", "-f", self.conf], ["slurmd", "-D", "-f", self.conf]):
            with open(self.place / f"{command[0]}.out", "wb") as out:
                self.processes.append(subprocess.Popen([str(word) for word in command], stdin=subprocess.DEVNULL, stdout=out,
                                                       stderr=subprocess.STDOUT, env=self.environment))
            time.sleep(2)
        deadline = time.monotonic() + 30
        while time.monotonic() < deadline:
            if self.ask("sinfo", "-h", "-o", "%T") == "idle":
                return ""
            time.sleep(1)
        return " ".join((self.place / f"{name}.out").read_text()[-300:] for name in ("slurmctld", "slurmd"))

    def ask(self, *command):
        done = subprocess.run([str(word) for word in command], env=self.environment, capture_output=True, text=True, timeout=60, check=False)
        return done.stdout.strip()

    def stop(self):
        for process in reversed(self.processes):
            process.terminate()
            try:
                process.wait(timeout=20)
            except subprocess.TimeoutExpired:
                process.kill()
                process.wait()


class Slurm(Study):
    def setUp(self):
        super().setUp()
        for k in range(COPIES):
            copy = self.runs / f"again-{k}"
            shutil.copytree(self.runs / "aggregate-tiny", copy)
            scene = copy / "scene.toml"
            scene.write_text(scene.read_text().replace('name = "aggregate-tiny"', f'name = "again-{k}"'))
        self.study(stability=True, accuracy=True)

    def wait_for(self, what, seconds=PATIENCE):
        deadline = time.monotonic() + seconds
        while not (found := what()):
            if time.monotonic() > deadline:
                self.fail(f"{node.ask('squeue')}\n{self.logs()}")
            time.sleep(0.05)
        return found

    def logs(self):
        return "\n".join(path.read_text() for path in sorted(self.dir.glob("mdana-*.log")))

    def test_an_array_whose_task_is_told_that_its_time_is_over(self):
        job = node.ask("sbatch", "--parsable", "--array=1-2", "--cpus-per-task=1", "--mem=400", "--chdir", self.dir,
                       f"--export=ALL,MDANA={running.program}", SCRIPT, self.runs / "study.toml", self.out, 2)
        self.assertTrue(job.isdigit(), job)
        self.wait_for(lambda: (self.out / "shards").is_dir())
        # The one that has done a run, but not all of its runs.
        record = self.wait_for(lambda: [p for p in self.out.glob("shards/*/*.run") if not (p.parent / "task.json").exists()])[0]
        task = record.parent.name.split("-")[0]
        made = record.stat().st_mtime_ns
        node.ask("scancel", "--batch", "--signal=USR1", f"{job}_{task}")
        self.wait_for(lambda: "Restarts=1" in node.ask("scontrol", "show", "job", f"{job}_{task}"))
        node.ask("scontrol", "update", f"JobId={job}_{task}", "StartTime=now")
        self.wait_for(lambda: len(list(self.out.glob("shards/*-of-2/task.json"))) == 2)
        log = (self.dir / f"mdana-{job}-{task}.log").read_text()
        self.assertIn("goes on from there", log)
        self.assertIn(": from the cache\n", log)
        self.assertEqual(record.stat().st_mtime_ns, made, "a run was done twice")
        single = self.dir / "single"
        for arguments in (("merge", "-o", self.out), ("report", "-o", single)):
            self.mdana(arguments[0], self.runs / "study.toml", *arguments[1:], timeout=PATIENCE)
        whole, found = self.files(single), self.files(self.out)
        self.assertEqual(found.keys(), whole.keys())
        for name, content in found.items():
            if "accuracy" not in name and name not in ("results.json", "index.html"):  # these tell times
                self.assertEqual(content, whole[name], name)


if __name__ == "__main__":
    missing = [name for name in ("munged", "slurmctld", "slurmd", "sbatch") if not shutil.which(name)]
    if missing:
        running.skip(f"no SLURM: {', '.join(missing)} not found (Debian: apt install slurmctld slurmd slurm-client munge)")
    if os.geteuid() != 0:
        running.skip("SLURM's slurmd runs as root")
    with tempfile.TemporaryDirectory(prefix="mdana-slurm-") as scratch:
        node = Node(Path(scratch) / "node")
        try:
            if reason := node.start():
                running.skip(f"SLURM does not start here: {reason}")
            running.main()
        finally:
            node.stop()
