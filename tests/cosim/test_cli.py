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
import tomllib
import unittest
import xml.etree.ElementTree
from random import Random

ROOT = pathlib.Path(__file__).resolve().parents[2]
SCENARIOS = ROOT / "scenarios"
ARMATURE = ""
SHORT = "zero_and_tiny_moves"  # the shortest scenario that moves


class Program(unittest.TestCase):
    def setUp(self):
        self._folder = tempfile.TemporaryDirectory()
        self.folder = pathlib.Path(self._folder.name)
        self.addCleanup(self._folder.cleanup)

    def armature(self, *arguments, code=0):
        done = subprocess.run([ARMATURE, *map(str, arguments)], cwd=self.folder, text=True, capture_output=True)
        self.assertEqual(done.returncode, code, f"{arguments}\n{done.stdout}\n{done.stderr}")
        return done

    def text(self, name, text):
        (self.folder / name).write_bytes(text.encode())
        return name

    def rows(self, name):
        return list(csv.DictReader((self.folder / name).read_text().splitlines()))


class Cli(Program):
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
        done = self.armature("run", SCENARIOS / SHORT, "--out", "x", code=2)
        self.assertIn("x/summary.json: cannot write: No space left", done.stderr)
        self.assertTrue(pathlib.Path("/dev/full").is_char_device())

    def test_junit_that_cannot_be_written_is_no_success(self):
        done = self.armature("check", SCENARIOS / SHORT, "--junit", "/dev/full", code=2)
        self.assertIn("/dev/full: cannot write: No space left", done.stderr)

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
        for robot in (SCENARIOS / "robots").glob("*.toml"):
            self.assertRegex(listing, rf"(?m)^{robot.stem} +(six_r|five_r|joint moves only) ")
        info = self.armature("info").stdout
        for text in ("50 MHz", "2500", "0x43C10000", "pulse_train"):
            self.assertIn(text, info)

    def test_every_help_has_an_example(self):
        self.assertIn("Example", self.armature("--help").stdout)
        for command in ("run", "check", "compare", "bless", "fk", "ik", "list", "info"):
            self.assertIn("armature " + command, self.armature(command, "--help").stdout)


