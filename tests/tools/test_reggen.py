"""tools/reggen: goldens and lint of an example block, its simulation against seeded faults, and every message.

The example under tests/tools/reggen uses every access kind. Its goldens are rewritten by
`python3 tools/reggen --root tests/tools/reggen`.
"""

import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import tomllib
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
HEADERS = ROOT / "rtl/common"
EXAMPLE = pathlib.Path(__file__).resolve().parent / "reggen"
TESTBENCH = pathlib.Path(__file__).resolve().parent / "reg_top_tb.sv"
sys.path.insert(0, str(ROOT / "tools"))
from flat_ports import flat_module  # noqa: E402

REGS = "rtl/example/example_regs.toml"
SOC = "rtl/soc/soc_map.toml"


def run(*command):
    return subprocess.run([str(word) for word in command], capture_output=True, text=True, check=False)


def reggen(root, *options):
    return run(sys.executable, ROOT / "tools/reggen", "--root", root, *options)


class TreeTest(unittest.TestCase):
    """Works on a copy of the example tree."""

    def setUp(self):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.root = pathlib.Path(scratch.name) / "tree"
        shutil.copytree(EXAMPLE, self.root)

    def edit(self, path, old, new):
        """Replaces the first `old`, which must be there."""
        text = (self.root / path).read_text()
        self.assertIn(old, text, path)
        (self.root / path).write_text(text.replace(old, new, 1))


