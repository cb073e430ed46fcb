"""tools/reggen: goldens, stale files and lint of an example block, and its generated C++.

The example under tests/tools/reggen uses every access kind. Its goldens are rewritten by
`python3 tools/reggen --root tests/tools/reggen`.
"""

import pathlib
import re
import tempfile
import tomllib
import unittest

from generator_tree import ROOT, run
from reggen_tree import EXAMPLE, REGS, SOC, TreeTest, reggen

HEADERS = ROOT / "rtl/common"
WARNINGS = ("-Wall", "-Wextra", "-Wpedantic", "-Wconversion", "-Wsign-conversion", "-Werror")


def compile_cpp(source, *options):
    """Compiles a source that includes files of the example."""
    return run("g++", "-std=c++20", *WARNINGS, f"-I{EXAMPLE}", f"-I{ROOT}", source, *options)


class Check(TreeTest):
    def test_repository_is_up_to_date(self):
        result = reggen(ROOT, "--check")
        self.assertEqual((result.returncode, result.stderr), (0, ""))

    def test_example_equals_its_golden(self):
        result = reggen(EXAMPLE, "--check")
        self.assertEqual((result.returncode, result.stderr), (0, ""))

    def test_the_tick_is_the_same_in_both_maps(self):
        """The pulse distribution resets to the period of the trigger."""
        soc = tomllib.loads((ROOT / SOC).read_text())
        block = tomllib.loads((ROOT / "rtl/pulse_train/pulse_train_regs.toml").read_text())
        resets = [reg["fields"][0]["reset"] for reg in block["register"] if reg["name"] == "tick_cycles"]
        self.assertEqual(resets, [soc["tick_cycles"]])

    def test_an_edited_output_is_stale_until_generated_again(self):
        for path, word in (
            ("rtl/example/example_reg_top.sv", "example"),
            ("rtl/REGISTERS.md", "example"),
            ("rtl/common/example_reg_types.svh", "example"),
            ("controller/regs/example_regs.hpp", "example"),
            ("rtl/common/example_soc_pins.svh", "door"),
            ("cosim/logic/pins.hpp", "door"),
            ("cosim/logic/pin_list.hpp", "door"),
            ("cosim/fabric/model_pins.hpp", "door"),
        ):
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
        self.assertEqual(result.stderr.count("stale: "), 5)  # ports, structs, list, wiring, table
        self.assertEqual(reggen(self.root).returncode, 0)
        for path, text in (
            ("rtl/common/example_soc_pins.svh", "output logic        horn_o,"),
            ("cosim/logic/pins.hpp", "bool horn = false;"),
            ("rtl/REGISTERS.md", "| horn_o"),
            ("cosim/logic/pin_list.hpp", '<&SocOutputs::horn>("horn_o", 1)'),
            ("cosim/fabric/model_pins.hpp", "out.horn = model.horn_o != 0;"),
        ):
            self.assertIn(text, (self.root / path).read_text())

    def test_below_a_limit_nothing_is_an_error(self):
        self.edit(REGS, 'name = "example"', 'name = "example"\nno_error_below = 0x100')
        self.assertEqual(reggen(self.root).returncode, 0)
        text = (self.root / "rtl/example/example_reg_top.sv").read_text()
        for line in (
            "default: werr_q <= waddr[15:8] != '0;",
            "rdata_q <= raddr[15:8] != '0 ? 32'hBADACCE5 : 32'b0;",
            "rerr_q  <= raddr[15:8] != '0;",
            "if (locked) werr_q <= waddr[15:8] != '0;",
        ):
            self.assertIn(line, text)
        rule = "Below 0x100 every access answers OKAY"
        for path in ("rtl/REGISTERS.md", "rtl/example/example_reg_top.sv", "controller/regs/example_regs.hpp"):
            self.assertIn(rule, " ".join((self.root / path).read_text().replace("//", " ").split()), path)

    def test_a_block_without_a_lock_has_no_trace_of_it(self):
        self.edit(REGS, '[lock]\noffset = 0x1C\nkey = 0x0BADC0DE\nwhile = "the machine moves"\n', "")
        for _ in range(2):
            self.edit(REGS, "protected = true\n", "")
        self.edit(REGS, "protected = true, ", "")
        self.assertEqual(reggen(self.root).returncode, 0)
        for path in ("rtl/example/example_reg_top.sv", "controller/regs/example_regs.hpp", "rtl/REGISTERS.md"):
            text = (self.root / path).read_text()
            for word in ("protect_i", "(locked)", "Key", "KEY", "While the machine"):
                self.assertNotIn(word, text, path)

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


