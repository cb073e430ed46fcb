"""Generates the C++ table and the documentation of the pendant's frames from controller/pendant/frames.toml.

Exit code: 0 done or up to date, 1 `--check` found stale files, 2 the description is wrong.
"""

from __future__ import annotations

import argparse
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path[1:1] = [str(ROOT / "tools"), str(ROOT / "tools/reggen")]

import emit_cpp
import emit_md
from frames import load
from generated import NoSection, section, write_section
from table import MapError

HEADER = "controller/pendant/frame_table.hpp"
DOCUMENT = "controller/pendant/PROTOCOL.md"


def main() -> int:
    parser = argparse.ArgumentParser(prog="framegen", description=__doc__)
    parser.add_argument("--check", action="store_true", help="write nothing; list stale files and exit with 1")
    parser.add_argument("--root", type=Path, default=ROOT, help="repository to work on")
    args = parser.parse_args()

    root = args.root.resolve()
    header, document = root / HEADER, root / DOCUMENT
    try:
        frames = load(root)
        text, sections = emit_cpp.header(frames), emit_md.sections(frames)
        old_sections = [name for name, content in sections.items() if section(document, name) != content]
    except (MapError, NoSection) as error:
        print(f"framegen: {error}", file=sys.stderr)
        return 2

    stale = []
    if not header.is_file() or header.read_text() != text:
        stale.append(HEADER)
    if old_sections:
        stale.append(DOCUMENT)
    if args.check:
        for name in stale:
            print(f"stale: {name} (run `python3 tools/framegen`)", file=sys.stderr)
        return 1 if stale else 0
    if HEADER in stale:
        header.write_text(text)
    for name in old_sections:
        write_section(document, name, sections[name])
    for name in stale:
        print(f"wrote {name}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
