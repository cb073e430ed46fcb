#!/usr/bin/env python3
"""weave.py FOLDER: writes copies of cosim/model with the mutants of mutants.toml, and mutants.cmake with their tests.

The environment variable MUTANT selects the original or a mutant. A file that need not change is not written, so that the
build does not compile it again.
"""

from __future__ import annotations

import sys
import tomllib
from pathlib import Path

HERE = Path(__file__).resolve().parent
MODEL = HERE.parents[2] / "cosim/model"
SELECTOR = """
#include <cstdlib>
// The mutant that is active; 0: none.
inline int armature_mutant() {
  static const int number = std::getenv("MUTANT") == nullptr ? 0 : std::atoi(std::getenv("MUTANT"));
  return number;
}
"""


def woven(mutant: dict, number: int, text: str) -> str:
    """The text with the mutant."""
    original, changed = mutant["from"], mutant["to"]
    if text.count(original) != 1:
        sys.exit(f"{HERE}/mutants.toml: {mutant['name']}: 'from' must occur once in {mutant['file']}")
    return text.replace(original, f"(armature_mutant() == {number} ? ({changed}) : ({original}))")


def main():
    folder = Path(sys.argv[1])
    mutants = tomllib.loads((HERE / "mutants.toml").read_text())["mutant"]
    texts: dict[Path, str] = {path.relative_to(MODEL): path.read_text() for path in MODEL.rglob("*.?pp")}
    lines = []
    for number, mutant in enumerate(mutants, 1):
        file = Path(mutant["file"])
        texts[file] = woven(mutant, number, texts[file])
        lines.append(f"add_model_mutant({mutant['name']} {number} {mutant['block']} {mutant['killed_by']})\n")
    texts[Path("block.hpp")] = texts[Path("block.hpp")].replace("#pragma once\n", "#pragma once\n" + SELECTOR, 1)
    outputs = {folder / "cosim/model" / file: text for file, text in texts.items()}
    outputs[folder / "mutants.cmake"] = "".join(lines)
    for path, text in outputs.items():
        path.parent.mkdir(parents=True, exist_ok=True)
        if not path.exists() or path.read_text() != text:
            path.write_text(text)


if __name__ == "__main__":
    main()
