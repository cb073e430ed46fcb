"""The honest figures of the network that corrects a conveyor belt, over held-out targets. README.md has the last ones.

tools/python tools/policy vo_dynamic --write         the table of an arm, and its section of README.md
tools/python tools/policy weights                    runs with random and flipped weights: does a joint exceed a limit?
Exit code: 0 ok, 1 a run is beyond a limit, 2 usage.
"""

import argparse
import os
import pathlib
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent))
from generated import write_section  # noqa: E402
from runs import run_all  # noqa: E402
from table import figures_text, speed_text  # noqa: E402
from targets import ARMS  # noqa: E402
from weights import weights_text  # noqa: E402

README = HERE / "README.md"


def main():
    arms = {arm.name: arm for arm in ARMS}
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("what", choices=(*arms, "weights"), help="an arm with its plant, or the campaign of weights")
    parser.add_argument("--targets", type=int, default=1000, help="held-out targets of the table")
    parser.add_argument("--runs", type=int, default=50, help="runs of each kind of wrong weights")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--jobs", type=int, default=os.cpu_count(), help="runs at a time")
    parser.add_argument("--write", action="store_true", help="write the section of README.md")
    given = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        if given.what == "weights":
            text, beyond = weights_text(given.runs, given.seed, given.jobs, folder)
        else:
            arm = arms[given.what]
            results, speed = run_all(arm, given.targets, given.seed, given.jobs, folder)
            text, beyond = figures_text(arm, results, given.seed) + "\n" + speed_text(speed), 0
    print(text, end="")
    if given.write:
        write_section(README, given.what, text)
    return 1 if beyond else 0


if __name__ == "__main__":
    sys.exit(main())
