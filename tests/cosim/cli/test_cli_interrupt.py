"""armature run: Ctrl-C, killed runs, two runs into one folder."""

import json
import os
import select
import signal
import subprocess

from cli_program import BRIEF, SCENARIOS, TINY, Program, main, processor_s


class Interrupt(Program):
    def test_ctrl_c_closes_the_files_and_exits_130(self):
        with subprocess.Popen(
            [self.path, "run", SCENARIOS / "fig9_joint_move", "--out", "x", "--fst", "x.fst"],
            cwd=self.folder,
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
            text=True,
        ) as run:
            self.wait_for("x.fst")
            self.wait_until(lambda: processor_s(run.pid) > 0.1)  # it is under way
            run.send_signal(signal.SIGINT)
            run.communicate(timeout=60)
            self.assertEqual(run.returncode, 130)
        text = (self.folder / "x" / "trace.csv").read_text()
        self.assertTrue(text.endswith("\n"))
        result = json.loads((self.folder / "x" / "summary.json").read_text())["result"]
        self.assertTrue(result["interrupted"])
        self.assertEqual((result["golden"], result["golden_text"]), ("not compared", "the run was interrupted"))
        subprocess.run(["fst2vcd", "x.fst", "-o", os.devnull], cwd=self.folder, check=True, capture_output=True)

    def test_a_second_run_into_the_same_folder_is_an_error_that_names_the_first(self):
        first = self.beside("run", SCENARIOS / "fig9_joint_move", "--out", "x", "--set", "duration_s=1000")
        self.wait_for("x/trace.csv")
        done = self.armature("run", TINY, *BRIEF, "--out", "x", code=2)
        self.assertIn(f"x: process {first.pid} is writing a run into this folder", done.stderr)
        self.assertTrue((self.folder / "x/trace.csv").exists())
        first.send_signal(signal.SIGINT)
        self.assertEqual(first.wait(timeout=60), 130)
        self.assertFalse((self.folder / "x/unfinished").exists())
        self.armature("run", TINY, *BRIEF, "--out", "x")

    def test_a_killed_run_leaves_what_it_has_done_and_is_recognised_as_unfinished(self):
        run = self.beside("run", SCENARIOS / "fig9_joint_move", "--out", "x", "--set", "duration_s=1000")
        self.wait_for("x/trace.csv")
        trace = self.folder / "x/trace.csv"
        rows = 200  # it writes all files every 100 rows
        self.wait_until(lambda: trace.read_bytes().count(b"\n") > rows)
        run.kill()
        run.wait()
        text = trace.read_text()
        self.assertGreater(text.count("\n"), rows)
        self.assertTrue(text.endswith("\n"))
        self.assertIn("state moving", (self.folder / "x/log.txt").read_text())
        self.assertFalse((self.folder / "x/summary.json").exists())
        done = self.armature("compare", SCENARIOS / "fig9_joint_move/golden.csv", "x/trace.csv", code=1)
        self.assertIn("x/trace.csv: unfinished: the run that wrote it was killed or failed in the middle", done.stderr)
        for command in (("report",), ("plot", "--figure", "joints"), ("plot", "--figure", "path")):
            with self.subTest(command):
                done = self.armature(*command, "x", code=2 if "path" in command else 0)
                self.assertTrue(done.stderr.startswith("x: unfinished: the run that wrote it was killed"))
                self.assertNotIn("x/summary.json", done.stderr)
        page = (self.folder / "x/report.html").read_text()
        self.assertIn('"robot":"vo2021_6r"', page)
        self.assertIn("Vo 2021, Figure 9", (self.folder / "x/joints.svg").read_text())
        self.armature("run", TINY, *BRIEF, "--out", "x")  # takes the folder over
        self.assertFalse((self.folder / "x/unfinished").exists())

    def test_an_interrupt_before_the_first_tick_is_one_although_there_is_nothing_to_report(self):
        os.mkfifo(self.folder / "wave")
        with subprocess.Popen(
            [self.path, "run", TINY, "--out", "x", "--report", "--vcd", "wave"],
            cwd=self.folder,
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
            text=True,
        ) as run:
            self.wait_for("x/trace.csv")  # then it opens the pipe, and waits for a reader before its first cycle
            run.send_signal(signal.SIGINT)
            wave = os.open(self.folder / "wave", os.O_RDONLY | os.O_NONBLOCK)
            while run.poll() is None:
                if select.select([wave], [], [], 0.02)[0]:
                    os.read(wave, 1 << 16)
            os.close(wave)
            out, error = run.communicate(timeout=60)
        self.assertEqual((run.returncode, error), (130, ""))
        self.assertEqual((self.folder / "x/trace.csv").read_text().count("\n"), 1)
        self.assertIn("\nno report      the run ended before its first tick\n", out)
        self.assertFalse((self.folder / "x/report.html").exists())

    def test_an_interrupt_ends_a_run_that_is_planning_a_long_path(self):
        self.text(
            "slow.toml",
            """description = "a line of ten minutes, planned at a cycle a set-point"
robot = "kuka_kr6_r900"
duration_s = 86400
[cpu]
inverse_compute_cycles = 1
[[move]]
at_s = 0
type = "joint"
target_deg = [0, -90, 90, 0, 30, 0]
[[move]]
at_s = 0
type = "line"
frame = "tool"
xyz_mm = [100, 0, 0]
speed_mm_s = 0.17
""",
        )
        for how in (signal.SIGINT, signal.SIGTERM):
            with subprocess.Popen(
                [self.path, "run", "slow.toml", "--out", "x"],
                cwd=self.folder,
                stdout=subprocess.PIPE,
                stderr=subprocess.PIPE,
                text=True,
            ) as run:
                self.wait_until(lambda: processor_s(run.pid) > 0.3)  # nearly all of it for the plan
                before_s = processor_s(run.pid)
                run.send_signal(how)
                _, status, used = os.wait4(run.pid, 0)
                run.returncode = os.waitstatus_to_exitcode(status)
                out = run.stdout.read()
            self.assertEqual(run.returncode, 130)
            # In processor time, since others may hold the processor: 0.1 s, and what the clock of /proc rounds.
            self.assertLess(used.ru_utime + used.ru_stime - before_s, 0.12)
            self.assertRegex(out, r"^INTERRUPTED slow: ")
            self.assertRegex(out, r"\n  outcome +interrupted\n")
            result = json.loads((self.folder / "x/summary.json").read_text())["result"]
            self.assertEqual((result["outcome"], result["passed"]), ("interrupted", False))


if __name__ == "__main__":
    main()
