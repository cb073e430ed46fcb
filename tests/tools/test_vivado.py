"""tools/vivado: its outputs are up to date, and follow the address map, the sources and the ports."""

import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tools"))
from rtl_list import gated_clocks  # noqa: E402


class Generated(unittest.TestCase):
    def setUp(self):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.root = pathlib.Path(scratch.name)
        for folder in ("rtl", "tools/reggen"):
            shutil.copytree(ROOT / folder, self.root / folder)
        for file in ("vivado", "vivado_xdc.py", "rtl_list.py"):
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
        self.edit(
            "rtl/vivado/carrier.toml", "step = ", 'door_n = "BANK13_LVDS_5_N BANK13_LVDS_6..6 BANK13_SE_0"\nstep = '
        )
        self.assertEqual(self.run_tool("--check").stderr.count("stale: "), 3)
        self.run_tool()
        self.assertIn("input  wire [3:0] door_n,", self.text("arm_soc_ip.v"))
        self.assertRegex(self.text("arm_soc_ip.v"), r"\.door_ni +\(door_n\)")
        self.assertRegex(self.text("microzed.tcl"), r"pwm[\s\\]+door_n ")
        self.assertRegex(self.text("microzed.xdc"), r"PACKAGE_PIN V5 .*\[get_ports \{door_n\[3\]\}\]")
        self.assertIn("# Door.\nset_property PULLTYPE PULLDOWN [get_ports {door_n[*]}]\n", self.text("microzed.xdc"))

    def test_a_block_out_of_the_reach_of_the_processor_is_refused(self):
        self.edit("rtl/soc/soc_map.toml", "base = 0x4120_0000", "base = 0x8120_0000")
        result = self.run_tool()
        self.assertEqual(result.returncode, 1)
        self.assertIn("is not within M_AXI_GP0 of the Zynq", result.stderr)

    def test_a_port_in_another_form_is_refused(self):
        self.edit("rtl/soc/arm_soc.sv", "  output logic [5:0]  active_o,", "  output wire [5:0] active_o,")
        self.assertIn("a port is not written as", self.run_tool().stderr)

    def test_a_top_without_the_pins_is_refused(self):
        self.edit("rtl/soc/arm_soc.sv", '`include "arm_soc_pins.svh"', "  output logic step_o")
        self.assertIn("the list of ports does not include arm_soc_pins.svh", self.run_tool().stderr)

    def refused_carrier(self, old, new):
        self.edit("rtl/vivado/carrier.toml", old, new)
        result = self.run_tool()
        self.assertEqual(result.returncode, 1)
        return result.stderr

    def test_a_pin_without_a_net_is_refused(self):
        self.assertIn("pwm has 1 bits and 0 nets", self.refused_carrier('pwm = "BANK13_LVDS_4_N"\n', ""))

    def test_a_net_of_two_pins_is_refused(self):
        message = self.refused_carrier('pwm = "BANK13_LVDS_4_N"', 'pwm = "BANK13_LVDS_4_P"')
        self.assertIn("has no free net BANK13_LVDS_4_P", message)

    def test_a_net_without_a_pin_is_refused(self):
        self.assertIn("arm_soc has no pin fan", self.refused_carrier("pwm =", 'fan = "BANK13_SE_0"\npwm ='))


class Constraints(unittest.TestCase):
    """Every pin of the wrapper in rtl/vivado has its constraints."""

    def setUp(self):
        folder = ROOT / "rtl/vivado"
        self.xdc = re.sub(r"\s*\\\n\s*", " ", (folder / "microzed.xdc").read_text())
        wrapper = (folder / "arm_soc_ip.v").read_text()
        design = re.sub(r"\\\n", " ", (folder / "microzed.tcl").read_text())
        external = re.search(r"foreach pin \[list ([^\]]*)\]", design)[1].split()
        self.pins = {}  # name -> (direction, number of bits)
        for direction, msb, name in re.findall(
            r"^  (input|output) +wire (?:\[(\d+):0\] )?(\w+)", wrapper, re.MULTILINE
        ):
            if name in external:
                self.pins[name] = (direction, int(msb or 0) + 1)
        self.assertEqual(set(self.pins), set(external))

    def names(self, direction):
        return {name for name, (found, _) in self.pins.items() if found == direction}

    def ports_of(self, command):
        """The ports that a command lists, without the suffix of all bits."""
        found = re.search(rf"^{command} \[get_ports \[list ([^\n]*)\]\]$", self.xdc, re.MULTILINE)
        return set(re.sub(r"[{}]|\[\*\]", "", found[1]).split())

    def test_every_bit_has_its_own_package_pin_and_a_standard(self):
        placed = re.findall(
            r"^set_property -dict \{PACKAGE_PIN (\w+) +IOSTANDARD (\w+)\} \[get_ports \{([^}]*)\}\]",
            self.xdc,
            re.MULTILINE,
        )
        bits = {
            name if width == 1 else f"{name}[{bit}]" for name, (_, width) in self.pins.items() for bit in range(width)
        }
        self.assertEqual({bit for _, _, bit in placed}, bits)
        self.assertEqual(len({pin for pin, _, _ in placed}), len(bits))
        self.assertEqual({standard for _, standard, _ in placed}, {"LVCMOS33"})

    def test_every_input_has_a_limited_delay_and_every_output_a_delay(self):
        self.assertEqual(self.ports_of("set_max_delay -datapath_only 10 -from"), self.names("input"))
        self.assertEqual(self.ports_of("set_output_delay -clock clk_fpga_0 -max 5"), self.names("output"))
        self.assertEqual(self.ports_of("set_output_delay -clock clk_fpga_0 -min 0"), self.names("output"))

    def test_every_synchroniser_is_found_by_its_name(self):
        marked = 'ASYNC_REG = "TRUE"'
        for path in (ROOT / "rtl").glob("*/*.sv"):
            for line in path.read_text().splitlines():
                # The flops of encoder_switch are no synchroniser: that of the decoder follows.
                if marked in line and path.stem != "encoder_switch":
                    self.assertRegex(line, r"first_q, (\w+_)?second_q;", path.name)

    def test_the_flops_of_step_and_dir_are_in_the_pads(self):
        self.assertEqual(self.ports_of("set_property IOB TRUE"), {"step", "dir"})
        for path in ("pulse_train/pulse_gen.sv", "pulse_width/pulse_width_gen.sv"):
            text = (ROOT / "rtl" / path).read_text()
            for port in ("step_o", "dir_o"):
                self.assertRegex(text, rf'\(\* IOB = "TRUE" \*\)\n  output logic +{port},')

    def test_the_gated_clocks_are_the_clock(self):
        wrapper = (ROOT / "rtl/vivado/arm_soc_ip.v").read_text()
        self.assertEqual(set(re.findall(r"\.clk_\w*i +\((\w+)\)", wrapper)), {"clk"})
        self.assertEqual(len(re.findall(r"\.clk_\w*i +\(clk\)", wrapper)), 1 + len(gated_clocks(ROOT)))


if __name__ == "__main__":
    unittest.main()
