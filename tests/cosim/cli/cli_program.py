"""What the tests of the command line share: the program in a folder of its own."""

import csv
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import time
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[3]
SCENARIOS = ROOT / "scenarios"
SHORT = "encoder_hang"  # the shortest scenario that users have
TINY = ROOT / "tests/cosim/scenarios/tiny_moves"  # with moves of some pulses and a golden, for what any scenario shows
BRIEF = ("--set", "duration_s=0.03")  # TINY to the end of its moves: without a golden, in a quarter of the time
MOMENT = ("--set", "duration_s=0.001", "--set", "move=[]", "--set", "expect={}")  # TINY without its moves


class Program(unittest.TestCase):
    """Every test runs in an empty folder, removed at its end."""

    path = ""  # of the program
    longest_s = 240  # of host time: a program that has not ended by then fails its test
    engine = "model"  # of runs that name none and have no waveform: the bytes of the RTL in a third of the time

    @classmethod
    def setUpClass(cls):
        cls.shared = pathlib.Path(cls.enterClassContext(tempfile.TemporaryDirectory()))
        cls.kept = {}

    def setUp(self):
        self._folder = tempfile.TemporaryDirectory()
        self.folder = pathlib.Path(self._folder.name)
        self.addCleanup(self._folder.cleanup)

    def armature(self, *arguments, code=0, folder=".", program=None, **environment):
        """Runs in `folder` of the test's own folder; `program` instead of the one that is tested; `code` None: any."""
        done = subprocess.run(
            [program or self.path, *map(str, self.with_engine(arguments))],
            cwd=self.folder / folder,
            text=True,
            capture_output=True,
            env={**os.environ, **environment},
            timeout=self.longest_s,
        )
        if code is not None:
            self.assertEqual(done.returncode, code, f"{arguments}\n{done.stdout}\n{done.stderr}")
        return done

    def with_engine(self, arguments):
        """The arguments of a run with the engine of the class, unless they choose one or ask for a waveform."""
        names = [str(argument) for argument in arguments]
        chosen = any(name.startswith(("--engine", "--vcd", "--fst", "--help")) for name in names)
        return arguments if chosen or names[:1] != ["run"] else (*arguments, "--engine", self.engine)

    def listening(self, first_line, *arguments):
        """A program, killed at the end of the test, whose first line tells where it listens; and the match of this line."""
        process = subprocess.Popen(
            [self.path, *map(str, arguments)],
            cwd=self.folder,
            text=True,
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
        )
        self.addCleanup(process.communicate)
        self.addCleanup(process.kill)
        line = process.stdout.readline()
        found = re.match(first_line, line)
        self.assertTrue(found, line or process.stderr.read())
        return process, found

    def beside(self, *arguments, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL):
        """A program that runs beside the test, killed at its end if it still runs."""
        program = subprocess.Popen([self.path, *map(str, arguments)], cwd=self.folder, stdout=stdout, stderr=stderr)
        self.addCleanup(program.wait)
        self.addCleanup(program.kill)
        return program

    def once(self, name, make):
        """What `make` gives when the first test of the class asks for it. The tests share it and do not change it."""
        if name not in self.kept:
            self.kept[name] = make()
        return self.kept[name]

    def run_once(self, *arguments, code=0):
        """A run that tests share: the folder of its results, and what it printed."""
        out = self.shared / f"run{len(self.kept)}"
        return self.once(arguments, lambda: (out, self.armature("run", *arguments, "--out", out, code=code).stdout))

    def brief(self):
        """A scenario that tests share: TINY to the end of its moves, with the golden of that."""

        def make():
            scenario = pathlib.Path(shutil.copytree(TINY, self.shared / TINY.name))
            self.edit(scenario / "scenario.toml", "duration_s = 0.12", BRIEF[1].replace("=", " = "))
            self.armature("bless", scenario)
            return scenario

        return self.once("brief", make)

    def text(self, name, text):
        (self.folder / name).write_bytes(text.encode())
        return name

    def rows(self, name):
        return list(csv.DictReader((self.folder / name).read_text().splitlines()))

    def wait_until(self, condition, told=lambda: ""):
        """Until a program that runs beside has come so far; `told` is what it said until then."""
        deadline = time.monotonic() + 120
        while not condition():
            self.assertLess(time.monotonic(), deadline, told())
            time.sleep(0.02)

    def wait_for(self, name):
        self.wait_until((self.folder / name).exists, lambda: name)

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
