"""Proof engine: Yosys converts a design to an AIGER file, and ABC decides its properties."""

from __future__ import annotations

import re
import subprocess
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

from aiger import Aiger

# From Verilog to and-gates and plain flops. `check` rejects undriven nets (for example an input that the proof does not
# connect), loops and double drivers. Undefined values become free inputs, so a proof is valid for all their values.
# Memories become flops before `flatten`, so that a proof can connect to each word by its name.
# write_aiger writes only the gates that matter: opt_clean after techmap would cost a third of the time for the same file.
SYNTHESIS = """
hierarchy -check -top {top}
proc
memory_map
flatten
opt_expr
opt_clean
check -assert
{prune}
wreduce
peepopt
opt_clean
async2sync
opt -nodffe -nosdff
dffunmap
# plain flops
setundef -anyseq
simplemap
techmap
opt_expr
dffunmap
aigmap
setundef -anyseq
dump -o {folder}/properties.il t:$assert
write_aiger -zinit -vmap {folder}/design.map {folder}/design.aig
"""

PLAIN_FLOPS = "# plain flops\n"
REACHED = ".reached"
PROVED = ".proved"
INDUCTION_S = 180  # a proof by induction may take this time


class Failure(Exception):
    """A proof does not pass. The message contains the reason."""


@dataclass
class Design:
    folder: Path
    aiger: Aiger
    properties: list[str]  # instance paths in the order of the bad literals; they end in PROVED or REACHED

    def numbers(self, suffix: str) -> list[int]:
        return [number for number, name in enumerate(self.properties) if name.endswith(suffix)]

    def matching(self, name: str) -> list[int]:
        """The assertions called `name`, anywhere in the hierarchy."""
        return [number for number in self.numbers(PROVED) if self.properties[number].split(".")[-2] == name]


def _run(command: list[str], folder: Path, timeout_s: float) -> str:
    try:
        run = subprocess.run(command, cwd=folder, capture_output=True, text=True, timeout=timeout_s, check=False)
    except subprocess.TimeoutExpired:
        raise Failure(f"{command[0]} takes more than {timeout_s:g} s") from None
    output = run.stdout + run.stderr
    if run.returncode:
        raise Failure(f"{command[0]}: exit code {run.returncode}\n{output[-3000:]}")
    return output


def synthesise(
    folder: Path,
    includes: list[Path],
    sources: list[Path],
    top: str,
    timeout_s: float,
    only: str | None = None,
    rewrite: Callable[[str], str] | None = None,
) -> Design:
    """`only`: keeps the assertions of this name and the logic that they need. This saves half of the time.
    `rewrite`: changes the RTLIL of the flattened design with plain flops. `only` then has no effect."""
    prune = f"delete t:$assert c:*{only}{PROVED} %d\nopt_clean" if only and not rewrite else ""
    flags = " ".join(f"-I{include}" for include in includes)
    read = f"read_verilog -sv -formal {flags} {' '.join(map(str, sources))}\n"
    flops, gates = SYNTHESIS.format(top=top, folder=folder, prune=prune).split(PLAIN_FLOPS)
    script = folder / "synthesis.ys"
    if rewrite:
        script.write_text(f"{read}{flops}opt_clean\nwrite_rtlil {folder}/flops.il\n")
        _run(["yosys", "-q", "-e", "implicitly declared", str(script)], folder, timeout_s)
        try:
            (folder / "guarded.il").write_text(rewrite((folder / "flops.il").read_text()))
        except ValueError as error:
            raise Failure(str(error)) from None
        read, flops = f"read_rtlil {folder}/guarded.il\n", ""
    script.write_text(read + flops + gates)
    _run(["yosys", "-q", "-e", "implicitly declared", str(script)], folder, timeout_s)
    names = re.findall(r"^ *cell \$assert \\?(\S+)", (folder / "properties.il").read_text(), re.MULTILINE)
    aiger = Aiger.read(folder / "design.aig")
    if len(names) != len(aiger.bad):
        raise Failure(f"{len(names)} assertions became {len(aiger.bad)} properties")
    strange = [name for name in names if not name.endswith((REACHED, PROVED))]
    if strange:
        raise Failure(f"assertion outside the macros of assert.svh: {strange[0]}")
    return Design(folder, aiger, names)


def _is_inductive(design: Design, path: Path, conflicts: int) -> bool | None:
    """None: the solver gave up after this number of conflicts."""
    read = f"read_aiger {path}; fold; orpos; scleanup"
    output = _run(["yosys-abc", "-c", f"{read}; ind -v -F 2 -C {conflicts}"], design.folder, INDUCTION_S)
    if "The network is combinational" in output:  # no flop matters
        return "UNSATISFIABLE" in _run(["yosys-abc", "-c", f"{read}; sat -C {conflicts}"], design.folder, INDUCTION_S)
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
        output = _run(["yosys-abc", "-c", f"{read}; bmc3 -F 3"], design.folder, 3 * timeout_s)
        if "No output asserted in 3 frames" in output:
            return True
    output = _run(["yosys-abc", "-c", f"{read}; scorr; pdr -T {timeout_s:g}"], design.folder, 3 * timeout_s)
    if "Property proved" in output or "Networks are equivalent" in output:
        return True
    if "was asserted in frame" in output:
        return False
    raise Failure(f"undecided after {timeout_s:g} s\n{output[-1500:]}")


def counterexample(design: Design, numbers: list[int], timeout_s: float) -> list[list[int]] | None:
    """A run that ends with a failure of one of the properties, confirmed by replay; None: all of them are proved."""
    path, trace = design.folder / "one.aig", design.folder / "trace.cex"
    trace.unlink(missing_ok=True)
    design.aiger.write(path, numbers)
    read = f"read_aiger {path}; fold; orpos"
    output = _run(
        ["yosys-abc", "-c", f"{read}; dc2; bmc3 -F 60 -T 30; write_cex -n {trace}"],
        design.folder,
        3 * timeout_s,
    )
    if not trace.is_file():  # no failure within 60 clocks: the unbounded search decides
        output = _run(
            ["yosys-abc", "-c", f"{read}; pdr -T {timeout_s:g}; write_cex -n {trace}"],
            design.folder,
            3 * timeout_s,
        )
    if "Property proved" in output:
        return None
    if "was asserted in frame" not in output or not trace.is_file():
        raise Failure(f"undecided after {timeout_s:g} s: {design.properties[numbers[0]]}\n{output[-1500:]}")
    values = {
        (int(clock), int(pin)): int(value)
        for pin, clock, value in re.findall(r"^pi(\d+)@(\d+)=([01])", trace.read_text(), re.MULTILINE)
    }
    clocks = 1 + max(clock for clock, _ in values)
    stimulus = [[values[clock, pin] for pin in range(design.aiger.inputs)] for clock in range(clocks)]
    run = design.aiger.replay(stimulus, numbers)
    if run is None:
        raise Failure(f"the replay does not confirm the counterexample of {design.properties[numbers[0]]}")
    return run
