"""Yosys converts a design to an AIGER file."""

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


def run_tool(command: list[str], folder: Path, timeout_s: float) -> str:
    try:
        done = subprocess.run(command, cwd=folder, capture_output=True, text=True, timeout=timeout_s, check=False)
    except subprocess.TimeoutExpired:
        raise Failure(f"{command[0]} takes more than {timeout_s:g} s") from None
    output = done.stdout + done.stderr
    if done.returncode:
        raise Failure(f"{command[0]}: exit code {done.returncode}\n{output[-3000:]}")
    return output


def synthesise(
    folder: Path,
    includes: list[Path],
    sources: list[Path],
    top: str,
    timeout_s: float,
    only: set[str] | None = None,
    rewrite: Callable[[str], str] | None = None,
) -> Design:
    """`only`: keeps the assertions of these names and the logic that they need. This saves time.
    `rewrite`: changes the RTLIL of the flattened design with plain flops. `only` then has no effect."""
    kept = " ".join(f"c:*{name}{PROVED} %d" for name in sorted(only or ()))
    prune = f"delete t:$assert {kept}\nopt_clean" if only and not rewrite else ""
    flags = " ".join(f"-I{include}" for include in includes)
    read = f"read_verilog -sv -formal {flags} {' '.join(map(str, sources))}\n"
    flops, gates = SYNTHESIS.format(top=top, folder=folder, prune=prune).split(PLAIN_FLOPS)
    script = folder / "synthesis.ys"
    if rewrite:
        script.write_text(f"{read}{flops}opt_clean\nwrite_rtlil {folder}/flops.il\n")
        run_tool(["yosys", "-q", "-e", "implicitly declared", str(script)], folder, timeout_s)
        try:
            (folder / "guarded.il").write_text(rewrite((folder / "flops.il").read_text()))
        except ValueError as error:
            raise Failure(str(error)) from None
        read, flops = f"read_rtlil {folder}/guarded.il\n", ""
    script.write_text(read + flops + gates)
    run_tool(["yosys", "-q", "-e", "implicitly declared", str(script)], folder, timeout_s)
    names = re.findall(r"^ *cell \$assert \\?(\S+)", (folder / "properties.il").read_text(), re.MULTILINE)
    aiger = Aiger.read(folder / "design.aig")
    if len(names) != len(aiger.bad):
        raise Failure(f"{len(names)} assertions became {len(aiger.bad)} properties")
    strange = [name for name in names if not name.endswith((REACHED, PROVED))]
    if strange:
        raise Failure(f"assertion outside the macros of assert.svh: {strange[0]}")
    return Design(folder, aiger, names)
