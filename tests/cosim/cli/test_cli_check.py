"""armature check, bless and compare; list, info and help."""

import csv
import html
import json
import os
import pty
import re
import shutil
import signal
import subprocess
import urllib.parse
import xml.etree.ElementTree

from cli_program import ROOT, SCENARIOS, TINY, Program, main


class Check(Program):
    def assert_files_exist(self, text):
        """No message names a file that is gone afterwards."""
        for name in re.findall(r"[\w./-]+\.(?:csv|txt|json|toml)\b", text):
            if "/" in name:
                self.assertTrue((self.folder / name).exists(), f"{name}\n{text}")

    def files_below(self, folder):
        return sorted(str(path.relative_to(self.folder / folder)) for path in (self.folder / folder).rglob("*.*"))

    def test_check_passes_and_writes_junit(self):
        done = self.armature("check", TINY, "--junit", "j.xml")
        self.assertIn(TINY.name, done.stdout)
        suite = xml.etree.ElementTree.parse(self.folder / "j.xml").getroot()
        case = next(suite.iter("testcase"))
        self.assertEqual(case.get("name"), TINY.name)
        self.assertEqual(list(suite.iter("failure")), [])

    def test_check_shows_on_a_terminal_what_it_is_doing(self):
        terminal, its_end = pty.openpty()
        self.addCleanup(os.close, terminal)
        command = [self.path, "check", self.brief(), TINY]
        done = subprocess.run(command, cwd=self.folder, stdout=subprocess.PIPE, stderr=its_end, check=True)
        subprocess.run([*command, "--quiet"], cwd=self.folder, stdout=subprocess.DEVNULL, stderr=its_end, check=True)
        os.close(its_end)
        clear = "\r\x1b[K"
        expected = "".join(
            text + clear
            for text in (
                f"0 of 2 scenarios: {TINY.name}",
                "1 of 2 scenarios",
                f"1 of 2 scenarios: {TINY.name}",
                "2 of 2 scenarios",
            )
        )
        self.assertEqual(os.read(terminal, 4096).decode(), expected)
        self.assertNotIn(b"of 2", done.stdout)

    def test_junit_that_cannot_be_written_is_no_success(self):
        done = self.armature("check", TINY, "--junit", "/dev/full", code=2)
        self.assertIn("/dev/full: cannot write: No space left", done.stderr)

    def test_ctrl_c_keeps_the_finished_verdicts_of_check(self):
        with subprocess.Popen(
            [self.path, "check", TINY, SCENARIOS / "fig9_joint_move", "--junit", "j.xml"],
            cwd=self.folder,
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
            text=True,
        ) as run:
            self.assertIn(TINY.name, run.stdout.readline())
            self.assertFalse((self.folder / "j.xml").exists())
            run.send_signal(signal.SIGINT)
            self.assertIn("1 not run", run.communicate(timeout=60)[0])
            self.assertEqual(run.returncode, 130)
        suite = xml.etree.ElementTree.parse(self.folder / "j.xml").getroot()
        self.assertEqual([case.get("name") for case in suite.iter("testcase")], [TINY.name])

    def test_check_reports_a_changed_golden_and_bless_accepts_it(self):
        scenario = self.copy_of(TINY)
        golden = scenario / "golden.csv"
        lines = golden.read_text().splitlines(keepends=True)
        cells = lines[5].split(",")
        cells[3] = str(int(cells[3]) + 1)
        lines[5] = ",".join(cells)
        golden.write_text("".join(lines))
        done = self.armature("check", scenario, "--junit", "j.xml", code=1)
        self.assertIn("j1_cmd_pulses", done.stdout + done.stderr)
        failures = list(xml.etree.ElementTree.parse(self.folder / "j.xml").getroot().iter("failure"))
        self.assertEqual(len(failures), 1)
        blessed = self.armature("bless", scenario).stdout
        self.assertRegex(blessed, r"j1_cmd_pulses: golden before 1, this run 0 \(golden.csv line 6\)")
        self.assert_files_exist(blessed)
        self.armature("check", scenario)
        self.assertEqual(golden.read_bytes(), (TINY / "golden.csv").read_bytes())

    def test_check_keeps_the_results_of_what_failed_and_removes_those_of_an_earlier_failure(self):
        scenario = self.copy_of(TINY)
        golden = (scenario / "golden.csv").read_text()
        (scenario / "golden.csv").write_text(golden.replace("\n800,0.04006216,idle,0,", "\n800,0.04006216,idle,9,", 1))
        for arguments, folder in (((), "out/check"), (("--out", "kept here"), "kept here")):
            with self.subTest(folder):
                done = self.armature("check", scenario, *arguments, "--junit", "j.xml", code=1)
                if " " not in folder:  # which ends a name in the text
                    self.assert_files_exist(done.stdout)
                self.assertEqual(
                    self.files_below(folder),
                    [f"{TINY.name}/{name}" for name in ("load.csv", "log.txt", "summary.json", "trace.csv")],
                )
                command = re.search(r"to see it: armature (.*)", done.stdout).group(1)
                shown = subprocess.run(
                    f"{self.path} {command}", shell=True, cwd=self.folder, text=True, capture_output=True
                )
                self.assertEqual(shown.returncode, 1)
                self.assertRegex(
                    shown.stdout,
                    r"first mismatch at tick 800 \(0.040062 s\), j1_cmd_pulses: "
                    r"golden 9 \(golden.csv line 6\), this run 0 \(trace.csv line 42\)\n",
                )
                times = [float(row["time_s"]) for row in csv.DictReader(golden.splitlines())]
                self.assert_window_shown(f"out/{TINY.name}", times[3], times[4])
                summary = json.loads((self.folder / folder / TINY.name / "summary.json").read_text())
                self.assertEqual(summary["result"]["golden"], "differs")
                self.assertIn("j1_cmd_pulses", (self.folder / folder / TINY.name / "log.txt").read_text())
        (scenario / "golden.csv").write_text(golden)
        (self.folder / "out/check/other").mkdir()
        self.armature("check", scenario)
        self.assertEqual(self.files_below("out/check"), [])
        self.assertTrue((self.folder / "out/check/other").exists())

    def assert_window_shown(self, folder, begin_s, end_s):
        """Report and waveform have this time, and not much more."""
        page = (self.folder / folder / "report.html").read_text()
        shown = json.loads(re.search(r'"shown":(\{.*?\})', page).group(1))
        self.assertTrue(shown["from"] < begin_s <= shown["time"] <= end_s < shown["to"])
        self.assertLess(shown["to"] - shown["from"], 0.05)  # some rows
        wave = self.folder / folder / "failure.vcd"
        if end_s - begin_s > 0.002:  # a long one
            subprocess.run(["fst2vcd", wave.with_suffix(".fst"), "-o", wave], check=True, capture_output=True)
        with open(wave) as file:
            stamps = [int(line[1:]) * 1e-9 for line in file if line.startswith("#")]
        self.assertTrue(begin_s - 0.001 < stamps[0] < begin_s <= end_s < stamps[-1] < end_s + 0.001)

    def test_a_failed_expectation_is_shown_at_its_moment(self):
        """A late core: the first underrun is to blame. The command shows the run with its options."""
        late = self.copy_of("late_core")
        self.edit(late / "scenario.toml", "duration_s = 1.0", "duration_s = 0.31")
        # The golden would be that of the whole run.
        (late / "scenario.toml").write_text((late / "scenario.toml").read_text().partition("[golden]")[0])
        (late / "golden.csv").unlink()
        options = ("--set", "expect.underruns=0", "--engine", "rtl", "--cpu", "host", "--out", "my out")
        done = self.armature("run", late, *options, code=1)
        command = re.search(r"(?m)^to see it      armature (.*)$", done.stdout).group(1)
        self.assertIn(
            "--set expect.underruns=0 --engine rtl --cpu host --out 'my out' --report --vcd 'my out/failure.vcd' --from 0.",
            command,
        )
        shown = subprocess.run(f"{self.path} {command}", shell=True, cwd=self.folder, text=True, capture_output=True)
        self.assertEqual(shown.returncode, 1, shown.stderr)
        self.assertNotIn("to see it", shown.stdout)
        first_s = float(re.search(r"not met .*underruns.*tick \d+, (\S+) s", shown.stdout).group(1))
        self.assert_window_shown("my out", first_s - 1e-6, first_s + 1e-6)  # as rounded in the text

    def test_check_keeps_nothing_of_what_passed(self):
        self.armature("check", TINY)
        self.assertEqual(list(self.folder.iterdir()), [])

    def test_check_shows_a_missed_expectation_with_its_place_and_a_command(self):
        scenario = self.copy_of(TINY)
        self.edit(scenario / "scenario.toml", "underruns = 0", "underruns = 7")
        done = self.armature("check", scenario, "--junit", "j.xml", code=1)
        message = re.search(r"\S+/scenario.toml:\d+:1: expect.underruns: expected 7, got 0", done.stdout).group(0)
        self.assertIn(f"to see it: armature run {scenario} --report\n", done.stdout)  # no moment is to blame
        failure = next(xml.etree.ElementTree.parse(self.folder / "j.xml").getroot().iter("failure"))
        self.assertIn(message, failure.text)
        self.assertIn("not met: " + message, (self.folder / "out/check" / TINY.name / "log.txt").read_text())

    def test_check_writes_an_index_of_reports(self):
        failing = self.copy_of(TINY)
        self.edit(failing / "scenario.toml", "underruns = 0", "underruns = 7")
        failing = failing.rename(failing.parent / "bad # <b>")
        done = self.armature("check", TINY, failing, "--report-dir", "pages", "--junit", "j.xml", "--jobs", 2, code=1)
        self.assertEqual(self.files_below("pages"), ["bad # <b>.html", "index.html"])
        self.assertIn("report: pages/bad # <b>.html\n", done.stdout)
        index = (self.folder / "pages/index.html").read_text()
        self.assertIn("1 passed, 1 failed", index)
        links = [urllib.parse.unquote(html.unescape(link)) for link in re.findall(r'href="([^"]+)"', index)]
        self.assertEqual(links, ["bad # <b>.html"])
        self.assertNotIn("<b>", index)
        self.assertIn("expected 7, got 0", index)
        self.assertLess(index.index("bad #"), index.index(TINY.name))
        self.assertEqual(index.count("<svg "), 2)
        self.assertEqual(index.count(">0.120 s<"), 2)  # of simulated time
        description = re.search('description = "(.+)"', (TINY / "scenario.toml").read_text()).group(1)
        self.assertEqual(index.count(html.escape(description, quote=False)), 2)
        properties = xml.etree.ElementTree.parse(self.folder / "j.xml").getroot().iter("property")
        reports = [one.get("value") for one in properties if one.get("name") == "report"]
        self.assertEqual(reports, ["pages/bad # <b>.html"])

    def test_check_with_several_jobs_keeps_scenarios_of_one_name_apart(self):
        scenario = self.copy_of(TINY)
        self.edit(scenario / "scenario.toml", "underruns = 0", "underruns = 7")
        shutil.copytree(self.folder / "scenarios", self.folder / "others")
        self.edit(self.folder / "others" / TINY.name / "scenario.toml", "underruns = 7", "underruns = 8")
        self.armature("check", scenario, self.folder / "others" / TINY.name, "--jobs", "2", code=1)
        got = [
            json.loads((self.folder / "out/check" / name / "summary.json").read_text())["result"]["expect_failures"][0][
                "expected"
            ]
            for name in (TINY.name, TINY.name + "-2")
        ]
        self.assertEqual(got, ["7", "8"])

    def test_compare_names_the_values_in_the_order_of_the_files(self):
        self.text("a.csv", "tick,j1_cmd_pulses\n0,90\n")
        self.text("b.csv", "tick,j1_cmd_pulses\n0,0\n")
        done = self.armature("compare", "a.csv", "b.csv", code=1)
        self.assertIn("FAIL a.csv and b.csv differ: 1 of 1 common rows differ\n", done.stdout)
        self.assertIn("first mismatch at tick 0, j1_cmd_pulses: a.csv: 90 (line 2), b.csv: 0 (line 2)\n", done.stdout)

    def test_compare_with_a_golden_names_the_scenario_in_its_command(self):
        golden = TINY / "golden.csv"
        lines = golden.read_text().splitlines()
        lines[3] = lines[3][:-1] + ("0" if lines[3][-1] != "0" else "1")
        self.text("b.csv", "\n".join(lines) + "\n")
        done = self.armature("compare", golden, "b.csv", code=1)
        self.assertIn(f"these ticks: armature run {TINY} --set trace.every_ticks=1", done.stdout)

    def test_check_notices_a_change_that_only_the_full_rate_shows(self):
        scenario = self.copy_of(TINY)
        text = (scenario / "scenario.toml").read_text()
        digest = re.search(r'sha256 = "([0-9a-f]{64})"', text).group(1)
        (scenario / "scenario.toml").write_text(text.replace(digest, digest[::-1]))
        self.assertIn("sha256", self.armature("check", scenario, code=1).stdout)

    def test_bless_is_refused_while_an_expectation_fails(self):
        scenario = self.copy_of(TINY)
        before = (scenario / "golden.csv").read_bytes()
        self.edit(scenario / "scenario.toml", "underruns = 0", "underruns = 7")
        self.armature("bless", scenario, code=1)
        self.assertEqual((scenario / "golden.csv").read_bytes(), before)

    def test_compare_tells_equal_from_different(self):
        golden = TINY / "golden.csv"
        self.armature("compare", golden, golden)
        changed = self.folder / "changed.csv"
        changed.write_text(golden.read_text().replace("\n200,", "\n201,", 1))
        self.assertIn("tick", self.armature("compare", golden, changed, code=1).stdout)

    def test_list_and_info(self):
        listing = subprocess.run([self.path, "list"], cwd=ROOT, text=True, capture_output=True, check=True).stdout
        for scenario in SCENARIOS.iterdir():
            if (scenario / "scenario.toml").exists():
                self.assertIn(scenario.name, listing)
        for robot in (SCENARIOS / "robots").glob("*.toml"):
            self.assertRegex(listing, rf"(?m)^{robot.stem} +(six_r|five_r|joint moves only) ")
        info = self.armature("info").stdout
        for text in (
            "50 MHz",
            "2500",
            "0x43C10000   pulse_train, 64 KiB, --variant counts only",
            "0x41200000   axi_gpio, 64 KiB\n",
            "axi_uart16550",
            "axi_timer",
            "encoder_switch, 64 KiB, --variant paper only",
        ):
            self.assertIn(text, info)

    def test_the_help_of_what_runs_scenarios_tells_every_exit_code(self):
        for command in ("run", "check", "bless"):
            text = " ".join(self.armature(command, "--help").stdout.split("Exit code:")[1].split())
            for code in ("0 ", "1 ", "2 bad input", "3 internal error", "130 interrupted"):
                self.assertIn(code, text, command)


if __name__ == "__main__":
    main()
