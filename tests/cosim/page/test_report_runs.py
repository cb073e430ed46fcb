"""The report page in a browser: runs with faults, programs, goldens or changed files, and text that must not run."""

import json
import re
import shutil
import sys

from report_program import BRIEF, MOVES, SCENARIOS, TINY, PanelsProgram, main

EVIL = "</script><script>window.ran = 1</script><img src=x onerror='window.ran = 2'>"


class Report(PanelsProgram):
    def write_scenario_with(self, program):
        """The scenario `s` in the folder of the test, whose G-code is `s/part.ngc`."""
        (self.folder / "s").mkdir()
        (self.folder / "robots").symlink_to(SCENARIOS / "robots")
        (self.folder / "s/part.ngc").write_text(program)
        (self.folder / "s/scenario.toml").write_text(
            'description = "d"\nrobot = "abb_irb120"\nduration_s = 0.1\nprogram = "part.ngc"\n'
        )

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
        self.write_scenario_with("G21 G91 F6000\n(MSG, cut it)\nG1 X1\nM2\n")
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
        self.write_scenario_with("G21 G91 F6000\nG1 X1\nM2\n")
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