class Check(TreeTest):
    def test_repository_is_up_to_date(self):
        result = reggen(ROOT, "--check")
        self.assertEqual((result.returncode, result.stderr), (0, ""))

    def test_tick_cycles_resets_to_the_trigger_period(self):
        """The pulse distribution and the tick timer state the same tick, in two maps."""
        with open(ROOT / SOC, "rb") as file:
            period = tomllib.load(file)["tick_cycles"]
        with open(ROOT / "rtl/pulse_train/pulse_train_regs.toml", "rb") as file:
            register = next(r for r in tomllib.load(file)["register"] if r["name"] == "tick_cycles")
        self.assertEqual(register["fields"][0]["reset"], period)

    def test_example_equals_its_golden(self):
        result = reggen(EXAMPLE, "--check")
        self.assertEqual((result.returncode, result.stderr), (0, ""))

    def test_the_tick_is_the_same_in_both_maps(self):
        soc = tomllib.loads((ROOT / "rtl/soc/soc_map.toml").read_text())
        block = tomllib.loads((ROOT / "rtl/pulse_train/pulse_train_regs.toml").read_text())
        resets = [reg["fields"][0]["reset"] for reg in block["register"] if reg["name"] == "tick_cycles"]
        self.assertEqual(resets, [soc["tick_cycles"]])

    def test_an_edited_output_is_stale_until_generated_again(self):
        for path, word in (("rtl/example/example_reg_top.sv", "example"), ("rtl/REGISTERS.md", "example"),
                           ("rtl/common/example_reg_types.svh", "example"),
                           ("controller/regs/example_regs.hpp", "example"), ("rtl/common/example_soc_pins.svh", "door"),
                           ("cosim/fabric/pins.hpp", "door"), ("cosim/fabric/pin_list.hpp", "door"),
                           ("cosim/fabric/model_pins.hpp", "door"), ("tools/example_soc.gtkw", "door")):
            with self.subTest(path):
                self.edit(path, word, word.capitalize())
                result = reggen(self.root, "--check")
                self.assertEqual(result.returncode, 1)
                self.assertEqual(result.stderr, f"stale: {path} (run `python3 tools/reggen`)\n")
                self.assertEqual(reggen(self.root).stdout, f"wrote {path}\n")
                self.assertEqual(reggen(self.root, "--check").returncode, 0)

    def test_an_edited_map_makes_all_its_outputs_stale(self):
        self.edit(REGS, "reset = 7", "reset = 8")
        result = reggen(self.root, "--check")
        self.assertEqual(result.returncode, 1)
        self.assertEqual(result.stderr.count("stale: "), 4)  # package, register file, header, table

    def test_a_new_pin_makes_every_list_of_pins_stale(self):
        self.edit(SOC, '  { name = "lamp"', '  { name = "horn", dir = "out", desc = "Horn" },\n  { name = "lamp"')
        result = reggen(self.root, "--check")
        self.assertEqual(result.returncode, 1)
        self.assertEqual(result.stderr.count("stale: "), 6)  # ports, structs, list, wiring, view, table
        self.assertEqual(reggen(self.root).returncode, 0)
        for path, text in (("rtl/common/example_soc_pins.svh", "output logic        horn_o,"),
                           ("cosim/fabric/pins.hpp", "bool horn = false;"), ("rtl/REGISTERS.md", "| horn_o"),
                           ("cosim/fabric/pin_list.hpp", '<&FabricOutputs::horn>("horn_o", 1)'),
                           ("cosim/fabric/model_pins.hpp", "out.horn = model.horn_o != 0;"),
                           ("tools/example_soc.gtkw", "+{horn_o} top.horn_o")):
            self.assertIn(text, (self.root / path).read_text())

    def test_the_rest_of_a_view_stays_as_it_is(self):
        view = self.root / "tools/example_soc.gtkw"
        self.edit("tools/example_soc.gtkw", "top.clk_i\n", "top.clk_i\n@28\ntop.mine\n")
        mine = view.read_text()
        self.assertEqual(reggen(self.root).stdout, "")
        self.assertEqual(view.read_text(), mine)

    def test_a_view_without_a_place_for_the_pins_is_refused(self):
        for path in ("", "[*] Every pin, written by tools/reggen.\n"):
            (self.root / "tools/example_soc.gtkw").write_text(path)
            result = reggen(self.root)
            self.assertEqual(result.returncode, 2)
            self.assertEqual(result.stderr, "reggen: tools/example_soc.gtkw: expected a line `[*] Every pin, written by "
                             "tools/reggen.` and below it a line `[*] End of the pins.`\n")

    def test_below_a_limit_nothing_is_an_error(self):
        self.edit(REGS, 'name = "example"', 'name = "example"\nno_error_below = 0x100')
        self.assertEqual(reggen(self.root).returncode, 0)
        text = (self.root / "rtl/example/example_reg_top.sv").read_text()
        for line in ("default: werr_q <= waddr[15:8] != '0;", "rdata_q <= raddr[15:8] != '0 ? 32'hBADACCE5 : 32'b0;",
                     "rerr_q  <= raddr[15:8] != '0;"):
            self.assertIn(line, text)
        self.assertIn("Words below 0x100 without a register read 0", (self.root / "rtl/REGISTERS.md").read_text())

    def test_a_missing_output_is_stale(self):
        (self.root / "rtl/soc/soc_map_pkg.sv").unlink()
        result = reggen(self.root, "--check")
        self.assertEqual(result.returncode, 1)
        self.assertIn("stale: rtl/soc/soc_map_pkg.sv", result.stderr)

    def test_outputs_of_a_removed_map_are_stale_and_go_but_hand_written_files_stay(self):
        gone = self.root / "controller/regs/gone_regs.hpp"
        kept = self.root / "controller/regs/kept_regs.hpp"
        gone.write_text("// Generated by tools/reggen from rtl/gone/gone_regs.toml; do not edit.\n")
        kept.write_text("// Written by hand.\n")
        result = reggen(self.root, "--check")
        self.assertEqual(result.returncode, 1)
        self.assertIn("stale: controller/regs/gone_regs.hpp", result.stderr)
        self.assertEqual(reggen(self.root).stdout, "removed controller/regs/gone_regs.hpp\n")
        self.assertFalse(gone.exists())
        self.assertTrue(kept.exists())


