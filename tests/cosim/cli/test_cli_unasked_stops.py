"""armature run of a chain that the controller plans too slowly: a stop that nobody asked for does not pass."""

import json
import math
import os
import random

from cli_program import SCENARIOS, Program, main

LINES = 50
STEP_MM = 0.3
SPEED_MM_S = 100
# With the default of 350 the tool draws some of the curves faster than core 1 plans.
FAST = "[cpu]\ninverse_compute_cycles = 150\n"
SLOW = "[cpu]\nwindow_compute_cycles = 5000000  # 0.1 s for each window, on core 1\n"
LONGER = ("--set", "duration_s=1.1")
SEED = 20261127
# Each takes 16 s. tests/controller/app/smooth_curves_test.cpp draws a hundred, without the program around them.
CURVES = 1 if "ARMATURE_FEW_DRAWS" in os.environ else 2


def place(i):
    """On a circle of 40 mm, around the origin of the table."""
    angle = STEP_MM * i / 40
    return 40 * math.cos(angle), 40 * math.sin(angle), 0


class Curve:
    """Short lines on a smooth curve around the origin of the table; its radius waves."""

    def __init__(self, source):
        self.step_mm, self.radius_mm = source.uniform(0.15, 0.4), source.uniform(25, 50)
        self.wave_mm, self.wave_length_mm = source.uniform(0, 4), source.uniform(5, 12)
        self.count, self.speed_mm_s = source.randint(200, 400), source.uniform(50, 150)
        self.places = [self.place(i) for i in range(self.count + 1)]

    def place(self, i):
        s = self.step_mm * i
        radius, angle = self.radius_mm + self.wave_mm * math.sin(s / self.wave_length_mm), s / self.radius_mm
        return radius * math.cos(angle), radius * math.sin(angle), 0

    def __str__(self):
        return f"{self.count} lines of {self.step_mm:.3f} mm at {self.speed_mm_s:.1f} mm/s"


TABLE = """[tool]
xyz_mm = [0, 0, 100]
[[frame]]
name = "table"
xyz_mm = [430, 0, 430]
rpy_deg = [0, -45, 0]
"""


def approach(start):
    return f"""[[move]]
at_s = 0.01
type = "joint"
xyz_mm = {list(start)}
rpy_deg = [180, 0, 180]
frame = "table"
"""


SCENARIO = f"""description = "A curve of short lines"
robot = "abb_irb120"
duration_s = 0.75
{TABLE}{approach(place(0))}[[move]]
at_s = 0.02
type = "polyline"
points_file = "curve.csv"
frame = "table"
speed_mm_s = {SPEED_MM_S}
accel_mm_s2 = 2000
blend_mm = 0.02
"""


class UnaskedStops(Program):
    def scenario(self, tables=""):
        folder = self.folder / "s"
        folder.mkdir(exist_ok=True)
        (folder / "scenario.toml").write_text(SCENARIO + tables)
        points = [place(i) for i in range(1, LINES + 1)]
        (folder / "curve.csv").write_text("x_mm,y_mm,z_mm\n" + "".join("%.4f,%.4f,%.4f\n" % p for p in points))
        return "s", "--path", SCENARIOS, "--out", "out"

    def result(self):
        return json.loads((self.folder / "out/summary.json").read_text())["result"]

    def test_a_chain_that_is_planned_in_time_has_none(self):
        self.armature("run", *self.scenario())
        result = self.result()
        self.assertEqual(result["unasked_stops"], 0)
        self.assertEqual([move["continues"] for move in result["moves"][1:]], [False] + [True] * (LINES - 1))

    def test_a_stop_because_planning_is_slow_fails_the_run_unless_it_is_stated(self):
        done = self.armature("run", *self.scenario(SLOW), *LONGER, code=1)
        stops = self.result()["unasked_stops"]
        self.assertGreater(stops, 0)
        self.assertIn(
            f"expect.unasked_stops: expected 0, as it is not stated, got {stops} (before move[1], tick", done.stdout
        )
        log = (self.folder / "out/log.txt").read_text()
        self.assertEqual(log.count("after a stop that nobody asked for"), stops)
        # The first path of a chain begins at rest, as asked.
        moves = self.result()["moves"][2:]
        self.assertEqual([not move["continues"] for move in moves], [move.get("unasked_stop", False) for move in moves])
        self.assertEqual(sum(not move["continues"] for move in moves), stops)

        self.armature("run", *self.scenario(f"{SLOW}[expect]\nunasked_stops = {stops}\n"), *LONGER)

    def test_random_smooth_curves_of_a_fast_core_have_none(self):
        source = random.Random(SEED)
        for number in range(CURVES):
            curve = Curve(source)
            for kind in ("polyline", "program"):
                with self.subTest(f"seed {SEED}, curve {number}, {kind}: {curve}"):
                    self.run_curve(curve, kind)
                    result = self.result()
                    self.assertEqual(result["unasked_stops"], 0)
                    lines = [move["continues"] for move in result["moves"][-curve.count :]]
                    self.assertEqual(lines, [False] + [True] * (curve.count - 1))

    def run_curve(self, curve, kind):
        folder = self.folder / "curve"
        folder.mkdir(exist_ok=True)
        lines_s = curve.count * curve.step_mm / curve.speed_mm_s
        text = f'description = "{curve}"\nrobot = "abb_irb120"\n'
        if kind == "program":
            lines = "".join("G1 X%.4f Y%.4f Z%.4f\n" % place for place in curve.places[1:])
            head = f"G21 G90 G64 P0.02 F{60 * curve.speed_mm_s:.3f}\n"
            (folder / "curve.ngc").write_text(f"{head}{lines}M2\n")
            text += f'program = "curve.ngc"\n[gcode]\nframe = "table"\n{TABLE}{approach(curve.places[0])}'
        else:
            points = "".join("%.4f,%.4f,%.4f\n" % place for place in curve.places[1:])
            (folder / "points.csv").write_text(f"x_mm,y_mm,z_mm\n{points}")
            text += f"""duration_s = {2 + 2 * lines_s:.3f}
{TABLE}{approach(curve.places[0])}[[move]]
at_s = 0.02
type = "polyline"
points_file = "points.csv"
frame = "table"
speed_mm_s = {curve.speed_mm_s}
accel_mm_s2 = 2000
blend_mm = 0.02
"""
        (folder / "scenario.toml").write_text(text + FAST)
        self.armature("run", "curve", "--path", SCENARIOS, "--out", "out")

    def test_a_hold_on_the_path_is_asked_for(self):
        hold = '[[move]]\nat_s = 0.38\ntype = "hold"\n[[move]]\nat_s = 0.46\ntype = "resume"\n'
        self.armature("run", *self.scenario(hold))
        self.assertGreater(self.result()["held_s"], 0)

    def test_a_stop_on_the_path_is_asked_for_although_planning_is_slow(self):
        stop = '[[move]]\nat_s = 0.36\ntype = "stop"\n'
        back = '[[move]]\nat_s = 0.45\ntype = "line"\nxyz_mm = [40, 0, 0]\nframe = "table"\nspeed_mm_s = 50\n'
        done = self.armature("run", *self.scenario(stop + back + SLOW), code=1)
        self.assertIn("expect.refused_moves", done.stdout)  # the rest of the curve
        self.assertIsNotNone(self.result()["moves"][-1]["taken_ticks"])
        self.assertEqual(self.result()["unasked_stops"], 0)


if __name__ == "__main__":
    main()
