"""Generates the lists of the software's signals and of the registers, and the views of waveforms.

Exit code: 0 done or up to date, 1 `--check` found stale files, 2 a description is wrong.
"""

from __future__ import annotations

import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path[1:1] = [str(ROOT / "tools"), str(ROOT / "tools/reggen")]

import emit_cpp
import emit_gtkw
import emit_md
import emit_surfer
from generator import Outputs, generate
from load import MapError, load_all
from model import VARIANTS
from signals import load

# Without the ends of their names.
VIEWS = dict(zip(VARIANTS, ("tools/arm_soc", "tools/arm_soc_paper")))


def outputs(root: Path) -> Outputs:
    soc, blocks = load_all(root)
    groups = load(root)
    files = {
        "cosim/fabric/software_signal_list.hpp": emit_cpp.signal_list(groups),
        "cosim/fabric/register_names.hpp": emit_cpp.register_names(soc, blocks),
    }
    for variant, name in VIEWS.items():
        for kind, emit in ((".gtkw", emit_gtkw), (".sucl", emit_surfer)):
            files[name + kind] = emit.view(name + kind, variant, groups, soc, blocks)
    return Outputs(files, {"scenarios/WAVEFORMS.md": {"signals of the software": emit_md.table(groups)}})


if __name__ == "__main__":
    sys.exit(generate("wavegen", __doc__, outputs, MapError))