# What is changed in which file, and the whole message.
MESSAGES = [
    (REGS, 'bits = "0",    access = "rw"', 'bits = "4",    access = "rw"',
     "register ctrl: field limit (bits 19:4) overlaps field enable (bits 4)"),
    (REGS, 'bits = "31",', 'bits = "32",', 'register ctrl, field run: bits "32" are outside 0..31'),
    (REGS, 'bits = "19:4"', 'bits = "4:19"', 'register ctrl, field limit: bits "4:19": msb is below lsb'),
    (REGS, 'bits = "19:4"', 'bits = "19-4"',
     'register ctrl, field limit: bits "19-4" is neither "bit" nor "msb:lsb"'),
    (REGS, "reset = 0xBEEF", "reset = 0x1_0000",
     "register ctrl, field limit: reset 65536 does not fit in 16 bits (0..65535)"),
    (REGS, "reset = 0xBEEF", "reset = -1", "register ctrl, field limit: reset -1 does not fit in 16 bits (0..65535)"),
    (REGS, "reset = -5", "reset = 2048",
     "register gain, field value: reset 2048 does not fit in 12 bits (-2048..2047)"),
    (REGS, "reset = -5", "reset = -2049",
     "register gain, field value: reset -2049 does not fit in 12 bits (-2048..2047)"),
    (REGS, "reset = 0xBEEF, ", "", "register ctrl, field limit: missing key `reset` (access rw)"),
    (REGS, "reset = 0x4558, ", "", "register id, field block: missing key `reset` (access const)"),
    (REGS, 'access = "ro", desc = "Live', 'access = "ro", reset = 0, desc = "Live',
     "register status, field busy: `reset` is not for access ro"),
    (REGS, 'access = "w1c"', 'access = "rc"',
     "register event, field over: unknown access `rc` (one of rw, ro, const, w1c, pulse)"),
    (REGS, 'unit = "mV"', 'units = "mV"', "register status, field level: unknown key `units`"),
    (REGS, "strobe = true", "strobes = true", "register go: unknown key `strobes`"),
    (REGS, 'name = "example"', 'name = "example"\nversion = 1', "unknown key `version`"),
    (REGS, 'name = "example"', 'name = "example"\nno_error_below = 0x180',
     "no_error_below 0x180 is not a power of two below 0x10000"),
    (REGS, 'desc = "Read only"\n', "", "register status: missing key `desc`"),
    (REGS, "offset = 0x08", 'offset = "0x08"', "register status: `offset` must be of type int, is '0x08'"),
    (REGS, "strobe = true", "strobe = 1", "register go: `strobe` must be of type bool, is 1"),
    (REGS, "offset = 0x08", "offset = 0x0A", "register status: offset 0xA is not a multiple of 4"),
    (REGS, "offset = 0x4C", "offset = 0x1_0000",
     "register probe: offset 0x10000 is outside the 16 address bits of a block"),
    (REGS, "offset = 0x4C", "offset = -4", "register probe: offset -0x4 is outside the 16 address bits of a block"),
    (REGS, "offset = 0x20", "offset = 0x24",
     "register gain: offset 0x24: an array of 3 starts at a multiple of 0x10, "
     "so that its index is a slice of the address"),
    (REGS, "count = 3", "count = 1", "register gain: count 1 is below 2"),
    (REGS, "external = true", "external = true\nstrobe = true",
     "register core: an external register has neither `count` nor `strobe`"),
    (REGS, 'desc = "Read only"', 'desc = "Read only"\nstrobe = true', "register status: `strobe` needs a rw field"),
    (REGS, "offset = 0x08", "offset = 0x04", "register status (0x4) overlaps register ctrl (0x4..0x7)"),
    (REGS, "offset = 0x18", "offset = 0x24", "register mixed (0x24) overlaps register gain (0x20..0x2B)"),
    (REGS, 'name = "status"', 'name = "ctrl"', "duplicate register `ctrl`"),
    (REGS, 'name = "level", bits', 'name = "busy", bits', "register status: duplicate field `busy`"),
    (REGS, 'name = "sequence"', 'name = "we"', "duplicate member `go_we`"),
    (REGS, 'name = "busy",  bits', 'name = "offset", bits', "duplicate constant `StatusOffset`"),
    (REGS, 'name = "level"\noffset = 0x30\ncount = 2\ndesc = "Array of ro"\nfields = [{ name = "value"',
     'name = "level"\noffset = 0x30\ncount = 2\ndesc = "Array of ro"\nfields = [{ name = "count"',
     "duplicate constant `LevelCount`"),
    (REGS, 'name = "status"', 'name = "Status"', "register Status: name `Status` is not snake_case"),
    (REGS, 'name = "example"', 'name = "sample"',
     "name `sample` does not match the file, expected rtl/sample/sample_regs.toml"),
    (REGS, 'fields = [{ name = "sequence"', 'fields = [1, { name = "sequence"',
     "register go: `fields` must be a list of tables with at least one element"),
    (SOC, "size = 0x1000", "size = 0x1800", "block right: size 0x1800 is not a power of two of at least 4"),
    (SOC, "size = 0x1_0000", "size = 0x2_0000",
     "block left: size 0x20000 is above the 0x10000 that a register file decodes"),
    (SOC, "size = 0x1000", "size = 0x40", "block right: size 0x40 does not hold register fire (0x54)"),
    (SOC, "base = 0x4001_0000", "base = 0x4001_8000", "block left: base 0x40018000 is not a multiple of size 0x10000"),
    (SOC, "base = 0x4001_0000", "base = 0x1_0000_0000",
     "block left: base 0x100000000 is outside the 32-bit address space"),
    (SOC, "base = 0x4000_0000", "base = 0x4001_F000",
     "block right (base 0x4001F000) overlaps block left (0x40010000, size 0x10000)"),
    (SOC, "size = 0x1000\n", "size = 0x1000\nirq = 2\n", "block right: irq 2 is already used by block left"),
    (SOC, "irq = 2", "irq = 32", "block left: irq 32 is outside 0..31"),
    (SOC, 'name = "right"', 'name = "left"', "duplicate block `left`"),
    (SOC, 'regs = "example"', 'regs = "sample"', "block left: `regs`: rtl/sample/sample_regs.toml does not exist"),
    (SOC, "tick_cycles = 2_500", "tick_cycles = 0", "tick_cycles 0 is outside 1..2^31-1"),
    (SOC, "irq = 2", "irqs = 2", "block left: unknown key `irqs`"),
    (SOC, "num_axes = 6\n", "", "missing key `num_axes`"),
    (SOC, "num_axes = 6", "num_axes = 0", "num_axes 0 is outside 1..32"),
    (SOC, 'name = "line", dir = "in"', 'name = "line", dir = "inout"', "pin line: `dir`: inout is none of in, out"),
    (SOC, 'name = "line", dir = "in", ', 'name = "line", ', "pin line: missing key `dir`"),
    (SOC, 'name = "line"', 'name = "Line"', "pin Line: name `Line` is not snake_case"),
    (SOC, 'name = "line"', 'name = "clk"', "pin clk: the clocks, the reset and the bus are no pins"),
    (SOC, 'name = "line"', 'name = "s_axi_line"', "pin s_axi_line: the clocks, the reset and the bus are no pins"),
    (SOC, 'per = "axis"', 'per = "joint"', "pin probe: `per`: joint is none of axis, irq"),
    (SOC, 'per = "axis"', 'per = "axis", bits = 6', "pin probe: `bits` is not for a pin with `per`, which has 6"),
    (SOC, "irq = 2\n", "", "pin irq: `per`: no block raises an irq"),
    (SOC, "bits = 17", "bits = 33", "pin data: bits 33 is outside 1..32"),
    (SOC, "bits = 17", "bits = 0", "pin data: bits 0 is outside 1..32"),
    (SOC, "bits = 17", 'bits = "17"', "pin data: `bits` must be of type int, is '17'"),
    (SOC, "bits = 17", "width = 17", "pin data: unknown key `width`"),
    (SOC, "idle = 1, pull", "idle = 2, pull", "pin line: idle 2 is neither 0 nor 1"),
    (SOC, 'pull = "up"', 'pull = "high"', "pin line: `pull`: high is none of up, down"),
    (SOC, 'dir = "out", active_low = true', 'dir = "out", active_low = 1',
     "pin lamp: `active_low` must be of type bool, is 1"),
    (SOC, 'dir = "out", active_low = true', 'dir = "out", pull = "up"', "pin lamp: `pull` is for inputs"),
    (SOC, ', desc = "Lamp"', "", "pin lamp: missing key `desc`"),
    (SOC, 'name = "line"', 'name = "probe"', "duplicate pin `probe_i`"),
    (SOC, 'name = "line"', 'name = "door_n"', "duplicate input pin `door_n`"),
    (SOC, 'group = "Outputs"', 'group = "Inputs"', "duplicate group of pins `Inputs`"),
    (SOC, 'group = "Outputs"\n', "", "pins of ?: missing key `group`"),
    (SOC, 'name = "lamp", dir = "out"', 'name = "lamp", dir = "out", bits = 30',
     "the output pins have 65 bits, at most 64 are compared in each clock"),
]


