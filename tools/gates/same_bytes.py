"""The same scenario gives the same bytes with each compiler and optimisation."""

from __future__ import annotations

import os
import subprocess
import tempfile
from concurrent.futures import ThreadPoolExecutor
from functools import partial
from pathlib import Path

from session import ROOT, Outcome

# With g++ every golden is checked on the model of the logic, and these on the RTL: one of each variant.
ON_RTL = ("fig9_joint_move", "paper_pulse_width")
# The slow build with sanitizers runs the beginning of a few, on the RTL, for this simulated time [s]: S-curves, feedback,
# joint moves, half periods of the paper.
BEGINNINGS = {
    "scurve_moves": 0.65,
    "pulse_loss_recovered": 0.4,
    "fig9_joint_move": 0.1,
    "paper_pulse_width": 0.12,
}
FINDING = 99  # exit code of a sanitizer


def _run(words: list, code: int) -> str:
    """A message if the program ends with an exit code above `code`, or by a signal; else empty."""
    options = {"ASAN_OPTIONS": f"exitcode={FINDING}", "UBSAN_OPTIONS": f"exitcode={FINDING}"}
    run = subprocess.run([str(word) for word in words], capture_output=True, text=True, env={**os.environ, **options})
    return f"exit code {run.returncode}\n{run.stdout}{run.stderr}" if not 0 <= run.returncode <= code else ""


def _beginning(scenario: str, duration_s: float, builds: list[Path]) -> str:
    """A message if the builds write different traces of the beginning. A run that is cut short does not meet the
    expectations of the scenario (exit code 1)."""
    traces = []
    with tempfile.TemporaryDirectory() as folder:
        for build in builds:
            out = Path(folder) / build.name
            words = [build / "armature", "run", ROOT / "scenarios" / scenario, "--out", out]
            words += ["--set", f"duration_s={duration_s}", "--set", "trace.every_ticks=1"]
            if message := _run(words, 1):
                return f"{scenario}, {build.name}: {message}"
            traces.append((out / "trace.csv").read_bytes())
    if any(trace != traces[0] for trace in traces):
        return f"{scenario}: {', '.join(build.name for build in builds)}: the traces differ"
    return "" if traces[0].count(b"\n") > 2 else f"{scenario}: the trace has no rows"


def same_bytes(gcc: Path, test: Path, sanitized: Path) -> Outcome:
    """Two compilers: with g++, optimised, all scenarios equal their goldens, as they do with clang++ in the gate
    `scenarios`. No optimisation and sanitizers: the beginnings are equal. The tests replay.* compare the model with
    another simulator."""
    goldens = [file.parent for file in sorted((ROOT / "scenarios").glob("*/golden.csv"))]
    check = [gcc / "armature", "check"]
    runs = [
        lambda: _run([*check, "--engine", "model", *goldens], 0),
        lambda: _run([*check, *(ROOT / "scenarios" / name for name in ON_RTL)], 0),
        *(partial(_beginning, name, duration_s, [test, sanitized]) for name, duration_s in BEGINNINGS.items()),
    ]
    with ThreadPoolExecutor(os.cpu_count()) as pool:
        messages = [message for message in pool.map(lambda run: run(), runs) if message]
    text = f"{len(goldens)} goldens, {len(BEGINNINGS)} beginnings"
    return Outcome(int(not messages), int(bool(messages)), text, "\n".join(messages))
