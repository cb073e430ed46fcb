"""Runs the gates of tools/test one after the other, counts what passed, and compares their processor time with a budget."""

from __future__ import annotations

import subprocess
import sys
import time
import tomllib
import traceback
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tools"))
from processor_time import processor_s  # noqa: E402

BUDGET = Path(__file__).resolve().with_name("budget.toml")
TIMES_OF_SHARE = 2.0  # a gate that takes more than this multiple of its share fails the budget
LEAST_EXCESS = 0.04  # of the build: less than this above the share is noise of a short gate
BUILD = "build"  # the gate whose processor time is the unit of the shares


@dataclass
class Outcome:
    passed: int
    failed: int
    text: str = ""  # one line about what ran
    log: str = ""  # printed if something failed


@dataclass(frozen=True)
class Row:
    name: str
    wall_s: float
    processor_s: float


def say(text: str):
    print(text, file=sys.stderr, flush=True)


def command(words: list, folder: Path = ROOT, environment: dict[str, str] | None = None) -> Outcome:
    """One check: a program that ends with exit code 0."""
    run = subprocess.run(
        [str(word) for word in words],
        cwd=folder,
        env=environment,
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        text=True,
        errors="replace",
    )
    return Outcome(int(run.returncode == 0), int(run.returncode != 0), log=run.stdout)


def excess(rows: list[Row], shares: dict[str, float]) -> list[str]:
    """A line for each gate that took more than its share of the build allows, or whose share is not known."""
    build_s = next((row.processor_s for row in rows if row.name == BUILD), 0.0)
    if build_s <= 0.0:
        return [f"no gate `{BUILD}` ran"]
    lines = []
    for row in rows:
        ratio, share = row.processor_s / build_s, shares.get(row.name)
        if share is None:
            lines.append(f"{row.name}: no share in {BUDGET.name}; it took {ratio:.2f} of the build")
        elif ratio > max(TIMES_OF_SHARE * share, share + LEAST_EXCESS):
            lines.append(f"{row.name}: {ratio:.2f} of the build, its share is {share:.2f}")
    missing = shares.keys() - {row.name for row in rows}
    return lines + [f"{name}: has a share in {BUDGET.name}, but is no gate" for name in sorted(missing)]


class Session:
    """One run of tools/test. `budget`: the table of budget.toml with its shares."""

    def __init__(self, budget: str):
        self.passed = self.failed = 0
        self.rows: list[Row] = []
        self.shares: dict[str, float] = tomllib.loads(BUDGET.read_text())[budget]

    def gate(self, name: str, run: Callable[[], Outcome]) -> bool:
        """Runs a gate, counts its checks and prints its line. True: nothing failed."""
        wall_s, used_s = time.monotonic(), processor_s()
        try:
            outcome = run()
        except Exception:  # the other gates continue, and the table is printed
            outcome = Outcome(0, 1, log=traceback.format_exc())
        row = Row(name, time.monotonic() - wall_s, processor_s() - used_s)
        self.rows.append(row)
        self.count(name, outcome, f" ({row.wall_s:.0f} s)")
        return outcome.failed == 0

    def count(self, name: str, outcome: Outcome, suffix: str = ""):
        self.passed += outcome.passed
        self.failed += outcome.failed
        if outcome.failed and outcome.log:
            say(outcome.log.rstrip("\n"))
        text = f"{name}: {outcome.text}" if outcome.text else name
        say(f"{'FAILED ' if outcome.failed else 'ok     '} {text}{suffix}")

    def table(self) -> str:
        """Wall and processor seconds of each gate; processor seconds in multiples of the build's; the share allowed."""
        build_s = next((row.processor_s for row in self.rows if row.name == BUILD), 0.0)
        lines = ["seconds  processor s  of build  share  gate"]
        total = Row("all", sum(row.wall_s for row in self.rows), sum(row.processor_s for row in self.rows))
        for row in [*self.rows, total]:
            ratio = f"{row.processor_s / build_s:8.2f}" if build_s else " " * 8
            share = f"{self.shares[row.name]:5.2f}" if row.name in self.shares else " " * 5
            lines.append(f"{row.wall_s:7.0f}  {row.processor_s:11.0f}  {ratio}  {share}  {row.name}")
        return "\n".join(lines)

    def judge_budget(self):
        """One check: no gate takes more than twice its share of the build's processor time."""
        lines = excess(self.rows, self.shares)
        self.count("budget", Outcome(int(not lines), int(bool(lines)), log="\n".join(lines)))
