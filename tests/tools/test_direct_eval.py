"""tools/direct_eval reads the clocks of a model of the installed Verilator, and leaves models of another form to eval()."""

import pathlib
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]

TWO_CLOCKS = """
module top (input logic b_clk, input logic a_clk, input logic d, output logic q, output logic p);
  always_ff @(posedge a_clk) q <= d;
  always_ff @(posedge b_clk) p <= q;
endmodule
"""


class DirectEval(unittest.TestCase):
    def header(self, source, edit=lambda text: text):
        with tempfile.TemporaryDirectory() as scratch:
            folder = pathlib.Path(scratch)
            (folder / "top.sv").write_text(source)
            verilator = ["verilator", "--cc", "-O3", "--no-timing", "--prefix", "V", "-Mdir", "model", "top.sv"]
            subprocess.run(verilator, cwd=folder, check=True, capture_output=True)
            for path in (folder / "model").glob("*.cpp"):
                path.write_text(edit(path.read_text()))
            target = folder / "direct.hpp"
            tool = [sys.executable, "-B", ROOT / "tools/direct_eval", folder / "model", "V", target]
            subprocess.run(tool, check=True)
            return target.read_text()

    def test_each_clock_evaluates_its_own_flops(self):
        text = self.header(TWO_CLOCKS)
        self.assertIn("kKnown = true", text)
        self.assertRegex(text, r"evaluate\(model.rootp, clocks\.\w_clk\(\), clocks\.\w_clk\(\)\);")
        self.assertIn("if (rises0) {", text)
        self.assertIn("if (rises1) {", text)

    def test_logic_behind_an_input_pin_is_left_to_eval(self):
        text = self.header(TWO_CLOCKS.replace("p <= q;", "p <= q;\n  assign r = d ^ q;").replace("p)", "p, output r)"))
        self.assertNotIn("kKnown", text)
        self.assertIn("evaluated by eval(): an input pin drives logic", text)

    def test_a_falling_edge_is_left_to_eval(self):
        text = self.header(TWO_CLOCKS.replace("posedge a_clk", "negedge a_clk"))
        self.assertIn("a trigger that is not a rising edge of a pin", text)

    def test_a_model_without_the_names_is_left_to_eval(self):
        text = self.header(TWO_CLOCKS, lambda model: model.replace("eval_triggers__act", "eval_all"))
        self.assertIn("no function V___024root___eval_triggers__act", text)


if __name__ == "__main__":
    unittest.main()
