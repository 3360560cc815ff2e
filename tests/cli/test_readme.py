# SPDX-License-Identifier: GPL-3.0-or-later
"""The outputs that README.md shows are those of the program.

    test_readme.py MDANA            compares
    test_readme.py MDANA --update   writes them anew into README.md
"""

import re
import shlex
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
README = ROOT / "README.md"
BLOCK = re.compile(r"```console\n\$ (build/mdana [^\n]*)\n(.*?)```", re.DOTALL)


def output(mdana, command):
    arguments = [mdana, *shlex.split(command)[1:]]
    result = subprocess.run(arguments, cwd=ROOT, capture_output=True, text=True, check=True)
    return result.stdout


def without_times(text):
    text = re.sub(r" *\d+(\.\d+)? (ms|s)\b(?!\^)", " SECONDS", text)
    return re.sub(r" *\d+ MB\b", " MEMORY", text)


def main(mdana, update):
    text = README.read_text()
    blocks = BLOCK.findall(text)
    if len(blocks) < 3:
        sys.exit("README.md: fewer than three console blocks are left: nothing is tested")
    different = 0
    for command, shown in blocks:
        printed = output(mdana, command)
        if without_times(printed) == without_times(shown):
            continue
        different += 1
        text = text.replace(f"$ {command}\n{shown}```", f"$ {command}\n{printed}```")
        if not update:
            print(f"README.md shows for '{command}':\n{shown}\nbut the program prints:\n{printed}")
    if update:
        README.write_text(text)
    elif different:
        sys.exit(1)
    print(f"{len(blocks)} outputs, {different} different")


if __name__ == "__main__":
    main(sys.argv[1], "--update" in sys.argv[2:])
