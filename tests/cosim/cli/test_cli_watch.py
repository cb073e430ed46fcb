"""armature watch: a scenario that runs again whenever a file changes."""

import os
import re
import shutil
import signal
import subprocess
import time

from cli_program import SCENARIOS, TINY, Program, main


class Watch(Program):
    def start(self, *arguments):
        self.log = open(self.folder / "watch.txt", "w")
        self.addCleanup(self.log.close)
        return self.beside("watch", *arguments, stdout=self.log, stderr=subprocess.STDOUT)

    def said(self):
        return (self.folder / "watch.txt").read_text()

    def wait_until(self, condition, told=None):
        super().wait_until(condition, told or self.said)

    def wait_for_runs(self, count):
        self.wait_until(lambda: self.said().count("report  ") >= count)

    def replace(self, path, old, new):
        """As editors do: a new file takes the place of the old one."""
        text = path.read_text()
        self.assertIn(old, text)
        beside = path.with_suffix(".new")
        beside.write_text(text.replace(old, new, 1))
        os.replace(beside, path)

    def test_it_runs_again_when_a_file_that_it_reads_changes(self):
        scenario = self.copy_of(self.brief())
        watch = self.start(scenario, "--out", "x")
        self.wait_for_runs(1)
        self.assertIn(f"PASSED {TINY.name}", self.said())
        self.replace(scenario / "scenario.toml", "description = ", 'description = "second" #')
        self.wait_for_runs(2)
        self.assertIn(": second\n", self.said())
        self.assertIn('"description":"second"', (self.folder / "x/report.html").read_text())
        robot = re.search('robot = "(.*?)"', (scenario / "scenario.toml").read_text()).group(1)
        with open(self.folder / f"scenarios/robots/{robot}.toml", "a") as file:
            file.write("\n# a comment\n")
        self.wait_for_runs(3)
        golden = scenario / "golden.csv"
        golden.write_text(golden.read_text().replace(",idle,", ",fault,", 1))
        self.wait_for_runs(4)
        self.assertIn(f"FAILED {TINY.name}", self.said())
        time.sleep(0.5)  # it looks for changes ten times a second
        self.assertEqual(self.said().count("report  "), 4)
        watch.send_signal(signal.SIGINT)
        self.assertEqual(watch.wait(timeout=60), 130)

    def test_an_error_is_told_and_the_next_change_runs_again(self):
        scenario = self.copy_of(self.brief())
        file = scenario / "scenario.toml"
        self.start(scenario, "--out", "x")
        self.wait_for_runs(1)
        before = (self.folder / "x/reload.js").read_text()
        self.assertRegex(before, r'^reportChanged\(\{"digest":"[0-9a-f]{64}","problem":""\}\);\n$')
        self.replace(file, "duration_s", "duration_x")
        self.wait_until(lambda: "duration_x" in self.said())
        self.wait_until(lambda: "duration_x" in (self.folder / "x/reload.js").read_text())
        self.replace(file, "duration_x", "duration_s")
        self.wait_for_runs(2)
        self.assertEqual((self.folder / "x/reload.js").read_text(), before)

    def test_a_change_ends_a_run_that_is_under_way(self):
        scenario = self.copy_of("fig9_joint_move")
        self.edit(scenario / "scenario.toml", "duration_s = 1.0", "duration_s = 1000.0")
        self.start(scenario, "--out", "x")
        self.wait_for("x/trace.csv")
        shutil.copy(TINY / "golden.csv", scenario / "golden.csv")
        self.replace(scenario / "scenario.toml", "duration_s = 1000.0", "duration_s = 0.02")
        self.wait_for_runs(1)

    def test_ctrl_c_ends_a_run_and_the_program(self):
        watch = self.start(SCENARIOS / "fig9_joint_move", "--set", "duration_s=1000", "--out", "x")
        self.wait_for("x/trace.csv")
        watch.send_signal(signal.SIGINT)
        self.assertEqual(watch.wait(timeout=60), 130)
        self.assertFalse((self.folder / "x/unfinished").exists())

    def test_bad_input_is_told(self):
        self.assertIn("no such scenario", self.armature("watch", "nonsense", code=2).stderr)


if __name__ == "__main__":
    main()
