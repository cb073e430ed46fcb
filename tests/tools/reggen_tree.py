"""What the tests of tools/reggen share: the example tree."""

import pathlib

import generator_tree

EXAMPLE = pathlib.Path(__file__).resolve().parent / "reggen"

REGS = "rtl/example/example_regs.toml"
SOC = "rtl/soc/soc_map.toml"

reggen = generator_tree.generator("reggen")


class TreeTest(generator_tree.TreeTest):
    """Works on a copy of the example tree."""

    ORIGINAL = EXAMPLE
    COPIED = tuple(sorted(path.name for path in EXAMPLE.iterdir()))
