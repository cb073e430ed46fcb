"""Writes copies of the RTL that contain all mutants of the tests, and the list of the mutants for CMake.

The files go below FOLDER: each RTL file with mutants, with its path below rtl/, and mutants.cmake. A file that
would not change is not written. Exit code: 0, or 1 with a message about the mutant that is wrong.
"""

from __future__ import annotations

import argparse
import sys
from pathlib import Path

from catalogue import MUTANTS, RTL, CatalogueError, Mutant, load
from weave import weave


def _write(path: Path, text: str):
    if not path.is_file() or path.read_text() != text:
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)


def _cmake(mutants: list[Mutant]) -> str:
    lines = ["# Written by tools/mutants while configuring."]
    programs = sorted({program for mutant in mutants for program in mutant.killed_by})
    for program in programs:
        lines.append(f"add_mutant_program({program})")
        for mutant in mutants:
            if program in mutant.killed_by:
                lines.append(
                    f"add_mutant({mutant.name} {mutant.number} {program} {mutant.file} "
                    f'"{mutant.killed_by[program]}")'
                )
        killers = {one for mutant in mutants for one in mutant.killed_by.get(program, "").split(":") if one}
        lines.append(f"add_healthy({program} \"{':'.join(sorted(killers))}\")")
    return "\n".join(lines) + "\n"


def main() -> int:
    parser = argparse.ArgumentParser(
        prog="mutants", description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("folder", type=Path)
    folder = parser.parse_args().folder
    try:
        mutants = [mutant for mutant in load() if mutant.killed_by]
        for file in sorted({mutant.file for mutant in mutants}):
            _write(folder / file, weave((RTL / file).read_text(), [one for one in mutants if one.file == file]))
    except CatalogueError as error:
        print(
            f"mutants: {MUTANTS.relative_to(MUTANTS.parents[1])}/{error}"
            if ".toml" in str(error)
            else f"mutants: {error}",
            file=sys.stderr,
        )
        return 1
    _write(folder / "mutants.cmake", _cmake(mutants))
    # An old copy of a file that has no mutant now would still replace the original.
    written = {folder / mutant.file for mutant in mutants}
    for old in folder.rglob("*.sv"):
        if old not in written:
            old.unlink()
    return 0


if __name__ == "__main__":
    sys.exit(main())
