"""tools/vivado: its outputs are up to date, and follow the address map, the sources and the ports."""

import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]


class Generated(unittest.TestCase):
    def setUp(self):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.root = pathlib.Path(scratch.name)
        for folder in ("rtl", "tools/reggen"):
            shutil.copytree(ROOT / folder, self.root / folder)
        for file in ("vivado", "rtl_list.py"):
            shutil.copy(ROOT / "tools" / file, self.root / "tools" / file)

    def run_tool(self, *options):
        return subprocess.run(
            [sys.executable, "-B", self.root / "tools/vivado", *options], capture_output=True, text=True, check=False
        )

    def edit(self, path, old, new):
        text = (self.root / path).read_text()
        self.assertIn(old, text)
        (self.root / path).write_text(text.replace(old, new, 1))

    def text(self, name):
        return (self.root / "rtl/vivado" / name).read_text()

    def test_the_repository_is_up_to_date(self):
        result = self.run_tool("--check")
        self.assertEqual((result.returncode, result.stderr), (0, ""))

    def test_a_moved_block_makes_the_design_stale_and_moves_there(self):
        self.edit("rtl/soc/soc_map.toml", "base = 0x4120_0000", "base = 0x4400_0000")
        result = self.run_tool("--check")
        self.assertEqual(
            (result.returncode, result.stderr), (1, "stale: rtl/vivado/microzed.tcl (run `tools/vivado`)\n")
        )
        self.assertEqual(self.run_tool().returncode, 0)
        self.assertIn("0x44000000  axi_gpio, irq[2] = interrupt 63", self.text("microzed.tcl"))
        self.assertIn("-offset 0x40000000 -range 0x8000000 ", self.text("microzed.tcl"))
        self.assertEqual(self.run_tool("--check").returncode, 0)

    def test_a_new_pin_reaches_every_file(self):
        self.edit(
            "rtl/soc/soc_map.toml",
            '  { name = "trigger",',
            '  { name = "door", dir = "in", bits = 4, '
            'active_low = true, pull = "down", desc = "Door" },\n  { name = "trigger",',
        )
        self.assertEqual(self.run_tool("--check").stderr.count("stale: "), 3)
        self.run_tool()
        self.assertIn("input  wire [3:0] door_n,", self.text("arm_soc_ip.v"))
        self.assertRegex(self.text("arm_soc_ip.v"), r"\.door_ni +\(door_n\)")
        self.assertRegex(self.text("microzed.tcl"), r"pwm[\s\\]+door_n ")
        self.assertIn("[get_ports {door_n[3]}", self.text("microzed.xdc"))
        self.assertIn("# Door.\nset_property PULLTYPE PULLDOWN [get_ports {door_n[*]}]\n", self.text("microzed.xdc"))

    def test_a_block_out_of_the_reach_of_the_processor_is_refused(self):
        self.edit("rtl/soc/soc_map.toml", "base = 0x4120_0000", "base = 0x8120_0000")
        result = self.run_tool()
        self.assertEqual(result.returncode, 1)
        self.assertIn("is not within M_AXI_GP0 of the Zynq", result.stderr)

    def test_a_port_in_another_form_is_refused(self):
        self.edit("rtl/soc/arm_soc.sv", "  output logic [2:0]  active_o,", "  output wire [2:0] active_o,")
        self.assertIn("a port is not written as", self.run_tool().stderr)

    def test_a_top_without_the_pins_is_refused(self):
        self.edit("rtl/soc/arm_soc.sv", '`include "arm_soc_pins.svh"', "  output logic step_o")
        self.assertIn("the list of ports does not include arm_soc_pins.svh", self.run_tool().stderr)


if __name__ == "__main__":
    unittest.main()
