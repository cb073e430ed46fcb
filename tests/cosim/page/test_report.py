"""The report page in a browser: it shows what the files of the run say, and nothing of a user's text runs."""

import json
import math
import re
import shutil
import sys

from report_program import BRIEF, OURS, SCENARIOS, TINY, ReportProgram, main

MOVES = OURS / "joint_move_and_circle"  # with a trace of every tick
EVIL = "</script><script>window.ran = 1</script><img src=x onerror='window.ran = 2'>"
# Share of the pixels of a canvas that differ from its upper left corner.
PAINTED = """(canvas => {
  const copy = document.createElement('canvas');
  copy.width = canvas.width; copy.height = canvas.height;
  const context = copy.getContext('2d');
  context.drawImage(canvas, 0, 0);
  const pixels = new Uint32Array(context.getImageData(0, 0, copy.width, copy.height).data.buffer);
  return pixels.filter(pixel => pixel !== pixels[0]).length / pixels.length;
})"""
BOX = "(b => [b.x, b.y, b.width, b.height])(document.querySelector('%s').getBoundingClientRect())"
SLIDE = "(() => { const s = document.getElementById('slider'); s.value = %d; s.dispatchEvent(new Event('input')); })()"


class Panels(ReportProgram):
    def painted(self, selector):
        return self.page.run(f"{PAINTED}(document.querySelector('{selector}'))")

    def assert_panels_painted(self, plots):
        for plot in plots:
            with self.subTest(plot):
                self.assertGreater(self.painted(f"#plot-{plot} canvas"), 0.002)
        self.assertGreater(self.painted("#lanes canvas"), 0.1)
        self.assertGreater(self.painted("#arm canvas"), 0.02)


class OneReport(Panels):
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


