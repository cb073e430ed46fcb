"""What the tests of tools/reggen share: the example tree, a copy of it to work on, and calls of programs."""

import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
EXAMPLE = pathlib.Path(__file__).resolve().parent / "reggen"

REGS = "rtl/example/example_regs.toml"
SOC = "rtl/soc/soc_map.toml"


def run(*command):
    return subprocess.run([str(word) for word in command], capture_output=True, text=True, check=False)


def reggen(root, *options):
    return run(sys.executable, ROOT / "tools/reggen", "--root", root, *options)


class TreeTest(unittest.TestCase):
    """Works on a copy of the example tree."""

    def setUp(self):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.root = pathlib.Path(scratch.name) / "tree"
        shutil.copytree(EXAMPLE, self.root)

    def edit(self, path, old, new):
        """Replaces the first `old`, which must be there."""
        text = (self.root / path).read_text()
        self.assertIn(old, text, path)
        (self.root / path).write_text(text.replace(old, new, 1))
