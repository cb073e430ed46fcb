"""tools/wavegen: stale files, and the message for each rule that a description breaks."""

import unittest

from generator_tree import ROOT, TreeTest, generator

SOURCE = "cosim/fabric/software_signals.toml"
OUTPUTS = (
    "cosim/fabric/software_signal_list.hpp",
    "cosim/fabric/register_names.hpp",
    "tools/arm_soc.gtkw",
    "tools/arm_soc_paper.gtkw",
    "tools/arm_soc.sucl",
    "tools/arm_soc_paper.sucl",
    "scenarios/WAVEFORMS.md",
)
INPUTS = (SOURCE, "rtl/soc/soc_map.toml", *(str(path.relative_to(ROOT)) for path in ROOT.glob("rtl/*/*_regs.toml")))

# What is replaced in the description, by what, and the message.
WRONG = [
    ('name = "tick"', 'name = "Tick"', "[[group]] software, signal Tick: name `Tick` is not snake_case"),
    ('name = "tick"', 'name = "move"', "duplicate name of a signal `move`"),
    (
        'kind = "signed"',
        'kind = "real"',
        "signal tick: `kind` must be one of bit, number, signed, hex, text, is 'real'",
    ),
    ("bits = 32", "bits = 33", "signal tick: `bits` must give 1 .. 32 bits, gives 33"),
    ("bits = 32", "bits = 0", "signal tick: `bits` must give 1 .. 32 bits, gives 0"),
    ("characters = 8", "characters = 65", "signal motion: `characters` must give 1 .. 512 bits, gives 520"),
    ("characters = 8, ", "", "signal motion: missing key `characters`"),
    ('color = "yellow"', 'color = "pink"', "signal tick: `color` must be one of normal, red"),
    ('unit = "ticks"', 'unit = "ticks", width = 3', "signal tick: unknown key `width`"),
]

wavegen = generator("wavegen")


class Wavegen(TreeTest):
    COPIED = (*INPUTS, *OUTPUTS)

    def test_repository_is_up_to_date(self):
        result = wavegen(ROOT, "--check")
        self.assertEqual((result.returncode, result.stderr), (0, ""))

    def test_an_edited_output_is_stale_until_generated_again(self):
        for name, word in zip(OUTPUTS, ("kTick", "axi_timer", *["software.tick"] * 4, "| `tick`")):
            with self.subTest(name):
                self.edit(name, word, word + "s")
                result = wavegen(self.root, "--check")
                self.assertEqual(
                    (result.returncode, result.stderr), (1, f"stale: {name} (run `python3 tools/wavegen`)\n")
                )
                self.assertEqual(wavegen(self.root).stdout, f"wrote {name}\n")
                self.assertEqual((self.root / name).read_text(), (ROOT / name).read_text())

    def test_a_new_signal_makes_its_list_its_views_and_its_table_stale(self):
        self.edit(
            SOURCE, '  { name = "motion"', '  { name = "rate", kind = "bit", desc = "Rate" },\n  { name = "motion"'
        )
        result = wavegen(self.root, "--check")
        self.assertEqual(result.stderr.count("stale: "), len(OUTPUTS) - 1)  # not the names of the registers
        self.assertEqual(wavegen(self.root).returncode, 0)
        self.assertIn("+{rate} top.software.rate\n", (self.root / "tools/arm_soc_paper.gtkw").read_text())
        shown = "variable_add top.software.rate\nitem_focus c_\nitem_set_format Bit\n"
        self.assertIn(shown, (self.root / "tools/arm_soc_paper.sucl").read_text())

    def test_the_texts_of_the_serial_line_are_beside_its_pins(self):
        for variant in ("arm_soc", "arm_soc_paper"):
            gtkw = (ROOT / f"tools/{variant}.gtkw").read_text()
            group = gtkw.partition("-serial line and tool\n")[2].partition("-serial line and tool\n")[0]
            self.assertIn("+{serial_out} top.software.serial_out[255:0]\n@28\n+{uart_rxd_i} top.uart_rxd_i\n", group)
            sucl = (ROOT / f"tools/{variant}.sucl").read_text()
            group = sucl.partition("divider_add serial_line_and_tool\n")[2].partition("divider_add")[0]
            added = [line.split()[1] for line in group.splitlines() if line.startswith("variable_add")]
            self.assertEqual(added[:3], ["top.software.serial_in", "top.software.serial_out", "top.uart_rxd_i"])

    def test_each_item_of_a_surfer_view_has_the_focus_when_the_next_one_is_added(self):
        lines = (ROOT / "tools/arm_soc.sucl").read_text().splitlines()
        added = [at for at, line in enumerate(lines) if line.startswith(("variable_add ", "divider_add "))]
        self.assertGreater(len(added), 40)
        for number, at in enumerate(added):
            digits = "".join(
                f"{ord(one) - ord('a'):x}" for one in lines[at + 1].removeprefix("item_focus ").rstrip("_")
            )
            self.assertEqual(int(digits, 16), number)

    def test_a_new_pin_or_register_makes_the_views_stale(self):
        for path, old, new, shown in (
            (
                "rtl/soc/soc_map.toml",
                '{ name = "pwm"',
                '{ name = "horn", dir = "out", desc = "Horn" },\n  { name = "pwm"',
                "horn_o",
            ),
            ("rtl/encoder/encoder_regs.toml", 'name = "known"', 'name = "sure"', "sure.axes"),
        ):
            with self.subTest(path):
                self.edit(path, old, new)
                self.assertEqual(wavegen(self.root, "--check").returncode, 1)
                self.assertEqual(wavegen(self.root).returncode, 0)
                self.assertIn(f"+{{{shown}}}", (self.root / "tools/arm_soc.gtkw").read_text())

    def test_a_view_of_a_pin_or_register_that_is_gone_is_refused(self):
        self.edit("rtl/soc/soc_map.toml", 'name = "pwm"', 'name = "pulse"')
        result = wavegen(self.root)
        self.assertEqual(result.returncode, 2)
        self.assertEqual(
            result.stderr, "wavegen: rtl/soc/soc_map.toml: the views of tools/wavegen need the pin pwm_o\n"
        )

    def test_a_wrong_description_is_refused_with_its_place(self):
        right = (self.root / SOURCE).read_text()
        for old, new, message in WRONG:
            with self.subTest(new):
                (self.root / SOURCE).write_text(right)
                self.edit(SOURCE, old, new)
                result = wavegen(self.root)
                self.assertEqual(result.returncode, 2)
                self.assertIn(f"wavegen: {SOURCE}: ", result.stderr)
                self.assertIn(message, result.stderr)


if __name__ == "__main__":
    unittest.main()
