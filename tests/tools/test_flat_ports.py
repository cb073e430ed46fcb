"""tools/flat_ports.py: every form of a port, and that nothing else is taken for one."""

import pathlib
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tools"))
from flat_ports import flat_module, has_struct_ports  # noqa: E402

HEADER = """
typedef struct packed {
  logic [2*8-1:0] data;  // logic [3:0] not_this;
  logic           valid;
} to_left_t;
"""
MODULE = """
// module before (input to_left_t no);
`include "types.svh"
module block #(
  parameter int Count = 2
) (
  input  logic                clk_i,  // output to_left_t no
  input  to_left_t            bus_i,
  input  logic signed [3:0]   level_i,
  output logic [Count*ToLeftBits-1:0] all_o,
  output to_left_t            hw2reg_o
);
endmodule
"""


class Flat(unittest.TestCase):
    def setUp(self):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.folders = [pathlib.Path(scratch.name)]
        (self.folders[0] / "types.svh").write_text(HEADER)

    def test_each_member_is_a_port_called_after_its_bus(self):
        text = flat_module(MODULE, self.folders)
        ports = [" ".join(line.strip(" ,").split()) for line in text.splitlines() if "put logic" in line]
        self.assertEqual(
            ports,
            [
                "input logic clk_i",
                "input logic [15:0] bus_data_i",
                "input logic bus_valid_i",
                "input logic [3:0] level_i",
                "output logic [Count*16-1:0] all_data_o",
                "output logic [Count*1-1:0] all_valid_o",
                "output logic [15:0] data_o",
                "output logic valid_o",
            ],
        )

    def test_members_are_where_the_struct_has_them(self):
        text = flat_module(MODULE, self.folders)
        for line in (
            "module block_flat #(",
            "assign bus_i[1 +: 16] = bus_data_i;",
            "assign bus_i[0 +: 1] = bus_valid_i;",
            "assign all_data_o[i*16 +: 16] = all_o[i*17+1 +: 16];",
            "assign valid_o = hw2reg_o[0 +: 1];",
            "block #(.Count(Count)) u_flat (.*);",
        ):
            self.assertIn(line, text)

    def test_a_module_without_struct_ports_is_told_apart(self):
        self.assertTrue(has_struct_ports(MODULE, self.folders))
        self.assertFalse(has_struct_ports("module block (\n  input logic clk_i\n);\nendmodule\n", self.folders))

    def test_an_unknown_type_is_refused(self):
        with self.assertRaisesRegex(ValueError, "port bus_i: unknown type other_t"):
            flat_module(MODULE.replace("to_left_t            bus_i", "other_t bus_i"), self.folders)


if __name__ == "__main__":
    unittest.main()