class Kinematics(Program):
    """armature fk and armature ik."""

    MATRIX = ",".join(f"t{row}{column}" for row in (1, 2, 3) for column in (1, 2, 3, 4))

    @staticmethod
    def robots():
        """Name, number of joints and limits of every robot with kinematics."""
        for path in sorted((SCENARIOS / "robots").glob("*.toml")):
            robot = tomllib.loads(path.read_text())
            if "kinematics" in robot:
                limits = [{**robot["defaults"], **axis} for axis in robot["axis"]]
                yield path.stem, [(axis["min_deg"], axis["max_deg"]) for axis in limits]

    def joints_header(self, joints, before="j"):
        return ",".join(f"{before}{i + 1}_deg" for i in range(joints))

    def test_joints_to_poses_to_joints_and_back(self):
        random = Random(2021)
        for robot, limits in self.robots():
            with self.subTest(robot):
                joints = [[random.uniform(*limit) for limit in limits] for _ in range(50)]
                self.text("j.csv", "\n".join([self.joints_header(len(limits)),
                                               *(",".join(map(repr, row)) for row in joints)]))
                self.armature("fk", "--robot", robot, "--in", "j.csv", "--out", "poses.csv")
                poses = (self.folder / "poses.csv").read_text().splitlines()
                self.assertEqual(poses[0], self.MATRIX)
                self.assertEqual(len(poses), 51)
                with_previous = [poses[0] + "," + self.joints_header(len(limits), "prev")]
                with_previous += [f"{pose},{','.join(map(repr, row))}" for pose, row in zip(poses[1:], joints)]
                self.text("poses.csv", "\n".join(with_previous))
                self.armature("ik", "--robot", robot, "--in", "poses.csv", "--out", "solutions.csv")
                solutions = self.rows("solutions.csv")
                self.assertEqual(list(solutions[0]), "pose branch shoulder elbow flip singular within_limits selected".split()
                                 + self.joints_header(len(limits)).split(","))
                selected = [row for row in solutions if row["selected"] == "1"]
                self.assertEqual([int(row["pose"]) for row in selected], list(range(50)))
                for row, expected in zip(selected, joints):
                    for i, angle in enumerate(expected):
                        self.assertAlmostEqual(float(row[f"j{i + 1}_deg"]), angle, delta=1e-5)
                # Every branch is a way to the same pose, to the last digits.
                self.text("j.csv", "\n".join([self.joints_header(len(limits)), *(
                    ",".join(row[f"j{i + 1}_deg"] for i in range(len(limits))) for row in solutions)]))
                self.armature("fk", "--robot", robot, "--in", "j.csv", "--out", "again.csv")
                for row, again in zip(solutions, (self.folder / "again.csv").read_text().splitlines()[1:]):
                    for a, b in zip(again.split(","), poses[1 + int(row["pose"])].split(",")):
                        self.assertAlmostEqual(float(a), float(b), delta=1e-10)

    def test_branches_are_numbered_in_their_order(self):
        self.text("p.csv", self.MATRIX + "\n0,0,1,350,0,-1,0,-120,1,0,0,500\n")
        rows = csv.DictReader(self.armature("ik", "--robot", "abb_irb120", "--in", "p.csv").stdout.splitlines())
        flags = [(row["branch"], row["shoulder"], row["elbow"], row["flip"]) for row in rows]
        signs = ("1", "-1")
        self.assertEqual(flags, [(str(4 * s + 2 * e + f), signs[s], signs[e], signs[f])
                                 for s in (0, 1) for e in (0, 1) for f in (0, 1)])

    def test_a_pose_that_cannot_be_reached_is_a_row_with_the_reason(self):
        self.text("p.csv", self.MATRIX + "\n1,0,0,2000,0,1,0,0,0,0,1,0\n0,0,1,350,0,-1,0,-120,1,0,0,500\n")
        lines = self.armature("ik", "--robot", "abb_irb120", "--in", "p.csv").stdout.splitlines()
        self.assertRegex(lines[1], r"^0,none,unreachable by \d+\.\d{6} mm,{11}$")
        self.assertTrue(lines[2].startswith("1,0,1,1,1,"))
        self.text("q.csv", self.MATRIX + "\n0,0,1,100,0,1,0,50,-1,0,0,100\n")
        lines = self.armature("ik", "--robot", "hu2012_5r", "--in", "q.csv").stdout.splitlines()
        self.assertRegex(lines[1], r"^0,none,orientation off by \d+\.\d{6} deg,{10}$")

    def test_a_pose_outside_the_limits_has_its_branches_and_no_choice(self):
        # Straight behind the robot, lower than the shoulder: joint 1 stops at 165 degrees.
        self.text("p.csv", self.MATRIX + "\n0,0,1,-300,0,-1,0,0,1,0,0,60\n")
        rows = list(csv.DictReader(self.armature("ik", "--robot", "abb_irb120", "--in", "p.csv").stdout.splitlines()))
        self.assertEqual(len(rows), 8)
        self.assertEqual({row["within_limits"] for row in rows}, {"0"})
        self.assertEqual({row["selected"] for row in rows}, {"0"})

    def test_bad_input_names_the_place_and_writes_nothing(self):
        good = self.MATRIX + "\n1,0,0,0,0,1,0,0,0,0,1,0\n"
        cases = [
            ("fk", "j1_deg,j2_deg\n", "in.csv:1:14: header: expected \"j3_deg\""),
            ("fk", self.joints_header(6) + "\n1,2,3,4,5,six\n1,2,3,4,5,nan\n", "in.csv:3:11: j6_deg: expected a number"),
            ("fk", "", "in.csv: is empty"),
            ("ik", good + "1,0,0,0,0,1,0,0,0,0,-1,0\n", "in.csv:3:1: expected a rotation"),
            ("ik", good + "1,0,0,0,0,1,0,0,0,0,1\n", "in.csv:3:22: expected 12 values as in the header, found 11"),
            ("ik", good.replace("t34", "t34,prev1_deg"), "expected \"prev2_deg\""),
        ]
        for command, text, expected in cases:
            with self.subTest(expected):
                self.text("in.csv", text)
                self.text("out.csv", "kept")
                done = self.armature(command, "--robot", "abb_irb120", "--in", "in.csv", "--out", "out.csv", code=2)
                self.assertIn(expected, done.stderr)
                self.assertEqual((self.folder / "out.csv").read_text(), "kept")
                self.assertEqual(done.stdout, "")

    def test_bad_arguments_are_refused(self):
        pose = ("--xyz", 350, -120, 500, "--rpy", 30, 120, -10)
        cases = [
            (("fk", "--robot", "abb_irb12", 0, 0, 0, 0, 0, 0), "did you mean abb_irb120"),
            (("fk", "--robot", "nowhere/x.toml", 0, 0, 0, 0, 0, 0), "nowhere/x.toml: cannot open"),
            (("fk", "--robot", "hu2012_5r", 0, 0, 0, 0, 0, 0), "expected 5 numbers, found 6"),
            (("fk", "--robot", "abb_irb120", 0, 0, 0, 0, 0, "nan"), "found \"nan\""),
            (("fk", "--robot", "abb_irb120"), "--in"),
            (("fk", "--robot", "abb_irb120", 0, 0, 0, 0, 0, 0, "--out", "x"), "--in"),
            (("ik", "--robot", "abb_irb120"), "--xyz"),
            (("ik", "--robot", "abb_irb120", "--xyz", 1, 2, 3), "--rpy"),
            (("ik", "--robot", "abb_irb120", *pose, "--previous", 1, 2, 3), "expected 6 numbers, found 3"),
            (("ik", "--robot", "abb_irb120", *pose, "--in", "p.csv"), "--in"),
            (("ik", "--robot", "abb_irb120", "--in", "no.csv"), "no.csv: cannot open"),
        ]
        for arguments, expected in cases:
            with self.subTest(arguments):
                self.assertIn(expected, self.armature(*arguments, code=2).stderr)

    def test_a_robot_without_kinematics_has_no_poses(self):
        text = (SCENARIOS / "robots/vo2021_6r.toml").read_text()
        self.text("plain.toml", re.sub(r"(?s)\[kinematics\].*?(?=\[defaults\])", "", text).replace("vo2021_6r", "plain"))
        self.assertIn("plain.toml: has no [kinematics]",
                      self.armature("fk", "--robot", "plain.toml", 0, 0, 0, 0, 0, 0, code=2).stderr)

    def test_one_pose_of_fk_is_the_argument_of_ik(self):
        pose = self.armature("fk", "--robot", "abb_irb120", 10, 20, -30, 40, 50, 60).stdout
        numbers = lambda label: re.search(rf"{label} +(\S+) +(\S+) +(\S+)", pose).groups()
        found = self.armature("ik", "--robot", "abb_irb120", "--xyz", *numbers("position mm"), "--rpy",
                              *numbers("roll pitch yaw deg"), "--previous", 10, 20, -30, 40, 50, 60).stdout
        selected = [line for line in found.splitlines() if "SELECTED" in line]
        self.assertEqual(len(selected), 1)
        angles = [float(x) for x in re.findall(r"-?\d+\.\d{9}", selected[0])]
        for angle, expected in zip(angles, (10, 20, -30, 40, 50, 60), strict=True):
            self.assertAlmostEqual(angle, expected, delta=1e-4)
        self.assertIn("outside limits", self.armature("fk", "--robot", "abb_irb120", 0, 0, 71, 0, 0, 0).stdout)

    def test_a_single_pose_that_cannot_be_taken_is_exit_code_1(self):
        far = self.armature("ik", "--robot", "abb_irb120", "--xyz", 2000, 0, 0, "--rpy", 0, 0, 0, code=1)
        self.assertRegex(far.stdout, r"no solution, unreachable by \d+\.\d+ mm")
        behind = self.armature("ik", "--robot", "abb_irb120", "--xyz", -300, 0, 60, "--rpy", 90, 0, 90, code=1)
        self.assertRegex(behind.stdout, r"none of them inside the limits")
        self.assertRegex(behind.stdout, r"joint 1 is outside -165 \.\. 165")

    def test_the_pose_of_figure_2_of_hu_is_one_double_root(self):
        found = self.armature("ik", "--robot", "hu2012_5r", "--xyz", -21, 0, 340, "--rpy", 0, 0, 180).stdout
        self.assertEqual(found.count("singular: elbow"), 2)
        for line in found.splitlines()[2:]:
            angles = [float(x) for x in re.findall(r"-?\d+\.\d{9}", line)]
            for angle, expected in zip(angles, (0, -90, 0, -90, 0), strict=True):
                self.assertAlmostEqual(angle, expected, delta=1e-5)

    def test_examples_of_the_help_work(self):
        joints = self.joints_header(6) + "\n10,20,-30,0,45,90\n"
        for command in ("fk", "ik"):
            examples = re.findall(r"^  (armature .*|printf .*)$", self.armature(command, "--help").stdout, re.M)
            self.assertGreaterEqual(len(examples), 3)
            for example in examples:
                self.text("joints.csv", joints)
                self.armature("fk", "--robot", "abb_irb120", "--in", "joints.csv", "--out", "poses.csv")
                path = f"{os.path.dirname(ARMATURE)}:{os.environ['PATH']}"
                done = subprocess.run(["sh", "-c", example], cwd=self.folder, text=True, capture_output=True,
                                      env={**os.environ, "PATH": path})
                self.assertEqual((done.returncode, done.stderr), (0, ""), example)

    def test_output_that_cannot_be_written_is_no_success(self):
        self.text("j.csv", self.joints_header(6) + "\n1,2,3,4,5,6\n")
        self.assertIn("/dev/full", self.armature("fk", "--robot", "abb_irb120", "--in", "j.csv", "--out", "/dev/full",
                                                 code=2).stderr)


if __name__ == "__main__":
    ARMATURE = os.path.abspath(sys.argv.pop(1))
    unittest.main()
