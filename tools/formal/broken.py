"""The broken copies of a proof: each must refute the assertion that it names.

All breaks of a proof are woven into one design (tools/mutants/weave.py). In it each broken module has a free input
mutant_number. A value in the AIGER file selects one break; 0 selects the original. A break of a constant cannot be
selected. It gets a design of its own.
"""

from __future__ import annotations

import sys
from collections.abc import Callable
from pathlib import Path

from engine import Question, Run, counterexamples
from proofs import ROOT, Break, Proof
from synthesis import Design, Failure

sys.path.insert(0, str(ROOT / "tools/mutants"))
from catalogue import CatalogueError, Mutant  # noqa: E402
from weave import NUMBER, weave  # noqa: E402

BITS = 32
DECLARATION = f"  (* anyseq *) logic [{BITS - 1}:0] {NUMBER};"
# The design of a proof with replaced sources, and the assertions that it keeps.
Synthesis = Callable[[Path, dict[Path, Path], set[str]], Design]


def as_mutant(broken: Break) -> Mutant:
    return Mutant(broken.name, broken.file.name, broken.old, broken.new)


def _check(broken: Break, sources: list[Path]):
    if broken.file not in sources:
        raise Failure(f"broken copy {broken.name}: the proof does not read {broken.file.name}")
    count = broken.file.read_text().count(broken.old)
    if count != 1:
        raise Failure(f"broken copy {broken.name}: {count} matches in {broken.file.name}: {broken.old}")


def can_be_woven(broken: Break) -> bool:
    try:
        weave(broken.file.read_text(), [as_mutant(broken)])
    except CatalogueError:
        return False
    return True


def woven_sources(breaks: list[Break], folder: Path) -> dict[Path, Path]:
    """Writes a copy of each broken file with all its breaks. Returns the copy of each file."""
    copies = {}
    for file in dict.fromkeys(broken.file for broken in breaks):
        mutants = [as_mutant(broken) for broken in breaks if broken.file == file]
        copies[file] = folder / file.name
        copies[file].write_text(weave(file.read_text(), mutants, DECLARATION))
    return copies


def selection(design: Design, number: int) -> dict[int, int]:
    """The input variables of `mutant_number` in all modules, with the values that select the break `number`."""
    values = {}
    for line in (design.folder / "design.map").read_text().splitlines():
        _, literal, bit, name = line.split(maxsplit=3)
        if name.rpartition(".")[2] == NUMBER:
            variable = int(literal) >> 1
            if int(literal) & 1 or not 1 <= variable <= design.aiger.inputs:
                raise Failure(f"{name} is not a free input")
            values[variable] = number >> int(bit) & 1
    return values


def refute(proof: Proof, folder: Path, synthesis: Synthesis, timeout_s: float) -> int:
    """Confirms that each break refutes its assertion. Returns the number of breaks with a design of their own."""
    for broken in proof.breaks:
        _check(broken, proof.sources)
    woven = [broken for broken in proof.breaks if can_be_woven(broken)]
    alone = [broken for broken in proof.breaks if broken not in woven]
    if woven:
        _refute_woven(woven, folder / "woven", synthesis, timeout_s)
    for broken in alone:
        path = folder / broken.name
        path.mkdir(parents=True, exist_ok=True)
        copy = path / broken.file.name
        copy.write_text(broken.file.read_text().replace(broken.old, broken.new))
        design = synthesis(path, {broken.file: copy}, {broken.refuted_by})
        _runs(design, [(broken, {})], timeout_s)
    return len(alone)


def _refute_woven(breaks: list[Break], folder: Path, synthesis: Synthesis, timeout_s: float):
    folder.mkdir(parents=True, exist_ok=True)
    numbers = {}
    for broken in breaks:
        other = numbers.setdefault(as_mutant(broken).number, broken)
        if other is not broken:
            raise Failure(f"broken copy {broken.name}: rename it, its number is that of {other.name}")
    try:
        copies = woven_sources(breaks, folder)
    except CatalogueError as error:
        raise Failure(str(error)) from None
    design = synthesis(folder, copies, {broken.refuted_by for broken in breaks})
    selected = [(broken, selection(design, as_mutant(broken).number)) for broken in breaks]
    for broken, run in zip(breaks, _runs(design, selected, timeout_s)):
        # The same inputs must not refute the assertion in the original.
        stimulus = [values[1 : 1 + design.aiger.inputs] for values in run]
        if design.aiger.replay(stimulus, design.matching(broken.refuted_by), selection(design, 0)):
            raise Failure(f"broken copy {broken.name}: {broken.refuted_by} fails without the break too")


def _runs(design: Design, breaks: list[tuple[Break, dict[int, int]]], timeout_s: float) -> list[Run]:
    """The run that refutes the assertion of each break, given with the inputs that select it."""
    questions = []
    for broken, constants in breaks:
        numbers = design.matching(broken.refuted_by)
        if not numbers:
            raise Failure(f"broken copy {broken.name}: there is no assertion {broken.refuted_by}")
        questions.append(Question(numbers, constants))
    runs = counterexamples(design, questions, timeout_s)
    for (broken, _), run in zip(breaks, runs):
        if not run:
            raise Failure(f"broken copy {broken.name}: {broken.refuted_by} is true, expected to be refuted")
    return runs
