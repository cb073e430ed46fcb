"""The headers that C++ sources of the project include, shared by the Python tools."""

import re
from functools import cache
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
INCLUDE = re.compile(r'^#include "([^"]+)"', re.MULTILINE)


@cache
def included(path: Path) -> frozenset[Path]:
    """The files of the project that a C++ file includes itself. Headers of a verilated model are not among them."""
    found = set()
    for name in INCLUDE.findall(path.read_text()):
        for candidate in (path.parent / name, ROOT / name):
            if candidate.is_file():
                found.add(candidate.resolve())
                break
    return frozenset(found)


def include_closure(sources: set[Path]) -> set[Path]:
    """The sources and every file that they include directly or indirectly."""
    found, pending = set(sources), list(sources)
    while pending:
        new = included(pending.pop()) - found
        found |= new
        pending += new
    return found