class Messages(TreeTest):
    def test_each_broken_rule_names_file_place_and_reason(self):
        for path, old, new, message in MESSAGES:
            with self.subTest(message):
                original = (self.root / path).read_text()
                self.edit(path, old, new)
                result = reggen(self.root, "--check")
                (self.root / path).write_text(original)
                self.assertEqual(result.stderr, f"reggen: {path}: {message}\n")
                self.assertEqual(result.returncode, 2)

    def test_broken_toml_names_file_and_line(self):
        (self.root / REGS).write_text('name = "example"\ndesc =\n')
        result = reggen(self.root)
        self.assertEqual(result.returncode, 2)
        self.assertIn(f"reggen: {REGS}: ", result.stderr)
        self.assertIn("at line 2", result.stderr)

    def test_a_missing_address_map_is_named(self):
        (self.root / SOC).unlink()
        self.assertEqual(reggen(self.root).stderr, f"reggen: {SOC}: file not found\n")

    def test_nothing_is_written_from_a_broken_map(self):
        self.edit(REGS, "reset = 7", "reset = 256")
        (self.root / "rtl/REGISTERS.md").unlink()
        self.assertEqual(reggen(self.root).returncode, 2)
        self.assertFalse((self.root / "rtl/REGISTERS.md").exists())


