"""tools/framegen: stale files, and the message for each rule that a description breaks."""

import pathlib
import unittest

from generator_tree import ROOT, TreeTest, generator

FOLDER = pathlib.Path("controller/pendant")
SOURCE = FOLDER / "frames.toml"

# What is replaced in the description, by what, and the message.
WRONG = [
    ("nibble = 0xA", "nibble = 0xE", "[[kind]] command: `nibble` must not be 0xE"),
    ("nibble = 0xA", "nibble = 0xD", "duplicate nibble `0xD`"),
    ("nibble = 0xA", "nibble = 16", "[[kind]] command: `nibble` must be 0 .. 15, is 16"),
    ('from = "pendant"', 'from = "arm"', '[[kind]] command: `from` must be "pendant" or "controller", is "arm"'),
    ("code = 0x05", "code = 0x04", "duplicate code of an opcode `0x04`"),
    ("code = 0x05", "code = 0x80", "[[opcode]] servo: `code` must be 1 .. 127, is 128"),
    ("code = 0x05", "code = 0x05\nlevel = 1", "[[opcode]] servo: unknown key `level`"),
    ('name = "servo"', 'name = "Servo"', "[[opcode]] Servo: name `Servo` is not snake_case"),
    ('name = "servo"', 'name = "stop"', "duplicate name in [[opcode]] `stop`"),
    ('states = ["estop"]', 'states = ["stopped"]', "[[opcode]] estop_reset: `states` names no state: stopped"),
    ('states = ["estop"]', "", "[[opcode]] estop_reset: a command has `states` or `extended`"),
    ('extended = ["run", "hold"]', 'extended = ["idle"]', "speed_override: `extended` repeats a state: idle"),
    ('refusal = "mode"', 'refusal = "no"', "[[state]] ready: `refusal` names no status: no"),
    ("max = 63", "max = 128", "[[opcode]] home parameter: `max` must be 0 .. 127, is 128"),
    ("min = 1, max = 63", "min = 64, max = 63", "[[opcode]] home parameter: `min` 64 is above `max` 63"),
    ("max = 63,", "max = 63, most = 1,", "[[opcode]] home parameter: unknown key `most`"),
    ("first = 7", "first = 6", "duplicate page `6`"),
    ("last = 6", "last = 0", "[[page]] joint: `last` must be 1 .. 127, is 0"),
    ("shift = 12", "shift = 11", "[[page]] state: duplicate bit `11`"),
    ("shift = 13", "shift = 27", "[[page]] state field 4: `shift` must be 0 .. 26, is 27"),
    ("shift = 8, bits = 4", "shift = 8, bits = 20", "[[page]] state field 2: `bits` must be 1 .. 19, is 20"),
    ('name = "drives_on", shift', 'name = "state", shift', "[[page]] state: duplicate name of a field `state`"),
    ("shift = 16, bits = 2", "shift = 16", "message field 2: `values` has 4 values, `bits = 1` has room for 2"),
    ('{ name = "stopped"', '{ name = "alarm"', "[[page]] message field 2: duplicate name of a value `alarm`"),
    ('value = "pulses"', "", "[[page]] joint: missing key `value`"),
    ("group = 16", "group = 1", "the parameter of set_telemetry has `max = 127`, all groups are 111"),
    ('parameter_name = "run_mode"', "", "[[opcode]] run: missing key `parameter_name`"),
    ('parameter_name = "run_mode"', 'parameter_name = "system"', "duplicate `parameter_name` `system`"),
    ("group = 8", "group = 6", "[[page]] tool: `group` must be a power of 2, is 6"),
    ('{ name = "gcode"', '{ name = "job"', "[[opcode]] program_begin: duplicate name of a parameter `job`"),
    ('name = "again", desc', 'name = "again", what', "[[opcode]] run parameter 2: missing key `desc`"),
]

framegen = generator("framegen")


class Framegen(TreeTest):
    COPIED = (FOLDER,)

    def test_repository_is_up_to_date(self):
        result = framegen(ROOT, "--check")
        self.assertEqual((result.returncode, result.stderr), (0, ""))

    def test_an_edited_output_is_stale_until_generated_again(self):
        for name, word in (("protocol/frame_table.hpp", "kServo"), ("PROTOCOL.md", "`jog_limit`")):
            with self.subTest(name):
                self.edit(FOLDER / name, word, word + "s")
                result = framegen(self.root, "--check")
                self.assertEqual(result.returncode, 1)
                self.assertEqual(result.stderr, f"stale: {FOLDER / name} (run `python3 tools/framegen`)\n")
                self.assertEqual(framegen(self.root).stdout, f"wrote {FOLDER / name}\n")
                self.assertEqual(framegen(self.root, "--check").returncode, 0)

    def test_an_edited_description_makes_both_outputs_stale(self):
        self.edit(SOURCE, 'desc = "switches the drives;', 'desc = "switches all drives;')
        self.assertEqual(framegen(self.root, "--check").stderr.count("stale: "), 2)

    def test_the_hand_written_text_of_the_document_is_kept(self):
        self.edit(FOLDER / "PROTOCOL.md", "# The pendant's protocol", "# Another title")
        self.edit(SOURCE, 'desc = "switches the drives;', 'desc = "switches all drives;')
        self.assertEqual(framegen(self.root).returncode, 0)
        text = (self.root / FOLDER / "PROTOCOL.md").read_text()
        self.assertIn("# Another title", text)
        self.assertIn("switches all drives", text)

    def test_a_missing_section_is_an_error(self):
        self.edit(FOLDER / "PROTOCOL.md", "<!-- states: generated", "<!-- status: generated")
        result = framegen(self.root)
        self.assertEqual(result.returncode, 2)
        self.assertIn("PROTOCOL.md has no section `<!-- states: generated by ... -->`", result.stderr)

    def test_each_broken_rule_has_a_message_with_file_table_and_key(self):
        good = (self.root / SOURCE).read_text()
        for old, new, message in WRONG:
            with self.subTest(message):
                (self.root / SOURCE).write_text(good)
                self.edit(SOURCE, old, new)
                result = framegen(self.root)
                self.assertEqual(result.returncode, 2)
                self.assertIn(f"framegen: {SOURCE}", result.stderr)
                self.assertIn(message, result.stderr)


if __name__ == "__main__":
    unittest.main()
