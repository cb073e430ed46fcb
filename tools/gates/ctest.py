"""Runs groups of the CTests of a build. Each test is in exactly one group."""

from __future__ import annotations

import json
import os
import re
import subprocess
import tempfile
import xml.etree.ElementTree as ElementTree
from collections import defaultdict
from dataclasses import dataclass, field
from pathlib import Path

from session import Outcome

SUMMARY = re.compile(r"(\d+) tests failed out of (\d+)")
GATE = "gate:"  # label of the tests of a recorded gate, with its name

# Groups by label. A test without one of these labels is in OTHERS.
LABELS = {
    "unit tests": "^unit$",
    "scenarios": "^scenario$",
    "command line and page": "^cli$",
    "long tests": "^long$",
    "recorded gates": f"^{GATE}",
}
OTHERS = "other tests"
# Tests of these groups wait for clocks, sockets and a browser in half of their time.
WAITING = {"command line and page"}


@dataclass
class Result(Outcome):
    failed_tests: set[str] = field(default_factory=set)
    run_tests: set[str] = field(default_factory=set)


def selection(group: str, gates: list[str] | None = None) -> list[str]:
    """Options of ctest that select a group; of the recorded gates only `gates`, if given."""
    if group == OTHERS:
        return ["-LE", "|".join(LABELS.values())]
    if gates is not None:
        return ["-L", f"^{GATE}({'|'.join(map(re.escape, gates))})$"]
    return ["-L", LABELS[group]]


def at_a_time(group: str) -> int:
    """How many tests of a group run at the same time."""
    return os.cpu_count() * (2 if group in WAITING else 1)


def run(
    build: Path,
    options: list[str],
    unbuilt: list[str] = (),
    environment: dict[str, str] | None = None,
    jobs: int = os.cpu_count(),
) -> Result:
    """Runs the selected tests, `jobs` at a time. `unbuilt`: programs that were not built on purpose; CTest has a test
    NAME_NOT_BUILT in place of the tests of each."""
    if unbuilt:
        options = [*options, "-E", f"^({'|'.join(map(re.escape, unbuilt))})_NOT_BUILT"]
    with tempfile.TemporaryDirectory() as folder:
        report = Path(folder) / "report.xml"
        done = subprocess.run(
            ["ctest", f"-j{jobs}", "--output-on-failure", "--output-junit", str(report), *options],
            cwd=build,
            env={**os.environ, **(environment or {})},
            stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT,
            text=True,
            errors="replace",
        )
        summary = SUMMARY.search(done.stdout)
        if not summary or int(summary[2]) == 0:
            return Result(0, 1, "no test ran", done.stdout)
        failed, all_tests = int(summary[1]), int(summary[2])
        cases = ElementTree.parse(report).getroot().iter("testcase")
        status = {case.get("name"): case.get("status") for case in cases}
    text = f"{all_tests} run, {failed} failed"
    run_tests = {name for name, word in status.items() if word in ("run", "fail")}
    bad = {name for name, word in status.items() if word != "run"}
    return Result(all_tests - failed, failed, text, done.stdout, bad, run_tests)


def tests_of_gates(build: Path) -> dict[str, set[str]]:
    """The tests of each recorded gate, by their labels."""
    listed = subprocess.run(
        ["ctest", "--show-only=json-v1", *selection("recorded gates")],
        cwd=build,
        check=True,
        capture_output=True,
        text=True,
    )
    found = defaultdict(set)
    for test in json.loads(listed.stdout)["tests"]:
        for entry in test.get("properties", ()):
            if entry["name"] == "LABELS":
                for label in entry["value"]:
                    if label.startswith(GATE):
                        found[label.removeprefix(GATE)].add(test["name"])
    return found
