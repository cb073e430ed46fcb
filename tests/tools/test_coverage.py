"""tools/coverage: what it counts, what it reports, and that a waiver must be needed."""

import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
SOURCE = """module m;
  always_ff @(posedge clk_i) begin
    if (go_i) begin
      a_q <= 1;
    end else begin
      b_q <= 1;
    end
  end
endmodule
"""
WAIVER = '[[waiver]]\nfile = "b/m.sv"\nwhat = "{what}"\nwhy = "{why}"\n'


class Tool(unittest.TestCase):
    def setUp(self):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.root = pathlib.Path(scratch.name).resolve()
        for folder in ("tools", "rtl/b", "data", "tests/coverage"):
            (self.root / folder).mkdir(parents=True)
        for file in ("coverage", "rtl_list.py"):
            shutil.copy(ROOT / "tools" / file, self.root / "tools" / file)
        (self.root / "rtl/rtl.f").write_text("// level 0\nb/m.sv\nb/wires.sv\nb/b_reg_top.sv\n")
        (self.root / "rtl/b/m.sv").write_text(SOURCE)
        (self.root / "rtl/b/wires.sv").write_text("module wires; assign a = b; endmodule\n")

    def data(self, name, *points):
        """Each point is (page, line, lines of its block, name, instance, count)."""
        lines = []
        for page, line, block, label, instance, count in points:
            fields = {
                "f": self.root / "rtl/b/m.sv",
                "l": line,
                "n": 3,
                "page": f"v_{page}/m",
                "o": label,
                "S": block,
                "h": instance,
            }
            lines.append("C '" + "".join(f"\1{key}\2{value}" for key, value in fields.items()) + f"' {count}\n")
        (self.root / "data" / f"{name}.dat").write_text("# SystemC::Coverage-3\n" + "".join(lines))

    def blocks(self, name, taken, other, cover=1, instance="TOP.m"):
        self.data(
            name,
            ("line", 2, "2", "block", instance, taken + other),
            ("branch", 3, "3-4", "if", instance, taken),
            ("branch", 5, "6", "else", instance, other),
            ("user", 8, "", "cover", f"{instance}.Seen", cover),
        )

    def run_tool(self, waivers=""):
        (self.root / "tests/coverage/waivers.toml").write_text(waivers)
        result = subprocess.run(
            [sys.executable, "-B", self.root / "tools/coverage", "--data", self.root / "data"],
            capture_output=True,
            text=True,
            check=False,
        )
        return result.returncode, result.stdout.splitlines(), result.stderr

    def test_all_reached(self):
        self.blocks("one", 3, 4)
        code, table, errors = self.run_tool()
        self.assertEqual((code, errors), (0, ""))
        self.assertEqual(table[1].split(), ["b/m.sv", "4/4", "2/2", "1/1"])
        self.assertEqual(table[-1].split()[0], "all")
        self.assertEqual(len(table), 3, "neither wiring nor generated files")

    def test_a_line_that_never_runs_is_reported_with_its_text(self):
        self.blocks("one", 3, 0)
        code, table, errors = self.run_tool()
        self.assertEqual((code, errors), (1, "rtl/b/m.sv:6: not executed: b_q <= 1;\n"))
        self.assertEqual(table[1].split(), ["b/m.sv", "3/4", "1/2", "1/1"])

    def test_programs_and_instances_add_up(self):
        self.blocks("one", 3, 0, cover=0)
        self.blocks("two", 0, 1, instance="TOP.other.m")
        self.assertEqual(self.run_tool()[0], 0)

    def test_a_cover_that_is_never_reached_is_reported(self):
        self.blocks("one", 1, 1, cover=0)
        self.assertEqual(self.run_tool()[::2], (1, "rtl/b/m.sv: not reached: COVER Seen\n"))

    def test_a_waiver_with_a_reason_excuses(self):
        self.blocks("one", 1, 0, cover=0)
        waivers = WAIVER.format(what="b_q <= 1;", why="x") + WAIVER.format(what="Seen", why="y")
        self.assertEqual(self.run_tool(waivers)[::2], (0, ""))

    def test_a_waiver_needs_a_reason_and_a_need(self):
        self.blocks("one", 1, 0)
        self.assertIn("`why` is missing", self.run_tool(WAIVER.format(what="b_q <= 1;", why=""))[2])
        self.blocks("one", 1, 1)
        code, _, errors = self.run_tool(WAIVER.format(what="b_q <= 1;", why="x"))
        self.assertEqual((code, errors), (1, "waivers.toml: stale, reached or missing: b/m.sv: b_q <= 1;\n"))

    def test_a_file_that_no_program_contains_is_reported(self):
        self.data("one")
        self.assertEqual(self.run_tool()[::2], (1, "rtl/b/m.sv: in no coverage program\n"))


if __name__ == "__main__":
    unittest.main()