class Report(Panels):
    def test_the_address_leads_to_a_moment(self):
        every_tick = ("--set", "trace.every_ticks=1")
        out = self.show(TINY, *BRIEF, *every_tick, "--from", "0.01", "--to", "0.02")
        shown = "[report.timeline.time, ...report.timeline.window]"
        for value, expected in zip(self.page.run(shown), (0.015, 0.01, 0.02)):
            self.assertAlmostEqual(value, expected)
        self.page.of_page("Page.navigate", url="about:blank")
        self.page.open(out / "report.html", "#time=0.012&from=0.011&to=0.013")
        self.assertEqual(self.page.run(shown), [0.012, 0.011, 0.013])

    def test_a_watched_report_reloads_itself_and_stays_where_it_is(self):
        scenario = self.copy_of(self.brief())
        file = scenario / "scenario.toml"
        self.beside("watch", scenario, "--out", "x")
        self.addCleanup(self.page.of_page, "Page.navigate", url="about:blank")  # it asks for the file no more
        self.wait_for("x/reload.js")
        self.page.open(self.folder / "x/report.html")
        self.page.run("report.timeline.setWindow(0.01, 0.02); report.timeline.setTime(0.012)")
        text = file.read_text()
        file.write_text(text.replace("duration_s", "duration_x"))
        self.page.wait_until("document.getElementById('watch')?.textContent.includes('duration_x')")
        file.write_text(re.sub(r"(?m)^description = .*$", 'description = "second"', text))
        self.page.wait_until(
            "document.body && document.body.dataset.ready === 'yes'"
            " && document.querySelector('#head .description').textContent === 'second'"
        )
        self.assertEqual(self.page.run("[report.timeline.time, ...report.timeline.window]"), [0.012, 0.01, 0.02])
        self.assertEqual(self.page.run("document.getElementById('watch').textContent"), "")
        beside = {url.partition("?")[0] for url in self.page.requests()}
        page = (self.folder / "x").resolve().as_uri()
        self.assertLessEqual(beside, {page + "/report.html", page + "/reload.js"})

    def test_a_page_of_a_growing_run_shows_its_newest_moment(self):
        self.beside("run", SCENARIOS / "fig9_joint_move", "--out", "x", "--set", "duration_s=1000")
        self.wait_for("x/trace.csv")
        self.beside("report", "x", "--follow")
        self.addCleanup(self.page.of_page, "Page.navigate", url="about:blank")
        self.wait_for("x/reload.js")
        self.page.open(self.folder / "x/report.html")
        ready = "document.body && document.body.dataset.ready === 'yes'"
        newest = "report.timeline.time === report.run.end && report.timeline.window[1] === report.run.end"
        self.page.wait_until(f"{ready} && report.run.end > 0.5 && {newest}")
        # The page keeps what the user looks at.
        self.page.wait_until(f"{ready} && (report.timeline.setTime(0.01), window.end = report.run.end, true)")
        self.page.wait_until(f"{ready} && window.end === undefined && report.timeline.time === 0.01")

    def test_a_fault_is_a_lane(self):
        scenario = self.copy_of(TINY)
        with (scenario / "scenario.toml").open("a") as file:
            file.write('\n[[fault]]\nat_s = 0.012\nkind = "estop"\nduration_s = 0.001\n')
        self.show(scenario, *BRIEF, code=1)
        self.assert_panels_painted(["position"])
        text = self.page.run(
            "report.lanes.lanes.flatMap(([name, items]) => items.map(i => name + ' ' + i.label)).join('; ')"
        )
        for part in ("State fault", "Faults injected: estop", "Faults fault: estop"):
            self.assertIn(part, text)
        # The head says why the run failed.
        missed = self.page.run("report.run.summary.result.expectations.filter(e => !e.met).map(e => e.key)")
        self.assertTrue(missed)
        self.assertIn(f"{missed[0]}: expected", self.page.run("document.querySelector('#head .failure').textContent"))

    def test_a_step_of_the_set_points_at_a_fault_hides_no_acceleration(self):
        self.show(SCENARIOS / "estop_and_clear", "--engine", "model")
        self.assertEqual(self.page.run("report.run.steps.length"), 2)
        accelerations = "report.run.acceleration.flatMap(values => Array.from(values, Math.abs)).filter(a => !isNaN(a))"
        limits = self.page.run("report.run.axes.map(axis => axis.max_accel_deg_s2)")
        self.assertLess(self.page.run(f"Math.max(...{accelerations})"), 1.02 * max(limits))
        self.assertIn("a fault begins", self.page.run("document.querySelector('#plot-acceleration .note').textContent"))
        moves = self.page.run("report.lanes.lanes.find(([name]) => name === 'Moves')[1]")
        move = next(one for one in moves if "not finished" in one["detail"])
        fault = self.page.run(
            "report.lanes.lanes.find(([name]) => name === 'Faults')[1].find(f => f.label === 'fault: estop')"
        )
        self.assertEqual(move["to"], fault["from"])

    def test_a_program_is_a_lane_and_names_its_moves(self):
        (self.folder / "s").mkdir()
        (self.folder / "robots").symlink_to(SCENARIOS / "robots")
        (self.folder / "s/part.ngc").write_text("G21 G91 F6000\n(MSG, cut it)\nG1 X1\nM2\n")
        (self.folder / "s/scenario.toml").write_text(
            'description = "d"\nrobot = "abb_irb120"\nduration_s = 0.1\nprogram = "part.ngc"\n'
        )
        self.show(self.folder / "s")
        text = self.page.run(
            "report.lanes.lanes.flatMap(([name, items]) => items.map(i => name + ' ' + i.label)).join('; ')"
        )
        for part in ("Program 1;", "Program cut it;", "Program ended;", "Moves line 3 of part.ngc: line"):
            self.assertIn(part, text + ";")

    def test_the_line_of_the_program_at_the_cursor_is_highlighted_and_a_click_leads_to_a_line(self):
        out = self.show(SCENARIOS / "gcode_laser_cut", "--engine", "model")
        text = (SCENARIOS / "gcode_laser_cut/plate.ngc").read_text().splitlines()
        self.assertEqual(self.page.run("[...document.querySelectorAll('#program li')].map(l => l.textContent)"), text)
        moves = self.moves_of_lines(out)
        start = self.page.run("report.run.time[0] - report.run.tick[0] * 50e-6")
        highlighted = "[...document.querySelectorAll('#program li')].findIndex(l => l.classList.contains('%s')) + 1"
        for line, first, last in moves:
            at = start + (first + 0.9 * (last - first)) * 50e-6
            self.page.run(f"report.timeline.setTime({at})")
            self.assertEqual(self.page.run(highlighted % "moves"), line)
            self.page.run("report.timeline.setTime(0)")
            self.assertEqual(self.page.run(highlighted % "moves"), 0)
            self.page.run(f"document.querySelectorAll('#program li')[{line - 1}].click()")
            self.assertAlmostEqual(self.page.run("report.timeline.time"), start + first * 50e-6, places=9)
        # Core 1 reads the last line while the arm is still cutting.
        self.page.run("report.timeline.setTime(2)")
        self.assertEqual(self.page.run(highlighted % "reads"), len(text))
        self.page.run("report.timeline.setTime(report.timeline.end)")
        self.assertEqual(self.page.run(highlighted % "reads"), 0)
        # A line that does nothing leads nowhere.
        comment = "document.querySelectorAll('#program li')[0]"
        self.assertIn("A laser cuts", self.page.run(f"{comment}.textContent"))

    def moves_of_lines(self, out):
        """(line, first tick, last tick) of each move of the program."""
        moves = json.loads((out / "summary.json").read_text())["result"]["moves"]
        found = [(re.match(r"line (\d+) of plate.ngc", move["command"]), move) for move in moves]
        return [
            (int(line[1]), move["start_tick"], move["start_tick"] + move["taken_ticks"]) for line, move in found if line
        ]

    def test_ways_between_cuts_are_dashed(self):
        out = self.show(SCENARIOS / "gcode_laser_cut", "--engine", "model")
        # By the text of the program, in which each line has its own G0 or G1, G2, G3.
        text = (SCENARIOS / "gcode_laser_cut/plate.ngc").read_text().splitlines()
        cuts = [(first, last) for line, first, last in self.moves_of_lines(out) if not text[line - 1].startswith("G0")]
        ticks = [int(row["tick"]) for row in self.rows(out / "trace.csv")]
        shown = self.page.run(
            "(isWay => Array.from(report.run.tick, (_, row) => isWay(row)))(report.wayRows(report.run))"
        )
        inside = [any(first < tick < last for first, last in cuts) for tick in ticks]
        # A rounded corner between both belongs to either.
        self.assertLess(sum(way == cut for way, cut in zip(shown, inside)), 0.01 * len(ticks))
        self.assertGreater(sum(shown), 300)
        dashed = (
            "report.arm.scene.children.filter(c => c.isLine && Boolean(c.material.isLineDashedMaterial) === %s).length"
        )
        self.assertGreater(self.page.run(dashed % "true"), 4)
        self.assertGreater(self.page.run(dashed % "false"), 4)
        self.show(MOVES)
        self.assertEqual(
            self.page.run("report.run.time.filter((_, row) => report.wayRows(report.run)(row)).length > 0"), True
        )

    def test_frames_of_the_scenario_and_axes_of_the_joints_are_in_the_picture(self):
        self.show(SCENARIOS / "gcode_laser_cut", "--engine", "model")
        frames = self.page.run(
            "report.arm.scene.children.filter(c => c.children.some(d => d.isSprite)).map(c => c.matrix.elements.slice(12, 15))"
        )
        self.assertEqual(len(frames), 1)
        for shown, wanted in zip(frames[0], (0.38, 0, 0.25)):
            self.assertAlmostEqual(shown, wanted)
        # The axis of joint 2 lies level, across the arm, whatever joint 1 does about the vertical.
        axis = "(m => [m[8], m[9], m[10]])(report.arm.links[1].matrix.elements)"
        self.assertAlmostEqual(self.page.run(axis)[2], 0, places=6)
        axes = "report.arm.links.map(link => link.children.filter(c => c.isLine && c.material.isLineDashedMaterial).length)"
        self.assertEqual(self.page.run(axes), [1] * 6 + [0])

    def test_a_narrow_window_needs_no_scrolling_to_the_side(self):
        self.show(SCENARIOS / "gcode_laser_cut", "--engine", "model")
        self.addCleanup(self.page.of_page, "Emulation.clearDeviceMetricsOverride")
        for width in (390, 700, 1000):
            size = {"width": width, "height": 800, "deviceScaleFactor": 1, "mobile": False}
            self.page.of_page("Emulation.setDeviceMetricsOverride", **size)
            self.page.run("new Promise(done => requestAnimationFrame(() => requestAnimationFrame(done)))")
            self.assertLessEqual(self.page.run("document.documentElement.scrollWidth"), width)

    def test_a_program_that_has_changed_since_the_run_is_not_shown(self):
        (self.folder / "s").mkdir()
        (self.folder / "robots").symlink_to(SCENARIOS / "robots")
        (self.folder / "s/part.ngc").write_text("G21 G91 F6000\nG1 X1\nM2\n")
        (self.folder / "s/scenario.toml").write_text(
            'description = "d"\nrobot = "abb_irb120"\nduration_s = 0.1\nprogram = "part.ngc"\n'
        )
        self.armature("run", "s", "--out", "x")
        self.armature("report", "x")
        self.open("x/report.html")
        self.assertEqual(self.page.run("document.querySelectorAll('#program li').length"), 3)
        (self.folder / "s/part.ngc").write_text("G21 G91 F6000\nG1 X2\nM2\n")
        self.armature("report", "x")
        self.open("x/report.html")
        self.assertIn("has changed since the run", self.page.run("document.querySelector('#program').textContent"))

    def test_labels_of_a_lane_end_before_the_next_item(self):
        self.show(SCENARIOS / "gcode_laser_cut", "--engine", "model")
        for window in ("report.timeline.begin, report.timeline.end", "0.7, 1.2"):
            self.page.run(f"report.timeline.setWindow({window})")
            crossed, labelled = self.page.run(
                "(() => { const canvas = report.lanes.canvas.getContext('2d'); canvas.font = '11px sans-serif';"
                " const {drawn} = report.lanes; let crossed = 0; let labelled = 0;"
                " drawn.forEach((one, i) => { if (!one.labelled) return; labelled += 1;"
                " const end = one.left + 6 + canvas.measureText(one.item.label).width; const next = drawn[i + 1];"
                " if (next && next.y === one.y && end > next.left + 3) crossed += 1; }); return [crossed, labelled]; })()"
            )
            self.assertEqual(crossed, 0)
            self.assertGreater(labelled, 4)

    def test_a_failed_golden_shows_its_deviation(self):
        scenario = self.copy_of(TINY)
        lines = (scenario / "golden.csv").read_text().splitlines()
        cells = lines[5].split(",")
        column = lines[0].split(",").index("j2_enc_counts")
        cells[column] = str(int(cells[column]) + 3)
        (scenario / "golden.csv").write_text("\n".join([*lines[:5], ",".join(cells), *lines[6:]]) + "\n")
        self.show(scenario, code=1)
        self.assertEqual(self.page.run("document.getElementById('verdict').textContent"), "FAILED")
        head = self.page.run("document.querySelector('#head .failure').textContent")
        self.assertIn(self.page.run("report.run.summary.result.golden_text"), head)
        tick = self.page.run("report.run.tick[40]")
        self.assertIn(f"J2 deviates by -3 counts in tick {tick}", head)
        self.assert_panels_painted(["deviation"])
        deviation = self.page.run("report.run.other.deviation.map(d => Array.from(d))")
        # The golden has every tenth row of the trace; this is its fifth one.
        self.assertEqual([[row for row, d in enumerate(joint) if d] for joint in deviation], [[], [40], [], [], [], []])
        self.assertEqual(deviation[1][40], -3)
        # Its rows are joined, also in a part of the run between two of them, and stay readable up to the next one.
        self.page.run("report.timeline.setWindow(report.run.time[42], report.run.time[44])")
        shown = self.page.run("report.plots.find(p => p.what.id === 'deviation').rows().map(r => r[2])")
        self.assertEqual(shown, [-3, *[None] * 4, 0])
        self.page.run("report.timeline.setTime(report.run.time[43])")
        readout = self.page.run("document.querySelector('#plot-deviation .readout').textContent")
        self.assertIn("J2 -3", readout)

    def test_an_equal_golden_needs_no_plot_of_deviations(self):
        self.show(TINY)
        found = self.page.run("[report.run.other.name, report.plots.filter(p => p.what.id === 'deviation').length]")
        self.assertEqual(found, ["golden", 0])

    def test_text_of_a_user_does_not_run(self):
        scenario = self.copy_of(self.brief())
        text = (scenario / "scenario.toml").read_text()
        text = re.sub(r"(?m)^description = .*$", lambda _: f'description = "{EVIL}"', text)
        (scenario / "scenario.toml").write_text(text)
        out = self.show(scenario)
        self.assertEqual(self.page.run("document.querySelector('#head .description').textContent"), EVIL)
        self.assertIsNone(self.page.run("window.ran"))
        page = (out / "report.html").read_text()
        self.assertEqual(page.count("</script"), 3)  # data, libraries, ours
        self.assertNotIn("<img", page)

    def test_a_minute_at_a_kilohertz_is_small_and_opens_quickly(self):
        """Prints the time; a limit of it would depend on what else the machine does."""
        out, _ = self.run_once(MOVES, "--report")
        shutil.copytree(out, self.folder / "x")
        for name in ("trace.csv", "load.csv"):
            rows = (self.folder / "x" / name).read_text().splitlines()
            half = [line.split(",") for line in rows[1::20]]
            tick, time = (rows[0].split(",").index(name) for name in ("tick", "time_s"))
            lines = [rows[0]]
            for n in range(120):
                for cells in half:
                    cells = list(cells)
                    cells[tick] = str(int(cells[tick]) + 10000 * n)
                    cells[time] = f"{float(cells[time]) + n / 2:.8f}"
                    lines.append(",".join(cells))
            (self.folder / "x" / name).write_text("\n".join(lines) + "\n")
        self.armature("report", "x")
        size = (self.folder / "x/report.html").stat().st_size
        seconds = self.open("x/report.html")
        print(f"60 s at 1 kHz: {size / 1e6:.1f} MB, shown after {seconds:.2f} s", file=sys.stderr)
        self.assertLess(size, 15e6)
        self.assertEqual(self.page.run("report.run.time.length"), len(lines) - 1)
        self.assertEqual(self.page.run("report.run.load.awake[0].length"), len(lines) - 1)
        self.assertLess(max(self.page.run("report.plots.map(plot => plot.graph.numRows())")), 5000)


if __name__ == "__main__":
    main()
