"""The report page in a browser: what a person does with a report, and that it shows what the files of the run say."""

import json
import math

from report_program import MOVES, PanelsProgram, main

BOX = "(b => [b.x, b.y, b.width, b.height])(document.querySelector('%s').getBoundingClientRect())"
SLIDE = "(() => { const s = document.getElementById('slider'); s.value = %d; s.dispatchEvent(new Event('input')); })()"


class OneReport(PanelsProgram):
    """What a person does with a report. Its page is open all the time; each test leaves the whole run shown."""

    def setUp(self):
        super().setUp()
        self.out = self.once("page", lambda: self.show(MOVES))

    def test_a_joint_move_is_shown_with_every_panel(self):
        self.assert_panels_painted(
            ["position", "speed", "acceleration", "jerk", "following", "pulses", "budget", "bus"]
        )
        self.assertEqual(self.page.run("document.getElementById('verdict').textContent"), "PASSED")
        self.assertIn("underruns", self.page.run("document.getElementById('expectations').textContent"))
        rows = self.rows(self.out / "trace.csv")
        for joint in range(6):
            for ours, theirs in (("reference", "ref_deg"), ("encoder", "enc_deg"), ("counts", "enc_counts")):
                shown = self.page.run(f"Array.from(report.run.{ours}[{joint}])")
                self.assertEqual(shown, [float(row[f"j{joint + 1}_{theirs}"]) for row in rows])

    def test_the_load_of_the_cores_is_shown_as_the_file_says(self):
        rows = self.rows(self.out / "load.csv")
        for core in range(2):
            for ours, theirs in (("awake", "awake_cycles"), ("bus", "bus_cycles")):
                shown = self.page.run(f"Array.from(report.run.load.{ours}[{core}])")
                self.assertEqual(shown, [float(row[f"core{core}_{theirs}"]) for row in rows])
        result = json.loads((self.out / "summary.json").read_text())["result"]
        # Measured by other means: the core's own count of its longest tick, and the number of accesses.
        self.assertEqual(max(int(row["core0_awake_cycles"]) for row in rows), result["worst_tick_cycles"])
        cycles = sum(int(row[f"core{core}_bus_cycles"]) for row in rows for core in range(2))
        accesses = result["bus_reads"] + result["bus_writes"]
        self.assertGreater(cycles / accesses, 10)
        self.assertLess(cycles / accesses, 25)
        self.assertGreater(max(int(row["core1_awake_cycles"]) for row in rows), 0)  # it has planned the circle
        readout = "document.querySelector('#plot-budget .readout').textContent"
        self.assertRegex(self.page.run(readout), r"core 0 \d+core 1 \d+")

    def test_values_of_every_tick_are_beyond_no_limit_because_they_are_rounded(self):
        beyond = (
            "report.plots.filter(plot => plot.what.limits).map(plot =>"
            " plot.what.curves.map((_, joint) => report.run.time.filter((_, row) => plot.isBeyond(joint, row)).length))"
        )
        self.assertEqual({count for plot in self.page.run(beyond) for count in plot}, {0})
        what = "report.plots[2].what"
        self.page.run(f"window.limits = {what}.limits; {what}.limits = limits.map(() => [-50, 50])")
        self.addCleanup(self.page.run, f"{what}.limits = limits")
        self.assertGreater(sum(self.page.run(beyond)[2]), 100)

    def test_the_slider_moves_arm_cursors_and_lanes_together(self):
        state = (
            "[report.arm.links[5].matrix.elements[12], report.timeline.time,"
            " ...Array.from(document.querySelectorAll('.cursor'), c => parseFloat(c.style.left))]"
        )
        self.page.run(SLIDE % 2000)
        before = self.page.run(state)
        picture = self.page.run("report.arm.renderer.domElement.toDataURL()")
        self.page.run(SLIDE % 8000)
        after = self.page.run(state)
        self.assertNotEqual(picture, self.page.run("report.arm.renderer.domElement.toDataURL()"))
        self.assertGreater(len(after), 8)
        for one, other in zip(before, after):
            self.assertNotAlmostEqual(one, other, places=3)
        self.assertAlmostEqual(min(after[2:]), max(after[2:]), delta=1.5)  # the cursors stand below each other

    def test_playing_moves_the_time_until_it_is_stopped(self):
        self.page.run("report.timeline.setTime(report.timeline.begin)")
        self.page.run("document.querySelector('#bar .play').click()")
        self.page.wait_until("report.timeline.time > report.timeline.begin")
        self.page.run("report.timeline.playing && document.querySelector('#bar .play').click()")
        self.assertFalse(self.page.run("report.timeline.playing"))

    def test_zooming_one_plot_zooms_all_to_full_detail(self):
        left, top, width, height = self.page.run(BOX % "#plot-position .area")
        shown = "report.plots.map(plot => plot.graph.numRows())"
        windows = "report.plots.map(plot => plot.graph.xAxisRange())"
        self.assertLess(max(self.page.run(shown)), 5000)
        self.page.drag((left + width * 0.5, top + height * 0.5), (left + width * 0.55, top + height * 0.5))
        self.page.wait_until("report.timeline.window[1] < 0.35")
        begin, end = self.page.run("report.timeline.window")
        self.assertAlmostEqual(end - begin, 0.025, delta=0.01)
        self.assertEqual(self.page.run(windows), [[begin, end]] * len(self.page.run(windows)))
        rows = sum(begin <= float(row["time_s"]) <= end for row in self.rows(self.out / "trace.csv"))
        for count in self.page.run(shown):
            self.assertAlmostEqual(count, rows, delta=2)
        self.page.run("document.querySelector('#bar .all').click()")
        self.assertEqual(self.page.run("report.timeline.window[1]"), self.page.run("report.timeline.end"))

    def test_the_tool_is_where_the_trace_says_and_has_the_speed_of_its_way(self):
        rows = self.rows(self.out / "trace.csv")
        for side, name in (("reference", "ref"), ("encoder", "enc")):
            shown = self.page.run(f"report.run.tool.{side}.map(values => Array.from(values))")
            for values, axis in zip(shown, "xyz"):
                wanted = [float(row[f"tcp_{name}_{axis}_mm"]) for row in rows]
                self.assertLess(max(abs(one - other) for one, other in zip(values, wanted)), 2e-5)
        speed = self.page.run("Array.from(report.run.toolSpeed)")
        self.assertEqual((speed[0], speed[-1]), (None, None))
        points = [[float(row[f"tcp_ref_{axis}_mm"]) for axis in "xyz"] for row in rows]
        for at in range(1, len(rows) - 1, 97):
            self.assertAlmostEqual(
                speed[at], math.dist(points[at - 1], points[at + 1]) / 1e-4, delta=0.5
            )  # of rounded mm
        self.assert_panels_painted(["tool", "tool-speed"])

    def test_the_mouse_over_a_plot_shows_the_values_there(self):
        left, top, width, height = self.page.run(BOX % "#plot-speed .area")
        readout = "document.querySelector('#plot-position .readout').textContent"
        at_cursor = self.page.run(readout)
        where = {"x": left + width * 0.6, "y": top + height / 2}
        self.page.of_page("Input.dispatchMouseEvent", type="mouseMoved", **where)
        self.page.wait_until("report.timeline.pointed !== null")
        pointed = self.page.run("report.timeline.pointed")
        row = self.page.run("report.run.rowAt(report.timeline.pointed)")
        below = self.page.run(f"report.plots[1].graph.toDataXCoord({width * 0.6})")
        self.assertAlmostEqual(pointed, below, delta=2e-3)
        self.assertIn(f"{self.page.run('report.run.time')[str(row)]:.6f} s", self.page.run(readout))
        self.page.of_page("Input.dispatchMouseEvent", type="mouseMoved", x=5, y=5)
        self.page.wait_until("report.timeline.pointed === null")
        self.assertEqual(self.page.run(readout), at_cursor)

    def test_keys_play_and_step(self):
        self.page.run("document.activeElement.blur(); report.timeline.setTime(report.run.time[100])")
        for key, shift, row in (
            ("ArrowRight", 0, 101),
            ("ArrowRight", 8, 111),
            ("ArrowLeft", 0, 110),
            ("ArrowLeft", 8, 100),
        ):
            self.press(key, shift)
            self.assertEqual(self.page.run("report.run.rowAt(report.timeline.time)"), row, key)
        self.press(" ")
        self.assertTrue(self.page.run("report.timeline.playing"))
        self.press(" ")
        self.assertFalse(self.page.run("report.timeline.playing"))
        self.page.run("document.querySelector('#bar .speed').focus(); report.timeline.setTime(report.run.time[100])")
        self.press("ArrowRight")  # of the field
        self.assertEqual(self.page.run("report.run.rowAt(report.timeline.time)"), 100)
        self.page.run("document.activeElement.blur()")

    def press(self, key, modifiers=0):
        self.page.of_page("Input.dispatchKeyEvent", type="keyDown", key=key, modifiers=modifiers)
        self.page.of_page("Input.dispatchKeyEvent", type="keyUp", key=key, modifiers=modifiers)

    def test_the_wheel_zooms_with_ctrl_and_keeps_the_time_below_the_mouse(self):
        for selector, time in (
            ("#plot-speed .area", "report.plots[1].graph.toDataXCoord(%f)"),
            ("#lanes canvas", "report.lanes.timeAt(%f)"),
        ):
            with self.subTest(selector):
                self.page.run("report.timeline.showAll(); window.scrollTo(0, 0)")
                self.addCleanup(self.page.run, "report.timeline.showAll()")
                left, top, width, height = self.page.run(BOX % selector)
                under = time % (width * 0.6)
                before, shown = self.page.run(under), self.page.run("report.timeline.window")
                wheel = {
                    "type": "mouseWheel",
                    "x": left + width * 0.6,
                    "y": top + height / 2,
                    "deltaX": 0,
                    "deltaY": -100,
                }
                self.page.of_page("Input.dispatchMouseEvent", **wheel, modifiers=2)
                self.page.wait_until(f"report.timeline.window[1] < {shown[1]}")
                begin, end = self.page.run("report.timeline.window")
                self.assertAlmostEqual((shown[1] - shown[0]) / (end - begin), 1.25, delta=0.01)
                self.assertAlmostEqual(self.page.run(under), before, delta=2e-3)

    def test_a_cartesian_move_has_its_path_and_its_error(self):
        self.assert_panels_painted(["path-error", "position"])
        rows = self.rows(self.out / "trace.csv")
        for side, name in (("reference", "ref"), ("encoder", "enc")):
            for at in (0, len(rows) // 2, len(rows) - 1):
                point = self.page.run(f"report.run.kinematics.toolPoint(report.run.jointsAt(report.run.{side}, {at}))")
                for axis, value in zip("xyz", point):
                    self.assertAlmostEqual(value, float(rows[at][f"tcp_{name}_{axis}_mm"]), delta=2e-5)
        measured = json.loads((self.out / "summary.json").read_text())["result"]["path_error"]["mm"]
        largest = self.page.run(
            "Math.max(...report.plots.find(p => p.what.id === 'path-error').what.curves[0].filter(e => !isNaN(e)))"
        )
        self.assertAlmostEqual(largest, measured, delta=0.02 * measured)  # the angles of the trace are rounded


if __name__ == "__main__":
    main()