class Lint(unittest.TestCase):
    """Every generated file of the example and of the repository, in the tools that must read it."""

    @staticmethod
    def register_files():
        found = [*EXAMPLE.glob("rtl/*/*_reg_top.sv"), *sorted(ROOT.glob("rtl/*/*_reg_top.sv"))]
        return [(path, [f"-I{path.parents[1] / 'common'}", f"-I{HEADERS}",
                        path.with_name(path.name.replace("_top", "_pkg")), path]) for path in found]

    def accept(self, *command):
        result = run(*command)
        self.assertEqual((result.returncode, result.stdout + result.stderr), (0, ""))

    def test_verilator(self):
        for top, sources in self.register_files():
            with self.subTest(top.stem):
                self.accept("verilator", "--lint-only", "-Wall", "-fno-const-bit-op-tree", "--top-module", top.stem,
                            *sources)

    def test_yosys(self):
        for top, sources in self.register_files():
            with self.subTest(top.stem):
                read = " ".join(str(source) for source in [*sources, EXAMPLE / "rtl/soc/soc_map_pkg.sv"])
                script = f"read_verilog -sv {read}; hierarchy -check -top {top.stem}; proc; check -assert"
                self.accept("yosys", "-q", "-e", "implicitly declared", "-p", script)

    def test_icarus(self):
        for top, sources in self.register_files():
            with self.subTest(top.stem):
                self.accept("iverilog", "-g2012", "-Wall", "-o", "/dev/null", *sources)

    def test_the_pins_stand_in_a_list_of_ports(self):
        with tempfile.TemporaryDirectory() as scratch:
            top = pathlib.Path(scratch) / "top.sv"
            top.write_text('module top (\n  input logic clk_i,\n`include "example_soc_pins.svh"\n);\n'
                           "  assign data_o = {15'b0, data_i};\n  assign lamp_no = ^{clk_i, door_ni, line_i};\n"
                           "  assign irq_o = probe_i[2:0] ^ probe_i[5:3];\nendmodule\n")
            include = EXAMPLE / "rtl/common"
            self.accept("verilator", "--lint-only", "-Wall", f"-I{include}", top)
            self.accept("yosys", "-q", "-p", f"read_verilog -sv -I{include} {top}; hierarchy -check -top top; check -assert")
            self.accept("iverilog", "-g2012", "-Wall", "-t", "null", "-I", include, top)

    def test_each_block_has_its_place_in_the_crossbar(self):
        """Of the repository, whose variants differ: port i of each variant claims the addresses of its block."""
        text = (ROOT / "rtl/soc/soc_map_pkg.sv").read_text()
        with open(ROOT / SOC, "rb") as file:
            blocks = tomllib.load(file)["block"]
        port = {name: int(value) for name, value in re.findall(r"localparam int +(\w+)Port += (\d+);", text)}
        self.assertEqual(len(port), len(blocks))
        for prefix, other in (("", "paper"), ("Paper", "counts")):
            base, mask = (re.search(rf" {prefix}Xbar{kind} = {{\n(.*?)}};", text, re.DOTALL)[1].replace(" ", "").split(",\n")[::-1]
                          for kind in ("Base", "Mask"))
            mine = [block for block in blocks if block.get("variant") != other]
            for block in mine:
                name = "".join(word.capitalize() for word in block["name"].split("_"))
                self.assertEqual(base[port[name]], f"{name}Base")
                self.assertEqual(int(mask[port[name]][4:].replace("_", ""), 16), 0x1_0000_0000 - block["size"])
            self.assertEqual([word for word in base if word.endswith("Base")], base[:len(mine)])
            self.assertEqual(set(mask[len(mine):]) | {"32'h0000_0000"}, {"32'h0000_0000"})

    def test_no_line_is_too_long(self):
        for tree in (EXAMPLE, ROOT):
            for path in [*tree.glob("rtl/*/*_reg_*.sv"), *tree.glob("rtl/soc/soc_map_pkg.sv"),
                         *tree.glob("rtl/common/*.svh"), *tree.glob("controller/regs/*.hpp"),
                         *tree.glob("cosim/fabric/*pin*.hpp")]:
                for number, line in enumerate(path.read_text().splitlines(), 1):
                    self.assertLessEqual(len(line), 120, f"{path}:{number}")


