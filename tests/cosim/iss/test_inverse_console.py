"""ik --on a9: the firmware solves a pose and shows the joint angles on its serial line."""

import json
import pathlib
import re
import sys

sys.path.insert(0, str(pathlib.Path(__file__).parents[1] / "cli"))
from cli_program import Program, main

POSE = ("--robot", "abb_irb120", "--xyz", 350, -120, 500, "--rpy", 30, 120, -10)
CLOCKS_OF_INSTRUCTION = 1.5 * 50e6 / (2e9 / 3)  # of the logic
LINE = re.compile(
    r"branch (\d) shoulder (-?1) elbow (-?1) flip (-?[01]) singular (\d+) clamped [01]((?: angle\d=\S+)+)"
)


class InverseConsole(Program):
    def json(self, *pose, on, code=0):
        return json.loads(self.armature("ik", *pose, "--on", on, "--json", code=code).stdout)

    def console_of(self, result):
        """The branches in the text of the console, as the lists of their angles."""
        first, *lines = result["console"].splitlines()
        self.assertRegex(first, rf"^solutions {len(lines)} status \d selected -?\d$")
        return [[float(word.partition("=")[2]) for word in LINE.fullmatch(line)[6].split()] for line in lines]

    def expect_as_host(self, pose, code=0):
        host, arm = (self.json(*pose, on=on, code=code) for on in ("host", "a9"))
        self.assertEqual(arm["other_branches"], 0)
        self.assertLess(arm["difference_pulses"], 2e-6, "half of the last digit of the text")
        self.assertEqual(arm["selected"], host["selected"])
        shown = self.console_of(arm)
        self.assertEqual(len(shown), len(host["branches"]))
        for angles, branch in zip(shown, host["branches"], strict=True):
            self.assertEqual([f"{deg:.9f}" for deg in angles], [f"{deg + 0.0:.9f}" for deg in branch["joints_deg"]])
        clocks = arm["instructions"] * CLOCKS_OF_INSTRUCTION
        self.assertAlmostEqual(arm["clocks"], clocks, delta=1)
        return arm

    def test_the_console_shows_what_the_host_finds(self):
        arm = self.expect_as_host(POSE)
        self.assertEqual(len(arm["branches"]), 8)
        self.assertTrue(5_000 < arm["instructions"] < 50_000, arm["instructions"])

    def test_the_pose_of_figure_2_is_solved(self):
        """Its only solution is (0, -90, 0, -90, 0), stretched, so both elbows are the same."""
        flange = self.armature("fk", "--robot", "hu2012_5r", 0, -90, 0, -90, 0).stdout
        xyz, rpy = (re.search(rf"{label} +([-0-9. ]+)", flange)[1].split() for label in ("position mm", "yaw deg"))
        shown = self.console_of(self.expect_as_host(("--robot", "hu2012_5r", "--xyz", *xyz, "--rpy", *rpy)))
        for angles in shown:
            for deg, expected in zip(angles, (0, -90, 0, -90, 0), strict=True):
                self.assertAlmostEqual(deg, expected, delta=1e-6)

    def test_a_pose_out_of_reach_has_no_angles(self):
        pose = ("--robot", "abb_irb120", "--xyz", 2000, 0, 0, "--rpy", 0, 0, 0)
        arm = self.expect_as_host(pose, code=1)
        self.assertEqual(arm["console"], "solutions 0 status 3 selected -1\n")

    def test_the_previous_angles_choose_the_turn(self):
        previous = ("--previous", 0, 0, 0, 90, 0, -390)
        first, other = self.console_of(self.expect_as_host(POSE)), self.console_of(self.expect_as_host(POSE + previous))
        self.assertNotEqual(first, other)

    def test_text_for_users_has_the_console_and_the_cost(self):
        table = self.armature("ik", *POSE).stdout
        shown = self.armature("ik", *POSE, "--on", "a9").stdout
        self.assertTrue(shown.startswith(table))
        below = shown[len(table) :].splitlines()
        self.assertEqual(below[0], "console of the firmware, from the pin of its serial line:")
        self.assertEqual(below[1], "solutions 8 status 0 selected 1")
        self.assertRegex(
            below[-3], r"^by core 1 of the Cortex-A9: \d+ instructions, \d+ clocks \(\d+\.\d\d us\) at 1\.5 "
        )
        self.assertEqual(below[-2], "largest difference from the host: 0.0000 pulses")
        self.assertEqual(below[-1], "the controller that is compiled for the host shows the same text, byte for byte")


if __name__ == "__main__":
    main()
