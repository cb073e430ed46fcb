"""armature check, bless and compare; list, info and help."""

import re
import signal
import subprocess
import xml.etree.ElementTree

from cli_program import ROOT, SCENARIOS, SHORT, Program, main


class Check(Program):
    def test_check_passes_and_writes_junit(self):
        done = self.armature("check", SCENARIOS / SHORT, "--junit", "j.xml")
        self.assertIn(SHORT, done.stdout)
        suite = xml.etree.ElementTree.parse(self.folder / "j.xml").getroot()
        case = next(suite.iter("testcase"))
        self.assertEqual(case.get("name"), SHORT)
        self.assertEqual(list(suite.iter("failure")), [])

    def test_junit_that_cannot_be_written_is_no_success(self):
        done = self.armature("check", SCENARIOS / SHORT, "--junit", "/dev/full", code=2)
        self.assertIn("/dev/full: cannot write: No space left", done.stderr)

    def test_ctrl_c_keeps_the_finished_verdicts_of_check(self):
        with subprocess.Popen([self.path, "check", SCENARIOS / SHORT, SCENARIOS / "fig9_joint_move", "--junit", "j.xml"],
                              cwd=self.folder, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True) as run:
            self.assertIn(SHORT, run.stdout.readline())
            self.assertFalse((self.folder / "j.xml").exists())
            run.send_signal(signal.SIGINT)
            self.assertIn("1 not run", run.communicate(timeout=60)[0])
            self.assertEqual(run.returncode, 130)
        suite = xml.etree.ElementTree.parse(self.folder / "j.xml").getroot()
        self.assertEqual([case.get("name") for case in suite.iter("testcase")], [SHORT])

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

    def test_list_and_info(self):
        listing = subprocess.run([self.path, "list"], cwd=ROOT, text=True, capture_output=True, check=True).stdout
        for scenario in SCENARIOS.iterdir():
            if (scenario / "scenario.toml").exists():
                self.assertIn(scenario.name, listing)
        for robot in (SCENARIOS / "robots").glob("*.toml"):
            self.assertRegex(listing, rf"(?m)^{robot.stem} +(six_r|five_r|joint moves only) ")
        info = self.armature("info").stdout
        for text in ("50 MHz", "2500", "0x43C10000   pulse_train, 64 KiB, --fabric rtl only", "0x41200000   axi_gpio, 64 KiB\n",
                     "axi_uart16550", "axi_timer", "encoder_switch, 64 KiB, --fabric paper only"):
            self.assertIn(text, info)

    def test_the_help_of_what_runs_scenarios_tells_every_exit_code(self):
        for command in ("run", "check", "bless"):
            text = " ".join(self.armature(command, "--help").stdout.split("Exit code:")[1].split())
            for code in ("0 ", "1 ", "2 bad input", "3 internal error", "130 interrupted"):
                self.assertIn(code, text, command)

    def test_every_help_has_an_example(self):
        self.assertIn("Example", self.armature("--help").stdout)
        for command in ("run", "check", "compare", "bless", "fk", "ik", "list", "info"):
            self.assertIn("armature " + command, self.armature(command, "--help").stdout)


if __name__ == "__main__":
    main()