class Header(unittest.TestCase):
    CLAIMS = """
        #include "controller/regs/example_regs.hpp"
        #include "controller/regs/soc_map.hpp"
        using namespace armature::regs;
        static_assert(example::kCtrlOffset == 0x04 && example::kGainOffset == 0x20);
        static_assert(example::kGainCount == 3 && example::kGainStride == 4);
        static_assert(example::kCtrlLimitMask == 0x000FFFF0 && example::kCtrlLimit.mask() == example::kCtrlLimitMask);
        static_assert(example::kLevelValueMask == 0xFFFFFFFF && example::kLevelValue.mask() == 0xFFFFFFFF);
        static_assert(example::kCtrlLimitReset == 0xBEEF && example::kGainValueReset == -5);
        static_assert(soc::kLeftBase == 0x40010000 && soc::kLeftSize == 0x10000 && soc::kLeftIrq == 2);
        static_assert(soc::kRightBase == 0x40000000 && soc::kNumBlocks == 2 && soc::kNumIrqs == 3);
        static_assert(soc::kClkFreqHz == 50000000 && soc::kTickCycles == 2500 && soc::kNumAxes == 6);

        static_assert(extract(0x800A5A51, example::kCtrlLimit) == 0xA5A5);
        static_assert(extract(0x80000000, example::kCtrlRun) == 1);
        static_assert(extract(0x89ABCDEF, example::kLevelValue) == 0x89ABCDEF);
        static_assert(extract_signed(0xFFFFF7FF, example::kGainValue) == 2047);
        static_assert(extract_signed(0x00000FFB, example::kGainValue) == -5);
        static_assert(extract_signed(0x00000800, example::kGainValue) == -2048);
        static_assert(extract_signed(0xFFFFFFFF, example::kLevelValue) == -1);
        static_assert(extract_signed(0x00F00000, Field{.lsb = 20, .width = 4}) == -1);
        static_assert(insert(0xFFFFFFFF, example::kCtrlLimit, 0x12345A5A) == 0xFFF5A5AF);
        static_assert(insert(0, example::kLevelValue, 0x89ABCDEF) == 0x89ABCDEF);
        static_assert(insert_signed(0xFFFFF000, example::kGainValue, -5) == 0xFFFFFFFB);
        static_assert(insert_signed(0, Field{.lsb = 28, .width = 4}, -1) == 0xF0000000);
    """

    def test_constants_and_helpers_are_right_at_compile_time(self):
        with tempfile.TemporaryDirectory() as scratch:
            source = pathlib.Path(scratch) / "claims.cpp"
            source.write_text(self.CLAIMS)
            result = run("g++", "-std=c++20", "-Wall", "-Wextra", "-Wpedantic", "-Wconversion", "-Wsign-conversion",
                         "-Werror", "-fsyntax-only", f"-I{EXAMPLE}", f"-I{ROOT}", source)
            self.assertEqual((result.returncode, result.stderr), (0, ""))


