"""Generates the lists of the software's signals and of the registers, and the views of waveforms.

Exit code: 0 done or up to date, 1 `--check` found stale files, 2 a description is wrong.
"""

from __future__ import annotations

import argparse
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path[1:1] = [str(ROOT / "tools"), str(ROOT / "tools/reggen")]

import emit_cpp
import emit_gtkw
import emit_md
from generated import NoSection, section, write_section
from load import MapError, load_all
from model import VARIANTS
from signals import load

DOCUMENT, SECTION = "scenarios/WAVEFORMS.md", "signals of the software"
VIEWS = dict(zip(VARIANTS, ("tools/arm_soc.gtkw", "tools/arm_soc_paper.gtkw")))


def outputs(root: Path) -> tuple[dict[str, str], str]:
    """The text of every generated file by its name, and the section of the document."""
    soc, blocks = load_all(root)
    groups = load(root)
    texts = {
        "cosim/fabric/software_signal_list.hpp": emit_cpp.signal_list(groups),
        "cosim/fabric/register_names.hpp": emit_cpp.register_names(soc, blocks),
    }
    for variant, name in VIEWS.items():
        texts[name] = emit_gtkw.view(name, variant, groups, soc, blocks)
    return texts, emit_md.table(groups)


def main() -> int:
    parser = argparse.ArgumentParser(prog="wavegen", description=__doc__)
    parser.add_argument("--check", action="store_true", help="write nothing; list stale files and exit with 1")
    parser.add_argument("--root", type=Path, default=ROOT, help="repository to work on")
    args = parser.parse_args()

    root = args.root.resolve()
    document = root / DOCUMENT
    try:
        texts, table = outputs(root)
        old_table = section(document, SECTION) != table
    except (MapError, NoSection) as error:
        print(f"wavegen: {error}", file=sys.stderr)
        return 2

    stale = [name for name, text in texts.items() if not (root / name).is_file() or (root / name).read_text() != text]
    if args.check:
        for name in stale + [DOCUMENT] * old_table:
            print(f"stale: {name} (run `python3 tools/wavegen`)", file=sys.stderr)
        return 1 if stale or old_table else 0
    for name in stale:
        (root / name).write_text(texts[name])
    if old_table:
        write_section(document, SECTION, table)
    for name in stale + [DOCUMENT] * old_table:
        print(f"wrote {name}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
