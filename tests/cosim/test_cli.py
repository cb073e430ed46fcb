"""The program as a user sees it: exit codes, files, messages. usage: test_cli.py PATH_TO_ARMATURE"""

import csv
import json
import os
import pathlib
import re
import shutil
import signal
import subprocess
import sys
import tempfile
import time
import unittest
import xml.etree.ElementTree

ROOT = pathlib.Path(__file__).resolve().parents[2]
SCENARIOS = ROOT / "scenarios"
ARMATURE = ""
SHORT = "zero_and_tiny_moves"  # the shortest scenario that moves


class Cli(unittest.TestCase):
    def setUp(self):
        self._folder = tempfile.TemporaryDirectory()
        self.folder = pathlib.Path(self._folder.name)
        self.addCleanup(self._folder.cleanup)

    def armature(self, *arguments, code=0):
        done = subprocess.run([ARMATURE, *map(str, arguments)], cwd=self.folder, text=True, capture_output=True)
        self.assertEqual(done.returncode, code, f"{arguments}\n{done.stdout}\n{done.stderr}")
        return done

    def copy_of(self, name):
        """A scenario with its robots in a folder of its own."""
        shutil.copytree(SCENARIOS / "robots", self.folder / "scenarios" / "robots", dirs_exist_ok=True)
        return pathlib.Path(shutil.copytree(SCENARIOS / name, self.folder / "scenarios" / name))

    def edit(self, path, old, new):
        text = path.read_text()
        self.assertIn(old, text)
        path.write_text(text.replace(old, new, 1))

    # ---- run

    def test_run_writes_trace_summary_and_log(self):
        done = self.armature("run", SCENARIOS / SHORT, "--out", "result")
        self.assertIn("cycles/s", done.stdout)
        self.assertIn("real-time factor", done.stdout)
        rows = list(csv.reader((self.folder / "result" / "trace.csv").read_text().splitlines()))
        self.assertEqual(rows[0][0], "tick")
        self.assertTrue(all(len(row) == len(rows[0]) for row in rows))
        self.assertGreater(len(rows), 10)
        summary = json.loads((self.folder / "result" / "summary.json").read_text())
        self.assertEqual(summary["scenario"], SHORT)
        self.assertTrue((self.folder / "result" / "log.txt").exists())

    def test_results_go_to_out_slash_scenario_by_default(self):
        self.armature("run", SCENARIOS / SHORT)
        self.assertTrue((self.folder / "out" / SHORT / "trace.csv").exists())

    def test_two_runs_give_the_same_bytes(self):
        for out in ("a", "b"):
            self.armature("run", SCENARIOS / SHORT, "--out", out, "--set", "trace.every_ticks=1")
        self.assertEqual((self.folder / "a/trace.csv").read_bytes(), (self.folder / "b/trace.csv").read_bytes())

    def test_bus_stalls_do_not_change_the_motion(self):
        self.armature("run", SCENARIOS / SHORT, "--out", "a")
        self.armature("run", SCENARIOS / SHORT, "--out", "b", "--set", "bus.stall_probability=0.3")
        self.assertEqual(0, self.armature("compare", "a/trace.csv", "b/trace.csv").returncode)

    def test_a_missed_expectation_is_exit_code_1(self):
        done = self.armature("run", SCENARIOS / SHORT, "--set", "expect.underruns=3", code=1)
        self.assertRegex(done.stdout + done.stderr, r"underruns.*3.*0")

    def test_a_bus_time_out_ends_the_run_with_address_cycle_and_core(self):
        done = self.armature("run", SCENARIOS / SHORT, "--set", "bus.stall_probability=0.9",
                             "--set", "bus.timeout_cycles=20", code=1)
        self.assertRegex(done.stdout + done.stderr, r"0x4[0-9A-F]{7} by core 0.*time-out.*cycle \d+")

    def test_waveform_window(self):
        self.armature("run", SCENARIOS / SHORT, "--vcd", "w.vcd", "--from", "0.012", "--to", "0.0121")
        text = (self.folder / "w.vcd").read_text()
        for name in ("step_o", "dir_o", "enc_a_i", "s_axi_awaddr_i"):
            self.assertRegex(text, rf"\$var \w+ +\d+ \S+ {name}\b")
        times = [int(t) for t in re.findall(r"^#(\d+)", text, re.M)]
        self.assertGreaterEqual(times[0], 12_000_000)
        self.assertLessEqual(times[-1], 12_100_000 + 20)
        self.assertGreater(len(times), 9_000)

    def test_every_signal_of_the_gtkwave_view_exists(self):
        self.armature("run", SCENARIOS / SHORT, "--vcd", "w.vcd", "--from", "0.012", "--to", "0.012001")
        scope, signals = [], set()
        for line in (self.folder / "w.vcd").read_text().split("$enddefinitions")[0].splitlines():
            words = line.split()
            if words[:2] == ["$scope", "module"]:
                scope.append(words[2])
            elif words[:1] == ["$upscope"]:
                scope.pop()
            elif words[:1] == ["$var"]:
                signals.add(".".join(scope + [words[4]]))
        shown = re.findall(r"^\+\{[^}]+\} (?:\(\d+\))?(\S+?)(?:\[\d+:\d+\])?$", (ROOT / "tools/arm_soc.gtkw").read_text(), re.M)
        self.assertGreater(len(shown), 60)
        self.assertEqual([name for name in shown if name not in signals], [])

    def test_fst_has_the_same_changes_as_vcd(self):
        window = ("--from", "0.012", "--to", "0.01205")
        self.armature("run", SCENARIOS / SHORT, "--vcd", "w.vcd", *window)
        self.armature("run", SCENARIOS / SHORT, "--fst", "w.fst", *window)
        back = subprocess.run(["fst2vcd", "w.fst"], cwd=self.folder, text=True, capture_output=True, check=True).stdout
        count = lambda text: len(re.findall(r"^#\d+", text, re.M))
        self.assertEqual(count(back), count((self.folder / "w.vcd").read_text()))

    def test_wave_on_fault_begins_at_the_fault(self):
        scenario = self.copy_of(SHORT)
        with (scenario / "scenario.toml").open("a") as file:
            file.write('\n[[fault]]\nat_s = 0.012\nkind = "estop"\nduration_s = 0.001\n')
        self.armature("run", scenario, "--vcd", "w.vcd", "--wave-on", "fault", code=1)
        times = [int(t) for t in re.findall(r"^#(\d+)", (self.folder / "w.vcd").read_text(), re.M)]
        self.assertEqual(times[0], 12_000_000 + 20)
        self.assertEqual(times[-1], 13_000_000 + 10)

    def test_wave_on_fault_without_a_fault_leaves_no_file(self):
        done = self.armature("run", SCENARIOS / SHORT, "--vcd", "w.vcd", "--wave-on", "fault")
        self.assertRegex(done.stdout, r"no waveform.*w\.vcd.*no fault")
        self.assertFalse((self.folder / "w.vcd").exists())
        self.assertNotIn("no waveform", self.armature("run", SCENARIOS / SHORT, "--vcd", "w.vcd", "--from", "0.1",
                                                      "--to", "0.1001").stdout)

    def test_set_may_stand_before_the_scenario(self):
        self.armature("run", "--set", "trace.every_ticks=40", "--set", "seed=2", SCENARIOS / SHORT, "--out", "x")
        ticks = [int(row[0]) for row in list(csv.reader((self.folder / "x/trace.csv").read_text().splitlines()))[1:]]
        self.assertEqual(ticks[1] - ticks[0], 40)

    def test_a_core_that_hangs_after_the_logic_stopped_the_arm_is_no_completed_run(self):
        scenario = self.copy_of(SHORT)
        with (scenario / "scenario.toml").open("a") as file:
            file.write('\n[[fault]]\nat_s = 0.1\nkind = "slow_core"\ncompute_us = 1000000\n')
        done = self.armature("run", scenario, "--out", "x", code=1)
        self.assertIn("expect.outcome: expected completed, got fault:controller_silent", done.stdout)
        result = json.loads((self.folder / "x/summary.json").read_text())["result"]
        self.assertEqual(result["outcome"], "fault:controller_silent")

    def test_a_summary_that_cannot_be_written_is_no_success(self):
        (self.folder / "x").mkdir()
        (self.folder / "x/summary.json").symlink_to("/dev/full")
        done = self.armature("run", SCENARIOS / SHORT, "--out", "x", code=3)
        self.assertIn("x/summary.json: No space left", done.stderr)
        self.assertTrue(pathlib.Path("/dev/full").is_char_device())

    def test_junit_that_cannot_be_written_is_no_success(self):
        done = self.armature("check", SCENARIOS / SHORT, "--junit", "/dev/full", code=3)
        self.assertIn("/dev/full: No space left", done.stderr)

    def test_ctrl_c_keeps_the_finished_verdicts_of_check(self):
        with subprocess.Popen([ARMATURE, "check", SCENARIOS / SHORT, SCENARIOS / "fig9_joint_move", "--junit", "j.xml"],
                              cwd=self.folder, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True) as run:
            self.assertIn(SHORT, run.stdout.readline())
            self.assertFalse((self.folder / "j.xml").exists())
            run.send_signal(signal.SIGINT)
            self.assertIn("1 not run", run.communicate(timeout=60)[0])
            self.assertEqual(run.returncode, 130)
        suite = xml.etree.ElementTree.parse(self.folder / "j.xml").getroot()
        self.assertEqual([case.get("name") for case in suite.iter("testcase")], [SHORT])

    def test_ctrl_c_closes_the_files_and_exits_130(self):
        with subprocess.Popen([ARMATURE, "run", SCENARIOS / "fig9_joint_move", "--out", "x", "--fst", "x.fst"],
                              cwd=self.folder, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True) as run:
            deadline = time.monotonic() + 30
            while not (self.folder / "x.fst").exists() and time.monotonic() < deadline:
                time.sleep(0.05)
            time.sleep(0.5)
            run.send_signal(signal.SIGINT)
            run.communicate(timeout=60)
            self.assertEqual(run.returncode, 130)
        text = (self.folder / "x" / "trace.csv").read_text()
        self.assertTrue(text.endswith("\n"))
        self.assertTrue(json.loads((self.folder / "x" / "summary.json").read_text())["result"]["interrupted"])
        subprocess.run(["fst2vcd", "x.fst", "-o", os.devnull], cwd=self.folder, check=True, capture_output=True)

    def test_fst_without_its_converter_is_refused_before_the_run(self):
        (self.folder / "bin").mkdir()
        (self.folder / "bin" / "sh").symlink_to("/bin/sh")
        done = subprocess.run([ARMATURE, "run", SCENARIOS / SHORT, "--fst", "w.fst"], cwd=self.folder, text=True,
                              capture_output=True, env={"PATH": str(self.folder / "bin")})
        self.assertEqual(done.returncode, 2, done.stderr)
        self.assertIn("vcd2fst", done.stderr)

    # ---- bad input

    def test_bad_input_is_exit_code_2_with_a_message(self):
        cases = [
            (("run", "no_such_scenario"), "no_such_scenario"),
            (("run", SCENARIOS / SHORT, "--set", "controller.feedbak=false"), "feedback"),
            (("run", SCENARIOS / SHORT, "--set", "duration_s=fast"), "duration_s"),
            (("run", SCENARIOS / SHORT, "--from", "0.1"), "--vcd"),
            (("run", SCENARIOS / SHORT, "--vcd", "a.vcd", "--from", "0.2", "--to", "0.1"), "--to"),
            (("run", SCENARIOS / SHORT, "--vcd", "a.vcd", "--from", "0.4"), "--from"),  # the end of the run
            (("run", SCENARIOS / SHORT, "--vcd", "a.vcd", "--from", "nan"), "--from"),
            (("run", SCENARIOS / SHORT, "--vcd", "a.vcd", "--to", "inf"), "--to"),
            (("check", SCENARIOS / SHORT, "--junit", "no/such/folder/j.xml"), "no/such/folder/j.xml"),
            (("run", SCENARIOS / SHORT, "--vcd", "no/such/folder/a.vcd"), "no/such/folder/a.vcd"),
            (("run", SCENARIOS / SHORT, "--out", "/proc/nowhere"), "/proc/nowhere"),
            (("run",), "scenario"),
            (("fly",), "fly"),
            (("compare", "a.csv", "b.csv"), "a.csv"),
            (("check", "no_such_scenario"), "no_such_scenario"),
        ]
        for arguments, expected in cases:
            with self.subTest(arguments):
                done = self.armature(*arguments, code=2)
                self.assertIn(expected, done.stderr + done.stdout)

    # ---- check, bless, compare

    def test_check_passes_and_writes_junit(self):
        done = self.armature("check", SCENARIOS / SHORT, "--junit", "j.xml")
        self.assertIn(SHORT, done.stdout)
        suite = xml.etree.ElementTree.parse(self.folder / "j.xml").getroot()
        case = next(suite.iter("testcase"))
        self.assertEqual(case.get("name"), SHORT)
        self.assertEqual(list(suite.iter("failure")), [])

    def test_check_reports_a_changed_golden_and_bless_accepts_it(self):
        scenario = self.copy_of(SHORT)
        golden = scenario / "golden.csv"
        lines = golden.read_text().splitlines(keepends=True)
        cells = lines[5].split(",")
        cells[2] = str(int(cells[2]) + 1)
        lines[5] = ",".join(cells)
        golden.write_text("".join(lines))
        done = self.armature("check", scenario, "--junit", "j.xml", code=1)
        self.assertIn("j1_cmd_pulses", done.stdout + done.stderr)
        failures = list(xml.etree.ElementTree.parse(self.folder / "j.xml").getroot().iter("failure"))
        self.assertEqual(len(failures), 1)
        self.assertIn("j1_cmd_pulses", self.armature("bless", scenario).stdout)
        self.armature("check", scenario)
        self.assertEqual(golden.read_bytes(), (SCENARIOS / SHORT / "golden.csv").read_bytes())

    def test_check_notices_a_change_that_only_the_full_rate_shows(self):
        scenario = self.copy_of(SHORT)
        text = (scenario / "scenario.toml").read_text()
        digest = re.search(r'sha256 = "([0-9a-f]{64})"', text).group(1)
        (scenario / "scenario.toml").write_text(text.replace(digest, digest[::-1]))
        self.assertIn("sha256", self.armature("check", scenario, code=1).stdout)

    def test_bless_is_refused_while_an_expectation_fails(self):
        scenario = self.copy_of(SHORT)
        before = (scenario / "golden.csv").read_bytes()
        self.edit(scenario / "scenario.toml", "underruns = 0", "underruns = 7")
        self.armature("bless", scenario, code=1)
        self.assertEqual((scenario / "golden.csv").read_bytes(), before)

    def test_compare_tells_equal_from_different(self):
        golden = SCENARIOS / SHORT / "golden.csv"
        self.armature("compare", golden, golden)
        changed = self.folder / "changed.csv"
        changed.write_text(golden.read_text().replace("\n20,", "\n21,", 1))
        self.assertIn("tick", self.armature("compare", golden, changed, code=1).stdout)

    # ---- information

    def test_list_and_info(self):
        listing = subprocess.run([ARMATURE, "list"], cwd=ROOT, text=True, capture_output=True, check=True).stdout
        for scenario in SCENARIOS.iterdir():
            if (scenario / "scenario.toml").exists():
                self.assertIn(scenario.name, listing)
        info = self.armature("info").stdout
        for text in ("50 MHz", "2500", "0x43C10000", "pulse_train"):
            self.assertIn(text, info)

    def test_every_help_has_an_example(self):
        self.assertIn("Example", self.armature("--help").stdout)
        for command in ("run", "check", "compare", "bless", "list", "info"):
            self.assertIn("armature " + command, self.armature(command, "--help").stdout)


if __name__ == "__main__":
    ARMATURE = os.path.abspath(sys.argv.pop(1))
    unittest.main()
