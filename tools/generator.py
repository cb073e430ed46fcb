"""The command line of the generators: it writes the generated files that are stale, or `--check` lists them."""

from __future__ import annotations

import argparse
import sys
from collections.abc import Callable
from dataclasses import dataclass, field
from pathlib import Path

from generated import NoSection, section, write_section

REPOSITORY = Path(__file__).resolve().parents[1]


@dataclass
class Outputs:
    """What a generator makes, by names relative to the root."""

    files: dict[str, str]  # the text of every file
    sections: dict[str, dict[str, str]] = field(default_factory=dict)  # of documents: the texts of sections by name
    gone: list[str] = field(default_factory=list)  # generated files whose description no longer exists


def _stale_sections(root: Path, outputs: Outputs) -> dict[str, list[str]]:
    """The names of the stale sections of each document that has some."""
    stale = {
        document: [name for name, text in texts.items() if section(root / document, name) != text]
        for document, texts in outputs.sections.items()
    }
    return {document: names for document, names in stale.items() if names}


def generate(tool: str, description: str, make: Callable[[Path], Outputs], error: type[Exception]) -> int:
    """Runs a generator, and returns its exit code. `make` raises `error` when a description is wrong."""
    parser = argparse.ArgumentParser(prog=tool, description=description)
    parser.add_argument("--check", action="store_true", help="write nothing; list stale files and exit with 1")
    parser.add_argument("--root", type=Path, default=REPOSITORY, help="repository to work on")
    args = parser.parse_args()

    root = args.root.resolve()
    try:
        outputs = make(root)
        sections = _stale_sections(root, outputs)
    except (error, NoSection) as problem:
        print(f"{tool}: {problem}", file=sys.stderr)
        return 2

    files = [
        name for name, text in outputs.files.items() if not (root / name).is_file() or (root / name).read_text() != text
    ]
    if args.check:
        stale = [*files, *sections, *outputs.gone]
        for name in stale:
            print(f"stale: {name} (run `python3 tools/{tool}`)", file=sys.stderr)
        return 1 if stale else 0
    for name in files:
        (root / name).parent.mkdir(parents=True, exist_ok=True)
        (root / name).write_text(outputs.files[name])
    for document, names in sections.items():
        for name in names:
            write_section(root / document, name, outputs.sections[document][name])
    for name in [*files, *sections]:
        print(f"wrote {name}")
    for name in outputs.gone:
        (root / name).unlink()
        print(f"removed {name}")
    return 0
