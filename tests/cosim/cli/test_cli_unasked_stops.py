"""armature run of a chain that the controller plans too slowly: a stop that nobody asked for does not pass."""

import json
import math

from cli_program import SCENARIOS, Program, main

LINES = 50
STEP_MM = 0.3
SPEED_MM_S = 100
SLOW = "[cpu]\nplan_compute_cycles = 5000000  # 0.1 s for each window, on core 1\n"
LONGER = ("--set", "duration_s=1.1")


def place(i):
    """On a circle of 40 mm, around the origin of the table."""
    angle = STEP_MM * i / 40
    return 40 * math.cos(angle), 40 * math.sin(angle), 0


SCENARIO = f"""description = "A curve of short lines"
robot = "abb_irb120"
duration_s = 0.75
[tool]
xyz_mm = [0, 0, 100]
[[frame]]
name = "table"
xyz_mm = [430, 0, 430]
rpy_deg = [0, -45, 0]
[[move]]
at_s = 0.01
type = "joint"
xyz_mm = {list(place(0))}
rpy_deg = [180, 0, 180]
frame = "table"
[[move]]
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
