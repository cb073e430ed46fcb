"""armature run: results, expectations, overrides, bad input."""

import csv
import decimal
import hashlib
import json
import pathlib
import re
import time

from cli_program import BRIEF, MOMENT, SCENARIOS, TINY, Program, main

EVERY_TICK = ("--set", "trace.every_ticks=1")


class Run(Program):
    def test_what_is_not_finished_at_the_end_is_told_with_its_end(self):
        options = ("--set", "expect={unfinished_moves=2}", "--set", "duration_s=0.02")
        move = 'move=[{at_s=0.005,type="joint",target_deg=[9,0,0,0,0,0]},{at_s=0.006,type="joint",target_deg=[0,0,0,0,0,0]}]'
        done = self.armature("run", TINY, *options, "--set", move)
        self.assertRegex(done.stdout, r"moves +1 started, 0 finished, .*, 1 waiting and 1 under way at the end\n")
        self.assertRegex(done.stdout, r"under way +move\[0\]; as planned, its set-points end at 0\.\d{4} s\n")
        end_s = float(re.search(r"set-points end at (\S+) s", done.stdout).group(1))
        alone = ("--set", move.split(",{")[0] + "]", "--set", "expect={}", "--set", f"duration_s={end_s + 0.002}")
        self.armature("run", TINY, *alone)
        rows = self.rows(f"out/{TINY.name}/trace.csv")
        reached_s = next(float(row["time_s"]) for row in rows if float(row["j1_ref_deg"]) == 9)
        self.assertAlmostEqual(reached_s, end_s, delta=0.0015)  # a row of the trace is a millisecond

    def test_a_move_that_is_still_planned_at_the_end_is_told(self):
        self.text(
            "slow.toml",
            """description = "a line that is planned at a snail's pace"
robot = "kuka_kr6_r900"
duration_s = 0.02
unreferenced = false
[cpu]
inverse_compute_cycles = 100000
[[move]]
at_s = 0
type = "line"
frame = "tool"
xyz_mm = [0, 0, -100]
speed_mm_s = 10
[expect]
unfinished_moves = 1
""".replace(
                "unreferenced = false\n", ""
            ),
        )
        done = self.armature("run", "slow.toml", "--out", "x")
        self.assertRegex(
            done.stdout, r"moves +0 started, .*, 1 waiting \(still planning\) and 0 under way at the end\n"
        )

    def test_run_writes_trace_summary_and_log(self):
        done = self.armature("run", TINY, *BRIEF, "--out", "result")
        self.assertIn("cycles/s", done.stdout)
        self.assertIn("real-time factor", done.stdout)
        rows = list(csv.reader((self.folder / "result" / "trace.csv").read_text().splitlines()))
        self.assertEqual(rows[0][0], "tick")
        self.assertTrue(all(len(row) == len(rows[0]) for row in rows))
        self.assertGreater(len(rows), 10)
        summary = json.loads((self.folder / "result" / "summary.json").read_text())
        self.assertEqual(summary["scenario"], TINY.name)
        self.assertTrue((self.folder / "result" / "log.txt").exists())

    def test_results_go_to_out_slash_scenario_by_default(self):
        self.armature("run", TINY, *BRIEF)
        self.assertTrue((self.folder / "out" / TINY.name / "trace.csv").exists())

    def test_the_digests_of_summary_scenario_and_full_rate_trace_are_the_same(self):
        self.armature("run", TINY, "--set", "trace.every_ticks=1")
        summary = json.loads((self.folder / "out" / TINY.name / "summary.json").read_text())
        golden = re.search(r'sha256 = "(\w+)"', (TINY / "scenario.toml").read_text()).group(1)
        rows = self.rows(f"out/{TINY.name}/trace.csv")
        self.assertEqual(summary["result"]["sha256"], golden)
        self.assertEqual(rows[-1]["digest2"], golden[:16])
        # The decimated golden has the digests of the same ticks.
        full = {row["tick"]: row["digest2"] for row in rows}
        for row in csv.DictReader((TINY / "golden.csv").read_text().splitlines()):
            self.assertEqual(row["digest2"], full[row["tick"]])

    def test_the_columns_of_a_trace_are_the_documented_ones(self):
        table = (SCENARIOS / "RESULTS.md").read_text().split("| column ")[1].split("\n\n")[0]
        names = [name for row in table.splitlines()[2:] for name in re.findall(r"`([^`]+)`", row.split("|")[1])]
        columns = [
            column
            for name in names
            for column in ([f"j{n}{name[2:]}" for n in range(1, 7)] if name.startswith("jN_") else [name])
        ]
        self.armature("run", TINY, *BRIEF, "--set", "trace.tcp=true", "--out", "x")
        self.assertEqual((self.folder / "x/trace.csv").read_text().splitlines()[0].split(","), columns)
        states = {row["state"] for row in self.rows("x/trace.csv")}
        self.assertLessEqual(states, {"idle", "moving", "stopping", "holding", "fault"})
        self.assertIn("idle", states)

    def test_ticks_are_50_us_apart_exactly(self):
        out, _ = self.run_once(TINY, *BRIEF, *EVERY_TICK)
        times = [decimal.Decimal(row["time_s"]) for row in self.rows(out / "trace.csv")]
        self.assertEqual({later - time for time, later in zip(times, times[1:])}, {decimal.Decimal("0.00005")})

    def test_two_runs_give_the_same_bytes(self):
        out, _ = self.run_once(TINY, *BRIEF, *EVERY_TICK)
        self.armature("run", TINY, *BRIEF, *EVERY_TICK, "--out", "again")
        self.assertEqual((out / "trace.csv").read_bytes(), (self.folder / "again/trace.csv").read_bytes())

    def test_a_paced_run_is_not_faster_than_its_pace_and_gives_the_same_bytes(self):
        fast, _ = self.run_once(TINY, *BRIEF)
        start = time.monotonic()
        self.armature("run", TINY, *BRIEF, "--out", "paced", "--pace", "0.05")
        self.assertGreaterEqual(time.monotonic() - start, float(self.rows("paced/trace.csv")[-1]["time_s"]) / 0.05)
        self.assertEqual((fast / "trace.csv").read_bytes(), (self.folder / "paced/trace.csv").read_bytes())

    def test_a_processor_that_the_program_has_not_is_refused(self):
        for words in (
            ("run", TINY, "--cpu", "a9"),
            ("check", TINY, "--cpu", "a9"),
            ("run", TINY, "--set", 'cpu.processor="a9"'),
        ):
            told = self.armature(*words, code=2).stderr
            self.assertIn("--cpu a9 or [cpu] processor", told)
            self.assertIn("armature-iss (tools/iss)", told)
            self.assertEqual(list(self.folder.iterdir()), [])

    def test_charged_instructions_need_a_processor_that_executes_them(self):
        told = self.armature("run", TINY, "--set", "cpu.cpi=1.5", code=2).stderr
        self.assertIn("[cpu] cpi: expected it with --cpu a9", told)

    def test_the_option_of_the_processor_replaces_the_key(self):
        self.armature("run", TINY, *MOMENT, "--set", 'cpu.processor="a9"', "--cpu", "host")

    def test_a_pace_of_0_is_refused(self):
        self.assertIn("--pace", self.armature("run", TINY, "--pace", "0", code=2).stderr)

    def test_bus_stalls_do_not_change_the_motion(self):
        out, _ = self.run_once(TINY, *BRIEF)
        self.armature("run", TINY, *BRIEF, "--out", "stalled", "--set", "bus.stall_probability=0.3")
        self.assertEqual(0, self.armature("compare", out / "trace.csv", "stalled/trace.csv").returncode)

    def test_a_missed_expectation_is_exit_code_1(self):
        done = self.armature("run", TINY, *BRIEF, "--set", "expect.underruns=3", code=1)
        self.assertRegex(done.stdout + done.stderr, r"underruns.*3.*0")

    def test_a_missed_expectation_is_told_with_its_place_on_screen_in_the_log_and_in_the_summary(self):
        scenario = self.copy_of(TINY)
        text = (scenario / "scenario.toml").read_text()
        (scenario / "scenario.toml").write_text(re.sub("peak_pulses_per_tick = 1", "peak_pulses_per_tick = 5", text))
        line = text[: text.index("peak_pulses_per_tick")].count("\n") + 1
        done = self.armature("run", scenario, *BRIEF, "--out", "x", code=1)
        message = re.search(
            rf"not met +(.*/scenario.toml:{line}:1: expect.peak_pulses_per_tick: expected 5, got 1 "
            r"\(axis \d, tick \d+, 0\.\d{6} s\))",
            done.stdout,
        ).group(1)
        self.assertIn("error: not met: " + message, (self.folder / "x/log.txt").read_text())
        failures = json.loads((self.folder / "x/summary.json").read_text())["result"]["expect_failures"]
        self.assertEqual([failure["text"] for failure in failures], [message])

    def test_the_summary_tells_what_the_run_was_made_from(self):
        self.armature("run", TINY, *BRIEF, "--out", "x", "--set", "seed=3", "--set", "trace.every_ticks=40")
        summary = json.loads((self.folder / "x/summary.json").read_text())
        self.assertEqual((summary["seed"], summary["overrides"]), (3, [BRIEF[1], "seed=3", "trace.every_ticks=40"]))
        files = [TINY / "scenario.toml", SCENARIOS / "robots/vo2021_6r.toml"]
        self.assertEqual(
            [one["sha256"] for one in summary["inputs"]],
            [hashlib.sha256(file.read_bytes()).hexdigest() for file in files],
        )
        self.assertEqual([pathlib.Path(one["file"]).resolve() for one in summary["inputs"]], files)
        self.assertIn("armature " + summary["tool_version"] + "\n", self.armature("info").stdout)

    def test_a_bus_time_out_ends_the_run_with_address_cycle_and_core(self):
        done = self.armature(
            "run", TINY, "--set", "bus.stall_probability=0.9", "--set", "bus.timeout_cycles=20", code=1
        )
        self.assertRegex(done.stdout + done.stderr, r"0x4[0-9A-F]{7} by core 0.*time-out.*cycle \d+")

    def test_set_may_stand_before_the_scenario(self):
        self.armature("run", "--set", "trace.every_ticks=40", "--set", "seed=2", TINY, *BRIEF, "--out", "x")
        ticks = [int(row[0]) for row in list(csv.reader((self.folder / "x/trace.csv").read_text().splitlines()))[1:]]
        self.assertEqual(ticks[1] - ticks[0], 40)

    def test_the_variant_of_the_paper_shows_what_it_costs(self):
        done = self.armature("run", TINY, *BRIEF, "--variant", "paper", "--out", "x")
        self.assertRegex(done.stdout, r"variant +paper")
        self.assertRegex(done.stdout, r"largest residual +0 pulses")
        # The pulses are the same; what the five other motors did is not seen.
        paper = json.loads((self.folder / "x/summary.json").read_text())["result"]["paper"]
        self.assertEqual(
            paper, {"inexact_ticks": [0] * 6, "max_residual_pulses": 0, "lost_counts": [0, 0, 1, 1, -1, -1]}
        )

    def test_the_option_overrides_the_variant_of_a_scenario_of_the_paper(self):
        scenario = self.copy_of(TINY)
        text = (scenario / "scenario.toml").read_text()
        (scenario / "scenario.toml").write_text('variant = "paper"\npaper.switch_every_ticks = 20\n' + text)
        done = self.armature("run", scenario, *BRIEF, "--variant", "counts", "--engine", "rtl", "--out", "x")
        self.assertNotIn("paper", done.stdout)
        counts, _ = self.run_once(TINY, *BRIEF)
        self.assertEqual((self.folder / "x/trace.csv").read_bytes(), (counts / "trace.csv").read_bytes())

    def test_a_core_that_hangs_after_the_logic_stopped_the_arm_is_no_completed_run(self):
        scenario = self.copy_of(TINY)
        with (scenario / "scenario.toml").open("a") as file:
            file.write('\n[[fault]]\nat_s = 0.025\nkind = "slow_core"\ncompute_us = 1000000\n')
        done = self.armature("run", scenario, *BRIEF, "--out", "x", code=1)
        self.assertIn("expect.outcome: expected completed, got fault:controller_silent", done.stdout)
        result = json.loads((self.folder / "x/summary.json").read_text())["result"]
        self.assertEqual(result["outcome"], "fault:controller_silent")

    def test_injected_faults_and_inputs_stand_in_summary_and_log_with_their_effect(self):
        scenario = self.copy_of("pulse_loss_recovered") / "scenario.toml"
        self.edit(scenario, "at_s = 0.3", "at_s = 0.1")
        with scenario.open("a") as file:
            file.write("\n[[input]]\nat_s = 0.101\npin = 3\nlevel = 1\n")
        done = self.armature("run", scenario, "--out", "x", "--set", "duration_s=0.13", code=1)  # in mid-move
        log = (self.folder / "x/log.txt").read_text()
        summary = json.loads((self.folder / "x/summary.json").read_text())["result"]
        what = "pulse_loss of axis 3, 500 pulses"
        when = "at 0.100000 s (tick 1999, cycle 5000000)"
        self.assertIn(f"injected fault        {what} {when}:", done.stdout)
        self.assertIn("500 of 500 pulses lost, corrected by up to", done.stdout)
        self.assertIn(f"injected fault: {what}, {when}", log)
        self.assertRegex(log, r"cycle 5000000\): pulse_loss .*: 500 of 500 pulses lost, .* reports no fault\n")
        fault = summary["injected_faults"][0]
        self.assertEqual(
            [fault[key] for key in ("kind", "axis", "count", "lost_pulses", "tick", "cycle", "fault")],
            ["pulse_loss", 3, 500, 500, 1999, 5000000, None],
        )
        when = "0.101000 s (tick 2019, cycle 5050000)"
        self.assertIn(f"input                 pin 3 = 1 at {when}: no move waited for it", done.stdout)
        self.assertIn(f"input: pin 3 = 1, at {when}", log)
        self.assertEqual(
            [summary["inputs"][0][key] for key in ("pin", "level", "tick", "accepted_by_move")], [3, 1, 2019, None]
        )

    def test_a_summary_that_cannot_be_written_is_no_success(self):
        (self.folder / "x").mkdir()
        (self.folder / "x/summary.json").symlink_to("/dev/full")
        done = self.armature("run", TINY, *BRIEF, "--out", "x", code=2)
        self.assertIn("x/summary.json: cannot write: No space left", done.stderr)
        self.assertTrue(pathlib.Path("/dev/full").is_char_device())

    def test_bad_input_is_exit_code_2_with_a_message(self):
        cases = [
            (("run", "no_such_scenario"), "no_such_scenario"),
            (("run", TINY, "--set", "controller.feedbak=false"), "feedback"),
            (("run", TINY, "--set", "duration_s=fast"), "duration_s"),
            (("run", TINY, "--variant", "fpga"), "--variant: fpga not in {counts,paper}"),
            (("run", TINY, "--engine", "vhdl"), "--engine: vhdl not in {rtl,model,lockstep}"),
            (("run", TINY, "--fabric", "paper"), "--fabric: write --variant paper\n"),
            (("run", TINY, "--fabric", "rtl"), "--fabric: write --variant counts\n"),
            (("run", TINY, "--fabric", "x"), "--fabric: write --variant counts or --variant paper\n"),
            (
                ("run", TINY, "--set", "fabric=paper"),
                '--set fabric=paper: fabric: no longer a key, write variant = "paper"',
            ),
            (("run", TINY, "--variant", "paper", "--set", "controller.feedback=true"), "feedback"),
            (("run", TINY, "--from", "0.1"), "--vcd"),
            (("run", TINY, "--vcd", "a.vcd", "--from", "0.2", "--to", "0.1"), "--to"),
            (("run", TINY, "--vcd", "a.vcd", "--from", "0.12"), "--from"),  # the end of the run
            (("run", TINY, "--vcd", "a.vcd", "--from", "nan"), "--from"),
            (("run", TINY, "--vcd", "a.vcd", "--to", "inf"), "--to"),
            (("check", TINY, "--junit", "no/such/folder/j.xml"), "no/such/folder/j.xml"),
            (("run", TINY, "--vcd", "no/such/folder/a.vcd"), "no/such/folder/a.vcd"),
            (("run", TINY, "--out", "/proc/nowhere"), "/proc/nowhere"),
            (("run",), "scenario"),
            (("fly",), "fly"),
            (("compare", "a.csv", "b.csv"), "a.csv"),
            (("check", "no_such_scenario"), "no_such_scenario"),
        ]
        for arguments, expected in cases:
            with self.subTest(arguments):
                done = self.armature(*arguments, code=2)
                self.assertIn(expected, done.stderr + done.stdout)


if __name__ == "__main__":
    main()
