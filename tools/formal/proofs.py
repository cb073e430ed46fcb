"""What is proved: the list of tests/formal/proofs.toml, and for each block with a register map its port and registers."""

from __future__ import annotations

import re
import sys
import tomllib
from dataclasses import dataclass, field
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
FORMAL = ROOT / "tests" / "formal"
RTL = ROOT / "rtl"

sys.path[:0] = [str(ROOT / "tools"), str(ROOT / "tools/reggen")]
import emit_formal  # noqa: E402
from load import load_block  # noqa: E402
from model import Block  # noqa: E402
from rtl_list import rtl_sources  # noqa: E402

import harness  # noqa: E402

MODULE = re.compile(r"^(?:module|package)\s+(\w+)", re.MULTILINE)
COMMENT = re.compile(r"//[^\n]*")


class ListError(Exception):
    """An entry of the list that cannot be meant."""


@dataclass(frozen=True)
class Break:
    """A copy with one text replaced, which an assertion must refute."""

    name: str
    file: str  # the source by its file name
    old: str  # occurs exactly once
    new: str
    refuted_by: str  # name of an assertion


@dataclass
class Proof:
    name: str
    top: str
    sources: list[Path]
    generated: dict[str, str] = field(default_factory=dict)  # file name -> text
    breaks: list[Break] = field(default_factory=list)


def rtl_paths() -> list[Path]:
    return [RTL / source for source in rtl_sources(ROOT)]


def closure(texts: list[str], skip: frozenset[str] = frozenset()) -> list[Path]:
    """The RTL sources that `texts` use, directly or not, in the order of rtl.f; `skip` are modules that stay out."""
    owner = {}
    for path in rtl_paths():
        for name in MODULE.findall(path.read_text()):
            owner[name] = path
    used: set[Path] = set()
    pending = list(texts)
    while pending:
        words = set(re.findall(r"\w+", COMMENT.sub("", pending.pop())))
        for name in words & owner.keys() - skip:
            if owner[name] not in used:
                used.add(owner[name])
                pending.append(owner[name].read_text())
    return [path for path in rtl_paths() if path in used]


def _listed() -> list[Proof]:
    proofs = []
    for entry in tomllib.loads((FORMAL / "proofs.toml").read_text())["proof"]:
        name, top = entry.pop("name"), entry.pop("top")
        breaks = [Break(**values) for values in entry.pop("breaks")]
        if entry:
            raise ListError(f"proof {name}: unknown key `{next(iter(entry))}`")
        own = [FORMAL / f"{top}.sv"]
        texts = [path.read_text() for path in own]
        if any("axi_lite_properties" in text for text in texts):
            own.insert(0, FORMAL / "axi_lite_properties.sv")
        proofs.append(Proof(name, top, [*closure(texts), *own], breaks=breaks))
    return proofs


def _port(block: str) -> Proof:
    """The AXI4-Lite port of a block, its register file and core replaced by what their contracts promise."""
    source = RTL / block / f"{block}.sv"
    text = source.read_text()
    inside = frozenset(name for path in rtl_paths() for name in re.findall(r"^module\s+(\w+)", path.read_text(), re.M)
                       if name not in (block, "axi_lite_slave") and re.search(rf"^\s*{name}\s", text, re.M))
    stubs = {f"{name}_stub.sv": harness.stub(next(p for p in rtl_paths() if p.stem == name).read_text())
             for name in sorted(inside)}
    sources = closure([text, *stubs.values()], skip=inside)
    top = f"{block}_port_proof"
    breaks = [
        Break("answers_before_the_data", "axi_lite_slave.sv", "(s_axi_wvalid_i || !s_axi_wready_o) &&", "",
              "BAnswersAWholeWrite"),
        Break("forgets_a_stalled_read", "axi_lite_slave.sv", "if (s_axi_rvalid_o && s_axi_rready_i) begin",
              "if (s_axi_rvalid_o) begin", "RStaysUntilReady"),
    ]
    return Proof(f"port.{block}", top, [*sources, FORMAL / "axi_lite_properties.sv"],
                 {**stubs, f"{top}.sv": harness.port_proof(block, text)}, breaks)


def _registers(block: Block, root: Path) -> Proof:
    source = root / "rtl" / block.name / f"{block.name}_reg_top.sv"
    top = f"{block.name}_reg_proof"
    every = [Break(*values) for values in emit_formal.breaks(block, source.read_text())]
    # The example has a register of every kind and takes every break; a block shows that its proof bites.
    breaks = every if root != ROOT else every[:1]
    return Proof(f"registers.{block.name}", top, [source], {f"{top}.sv": emit_formal.proof(block)}, breaks)


def all_proofs() -> list[Proof]:
    proofs = _listed()
    example = ROOT / "tests" / "tools" / "reggen"
    for root in (example, ROOT):
        for path in sorted((root / "rtl").glob("*/*_regs.toml")):
            block = load_block(root, path)
            proofs.append(_registers(block, root))
            if root == ROOT and (RTL / block.name / f"{block.name}.sv").is_file():
                proofs.append(_port(block.name))
    return proofs
