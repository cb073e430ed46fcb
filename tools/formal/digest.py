"""What a proof reads, as one digest: with the same digest and the same tools it gives the same result (tools/gates)."""

from __future__ import annotations

import hashlib
from pathlib import Path

from proofs import FORMAL, ROOT, Proof

# The programs that make and decide the designs, and weave the broken copies.
PROGRAMS = ("tools/formal/*.py", "tools/mutants/*.py")


def _named(path: Path) -> str:
    return str(path.relative_to(ROOT))


def digest(proof: Proof) -> str:
    """SHA-256 of the texts of a proof, of its broken copies, and of every file that Yosys may read."""
    headers = [path for folder in {FORMAL, *proof.headers} for path in folder.glob("*.svh")]
    programs = [path for pattern in PROGRAMS for path in ROOT.glob(pattern)]
    files = sorted({*proof.sources, *headers, FORMAL / "formal_cells.sv", *programs})
    lines = [f"{_named(path)} {hashlib.sha256(path.read_bytes()).hexdigest()}" for path in files]
    lines += [proof.top, str(proof.assertions), proof.rewrite.__qualname__ if proof.rewrite else ""]
    lines += [f"{name}\n{text}" for name, text in sorted(proof.generated.items())]
    lines += [repr((each.name, _named(each.file), each.old, each.new, each.refuted_by)) for each in proof.breaks]
    return hashlib.sha256("\n".join(lines).encode()).hexdigest()
