"""tools/test [--all]: runs the gates of the project. tools/test installs the packages first and describes both."""

from __future__ import annotations

import os
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path

import ctest
import recorded
from build_reads import BuildReads
from same_bytes import same_bytes
from session import BUILD, ROOT, Outcome, Session, command, say

TEST, SANITIZED, GCC = (ROOT / "build" / name for name in ("test", "dev", "gcc"))
FEW = {"ARMATURE_FEW_DRAWS": "1"}
SHORT_FUZZ = {"ARMATURE_FUZZ_SECONDS": "5"}
EVERY_ENGINE = {"ARMATURE_SCENARIO_ENGINES": "lockstep model", "ARMATURE_ALL_FIRMWARE": "1"}
FEW_SCENARIOS = {"ARMATURE_RANDOM_SCENARIOS": "20"}
MOST_NAMES = 6  # of gates in a message
FOREIGN_INPUT = ["-L", "^foreign_input$"]


def build(folder: Path, targets: list[str] = ()) -> Outcome:
    """Configures and builds a preset; the folder has its name."""
    return command(["bash", "-c", 'source "$0"; build_preset "$@"', ROOT / "tools/setup.sh", folder.name, *targets])


def with_rs274() -> dict[str, str]:
    """The environment of the test that compares with the G-code interpreter of LinuxCNC; without it, it is skipped."""
    run = subprocess.run([ROOT / "tools/rs274"], stdout=subprocess.PIPE, text=True)
    if run.returncode:
        say("rs274 cannot be downloaded: its test is skipped")
        return {}
    return {"RS274": run.stdout.strip()}


class Records:
    """The recorded gates of this checkout, and their records as they were before this run."""

    def __init__(self):
        self.gates = recorded.all_gates(TEST)
        self.before = recorded.read_records()
        self.due = recorded.not_recorded(self.gates, self.before)

    def _run(self, gates: list[recorded.Gate]) -> tuple[ctest.Result, list[recorded.Gate]]:
        """Runs gates, whose programs are built. Returns those that passed, too."""
        result = ctest.run(TEST, ctest.selection("recorded gates", sorted(gate.name for gate in gates)))
        tests = ctest.tests_of_gates(TEST)  # now, because a program that was built may have other tests
        for line in recorded.unmatched(self.gates, gates, tests):
            result.failed += 1
            result.log += f"{line}\n"
        undescribed = recorded.undescribed(gates, BuildReads(TEST).files_of)
        result.failed += len(undescribed)
        result.log += "".join(f"{line}\n" for line in undescribed.values())
        changed = recorded.changed_since(self.gates, TEST)
        passes = recorded.passed(gates, tests, result.run_tests, result.failed_tests)
        return result, [gate for gate in passes if gate.name not in changed | undescribed.keys()]

    def run_due(self) -> Outcome:
        """Runs the gates that have no valid record, and records those that pass."""
        skipped = f"{len(self.gates) - len(self.due)} of {len(self.gates)} have a record"
        if not self.due:
            recorded.write_records(recorded.renewed(self.before, self.gates, [], []))
            return Outcome(1, 0, skipped)
        targets = sorted({target for gate in self.due for target in gate.targets})
        if targets and (built := build(TEST, targets)).failed:
            return built
        result, passes = self._run(self.due)
        recorded.write_records(recorded.renewed(self.before, self.gates, self.due, passes))
        if passes:
            names = [gate.name for gate in passes]
            more = f" and {len(names) - MOST_NAMES} more" if len(names) > MOST_NAMES else ""
            say(f"commit tests/passes.txt, which records now {', '.join(names[:MOST_NAMES])}{more}")
        result.text += f"; {skipped}"
        return result

    def run_all(self) -> Outcome:
        """Runs every gate and checks every record."""
        result, passes = self._run(self.gates)
        wrong = recorded.wrong_records(self.before, self.gates, passes)
        result.passed += not wrong
        result.failed += bool(wrong)
        if wrong:
            result.log += "\n".join(["tests/passes.txt, which tools/test writes:", *wrong])
        return result


def tests(session: Session, groups: list[str], unbuilt: list[str], environment: dict[str, str]):
    for group in groups:
        jobs = ctest.at_a_time(group)
        session.gate(group, lambda: ctest.run(TEST, ctest.selection(group), unbuilt, environment, jobs))


def sanitizer_tests() -> ctest.Result:
    """Runs the tests with sanitizers. They include all unit tests, which --all runs nowhere else."""
    result = ctest.run(SANITIZED, [], environment=FEW)
    for name in sorted(set(unit_tests()) - result.run_tests):
        result.failed += 1
        result.log += f"{name}: did not run with sanitizers; if it cannot, add it with NOT_SANITIZED\n"
    return result


def unit_tests() -> list[str]:
    """The programs of the unit tests."""
    return (TEST / "unit_tests.txt").read_text().split()


def recorded_gates(run: Callable[[Records], Outcome]) -> Outcome:
    try:
        return run(Records())
    except recorded.GateError as error:
        return Outcome(0, 1, log=str(error))


def all_changes(session: Session):
    """tools/test: what a change can break, in a quarter of an hour."""
    session.gate("style", lambda: command([ROOT / "tools/style"]))
    environment = {**with_rs274(), **FEW, **FEW_SCENARIOS}
    if session.gate(BUILD, lambda: build(TEST)):
        groups = ["unit tests", "scenarios", "command line and page", "long tests", ctest.OTHERS]
        tests(session, groups, recorded.targets(TEST), environment)
        session.gate("recorded gates", lambda: recorded_gates(Records.run_due))
    session.gate("clang-tidy", lambda: command([ROOT / "tools/tidy", "--changed"]))
    if session.gate("build for foreign input", lambda: build(SANITIZED, ["foreign_input"])):
        session.gate("foreign input", lambda: ctest.run(SANITIZED, FOREIGN_INPUT, environment={**FEW, **SHORT_FUZZ}))


def everything(session: Session):
    """tools/test --all: everything, in half an hour."""
    session.gate("style", lambda: command([ROOT / "tools/style"]))
    environment = {**with_rs274(), **EVERY_ENGINE}
    if session.gate(BUILD, lambda: build(TEST, ["without_unit_tests", "recorded_gates", "benchmarks"])):
        groups = ["scenarios", "command line and page", "long tests", ctest.OTHERS]
        tests(session, groups, unit_tests(), environment)
        session.gate("recorded gates", lambda: recorded_gates(Records.run_all))
    session.gate("clang-tidy", lambda: command([ROOT / "tools/tidy"]))
    sanitized = session.gate("sanitizer build", lambda: build(SANITIZED))
    if sanitized:
        session.gate("sanitizer tests", sanitizer_tests)
    if session.gate("build with g++", lambda: build(GCC)) and sanitized:
        session.gate("same bytes", lambda: same_bytes(GCC, TEST, SANITIZED))


def main() -> int:
    every = sys.argv[1:] == ["--all"]
    cold = not any(folder.exists() for folder in (TEST, SANITIZED, GCC))
    session = Session("all" if every else "changes")
    (everything if every else all_changes)(session)
    if every and cold:
        session.judge_budget()
    else:
        say("tools/test --all judges the budget, in a checkout that was not built before")
    say(session.table())
    print(f"{session.passed} passed, {session.failed} failed")
    return int(session.failed > 0)


if __name__ == "__main__":
    sys.exit(main())
