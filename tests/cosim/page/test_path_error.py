"""The path error in the report: helices, splines and what cannot be measured."""

import json
import shutil

from report_program import OURS, ReportProgram, main

SETTLED = "After a move without a path, encoders are measured when the drives have settled."
SPLINE, HELIX = 1, 2  # moves of spline_and_helix; move 0 is a joint move


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
            self.assertAlmostEqual(max(self.errors(side)), measured, delta=0.02 * measured + 1e-6)

    def note(self):
        return self.page.run("document.querySelector('#plot-path-error .note')?.textContent")

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
