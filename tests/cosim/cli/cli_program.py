"""What the tests of the command line share: the program in a folder of its own."""

import csv
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import time
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[3]
SCENARIOS = ROOT / "scenarios"
SHORT = "zero_and_tiny_moves"  # the shortest scenario that users have
TINY = ROOT / "tests/cosim/scenarios/tiny_moves"  # a shorter one, with a golden, for what any scenario shows


class Program(unittest.TestCase):
    """Every test runs in an empty folder, removed at its end."""

    path = ""  # of the program

    def setUp(self):
        self._folder = tempfile.TemporaryDirectory()
        self.folder = pathlib.Path(self._folder.name)
        self.addCleanup(self._folder.cleanup)

    def armature(self, *arguments, code=0, folder=".", program=None, **environment):
        """Runs in `folder` of the test's own folder; `program` instead of the one that is tested."""
        done = subprocess.run(
            [program or self.path, *map(str, arguments)],
            cwd=self.folder / folder,
            text=True,
            capture_output=True,
            env={**os.environ, **environment},
        )
        self.assertEqual(done.returncode, code, f"{arguments}\n{done.stdout}\n{done.stderr}")
        return done

    def text(self, name, text):
        (self.folder / name).write_bytes(text.encode())
        return name

    def rows(self, name):
        return list(csv.DictReader((self.folder / name).read_text().splitlines()))

    def wait_for(self, name):
        """Until a program that runs beside has made this file."""
        deadline = time.monotonic() + 60
        while not (self.folder / name).exists():
            self.assertLess(time.monotonic(), deadline, name)
            time.sleep(0.02)

    def copy_of(self, scenario):
        """A scenario, by its name or folder, with its robots in a folder of its own."""
        shutil.copytree(SCENARIOS / "robots", self.folder / "scenarios" / "robots", dirs_exist_ok=True)
        scenario = SCENARIOS / scenario
        return pathlib.Path(shutil.copytree(scenario, self.folder / "scenarios" / scenario.name))

    def edit(self, path, old, new):
        text = path.read_text()
        self.assertIn(old, text)
        path.write_text(text.replace(old, new, 1))


def processor_s(pid):
    """Processor time that a running program has used, in steps of 10 ms."""
    fields = pathlib.Path(f"/proc/{pid}/stat").read_text().rsplit(")", 1)[1].split()
    return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")


def main():
    """Usage of every test file: FILE PATH_TO_ARMATURE [unittest arguments]."""
    Program.path = os.path.abspath(sys.argv.pop(1))
    unittest.main()
