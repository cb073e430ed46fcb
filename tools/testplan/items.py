"""The proofs, tests, covers and mutants that exist, found in their sources."""

from __future__ import annotations

import fnmatch
import re
import sys
from dataclasses import dataclass, field
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path[:0] = [str(ROOT / "tools/formal"), str(ROOT / "tools")]
from proofs import RTL, all_proofs  # noqa: E402
from proofs import load_mutants  # noqa: E402
from rtl_list import rtl_sources  # noqa: E402

TEST = re.compile(r"^TEST(?:_P|_F)?\(\s*(\w+)\s*,\s*(\w+)\s*\)", re.MULTILINE)
COVER = re.compile(r"^\s*`COVER\((\w+)\s*,", re.MULTILINE)


@dataclass
class Items:
    """The names by kind. A name is assigned to features of the plan."""

    proofs: set[str]
    tests: set[str]  # Suite.Name of GoogleTest, scenario.NAME, or the path of a Python test
    covers: set[str]  # file.Label
    # The tests and proofs that detect each mutant, as patterns. The broken copies of a proof that come from a register map
    # are mutants too: PROOF.NAME.
    mutants: dict[str, set[str]] = field(default_factory=dict)

    def of_kind(self, kind: str) -> set[str]:
        return set(getattr(self, kind))


def plain_tests(filter_text: str) -> set[str]:
    """The tests of a GoogleTest filter as patterns of Suite.Name, without instance and parameter:
    `Stalls/Suite.Name/*:Other.*` gives Suite.Name and Other.*."""
    found = set()
    for part in filter_text.split(":"):
        suite, _, name = part.partition(".")
        found.add(f"{suite.rpartition('/')[2]}.{name.partition('/')[0]}")
    return found


def _tests(root: Path) -> set[str]:
    found = set()
    for path in (root / "tests").rglob("*.cpp"):
        found |= {f"{suite}.{name}" for suite, name in TEST.findall(path.read_text())}
    found |= {f"scenario.{path.parent.name}" for path in (root / "scenarios").glob("*/scenario.toml")}
    return found | {path.relative_to(root).as_posix() for path in (root / "tests").rglob("*.py")}


def existing() -> Items:
    proofs = [proof for proof in all_proofs() if any(RTL in path.parents for path in proof.sources)]  # not the example
    covers = {
        f"{Path(source).stem}.{label}"
        for source in rtl_sources(ROOT)
        for label in COVER.findall((RTL / source).read_text())
    }
    mutants = {}
    for mutant in load_mutants():
        mutants[mutant.name] = set(mutant.refuted_by).union(*map(plain_tests, mutant.killed_by.values()))
    for proof in proofs:
        for broken in proof.breaks:
            if broken.name not in mutants:
                mutants[f"{proof.name}.{broken.name}"] = {proof.name}
    return Items({proof.name for proof in proofs}, _tests(ROOT), covers, mutants)


def matching(pattern: str, names: set[str]) -> set[str]:
    return {name for name in names if fnmatch.fnmatchcase(name, pattern)}
