# SPDX-License-Identifier: GPL-3.0-or-later
"""Time and peak memory of a command."""

import json
import subprocess
import sys
import tempfile

# A process counts the memory of the one that it was forked from until it runs its own program: so a small one starts it.
STARTER = """
import json, os, sys, time
out, error = (os.open(name, os.O_WRONLY) for name in sys.argv[1:3])
start = time.monotonic()
process = os.fork()
if process == 0:
    os.dup2(out, 1), os.dup2(error, 2)
    os.execv(sys.argv[3], sys.argv[3:])
_, status, used = os.wait4(process, 0)
print(json.dumps([os.waitstatus_to_exitcode(status), time.monotonic() - start, used.ru_utime + used.ru_stime,
                  1024 * used.ru_maxrss]))
"""


def measured(command, codes=(0,)):
    """What the command prints, and its seconds by the clock and of processors, and its peak memory in bytes. RuntimeError
    if it ends with another exit code."""
    with tempfile.NamedTemporaryFile("r+") as out, tempfile.NamedTemporaryFile("r+") as error:
        starter = [sys.executable, "-S", "-E", "-c", STARTER, out.name, error.name, *map(str, command)]
        code, clock, processors, memory = json.loads(subprocess.run(starter, text=True, stdout=subprocess.PIPE, check=True,
                                                                    stdin=subprocess.DEVNULL).stdout)
        if code not in codes:
            raise RuntimeError(f"{' '.join(map(str, command))}: exit {code}: {error.read()}")
        return out.read(), clock, processors, memory
