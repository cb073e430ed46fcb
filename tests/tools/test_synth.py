"""tools/synth: resources and longest paths of small netlists whose answer is known; what is above a limit."""

import importlib.util
import pathlib
import sys
import tempfile
import unittest
from collections import Counter

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tools/synth"))
import netlist  # noqa: E402

spec = importlib.util.spec_from_file_location("synth", ROOT / "tools/synth/__main__.py")
synth = importlib.util.module_from_spec(spec)
sys.modules["synth"] = synth
spec.loader.exec_module(synth)

OUTPUTS = {"Q", "O", "CO", "DOA"}


def module(*cells):
    """Cells as (kind, {pin: bits}); a bit is a number."""
    nets = sorted({bit for _, pins in cells for bits in pins.values() for bit in bits})
    return {
        "cells": {
            str(number): {
                "type": kind,
                "connections": pins,
                "port_directions": {pin: "output" if pin in OUTPUTS else "input" for pin in pins},
            }
            for number, (kind, pins) in enumerate(cells)
        },
        "netnames": {f"n{net}": {"bits": [net]} for net in nets},
    }


def flop(d, q):
    return "FDRE", {"D": [d], "Q": [q]}


def lut(output, *inputs):
    return f"LUT{len(inputs)}", {**{f"I{i}": [bit] for i, bit in enumerate(inputs)}, "O": [output]}


class LongestPath(unittest.TestCase):
    def levels(self, *cells):
        return netlist.Graph(module(*cells)).longest().levels

    def test_a_shift_register_has_no_logic(self):
        self.assertEqual(self.levels(flop(1, 2), flop(2, 3)), 0)

    def test_the_deeper_input_counts(self):
        self.assertEqual(self.levels(flop(9, 1), lut(2, 1), lut(3, 2), lut(4, 3, 1), flop(4, 5)), 3)

    def test_a_flop_ends_a_path(self):
        self.assertEqual(self.levels(flop(9, 1), lut(2, 1), flop(2, 3), lut(4, 3), lut(5, 4), flop(5, 6)), 2)

    def test_a_pin_begins_a_path(self):
        self.assertEqual(self.levels(lut(2, 1), lut(3, 2), flop(3, 4)), 2)

    def test_a_bit_of_a_carry_chain_depends_on_the_bits_below_only(self):
        carry = ("CARRY4", {"S": [1, 2, 3, 9], "CI": [0], "DI": [0, 0, 0, 0], "O": [4, 5, 6, 7]})
        self.assertEqual(self.levels(carry, lut(9, 4), flop(7, 20)), 3, "bit 3 after a table that bit 0 feeds")

    def test_a_memory_is_read_through_its_address_only(self):
        ram = ("RAM32M", {"ADDRA": [3], "DIA": [4], "DOA": [5]})
        self.assertEqual(self.levels(flop(9, 1), lut(3, 1), lut(7, 1), lut(8, 7), lut(4, 8), ram, flop(5, 6)), 3)

    def test_a_loop_is_an_error(self):
        with self.assertRaisesRegex(ValueError, "combinational loop"):
            self.levels(lut(1, 2), lut(2, 1))

    def test_the_path_names_its_cells(self):
        path = netlist.Graph(module(flop(9, 1), lut(2, 1), flop(2, 3))).longest()
        self.assertEqual(path.cells, [("FDRE", "n1"), ("LUT1", "n2"), ("FDRE", "n3")])

    def test_the_next_cell_of_a_carry_chain_is_quick(self):
        def chain(*cells):
            return netlist.Graph(module(*cells)).longest().delay_ns

        first = ("CARRY4", {"CI": [1], "CO": [2]})
        second = ("CARRY4", {"CI": [2], "CO": [3]})
        self.assertAlmostEqual(chain(first, second) - chain(first), netlist.CHAINED_CARRY_NS)


