#!/usr/bin/env python3
"""engine_table.py BUILD [ROUNDS]: prints what the engines cost on this machine, with the goal beside each figure.

Ratios and times are processor time, the smallest of alternating rounds in one process. Numbers of instructions do not
depend on the load of the machine; they are those of whole runs with all that `armature run` records.
"""

import json
import os
import shutil
import sys
import tempfile
import time
from pathlib import Path

from table import CLOCK_HZ, ROOT, instructions, processor_s, run

TICK_S = 50e-6
# Scenario, goal for RTL / model, goal for the real-time factor of the model, and the simulated times between which
# instructions are counted [s]: in the middle of a motion. None: over the whole run, with the start of the program.
RUNS = (
    ("fig9_joint_move", 180, 100, (0.30, 0.50)),
    ("max_rate_4mpps", 250, 100, (0.20, 0.30)),
    ("draw_circle", 95, 60, (0.70, 1.00)),
    ("gcode_short_lines", 30, None, None),
    ("gcode_helix_six_axis", 30, None, None),
)
# Of the RTL: what, scenario, goal for instructions per clock, and between which times [s]; the plateau has 200 pulses in
# each tick.
CLOCKS = (
    ("fig9", "fig9_joint_move", 600, (0.02, 0.05)),
    ("plateau of max_rate", "max_rate_4mpps", 1150, (0.15, 0.17)),
)
LONG_S = 100
CHECK_GOAL_S = 10


def show(name, value, goal=""):
    print(f"{name:62}  {value:>10}  {goal:>12}", flush=True)


def words_of(line):
    """`name value` pairs of a line of engine_bench."""
    words = line.split()
    return {name: float(value) for name, value in zip(words[::2], words[1::2], strict=True)}


def show_times(bench, rounds):
    for name, ratio_goal, factor_goal, _ in RUNS:
        found = words_of(run(bench, "ratio", name, rounds))
        show(f"{name}: RTL / model", f"{found['ratio']:.1f}", f">= {ratio_goal}")
        show(
            f"{name}: model, real-time factor",
            f"{found['simulated'] / found['model']:.1f}",
            f">= {factor_goal}" if factor_goal else "",
        )


def show_instructions(program):
    if not shutil.which("perf") and not shutil.which("valgrind"):
        print("engine_table.py: skipped the numbers of instructions: neither perf nor valgrind is installed")
        return
    with tempfile.TemporaryDirectory() as scratch:
        folder = Path(scratch)

        def of_run(engine, name, end_s=None):
            end = () if end_s is None else ("--set", f"duration_s={end_s}")
            command = [program, "run", ROOT / "scenarios" / name, "--engine", engine, *end, "--out", folder / "out"]
            return instructions(command, folder)

        def of_second(engine, name, times):
            if times is None:
                count = of_run(engine, name)
                return count / json.loads((folder / "out/summary.json").read_text())["result"]["simulated_s"]
            begin_s, end_s = times
            return (of_run(engine, name, end_s) - of_run(engine, name, begin_s)) / (end_s - begin_s)

        for name, _, _, times in RUNS:
            show(f"{name}: instructions per tick, model", f"{of_second('model', name, times) * TICK_S:.0f}")
        for what, name, goal, times in CLOCKS:
            count = of_second("rtl", name, times) / CLOCK_HZ
            show(f"{what}: instructions per clock, RTL", f"{count:.0f}", f"<= {goal}")


def show_lengths(bench):
    found = words_of(run(bench, "long", LONG_S))
    show(f"{LONG_S} s of moves on the model / 1 s, time", f"{found['long']:.1f}", f"<= {LONG_S}")
    show(f"{LONG_S} s of moves on the model, growth of the memory [MB]", f"{found['memory']:.1f}", "flat")


def show_steps(bench, rounds):
    found = words_of(run(bench, "steps", "fig9_joint_move", rounds))
    show("steps of 1 ms from outside on the model, per second", f"{found['steps']:.0f}", ">= 50000")


def show_check(program):
    begin_s, begin = processor_s(), time.monotonic()
    run(program, "check", "--engine", "model", "--jobs", os.cpu_count())
    show("check of all scenarios on the model [s]", f"{time.monotonic() - begin:.1f}", f"<= {CHECK_GOAL_S}")
    show("check of all scenarios on the model, processor time [s]", f"{processor_s() - begin_s:.1f}")


def main():
    build = Path(sys.argv[1]).resolve()
    rounds = sys.argv[2] if len(sys.argv) > 2 else "3"
    bench, program = build / "tests/bench/engine_bench", build / "armature"
    os.chdir(ROOT)
    show("", "", "goal")
    show_times(bench, rounds)
    show_steps(bench, rounds)
    show_lengths(bench)
    show_check(program)
    show_instructions(program)


if __name__ == "__main__":
    main()
