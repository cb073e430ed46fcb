"""What the tests of the report share: the program, and the browser that opens its pages."""

import pathlib
import sys
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "cli"))

import browser  # noqa: E402
from cli_program import BRIEF, ROOT, SCENARIOS, TINY, Program, main  # noqa: E402, F401

OURS = ROOT / "tests/cosim/scenarios"
MOVES = OURS / "joint_move_and_circle"  # with a trace of every tick
# Share of the pixels of a canvas that differ from its upper left corner.
PAINTED = """(canvas => {
  const copy = document.createElement('canvas');
  copy.width = canvas.width; copy.height = canvas.height;
  const context = copy.getContext('2d');
  context.drawImage(canvas, 0, 0);
  const pixels = new Uint32Array(context.getImageData(0, 0, copy.width, copy.height).data.buffer);
  return pixels.filter(pixel => pixel !== pixels[0]).length / pixels.length;
})"""


@unittest.skipIf(browser.PROGRAM is None, "Chromium is not installed")
class ReportProgram(Program):
    page = None  # of the browser, which all tests of a file share
    size = (1500, 1000)  # of its window

    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        if ReportProgram.page is None:
            ReportProgram.page = unittest.enterModuleContext(browser.Browser(*cls.size))

    def show(self, scenario, *options, code=0):
        """Opens the report of a run that tests share. Returns the folder of its results."""
        out, _ = self.run_once(scenario, "--report", *options, code=code)
        self.open(out / "report.html")
        return out

    def open(self, name):
        seconds = self.page.open(self.folder / name)
        self.assertEqual(self.page.problems(), [])
        self.assertEqual(self.page.requests(), [(self.folder / name).resolve().as_uri()])
        return seconds


class PanelsProgram(ReportProgram):
    def painted(self, selector):
        return self.page.run(f"{PAINTED}(document.querySelector('{selector}'))")

    def assert_panels_painted(self, plots):
        for plot in plots:
            with self.subTest(plot):
                self.assertGreater(self.painted(f"#plot-{plot} canvas"), 0.002)
        self.assertGreater(self.painted("#lanes canvas"), 0.1)
        self.assertGreater(self.painted("#arm canvas"), 0.02)