class Pins(unittest.TestCase):
    """The structs, the list and the wiring of the example, with a stand-in for the verilated model."""

    PROGRAM = """
        #include "cosim/fabric/model_pins.hpp"
        #include "cosim/fabric/pin_list.hpp"
        #include <cassert>
        #include <type_traits>
        using namespace armature::cosim;
        struct Model {
          std::uint8_t door_ni = 9, line_i = 9, probe_i = 9;
          std::uint32_t data_i = 9, data_o = 0x80000001;
          std::uint8_t lamp_no = 1, irq_o = 5;
        };
        static_assert(FabricInputs{}.door_n && FabricInputs{}.line && FabricInputs{}.probe == 0);
        static_assert(FabricInputs{}.data == 0x1FFFF && FabricOutputs{}.data == 0 && FabricOutputs{}.lamp_n);
        static_assert(std::is_same_v<decltype(FabricInputs::probe), std::uint8_t>);
        static_assert(std::is_same_v<decltype(FabricInputs::door_n), bool>);
        static_assert(std::size(kPins) == 7 && kPins[0].name == "door_ni" && kPins[0].is_input() && kPins[0].bits == 1);
        static_assert(kPins[2].name == "probe_i" && kPins[2].bits == 6 && kPins[2].most() == 0x3F);
        static_assert(kPins[4].name == "data_o" && !kPins[4].is_input() && kPins[4].most() == 0xFFFFFFFF);
        int main() {
          Model model;
          drive_pins(model, {.door_n = false, .line = true, .probe = 0x2A, .data = 0x15555});
          assert(model.door_ni == 0 && model.line_i == 1 && model.probe_i == 0x2A && model.data_i == 0x15555);
          const FabricOutputs out = sample_pins(model);
          assert(out.data == 0x80000001 && out.lamp_n && out.irq == 5);
          FabricInputs in;
          kPins[3].set(in, 0x12345);
          assert(in.data == 0x12345 && kPins[3].get(in, out) == 0x12345 && kPins[6].get(in, out) == 5);
          for (int bit = 0; bit < 36; ++bit) {
            Model other = model;
            if (bit < 32) other.data_o ^= 1u << bit;
            else if (bit == 32) other.lamp_no ^= 1;
            else other.irq_o = static_cast<std::uint8_t>(other.irq_o ^ 1 << (bit - 33));
            assert(output_word(other) == (output_word(model) ^ std::uint64_t{1} << bit));
          }
        }
    """

    def test_levels_reach_their_ports_and_each_output_bit_counts(self):
        with tempfile.TemporaryDirectory() as scratch:
            source, program = pathlib.Path(scratch) / "pins.cpp", pathlib.Path(scratch) / "pins"
            source.write_text(self.PROGRAM)
            result = run("g++", "-std=c++20", "-Wall", "-Wextra", "-Wpedantic", "-Wconversion", "-Wsign-conversion",
                         "-Werror", f"-I{EXAMPLE}", f"-I{ROOT}", source, "-o", program)
            self.assertEqual((result.returncode, result.stderr), (0, ""))
            result = run(program)
            self.assertEqual((result.returncode, result.stderr), (0, ""))