class Resources(unittest.TestCase):
    def test_sites_of_each_kind(self):
        used = netlist.resources(
            Counter(
                {
                    "LUT6": 3,
                    "LUT1": 1,
                    "RAM32M": 1,
                    "FDRE": 2,
                    "FDSE": 1,
                    "MUXF7": 5,
                    "RAMB18E1": 1,
                    "RAMB36E1": 1,
                    "DSP48E1": 2,
                }
            )
        )
        self.assertEqual(used, {"lut": 8, "ff": 3, "bram": 1.5, "dsp": 2})

    def test_an_unknown_cell_is_an_error(self):
        for kind in ("LDCE", "$_DLATCH_P_"):
            with self.assertRaisesRegex(ValueError, "does not know"):
                netlist.resources(Counter({kind: 1}))

    def test_inverters_of_the_same_net_are_one(self):
        cells = module(("INV", {"I": [1], "O": [2]}), ("INV", {"I": [1], "O": [3]}), ("INV", {"I": [4], "O": [5]}))
        self.assertEqual(netlist.cell_counts(cells, set())["INV"], 2)


class Limits(unittest.TestCase):
    RESULT = synth.Result(
        {"timer": {"lut": 10, "ff": 20, "bram": 0, "dsp": 0}},
        {"lut": 10, "ff": 20, "bram": 0, "dsp": 0},
        netlist.Path(5, 3.0, [("FDRE", "a")]),
    )
    LIMITS = {
        "timer": {"lut": 10, "ff": 20, "bram": 0, "dsp": 0},
        "total": {"lut": 10, "ff": 20, "bram": 0, "dsp": 0, "levels": 5},
    }

    def above(self, **changed):
        return synth.above("counts", self.RESULT, {**self.LIMITS, **changed})

    def test_at_the_limits_is_good(self):
        self.assertEqual(self.above(), [])

    def test_one_above_is_reported(self):
        self.assertEqual(
            self.above(timer={**self.LIMITS["timer"], "lut": 9}), ["counts.timer.lut: 10 above the limit 9"]
        )
        self.assertEqual(
            self.above(total={**self.LIMITS["total"], "levels": 4}), ["counts.total.levels: 5 above the limit 4"]
        )

    def test_a_block_needs_limits_and_a_limit_a_block(self):
        self.assertEqual(self.above(ghost={"lut": 1}), ["counts.ghost: unknown block"])
        self.assertEqual(
            synth.above("counts", self.RESULT, {"total": self.LIMITS["total"]}), ["counts.timer: no limits"]
        )

    def test_more_than_the_device_is_reported_whatever_the_limits(self):
        big = synth.Result({}, {"lut": 53_201, "ff": 0, "bram": 0, "dsp": 0}, self.RESULT.path)
        limits = {"total": {"lut": 99_999, "ff": 0, "bram": 0, "dsp": 0, "levels": 5}}
        self.assertEqual(synth.above("counts", big, limits), ["counts: 53201 lut do not fit the XC7Z020"])


class Readme(unittest.TestCase):
    RESULT = Limits.RESULT

    def setUp(self):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.readme = pathlib.Path(scratch.name) / "README.md"
        self.readme.write_text("before\n<!-- counts: generated by synth -->\nold\n<!-- end -->\nafter\n")

    def test_an_old_table_is_stale_and_a_written_one_is_not(self):
        self.assertEqual(len(synth.stale("counts", self.RESULT, self.readme)), 1)
        synth.write_section(self.readme, "counts", synth.readme_text("counts", self.RESULT))
        self.assertEqual(synth.stale("counts", self.RESULT, self.readme), [])
        text = self.readme.read_text()
        self.assertTrue(text.startswith("before\n") and text.endswith("<!-- end -->\nafter\n"))

    def test_one_lut_more_is_stale(self):
        synth.write_section(self.readme, "counts", synth.readme_text("counts", self.RESULT))
        block = {"lut": 11, "ff": 20, "bram": 0, "dsp": 0}
        other = synth.Result({"timer": block}, block, self.RESULT.path)
        self.assertEqual(len(synth.stale("counts", other, self.readme)), 1)

    def test_a_readme_without_the_section_is_an_error(self):
        with self.assertRaisesRegex(Exception, "no section `<!-- paper"):
            synth.stale("paper", self.RESULT, self.readme)


if __name__ == "__main__":
    unittest.main()
