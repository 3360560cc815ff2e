# SPDX-License-Identifier: GPL-3.0-or-later
"""A report that is killed at fifty random moments goes on from there, and its bytes are those of one that nobody disturbs."""

import random
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent.parent / "cli"))
import running  # noqa: E402
from studies import StoppedStudy  # noqa: E402


class Kills(StoppedStudy):
    def test_at_fifty_moments(self):
        moments = random.Random(20261123)
        self.kill_at([moments.random() for _ in range(50)])


if __name__ == "__main__":
    running.main()