# Faults of the example register file; the testbench must find each of them.
FAULTS = [
    ("reset value", "ctrl_limit_q  <= 16'hBEEF;", "ctrl_limit_q  <= 16'hBEEE;"),
    ("reset of an array", "{3{-12'd5}}", "{{2{-12'd5}}, 12'd5}"),
    ("byte strobe ignored", "if (wstrb[1]) ctrl_limit_q", "if (1'b1) ctrl_limit_q"),
    ("wrong byte strobe", "if (wstrb[2]) ctrl_limit_q", "if (wstrb[3]) ctrl_limit_q"),
    ("byte strobe of an array", "if (wstrb[1]) gain_value_q", "if (wstrb[0]) gain_value_q"),
    ("element index on write", "gain_value_q[12*i +: 8]", "gain_value_q[12*(i % 2) +: 8]"),
    ("element index on read", "level_value[32*i +: 32]", "level_value[0 +: 32]"),
    ("read of a wrong field", "16'b0, go_sequence_q}", "16'b0, ctrl_limit_q}"),
    ("write error missing", "default: werr_q <= 1'b1;", "default: werr_q <= 1'b0;"),
    ("write error sticks", "werr_q <= 1'b0;\n        case", "case"),
    ("write to ro accepted", "16'h0048: ;", "16'h0008, 16'h0048: ;"),
    ("write to const accepted", "16'h0048: ;", "16'h0000, 16'h0048: ;"),
    ("write to external ro accepted", "16'h0048: ;", "16'h004C, 16'h0048: ;"),
    ("write past an array accepted", "16'h0020, 16'h0024, 16'h0028: begin",
     "16'h0020, 16'h0024, 16'h0028, 16'h002C: begin"),
    ("read error missing", "rerr_q  <= 1'b1;", "rerr_q  <= 1'b0;"),
    ("read error sticks", "rerr_q <= 1'b0;\n      case", "case"),
    ("unmapped data", "32'hBADACCE5", "32'h0"),
    ("upper address bits ignored on write", "{reg_i.waddr[15:2], 2'b00}", "{4'b0, reg_i.waddr[11:2], 2'b00}"),
    ("upper address bits ignored on read", "{reg_i.raddr[15:2], 2'b00}", "{4'b0, reg_i.raddr[11:2], 2'b00}"),
    ("byte address decoded on write", "assign waddr       = {reg_i.waddr[15:2], 2'b00}", "assign waddr       = reg_i.waddr"),
    ("byte address decoded on read", "assign raddr       = {reg_i.raddr[15:2], 2'b00}", "assign raddr       = reg_i.raddr"),
    ("read data not held", "end else if (re) begin", "end else begin"),
    ("write without strobe", "if (we) begin\n        werr_q", "begin\n        werr_q"),
    ("event lost while idle", "event_lost_q  <= event_lost_q | event_lost_set;", "event_lost_q  <= event_lost_q;"),
    ("event not sticky", "event_over_q  <= event_over_q | event_over_set;", "event_over_q  <= event_over_set;"),
    ("clear wins", "(event_over_q & ~wdata[0]) | event_over_set;", "(event_over_q & ~wdata[0]);"),
    ("clear wins in an array", "(alarm_lines_q[4*i + 1 +: 3] & ~wdata[10:8]) |",
     "(alarm_lines_q[4*i + 1 +: 3] & ~wdata[10:8]) &"),
    ("clears all flags", "(event_lost_q[3:0] & ~wdata[7:4])", "4'b0"),
    ("write 0 clears", "(mixed_hit_q & ~wdata[16])", "(mixed_hit_q & wdata[16])"),
    ("clear ignores byte strobe", "if (wstrb[0]) event_over_q", "if (1'b1) event_over_q"),
    ("pulse stays", "kick_now_q    <= '0;\n      kick_axis_q", "kick_axis_q"),
    ("pulse ignores byte strobe", "if (wstrb[0]) kick_now_q", "if (1'b1) kick_now_q"),
    ("pulse reads back", "rdata_q <= 32'b0;  // KICK", "rdata_q <= 32'b1;  // KICK"),
    ("pulse of the wrong element", "fire_line_q[2*i +: 2]", "fire_line_q[0 +: 2]"),
    ("strobe stays", "go_we_q       <= '0;\n      slot_we_q", "slot_we_q"),
    ("strobe without a byte", "go_we_q <= |wstrb;", "go_we_q <= 1'b1;"),
    ("strobe of all elements", "slot_we_q[i] <= |wstrb;", "slot_we_q <= 2'b11;"),
    ("external write strobe without write", "if (we) begin\n      core_we", "begin\n      core_we"),
    ("external write strobe of any register", "core_we = waddr == 16'h0048", "core_we = 1'b1"),
    ("external read strobe without read", "if (re) begin\n      core_re", "begin\n      core_re"),
    ("external read strobe of another register", "core_re  = raddr == 16'h0048", "core_re  = 1'b1"),
    ("external byte strobes", "assign reg2hw_o.wstrb       = wstrb", "assign reg2hw_o.wstrb       = 4'hF"),
]


class Simulation(unittest.TestCase):
    def simulate(self, design):
        """The last line of the testbench."""
        with tempfile.TemporaryDirectory() as scratch:
            source = pathlib.Path(scratch) / "example_reg_top.sv"
            program = pathlib.Path(scratch) / "tb.vvp"
            source.write_text(design)
            flat = source.with_name("example_reg_top_flat.sv")
            headers = [EXAMPLE / "rtl/common", HEADERS]
            flat.write_text(flat_module(design, headers))
            compiled = run("iverilog", "-g2012", "-s", "reg_top_tb", "-o", program, *(f"-I{path}" for path in headers),
                           source, flat, TESTBENCH)
            self.assertEqual(compiled.returncode, 0, compiled.stderr)
            return run("vvp", "-n", program).stdout

    def setUp(self):
        self.design = (EXAMPLE / "rtl/example/example_reg_top.sv").read_text()

    def test_the_register_file_behaves(self):
        log = self.simulate(self.design)
        self.assertRegex(log, r"\Areg_top_tb: [1-9]\d+ checks, 0 failed\n\Z")

    def test_the_testbench_finds_every_seeded_fault(self):
        for what, old, new in FAULTS:
            with self.subTest(what):
                before, found, after = self.design.partition(old)
                self.assertTrue(found, f"`{old}` is not in the design")
                self.assertRegex(self.simulate(before + new + after), r"checks, [1-9]\d* failed\n\Z")


if __name__ == "__main__":
    unittest.main()
