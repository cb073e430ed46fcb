"""What the tests of the report share: the program, and the browser that opens its pages."""

import pathlib
import sys
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "cli"))

import browser  # noqa: E402
from cli_program import SCENARIOS, TINY, Program, main  # noqa: E402, F401


@unittest.skipIf(browser.PROGRAM is None, "Chromium is not installed")
class ReportProgram(Program):
    @classmethod
    def setUpClass(cls):
        cls.page = cls.enterClassContext(browser.Browser())

    def show(self, scenario, *options, code=0):
        """Runs a scenario and opens its report."""
        self.armature("run", scenario, "--out", "x", *options, code=code)
        self.armature("report", "x")
        return self.open("x/report.html")

    def open(self, name):
        seconds = self.page.open(self.folder / name)
        self.assertEqual(self.page.problems(), [])
        self.assertEqual(self.page.requests(), [(self.folder / name).resolve().as_uri()])
        return seconds
