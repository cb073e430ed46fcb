"""armature run with a program: errors of its text, its alarms, its end, and where it brings the arm."""

import itertools
import json
import math
import re
import tomllib

from cli_program import SCENARIOS, Program, main

# A move brings the arm out of its singularity first. The tool then stands at this place of the base (d6 = 72 mm, turned
# down by joint 5), where programs have their 0.
JOINT_5_DEG = 10
START_MM = [302 + 72 * math.cos(math.radians(JOINT_5_DEG)), 0, 630 - 72 * math.sin(math.radians(JOINT_5_DEG))]
BEGIN_S = 0.16
SCENARIO = """description = "d"
robot = "abb_irb120"
duration_s = {duration_s}
program = "{program}"
program_at_s = {begin_s}
[[move]]
at_s = 0
type = "joint"
target_deg = [0, 0, 0, 0, {joint_5_deg}, 0]
[[frame]]
name = "start"
xyz_mm = {start}
[trace]
tcp = true
[gcode]
frame = "start"
{tables}"""

# Programs that end where it is not obvious: loops, subroutines, inches, increments, arcs, an early end.
ENDS = {
    "loop": "G21 G90 F6000\n#1=0\no1 while [#1 LT 3]\n#1=[#1+1]\nG1 X[#1*2] Y[-#1]\no1 endwhile\nM2\n",
    "subroutine": "G21 F6000\no1 sub\nG91 G1 X#1 Z-1\nG90\no1 endsub\no1 call [2.5]\no1 call [-1]\nM2\n",
    "inches": "G20 G91\nF300\nG1 X0.1 Y-0.05\nG21 X1\nM2\n",
    "arcs": "G21 G90 G17 F6000\nG2 X1.5 Y-1.5 J-1.5\nG18 G3 X3 Z1.5 K1.5\nM2\nG1 X100\n",
}


