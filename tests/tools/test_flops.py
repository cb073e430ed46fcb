"""tools/flops finds the signals of a model of the installed Verilator, by the names of the design."""

import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]

TWO_COUNTERS = """
module counter #(parameter int W = 4) (input logic clk, input logic up, output logic [W-1:0] count_o);
  always_ff @(posedge clk) if (up) count_o <= count_o + 1'b1;
endmodule
module top (input logic clk, input logic up, output logic [5:0] sum_o, output logic [7:0] last_o);
  assign last_o = entry_q[2];
  logic [3:0] counts [2];
  logic [7:0] entry_q [3];
  for (genvar i = 0; i < 2; i++) begin : g_axis
    counter u_counter (.clk, .up(up ^ sum_o[i]), .count_o(counts[i]));
  end
  always_ff @(posedge clk) begin
    sum_o <= counts[0] + counts[1];
    entry_q[2] <= entry_q[1] ^ {2'b0, sum_o};
    entry_q[1] <= entry_q[0];
    entry_q[0] <= {4'b0, counts[0]};
  end
endmodule
"""


class Flops(unittest.TestCase):
    def header(self, *options):
        with tempfile.TemporaryDirectory() as scratch:
            folder = pathlib.Path(scratch)
            (folder / "top.sv").write_text(TWO_COUNTERS)
            verilator = ["verilator", "--cc", *options, "--no-timing", "-Wno-fatal", "--top-module", "top"]
            verilator += ["--prefix", "V", "-Mdir", "model", "top.sv"]
            subprocess.run(verilator, cwd=folder, check=True, capture_output=True)
            target = folder / "flops.hpp"
            subprocess.run([sys.executable, "-B", ROOT / "tools/flops", folder / "model", "V", target], check=True)
            return target.read_text()

    def test_names_bits_and_elements_are_those_of_the_design(self):
        text = self.header("-O3")
        self.assertIn("kKnown = true", text)
        places = {name: tuple(map(int, size)) for name, *size in re.findall(r'\{"([^"]+)".*, (\d+), (\d+)\},', text)}
        self.assertEqual(places["sum_o"], (6, 1))
        self.assertEqual(places["entry_q"], (8, 3))
        self.assertEqual(places["g_axis[0].u_counter.count_o"], (4, 1))
        self.assertEqual(places["g_axis[1].u_counter.count_o"], (4, 1))
        self.assertFalse([name for name in places if "__" in name])

    def test_a_model_with_a_class_for_each_module_is_left_out(self):
        self.assertNotIn("kKnown", self.header("-O0"))


if __name__ == "__main__":
    unittest.main()
