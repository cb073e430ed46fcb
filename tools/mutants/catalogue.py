"""The mutants of tests/mutants/*.toml: the change of each, and the tests and proofs that must detect it."""

from __future__ import annotations

import fnmatch
import tomllib
import zlib
from dataclasses import dataclass, field
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
RTL = ROOT / "rtl"
MUTANTS = ROOT / "tests" / "mutants"


class CatalogueError(Exception):
    """A wrong entry. The message contains the file, the mutant and the expectation."""


@dataclass(frozen=True)
class Mutant:
    """One text of one RTL file replaced by another."""

    name: str
    file: str  # relative to rtl/
    old: str  # occurs exactly once in the file
    new: str
    killed_by: dict[str, str] = field(default_factory=dict)  # test program -> GoogleTest filter: each test must fail
    refuted_by: dict[str, str] = field(default_factory=dict)  # proof, or pattern of proofs -> assertion that must fail

    @property
    def number(self) -> int:
        """Selects the mutant at run time. It depends on the name only, not on other mutants. Never 0."""
        return zlib.crc32(self.name.encode()) or 1

    def applied(self, text: str) -> str:
        """`text`, the content of `file`, with the mutation."""
        return text.replace(self.old, self.new)

    def assertion_of(self, proof: str) -> str | None:
        """The assertion by which `proof` must refute this mutant; None: `proof` does not check this mutant."""
        for pattern, assertion in self.refuted_by.items():
            if fnmatch.fnmatchcase(proof, pattern):
                return assertion
        return None


KEYS = {"name": str, "file": str, "from": str, "to": str, "killed_by": dict, "refuted_by": dict}
REQUIRED = ("name", "file", "from", "to")


def _mutant(entry: dict, where: str, rtl: Path) -> Mutant:
    where = f"{where}: mutant {entry.get('name', '(without a name)')}"
    for key, value in entry.items():
        if key not in KEYS:
            raise CatalogueError(f"{where}: unknown key `{key}`")
        if not isinstance(value, KEYS[key]):
            raise CatalogueError(f"{where}: `{key}` must be a {'table' if KEYS[key] is dict else 'string'}")
    for key in REQUIRED:
        if key not in entry:
            raise CatalogueError(f"{where}: no `{key}`")
    mutant = Mutant(
        entry["name"],
        entry["file"],
        entry["from"],
        entry["to"],
        entry.get("killed_by", {}),
        entry.get("refuted_by", {}),
    )
    if not mutant.killed_by and not mutant.refuted_by:
        raise CatalogueError(f"{where}: neither a test in `killed_by` nor a proof in `refuted_by`")
    if not (rtl / mutant.file).is_file():
        raise CatalogueError(f"{where}: there is no rtl/{mutant.file}")
    count = (rtl / mutant.file).read_text().count(mutant.old)
    if count != 1:
        raise CatalogueError(
            f"{where}: `from` must occur exactly once in rtl/{mutant.file}, it occurs {count} times:\n" f"{mutant.old}"
        )
    if mutant.old == mutant.new:
        raise CatalogueError(f"{where}: `to` is the same as `from`")
    return mutant


def load(folder: Path = MUTANTS, rtl: Path = RTL) -> list[Mutant]:
    """Every mutant, in the order of the files. CatalogueError for the first entry that is wrong."""
    mutants: dict[str, Mutant] = {}
    numbers: dict[int, str] = {}
    for path in sorted(folder.glob("*.toml")):
        try:
            document = tomllib.loads(path.read_text())
        except tomllib.TOMLDecodeError as error:
            raise CatalogueError(f"{path.name}: {error}") from None
        for entry in document.pop("mutant", []):
            mutant = _mutant(entry, path.name, rtl)
            if mutant.name in mutants:
                raise CatalogueError(f"{path.name}: there are two mutants {mutant.name}")
            if mutant.number in numbers:
                raise CatalogueError(
                    f"{path.name}: rename {mutant.name}, its number is that of {numbers[mutant.number]}"
                )
            mutants[mutant.name] = mutant
            numbers[mutant.number] = mutant.name
        if document:
            raise CatalogueError(f"{path.name}: unknown table `{next(iter(document))}`")
    return list(mutants.values())