class Lint(unittest.TestCase):
    """Every generated file of the example and of the repository, in the tools that must read it."""

    @staticmethod
    def register_files():
        found = [*EXAMPLE.glob("rtl/*/*_reg_top.sv"), *sorted(ROOT.glob("rtl/*/*_reg_top.sv"))]
        return [
            (
                path,
                [
                    f"-I{path.parents[1] / 'common'}",
                    f"-I{HEADERS}",
                    path.with_name(path.name.replace("_top", "_pkg")),
                    path,
                ],
            )
            for path in found
        ]

    def accept(self, *command):
        result = run(*command)
        self.assertEqual((result.returncode, result.stdout + result.stderr), (0, ""))

    def test_verilator(self):
        for top, sources in self.register_files():
            with self.subTest(top.stem):
                self.accept(
                    "verilator", "--lint-only", "-Wall", "-fno-const-bit-op-tree", "--top-module", top.stem, *sources
                )

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
            top.write_text(
                'module top (\n  input logic clk_i,\n`include "example_soc_pins.svh"\n);\n'
                "  assign data_o = {15'b0, data_i};\n  assign lamp_no = ^{clk_i, door_ni, line_i};\n"
                "  assign irq_o = probe_i[2:0] ^ probe_i[5:3];\nendmodule\n"
            )
            include = EXAMPLE / "rtl/common"
            self.accept("verilator", "--lint-only", "-Wall", f"-I{include}", top)
            self.accept(
                "yosys", "-q", "-p", f"read_verilog -sv -I{include} {top}; hierarchy -check -top top; check -assert"
            )
            self.accept("iverilog", "-g2012", "-Wall", "-t", "null", "-I", include, top)

    def test_each_block_has_its_place_in_the_crossbar(self):
        """Of the repository, whose variants differ: port i of each variant claims the addresses of its block."""
        text = (ROOT / "rtl/soc/soc_map_pkg.sv").read_text()
        with open(ROOT / SOC, "rb") as file:
            blocks = tomllib.load(file)["block"]
        port = {name: int(value) for name, value in re.findall(r"localparam int +(\w+)Port += (\d+);", text)}
        self.assertEqual(len(port), len(blocks))
        for prefix, other in (("", "paper"), ("Paper", "counts")):
            base, mask = (
                re.search(rf" {prefix}Xbar{kind} = {{\n(.*?)}};", text, re.DOTALL)[1]
                .replace(" ", "")
                .split(",\n")[::-1]
                for kind in ("Base", "Mask")
            )
            mine = [block for block in blocks if block.get("variant") != other]
            for block in mine:
                name = "".join(word.capitalize() for word in block["name"].split("_"))
                self.assertEqual(base[port[name]], f"{name}Base")
                self.assertEqual(int(mask[port[name]][4:].replace("_", ""), 16), 0x1_0000_0000 - block["size"])
            self.assertEqual([word for word in base if word.endswith("Base")], base[: len(mine)])
            self.assertEqual(set(mask[len(mine) :]) | {"32'h0000_0000"}, {"32'h0000_0000"})

    def test_no_line_is_too_long(self):
        for tree in (EXAMPLE, ROOT):
            for path in [
                *tree.glob("rtl/*/*_reg_*.sv"),
                *tree.glob("rtl/soc/soc_map_pkg.sv"),
                *tree.glob("rtl/common/*.svh"),
                *tree.glob("controller/regs/*.hpp"),
                *tree.glob("cosim/fabric/*pin*.hpp"),
            ]:
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
        static_assert(example::kKeyOffset == 0x1C && example::kKeyWord == 0x0BADC0DE && example::kKeyUnlockedMask == 1);
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
            result = compile_cpp(source, "-fsyntax-only")
            self.assertEqual((result.returncode, result.stderr), (0, ""))


class Pins(unittest.TestCase):
    """The structs, the list and the wiring of the example, with a stand-in for the verilated model."""

    PROGRAM = """
        #include "cosim/fabric/model_pins.hpp"
        #include "cosim/logic/pin_list.hpp"
        #include <cassert>
        #include <type_traits>
        using namespace armature::cosim;
        struct Model {
          std::uint8_t door_ni = 9, line_i = 9, probe_i = 9;
          std::uint32_t data_i = 9, data_o = 0x80000001;
          std::uint8_t lamp_no = 1, irq_o = 5;
        };
        static_assert(SocInputs{}.door_n && SocInputs{}.line && SocInputs{}.probe == 0);
        static_assert(SocInputs{}.data == 0x1FFFF && SocOutputs{}.data == 0 && SocOutputs{}.lamp_n);
        static_assert(std::is_same_v<decltype(SocInputs::probe), std::uint8_t>);
        static_assert(std::is_same_v<decltype(SocInputs::door_n), bool>);
        static_assert(std::size(kPins) == 7 && kPins[0].name == "door_ni" && kPins[0].is_input() && kPins[0].bits == 1);
        static_assert(kPins[2].name == "probe_i" && kPins[2].bits == 6 && kPins[2].max_value() == 0x3F);
        static_assert(kPins[4].name == "data_o" && !kPins[4].is_input() && kPins[4].max_value() == 0xFFFFFFFF);
        int main() {
          Model model;
          drive_pins(model, {.door_n = false, .line = true, .probe = 0x2A, .data = 0x15555});
          assert(model.door_ni == 0 && model.line_i == 1 && model.probe_i == 0x2A && model.data_i == 0x15555);
          const SocOutputs out = sample_pins(model);
          assert(out.data == 0x80000001 && out.lamp_n && out.irq == 5);
          SocInputs in;
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
            result = compile_cpp(source, "-o", program)
            self.assertEqual((result.returncode, result.stderr), (0, ""))
            result = run(program)
            self.assertEqual((result.returncode, result.stderr), (0, ""))


if __name__ == "__main__":
    unittest.main()
