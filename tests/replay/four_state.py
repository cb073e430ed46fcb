"""four_state.py PAPER VECTORS...: arm_soc in a four-state simulator (Icarus Verilog) does what was recorded, with no X.

PAPER is 0 or 1. Each file is replayed from power-up, with all flops X, a reset and then the recorded inputs. That the
comparison can fail is shown by copies of the last file with one wrong bit.
"""

import pathlib
import re
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tools"))

from rtl_list import rtl_sources  # noqa: E402

FIRST_OUTPUT = 7 * 8  # hexadecimal digit
PREFIX_CLOCKS = 1000


def compile_bench(folder, paper):
    bench = folder / "replay.vvp"
    run = subprocess.run(["iverilog", "-g2012", "-o", bench, f"-Preplay_tb.PaperFabric={paper}", "-s", "replay_tb",
                          "-I", ROOT / "rtl/common", *(ROOT / "rtl" / source for source in rtl_sources(ROOT)),
                          ROOT / "tests/replay/replay_tb.sv"], capture_output=True, text=True, check=False)
    if run.returncode:
        sys.exit(run.stdout + run.stderr)
    return bench


def replay(bench, vectors):
    """Clocks, differences, everything that was printed."""
    run = subprocess.run(["vvp", "-n", bench, f"+vectors={vectors}"], capture_output=True, text=True, check=False)
    counts = re.search(r"^(\d+) clocks, (\d+) differences$", run.stdout, re.MULTILINE)
    if not counts:
        sys.exit(f"{vectors}: the bench did not finish\n{run.stdout}{run.stderr}")
    return int(counts[1]), int(counts[2]), run.stdout


def main():
    paper, *files = sys.argv[1:]
    failed = False
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        bench = compile_bench(folder, paper)
        for vectors in files:
            with open(vectors, encoding="ascii") as file:
                lines = sum(1 for _ in file)
            clocks, differences, output = replay(bench, vectors)
            good = clocks == lines > 0 and differences == 0
            failed |= not good
            print(f"{'ok    ' if good else 'FAILED'}  {vectors}: {clocks} of {lines} clocks, {differences} differences")
            if not good:
                print(output)
        # Does the bench notice?
        with open(files[-1], encoding="ascii") as file:
            lines = [line for _, line in zip(range(PREFIX_CLOCKS), file)]
        for digit in range(FIRST_OUTPUT, FIRST_OUTPUT + 8):
            broken = folder / "broken.txt"
            last = lines[-1]
            wrong = f"{int(last[digit], 16) ^ 1:x}"
            broken.write_text("".join(lines[:-1]) + last[:digit] + wrong + last[digit + 1:], encoding="ascii")
            clocks, differences, _ = replay(bench, broken)
            if (clocks, differences) != (PREFIX_CLOCKS, 1):
                print(f"FAILED  a wrong digit {digit}: {differences} differences in {clocks} clocks, expected 1")
                failed = True
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
