"""What the tests of the generators share: a folder to work in, and calls of programs."""

import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]


def run(*command):
    return subprocess.run([str(word) for word in command], capture_output=True, text=True, check=False)


def generator(tool):
    """A function that runs this generator on a root."""
    return lambda root, *options: run(sys.executable, "-B", ROOT / "tools" / tool, "--root", root, *options)


class TreeTest(unittest.TestCase):
    """Works on a copy of files or of folders. `COPIED`: their names below `ORIGINAL`."""

    ORIGINAL = ROOT
    COPIED = ()

    def setUp(self):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.root = pathlib.Path(scratch.name) / "tree"
        for name in self.COPIED:
            (self.root / name).parent.mkdir(parents=True, exist_ok=True)
            copy = shutil.copytree if (self.ORIGINAL / name).is_dir() else shutil.copy
            copy(self.ORIGINAL / name, self.root / name)

    def edit(self, path, old, new):
        """Replaces the first `old`, which must be there."""
        text = (self.root / path).read_text()
        self.assertIn(old, text, path)
        (self.root / path).write_text(text.replace(old, new, 1))
