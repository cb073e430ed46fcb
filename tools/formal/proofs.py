"""The list of proofs: each tests/formal/<name>_proof.sv, and the port and registers of each block with a register map.

The broken copies that a proof must refute are mutants of tests/mutants. Those of a register file come from its map.
"""

from __future__ import annotations

import fnmatch
import re
import sys
from collections.abc import Callable
from dataclasses import dataclass, field
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
FORMAL = ROOT / "tests" / "formal"
RTL = ROOT / "rtl"

sys.path[:0] = [str(ROOT / "tools"), str(ROOT / "tools/reggen"), str(ROOT / "tools/mutants")]
import emit_formal  # noqa: E402
import emit_formal_breaks  # noqa: E402
from catalogue import CatalogueError, Mutant  # noqa: E402
from catalogue import load as load_mutants  # noqa: E402
from load import load_block  # noqa: E402
from model import Block  # noqa: E402
from flat_ports import flat_module  # noqa: E402
from rtl_list import RtlTree  # noqa: E402

import gates  # noqa: E402
import harness  # noqa: E402


@dataclass(frozen=True)
class Break:
    """A broken copy: one text is replaced, and an assertion must refute it."""

    name: str
    file: Path
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
    headers: tuple[Path, ...] = (RTL / "common",)  # include path
    assertions: bool = True  # prove the assertions inside the modules too
    rewrite: Callable[[str], str] | None = None  # changes the flat netlist, see synthesis.synthesise


def _mutants_of(proof: str, mutants: list[Mutant]) -> list[Break]:
    return [
        Break(mutant.name, RTL / mutant.file, mutant.old, mutant.new, assertion)
        for mutant in mutants
        if (assertion := mutant.assertion_of(proof))
    ]


def _written(path: Path, tree: RtlTree, mutants: list[Mutant]) -> Proof:
    """A hand-written proof of tests/formal."""
    name, text = path.stem.removesuffix("_proof"), path.read_text()
    own = [path]
    if "axi_lite_properties" in text:
        own.insert(0, FORMAL / "axi_lite_properties.sv")
    flat = _flat_modules(text, tree)
    abstract = frozenset(re.findall(r"^module\s+(\w+)", text, re.M))  # of rtl/, replaced by modules of the proof
    sources = tree.closure([text, *flat.values()], skip=abstract)
    return Proof(name, path.stem, [*sources, *own], flat, _mutants_of(name, mutants))


def _flat_modules(text: str, tree: RtlTree) -> dict[str, str]:
    """The sources of the modules <module>_flat that `text` uses (tools/flat_ports.py), by file name."""
    names = {word.removesuffix("_flat") for word in re.findall(r"\w+_flat\b", text)} & tree.owner.keys()
    return {f"{name}_flat.sv": flat_module(tree.owner[name].read_text(), harness.HEADERS) for name in sorted(names)}


def _port(block: str, tree: RtlTree, mutants: list[Mutant]) -> Proof:
    """The proof of the AXI4-Lite port of a block. Stubs that keep the contracts replace its register file and core."""
    source = RTL / block / f"{block}.sv"
    text = source.read_text()
    inside = frozenset(
        name for name in tree.owner if name not in (block, "axi_lite_slave") and re.search(rf"^\s*{name}\s", text, re.M)
    )
    stubs = {f"{name}_stub.sv": harness.stub(tree.owner[name].read_text()) for name in sorted(inside)}
    flat = flat_module(text, harness.HEADERS)
    sources = tree.closure([text, flat, *stubs.values()], skip=inside)
    top = f"{block}_port_proof"
    generated = {**stubs, f"{block}_flat.sv": flat, f"{top}.sv": harness.port_proof(block, text)}
    return Proof(
        f"port.{block}",
        top,
        [*sources, FORMAL / "axi_lite_properties.sv"],
        generated,
        _mutants_of(f"port.{block}", mutants),
    )


def _gate(source: Path, tree: RtlTree, mutants: list[Mutant], requests: tuple[str, ...] = ()) -> Proof:
    block, text = source.stem, source.read_text()
    flat = flat_module(text, harness.HEADERS)
    top = f"{block}_gate_proof"
    generated = {f"{block}_flat.sv": flat, f"{top}.sv": gates.gate_proof(block, text, requests)}
    return Proof(
        f"gate.{block}",
        top,
        tree.closure([text, flat]),
        generated,
        _mutants_of(f"gate.{block}", mutants),
        assertions=False,
        rewrite=gates.with_guards,
    )


def _registers(block: Block, root: Path) -> Proof:
    source = root / "rtl" / block.name / f"{block.name}_reg_top.sv"
    top = f"{block.name}_reg_proof"
    every = [
        Break(name, source, old, new, refuted_by)
        for name, _, old, new, refuted_by in emit_formal_breaks.breaks(block, source.read_text())
    ]
    # The example has every kind of register and uses every break. A block uses one, to show that its proof can fail.
    breaks = every if root != ROOT else every[:1]
    flat = flat_module(source.read_text(), [root / "rtl/common", *harness.HEADERS])
    generated = {f"{source.stem}_flat.sv": flat, f"{top}.sv": emit_formal.proof(block)}
    return Proof(f"registers.{block.name}", top, [source], generated, breaks, (RTL / "common", root / "rtl/common"))


def all_proofs() -> list[Proof]:
    """All proofs. CatalogueError: a mutant names a proof that does not exist."""
    tree, mutants = RtlTree(ROOT), load_mutants()
    proofs = [_written(path, tree, mutants) for path in sorted(FORMAL.glob("*_proof.sv"))]
    proofs.append(_gate(RTL / gates.XBAR, tree, mutants, gates.XBAR_REQUESTS))
    example = ROOT / "tests" / "tools" / "reggen"
    for root in (example, ROOT):
        for path in sorted((root / "rtl").glob("*/*_regs.toml")):
            block = load_block(root, path)
            proofs.append(_registers(block, root))
            source = RTL / block.name / f"{block.name}.sv"
            if root == ROOT and source.is_file():
                proofs.append(_port(block.name, tree, mutants))
                if gates.has_gate(source.read_text()):
                    proofs.append(_gate(source, tree, mutants))
    for mutant in mutants:
        for pattern in mutant.refuted_by:
            if not any(fnmatch.fnmatchcase(proof.name, pattern) for proof in proofs):
                raise CatalogueError(f"mutant {mutant.name}: there is no proof {pattern}")
    return proofs
