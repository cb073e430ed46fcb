"""tools/reggen refuses a broken map, with the file, the place and the reason."""

import unittest

from reggen_tree import REGS, SOC, TreeTest, reggen


# What is changed in which file, and the whole message.
MESSAGES = [
    (
        REGS,
        'bits = "0",    access = "rw"',
        'bits = "4",    access = "rw"',
        "register ctrl: field limit (bits 19:4) overlaps field enable (bits 4)",
    ),
    (REGS, 'bits = "31",', 'bits = "32",', 'register ctrl, field run: bits "32" are outside 0..31'),
    (REGS, 'bits = "19:4"', 'bits = "4:19"', 'register ctrl, field limit: bits "4:19": msb is below lsb'),
    (REGS, 'bits = "19:4"', 'bits = "19-4"', 'register ctrl, field limit: bits "19-4" is neither "bit" nor "msb:lsb"'),
    (
        REGS,
        "reset = 0xBEEF",
        "reset = 0x1_0000",
        "register ctrl, field limit: reset 65536 does not fit in 16 bits (0..65535)",
    ),
    (REGS, "reset = 0xBEEF", "reset = -1", "register ctrl, field limit: reset -1 does not fit in 16 bits (0..65535)"),
    (
        REGS,
        "reset = -5",
        "reset = 2048",
        "register gain, field value: reset 2048 does not fit in 12 bits (-2048..2047)",
    ),
    (
        REGS,
        "reset = -5",
        "reset = -2049",
        "register gain, field value: reset -2049 does not fit in 12 bits (-2048..2047)",
    ),
    (REGS, "reset = 0xBEEF, ", "", "register ctrl, field limit: missing key `reset` (access rw)"),
    (REGS, "reset = 0x4558, ", "", "register id, field block: missing key `reset` (access const)"),
    (
        REGS,
        'access = "ro", desc = "Live',
        'access = "ro", reset = 0, desc = "Live',
        "register status, field busy: `reset` is not for access ro",
    ),
    (
        REGS,
        'access = "w1c"',
        'access = "rc"',
        "register event, field over: unknown access `rc` (one of rw, ro, const, w1c, pulse)",
    ),
    (REGS, 'unit = "mV"', 'units = "mV"', "register status, field level: unknown key `units`"),
    (REGS, "strobe = true", "strobes = true", "register go: unknown key `strobes`"),
    (REGS, 'name = "example"', 'name = "example"\nversion = 1', "unknown key `version`"),
    (
        REGS,
        'name = "example"',
        'name = "example"\nno_error_below = 0x180',
        "no_error_below 0x180 is not a power of two below 0x10000",
    ),
    (REGS, 'desc = "Read only"\n', "", "register status: missing key `desc`"),
    (REGS, "offset = 0x08", 'offset = "0x08"', "register status: `offset` must be of type int, is '0x08'"),
    (REGS, "strobe = true", "strobe = 1", "register go: `strobe` must be of type bool, is 1"),
    (REGS, "offset = 0x08", "offset = 0x0A", "register status: offset 0xA is not a multiple of 4"),
    (
        REGS,
        "offset = 0x4C",
        "offset = 0x1_0000",
        "register probe: offset 0x10000 is outside the 16 address bits of a block",
    ),
    (REGS, "offset = 0x4C", "offset = -4", "register probe: offset -0x4 is outside the 16 address bits of a block"),
    (
        REGS,
        "offset = 0x20",
        "offset = 0x24",
        "register gain: offset 0x24: an array of 3 starts at a multiple of 0x10, "
        "so that its index is a slice of the address",
    ),
    (REGS, "count = 3", "count = 1", "register gain: count 1 is below 2"),
    (
        REGS,
        "external = true",
        "external = true\nstrobe = true",
        "register core: an external register has neither `count` nor `strobe`",
    ),
    (REGS, 'desc = "Read only"', 'desc = "Read only"\nstrobe = true', "register status: `strobe` needs a rw field"),
    (
        REGS,
        'desc = "Read only"',
        'desc = "Read only"\nprotected = true',
        "register status: `protected` needs a writable field, and storage that is not in the core",
    ),
    (
        REGS,
        "external = true",
        "external = true\nprotected = true",
        "register core: `protected` needs a writable field, and storage that is not in the core",
    ),
    (
        REGS,
        '[lock]\noffset = 0x1C\nkey = 0x0BADC0DE\nwhile = "the machine moves"\n',
        "",
        "register mixed: `protected` needs a table [lock]",
    ),
    (REGS, "key = 0x0BADC0DE\n", "", "lock: missing key `key`"),
    (REGS, "key = 0x0BADC0DE", "key = 0", "lock: key 0x0 is outside 0x1..0xFFFFFFFE"),
    (REGS, "key = 0x0BADC0DE", "key = 0xFFFFFFFF", "lock: key 0xFFFFFFFF is outside 0x1..0xFFFFFFFE"),
    (REGS, 'while = "the', 'when = "the', "lock: missing key `while`"),
    (REGS, "offset = 0x1C", "offset = 0x1D", "lock: offset 0x1D is not a multiple of 4"),
    (REGS, "offset = 0x1C", "offset = 0x18", "register key (0x18) overlaps register mixed (0x18..0x1B)"),
    (REGS, 'name = "status"', 'name = "key"', "duplicate register `key`"),
    (REGS, "offset = 0x08", "offset = 0x04", "register status (0x4) overlaps register ctrl (0x4..0x7)"),
    (REGS, "offset = 0x18", "offset = 0x24", "register mixed (0x24) overlaps register gain (0x20..0x2B)"),
    (REGS, 'name = "status"', 'name = "ctrl"', "duplicate register `ctrl`"),
    (REGS, 'name = "level", bits', 'name = "busy", bits', "register status: duplicate field `busy`"),
    (REGS, 'name = "sequence"', 'name = "we"', "duplicate member `go_we`"),
    (REGS, 'name = "busy",  bits', 'name = "offset", bits', "duplicate constant `StatusOffset`"),
    (
        REGS,
        'name = "level"\noffset = 0x30\ncount = 2\ndesc = "Array of ro"\nfields = [{ name = "value"',
        'name = "level"\noffset = 0x30\ncount = 2\ndesc = "Array of ro"\nfields = [{ name = "count"',
        "duplicate constant `LevelCount`",
    ),
    (REGS, 'name = "status"', 'name = "Status"', "register Status: name `Status` is not snake_case"),
    (
        REGS,
        'name = "example"',
        'name = "sample"',
        "name `sample` does not match the file, expected rtl/sample/sample_regs.toml",
    ),
    (
        REGS,
        'fields = [{ name = "sequence"',
        'fields = [1, { name = "sequence"',
        "register go: `fields` must be a list of tables with at least one element",
    ),
    (SOC, "size = 0x1000", "size = 0x1800", "block right: size 0x1800 is not a power of two of at least 4"),
    (
        SOC,
        "size = 0x1_0000",
        "size = 0x2_0000",
        "block left: size 0x20000 is above the 0x10000 that a register file decodes",
    ),
    (SOC, "size = 0x1000", "size = 0x40", "block right: size 0x40 does not hold register fire (0x54)"),
    (SOC, "base = 0x4001_0000", "base = 0x4001_8000", "block left: base 0x40018000 is not a multiple of size 0x10000"),
    (
        SOC,
        "base = 0x4001_0000",
        "base = 0x1_0000_0000",
        "block left: base 0x100000000 is outside the 32-bit address space",
    ),
    (
        SOC,
        "base = 0x4000_0000",
        "base = 0x4001_F000",
        "block right (base 0x4001F000) overlaps block left (0x40010000, size 0x10000)",
    ),
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
    (SOC, 'name = "line"', 'name = "clk"', "pin clk: the clocks, the reset and the bus are not pins"),
    (SOC, 'name = "line"', 'name = "s_axi_line"', "pin s_axi_line: the clocks, the reset and the bus are not pins"),
    (SOC, 'per = "axis"', 'per = "joint"', "pin probe: `per`: joint is none of axis, irq"),
    (SOC, 'per = "axis"', 'per = "axis", bits = 6', "pin probe: `bits` is not for a pin with `per`, which has 6"),
    (SOC, "irq = 2\n", "", "pin irq: `per`: no block has an irq"),
    (SOC, "bits = 17", "bits = 33", "pin data: bits 33 is outside 1..32"),
    (SOC, "bits = 17", "bits = 0", "pin data: bits 0 is outside 1..32"),
    (SOC, "bits = 17", 'bits = "17"', "pin data: `bits` must be of type int, is '17'"),
    (SOC, "bits = 17", "width = 17", "pin data: unknown key `width`"),
    (SOC, "idle = 1, pull", "idle = 2, pull", "pin line: idle 2 is neither 0 nor 1"),
    (SOC, 'pull = "up"', 'pull = "high"', "pin line: `pull`: high is none of up, down"),
    (
        SOC,
        'dir = "out", active_low = true',
        'dir = "out", active_low = 1',
        "pin lamp: `active_low` must be of type bool, is 1",
    ),
    (SOC, 'dir = "out", active_low = true', 'dir = "out", pull = "up"', "pin lamp: `pull` is for inputs"),
    (SOC, ', desc = "Lamp"', "", "pin lamp: missing key `desc`"),
    (SOC, 'name = "line"', 'name = "probe"', "duplicate pin `probe_i`"),
    (SOC, 'name = "line"', 'name = "door_n"', "duplicate input pin `door_n`"),
    (SOC, 'group = "Outputs"', 'group = "Inputs"', "duplicate group of pins `Inputs`"),
    (SOC, 'group = "Outputs"\n', "", "pins of ?: missing key `group`"),
    (
        SOC,
        'name = "lamp", dir = "out"',
        'name = "lamp", dir = "out", bits = 30',
        "the output pins have 65 bits, at most 64 are compared in each clock",
    ),
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

    def test_a_lock_without_a_protected_register_is_refused(self):
        for _ in range(2):
            self.edit(REGS, "protected = true\n", "")
        self.assertEqual(reggen(self.root).stderr, f"reggen: {REGS}: lock: no register is `protected`\n")

    def test_a_missing_address_map_is_named(self):
        (self.root / SOC).unlink()
        self.assertEqual(reggen(self.root).stderr, f"reggen: {SOC}: file not found\n")

    def test_nothing_is_written_from_a_broken_map(self):
        self.edit(REGS, "reset = 7", "reset = 256")
        (self.root / "rtl/REGISTERS.md").unlink()
        self.assertEqual(reggen(self.root).returncode, 2)
        self.assertFalse((self.root / "rtl/REGISTERS.md").exists())


if __name__ == "__main__":
    unittest.main()
