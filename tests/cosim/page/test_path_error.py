"""The path error in the report: helices, splines and what cannot be measured. The curves are computed here again."""

import json
import math
import random
import shutil

from report_program import OURS, ReportProgram, main

SETTLED = "After a move without a path, encoders are measured when the drives have settled."
SPLINE, HELIX = 1, 2  # moves of spline_and_helix; move 0 is a joint move


def natural_spline(points):
    """The natural cubic spline over the sum of the chords, as a function of the piece and the share of it."""
    chords = [math.dist(a, b) for a, b in zip(points, points[1:])]
    bends = [[0.0] * len(points) for _ in range(3)]  # second derivatives of each coordinate
    for axis, bend in enumerate(bends):
        for _ in range(200):  # Gauss-Seidel
            for i in range(1, len(points) - 1):
                before, after = chords[i - 1], chords[i]
                slopes = [(points[j + 1][axis] - points[j][axis]) / chords[j] for j in (i - 1, i)]
                rest = before * bend[i - 1] + after * bend[i + 1]
                bend[i] = (6 * (slopes[1] - slopes[0]) - rest) / (2 * (before + after))

    def at(piece, share):
        chord, left, right = chords[piece], 1 - share, share
        return [
            left * points[piece][axis]
            + right * points[piece + 1][axis]
            + ((left**3 - left) * bend[piece] + (right**3 - right) * bend[piece + 1]) * chord**2 / 6
            for axis, bend in enumerate(bends)
        ]

    return at


class PathError(ReportProgram):
    size = (700, 500)  # nobody looks at it

    def summary(self, out="x"):
        return json.loads((self.folder / out / "summary.json").read_text())

    def show_spline_with(self, change):
        """Opens the report of spline_and_helix after a change of the moves in its summary."""
        out, _ = self.run_once(OURS / "spline_and_helix")
        shutil.copytree(out, self.folder / "x")
        summary = self.summary()
        change(summary["result"]["moves"])
        (self.folder / "x/summary.json").write_text(json.dumps(summary))
        self.armature("report", "x")
        self.open("x/report.html")

    def errors(self, side, move=None):
        """The curve of a side; of one move, or of all."""
        curve = {"encoder": "curves", "reference": "dashed"}[side]
        values, ticks = self.page.run(
            f"[Array.from(report.plots.find(p => p.what.id === 'path-error').what.{curve}[0],"
            " e => isNaN(e) ? null : e), Array.from(report.run.tick)]"
        )
        if move is None:
            return [value for value in values if value is not None]
        first, last = move["start_tick"], move["start_tick"] + move["taken_ticks"]
        return [value for value, tick in zip(values, ticks) if first < tick < last]

    def assert_curves_agree_with_the_summary(self, out):
        for side, key in (("encoder", "path_error"), ("reference", "command_path_error")):
            measured = self.summary(out)["result"][key]["mm"]
            # The run has measured in every tick. The angles of the trace are rounded.
            self.assertAlmostEqual(max(self.errors(side)), measured, delta=0.02 * measured + 1e-7)

    def note(self):
        return self.page.run("document.querySelector('#plot-path-error .note')?.textContent")

    def distances(self, move, points):
        shape = f"report.pathShape(report.run.summary.result.moves[{move}].path)"
        return self.page.run(f"(shape => {json.dumps(points)}.map(point => shape.distance(point)))({shape})")

    def test_the_curves_agree_with_what_the_run_has_measured(self):
        self.show_spline_with(lambda _: None)
        self.assertEqual(self.note(), SETTLED)
        self.assert_curves_agree_with_the_summary("x")
        out = self.show(OURS / "gcode_helix")
        self.assertIsNone(self.note())
        self.assert_curves_agree_with_the_summary(out)

    def test_a_helix_that_is_wider_than_the_motion_is_off_by_the_difference(self):
        def widen(moves):
            path = moves[HELIX]["path"]
            center, radius, normal = path["center_mm"], path["radius_mm"], path["normal"]
            for key in ("start_mm", "end_mm"):
                arm = [a - b for a, b in zip(path[key], center)]
                along = sum(a * n for a, n in zip(arm, normal))
                path[key] = [p + (a - along * n) * 0.5 / radius for p, a, n in zip(path[key], arm, normal, strict=True)]
            path["radius_mm"] += 0.5

        self.show_spline_with(widen)
        errors = self.errors("reference", self.summary()["result"]["moves"][HELIX])
        self.assertGreater(len(errors), 600)
        self.assertAlmostEqual(min(errors), 0.5, delta=1e-6)
        self.assertAlmostEqual(max(errors), 0.5, delta=1e-6)

    def test_the_distance_from_a_helix_is_that_to_the_nearest_of_many_points(self):
        def put(moves):
            moves[HELIX]["path"] = {
                "length_mm": 1, "start_mm": [5, 10, 20], "end_mm": [35, 0, 30], "center_mm": [5, 0, 20],
                "radius_mm": 10, "angle_deg": 1170, "normal": [1, 0, 0], "advance_mm": 30,
            }  # fmt: skip

        self.show_spline_with(put)
        curve = []
        for i in range(40001):
            angle = math.radians(1170) * i / 40000
            curve.append((5 + 30 * i / 40000, 10 * math.cos(angle), 20 + 10 * math.sin(angle)))
        draw = random.Random(16)
        points = [[draw.uniform(*ends) for ends in ((-5, 45), (-15, 15), (5, 35))] for _ in range(60)]
        for point, distance in zip(points, self.distances(HELIX, points), strict=True):
            nearest = min(math.dist(point, place) for place in curve)
            self.assertAlmostEqual(distance, nearest, delta=1e-4, msg=str(point))

    def test_the_distance_from_a_spline_is_known_beside_the_curve(self):
        points = [(400, -80, 300), (420, -40, 300), (380, -20, 300), (390, 10, 300), (430, 30, 300), (420, 90, 300)]

        def put(moves):
            path = moves[SPLINE]["path"]
            path["start_mm"], *path["through_mm"], path["end_mm"] = map(list, points)

        self.show_spline_with(put)
        at = natural_spline(points)
        draw = random.Random(17)
        beside, expected = [], []
        for _ in range(100):
            piece, share, off = draw.randrange(5), draw.uniform(0.01, 0.99), draw.uniform(0.001, 2)
            x, y, z = at(piece, share)
            ahead, behind = at(piece, share + 1e-6), at(piece, share - 1e-6)
            across = (behind[1] - ahead[1], ahead[0] - behind[0])
            scale = off / math.hypot(*across)
            # The curve is level, and it bends less than `off` would allow.
            beside += [[x, y, z + off], [x + scale * across[0], y + scale * across[1], z], [x, y, z]]
            expected += [off, off, 0]
        for point, distance, off in zip(beside, self.distances(SPLINE, beside), expected, strict=True):
            self.assertAlmostEqual(distance, off, delta=1e-6, msg=str(point))

    def test_what_is_not_measured_is_told(self):
        def put_on_conveyor(moves):
            moves[HELIX]["on_conveyor"] = True

        self.show_spline_with(put_on_conveyor)
        belt = "Not measured, because the path moves with the conveyor: move[2]."
        self.assertEqual(self.note(), f"{belt} {SETTLED}")
        moves = self.summary()["result"]["moves"]
        for side in ("encoder", "reference"):
            self.assertEqual(set(self.errors(side, moves[HELIX])), {None})
        self.assertNotIn(None, self.errors("reference", moves[SPLINE]))


if __name__ == "__main__":
    main()
