"""Generates the C++ table and the documentation of the pendant's frames from controller/pendant/frames.toml.

Exit code: 0 done or up to date, 1 `--check` found stale files, 2 the description is wrong.
"""

from __future__ import annotations

import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path[1:1] = [str(ROOT / "tools"), str(ROOT / "tools/reggen")]

import emit_cpp
import emit_md
from frames import load
from generator import Outputs, generate
from table import MapError


def outputs(root: Path) -> Outputs:
    frames = load(root)
    return Outputs(
        {"controller/pendant/protocol/frame_table.hpp": emit_cpp.header(frames)},
        {"controller/pendant/PROTOCOL.md": emit_md.sections(frames)},
    )


if __name__ == "__main__":
    sys.exit(generate("framegen", __doc__, outputs, MapError))