class RunsOfPrograms(Program):
    def scenario(self, program, after_s=0.2, tables="", name="part.ngc"):
        """A run that ends so long after the start of the program."""
        (self.folder / "s").mkdir(exist_ok=True)
        (self.folder / "s" / name).write_text(program)
        (self.folder / "s/scenario.toml").write_text(
            SCENARIO.format(
                duration_s=BEGIN_S + after_s,
                program=name,
                begin_s=BEGIN_S,
                joint_5_deg=JOINT_5_DEG,
                start=START_MM,
                tables=tables,
            )
        )
        return "s", "--path", SCENARIOS, "--out", "out"

    def result(self):
        return json.loads((self.folder / "out/summary.json").read_text())["result"]

    def test_all_errors_of_the_text_are_found_before_the_run(self):
        done = self.armature("run", *self.scenario("G21 F600\nG41 D1\nG1 X1\nG2 X30\nM2\n"), code=2)
        self.assertEqual(
            done.stderr.splitlines(),
            [
                "s/part.ngc:2:1: G41: the code is not supported: cutter compensation left",
                "s/part.ngc:4: G2: the arc has neither a radius nor a centre",
            ],
        )
        self.assertFalse((self.folder / "out").exists())

    def test_a_tool_that_the_scenario_does_not_have_is_told_with_what_to_add(self):
        done = self.armature("run", *self.scenario("G21 F600\nT2 M6\nM2\n", 0.01, "tools = [1]\n"), code=2)
        self.assertEqual(
            done.stderr,
            "s/part.ngc:2: T2: the tool is not in the tool table; set tools = [1, 2] in [gcode]\n",
        )

    def test_an_alarm_fails_the_run_with_its_line_unless_it_is_expected(self):
        program = "G21 F6000\nG1 X1\nX5000\nM2\n"
        done = self.armature("run", *self.scenario(program, 0.05), code=1)
        alarm = r"alarm: the path leaves the reach of the arm by up to \d+ mm"
        self.assertRegex(done.stdout, rf"program +line 3 of part.ngc {alarm} \(0\.\d+ s\)")
        self.assertRegex(done.stdout, rf"expected ended, as it is not stated, got {alarm} \(line 3 of part.ngc; 0\.")
        self.assertEqual([move["command"] for move in self.result()["moves"]], ["move[0]"])
        self.assertRegex((self.folder / "out/log.txt").read_text(), rf"error: \[.* s\] line 3 of part.ngc {alarm}\n")
        expected = '[expect]\nprogram_end = "alarm"\nprogram_end_line = 3\n'
        self.armature("run", *self.scenario(program, 0.05, expected))

    def test_a_run_that_is_shorter_than_its_program_fails_with_the_line(self):
        done = self.armature("run", *self.scenario("G21 F600\nG1 X0.1\nX5\nM2\n", 0.1), code=1)
        self.assertIn("got running (line 3 of part.ngc)", done.stdout)

    def test_messages_are_shown_and_a_pause_waits_for_the_operator(self):
        expected = '[expect]\nprogram_end = "paused"\nprogram_messages = ["change the part"]\n'
        done = self.armature("run", *self.scenario("G21\n(MSG, change the part)\nM0\nG0 X1\nM2\n", 0.01, expected))
        self.assertRegex(done.stdout, r'program +line 2 of part.ngc message: "change the part"')

    def test_it_ends_where_the_canonical_calls_end(self):
        for name, program in ENDS.items():
            with self.subTest(name):
                self.armature("run", *self.scenario(program, 0.28 if name == "arcs" else 0.2))
                canon = self.armature("gcode", "--canon", "s/part.ngc").stdout
                end = self.last_place(canon)
                measured = [mm - start for mm, start in zip(self.result()["final_tcp_mm"], START_MM)]
                for mm, expected in zip(measured, end):
                    self.assertAlmostEqual(mm, expected, delta=0.02, msg=f"{measured} {canon}")
                self.assertEqual(self.result()["program_end"], "ended")

    def test_the_golden_of_short_lines_nearly_has_the_programmed_speed_at_each_place(self):
        """Core 1 is busy for most of the time. The less it has planned, the sooner the tool must be able to stop."""
        folder = SCENARIOS / "gcode_short_lines"
        begin, end = (
            change["at_s"] for change in tomllib.loads((folder / "scenario.toml").read_text())["expect"]["output"]
        )
        rows = [row for row in self.rows(folder / "golden.csv") if begin < float(row["time_s"]) < end]
        places = [[float(row[f"tcp_ref_{axis}_mm"]) for axis in "xyz"] for row in rows]
        millimetres = [math.dist(*pair) for pair in itertools.pairwise(places)]
        times = [float(row["time_s"]) for row in rows]
        speeds = [mm / (after - before) for mm, (before, after) in zip(millimetres, itertools.pairwise(times))]
        held = [44 < speed < 50.5 for speed in speeds]
        first, last = held.index(True), len(held) - held[::-1].index(True)
        self.assertEqual([speed for speed in speeds[first:last] if not 44 < speed < 50.5], [])
        # 220.6 mm without the ramps at both ends.
        self.assertGreater(sum(millimetres[first:last]), 219)

    @staticmethod
    def last_place(canon):
        """X, Y and Z in mm behind the last call that moves."""
        unit, place, plane = 1.0, [0.0, 0.0, 0.0], "XY"
        for name, words in re.findall(r"([A-Z_0-9]+)\(([^)]*)\)", canon):
            numbers = [word.strip() for word in words.split(",")]
            if name == "USE_LENGTH_UNITS":
                unit = 25.4 if "INCH" in words else 1.0
            elif name == "SELECT_PLANE":
                plane = words.split("_")[-1]
            elif name in ("STRAIGHT_FEED", "STRAIGHT_TRAVERSE"):
                place = [float(number) * unit for number in numbers[:3]]
            elif name == "ARC_FEED":
                axes = {"XY": (0, 1, 2), "XZ": (2, 0, 1), "YZ": (1, 2, 0)}[plane]
                for axis, number in zip(axes, (numbers[0], numbers[1], numbers[5])):
                    place[axis] = float(number) * unit
        return place


if __name__ == "__main__":
    main()
