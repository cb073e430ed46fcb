"""Proof engine: ABC decides the properties of a design."""

from __future__ import annotations

import re
from dataclasses import dataclass, field
from pathlib import Path

from synthesis import Design, Failure, run_tool

INDUCTION_S = 180  # a proof by induction may take this time
SHORT = 12  # clocks of a short counterexample
SHORT_CONFLICTS = 5000
Run = list[list[int]]  # all variables of the AIGER file in each clock


def _is_inductive(design: Design, path: Path, conflicts: int) -> bool | None:
    """None: the solver gave up after this number of conflicts."""
    read = f"read_aiger {path}; fold; orpos; scleanup"
    output = run_tool(["yosys-abc", "-c", f"{read}; ind -v -F 2 -C {conflicts}"], design.folder, INDUCTION_S)
    if "The network is combinational" in output:  # no flop matters
        return "UNSATISFIABLE" in run_tool(
            ["yosys-abc", "-c", f"{read}; sat -C {conflicts}"], design.folder, INDUCTION_S
        )
    return None if "Conflict limit" in output else "Networks are equivalent" in output


def _one_by_one(design: Design, numbers: list[int]) -> bool:
    """Whether the assertions together are inductive, with one question for each.

    An assertion may use that none failed in an earlier clock, and that those proved before it do not fail in this clock.
    That is enough: consider the first clock in which assertions fail, and of those the one that was proved first.
    """
    path = design.folder / "step.aig"
    proved, left = [], []
    for number in numbers:  # without the others: the question is small
        design.aiger.write(path, [number])
        (proved if _is_inductive(design, path, 100000) else left).append(number)
    for conflicts in (5000, 50000, 500000):
        before = None
        while left and left != before:
            before = left
            left = []
            for number in before:
                design.aiger.write_step(path, number, proved, numbers)
                (proved if _is_inductive(design, path, conflicts) else left).append(number)
    return not left


def decide(design: Design, numbers: list[int], timeout_s: float) -> bool:
    """True: all assertions are true in every reachable state, without a bound. False: one of them is not.

    One step of induction proves assertions that together are inductive: all in one question if the solver can answer
    it, else one by one. For others the solver searches the missing invariant. That search is too slow for large sets of
    inductive assertions, so induction is tried first.
    """
    path = design.folder / "all.aig"
    design.aiger.write(path, numbers)
    read = f"read_aiger {path}; fold; orpos; scleanup"
    inductive = _is_inductive(design, path, 20000)
    if inductive or (inductive is None and _one_by_one(design, numbers)):
        # The induction step is proved; bmc3 checks the first clocks.
        output = run_tool(["yosys-abc", "-c", f"{read}; bmc3 -F 3"], design.folder, 3 * timeout_s)
        if "No output asserted in 3 frames" in output:
            return True
    output = run_tool(["yosys-abc", "-c", f"{read}; scorr; pdr -T {timeout_s:g}"], design.folder, 3 * timeout_s)
    if "Property proved" in output or "Networks are equivalent" in output:
        return True
    if "was asserted in frame" in output:
        return False
    raise Failure(f"undecided after {timeout_s:g} s\n{output[-1500:]}")


@dataclass(frozen=True)
class Question:
    """Can one of the properties `numbers` fail? `constants`: values of input variables, the same in every clock."""

    numbers: list[int]
    constants: dict[int, int] = field(default_factory=dict)


def _confirmed(design: Design, question: Question, trace: Path) -> Run | None:
    """The run that ABC wrote, if the replay of the whole AIGER file confirms it."""
    values = {
        (int(clock), int(pin)): int(value)
        for pin, clock, value in re.findall(r"^pi(\d+)@(\d+)=([01])", trace.read_text(), re.MULTILINE)
    }
    clocks = 1 + max(clock for clock, _ in values)
    stimulus = [[values[clock, pin] for pin in range(design.aiger.inputs)] for clock in range(clocks)]
    return design.aiger.replay(stimulus, question.numbers, question.constants)


def counterexample(design: Design, question: Question, timeout_s: float) -> Run | None:
    """A run that ends with a failure of one of the properties, confirmed by replay; None: all of them are proved."""
    path, trace = design.folder / "one.aig", design.folder / "trace.cex"
    trace.unlink(missing_ok=True)
    design.aiger.with_constants(question.constants).write(path, question.numbers)
    read = f"read_aiger {path}; fold; orpos"
    output = run_tool(
        ["yosys-abc", "-c", f"{read}; dc2; bmc3 -F 60 -T 30; write_cex -n {trace}"],
        design.folder,
        3 * timeout_s,
    )
    if not trace.is_file():  # no failure within 60 clocks: the unbounded search decides
        output = run_tool(
            ["yosys-abc", "-c", f"{read}; pdr -T {timeout_s:g}; write_cex -n {trace}"],
            design.folder,
            3 * timeout_s,
        )
    if "Property proved" in output:
        return None
    name = design.properties[question.numbers[0]]
    if "was asserted in frame" not in output or not trace.is_file():
        raise Failure(f"undecided after {timeout_s:g} s: {name}\n{output[-1500:]}")
    run = _confirmed(design, question, trace)
    if run is None:
        raise Failure(f"the replay does not confirm the counterexample of {name}")
    return run


def counterexamples(design: Design, questions: list[Question], timeout_s: float) -> list[Run | None]:
    """The counterexample of each question.

    Most are short: one call of ABC searches the first clocks for all questions. It need not find anything, so it may
    also end early. Each question that is left gets a search of its own.
    """
    commands, traces = [], []
    for index, question in enumerate(questions):
        path, trace = design.folder / f"{index}.aig", design.folder / f"{index}.cex"
        trace.unlink(missing_ok=True)
        design.aiger.with_constants(question.constants).write(path, question.numbers)
        commands.append(f"read_aiger {path}; fold; orpos; bmc3 -F {SHORT} -C {SHORT_CONFLICTS}; write_cex -n {trace}\n")
        traces.append(trace)
    script = design.folder / "short.abc"
    script.write_text("".join(commands))
    try:
        run_tool(["yosys-abc", "-f", str(script)], design.folder, 3 * timeout_s)
    except Failure:
        pass
    return [
        (trace.is_file() and _confirmed(design, question, trace)) or counterexample(design, question, timeout_s)
        for question, trace in zip(questions, traces)
    ]
