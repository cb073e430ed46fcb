"""armature gcode --canon against rs274 of LinuxCNC, where it is installed."""

import unittest

import gcode_oracle
import gcode_programs
import random_gcode
from cli_program import Program, main

RANDOM = range(150)
ORACLE = gcode_oracle.find()


@unittest.skipUnless(ORACLE, "rs274 (Debian package linuxcnc-uspace) is neither in the PATH nor named by RS274")
class Rs274(Program):
    def calls(self, text, code):
        self.text("program.ngc", text)
        tools = ["--tool", "1", "--tool", "2", "--tool", "3"]
        done = self.armature("gcode", *tools, "--canon", "program.ngc", code=code)
        return gcode_oracle.calls_of(done.stdout)

    def expect_equal(self, text):
        ended, theirs = gcode_oracle.run_oracle(ORACLE, text)
        self.assertTrue(ended, text)
        ours = self.calls(text, 0)
        self.assertGreater(len(ours), 4)
        self.assertIsNone(gcode_oracle.difference(ours, theirs), text)

    def test_each_feature_gives_the_same_calls(self):
        for name, text in gcode_programs.GOOD.items():
            with self.subTest(name):
                self.expect_equal(gcode_programs.START + text + "M2\n")

    def test_nothing_behind_the_second_percent_is_read(self):
        self.expect_equal(gcode_programs.ENDED_BY_PERCENT)

    def test_random_programs_give_the_same_calls(self):
        print(f"seeds {RANDOM.start} .. {RANDOM.stop - 1}")
        for seed in RANDOM:
            with self.subTest(seed=seed):
                self.expect_equal(random_gcode.random_program(seed))

    def test_both_refuse_the_same_programs(self):
        for name, text in gcode_programs.BAD.items():
            with self.subTest(name):
                ended, theirs = gcode_oracle.run_oracle(ORACLE, gcode_programs.START + text)
                self.assertFalse(ended)
                ours = self.calls(gcode_programs.START + text, 2)
                common = min(len(ours), len(theirs))  # the calls before the error; a line may have made some of its own
                self.assertIsNone(gcode_oracle.difference(ours[:common], theirs[:common]))


if __name__ == "__main__":
    main()
