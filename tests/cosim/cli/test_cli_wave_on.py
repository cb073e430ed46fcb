"""--wave-on of armature run and check: the waveform of a moment that has passed."""

import json
import os
import pathlib
import re
import signal
import subprocess
import time

from cli_program import BRIEF, TINY, Program, main

RTL = ("--engine", "rtl")
FIRST_TRIGGER = 3108  # cycle
ESTOP = '\n[[fault]]\nat_s = 0.012\nkind = "estop"\nduration_s = 0.001\n'
NOTE = r"(?m)^waveform       (\S+): (\d\.\d{6}) s to (\d\.\d{6}) s, of (.*) at (\d\.\d{6}) s$"


class WaveOn(Program):
    def stopped(self):
        """A scenario whose emergency stop fails."""
        scenario = self.copy_of(TINY)
        with (scenario / "scenario.toml").open("a") as file:
            file.write(ESTOP)
        return scenario

    def note(self, done):
        match = re.search(NOTE, done.stdout)
        self.assertIsNotNone(match, done.stdout)
        return match.groups()

    def cycle_of_fault(self, out):
        return json.loads((self.folder / out / "summary.json").read_text())["result"]["faults"][0]["cycle"]

    def assert_plain_wave(self, wave, scenario, begin_s, end_s, *options, code=1):
        """The file is that of a run in which the window was known."""
        plain = ("--vcd", "plain.vcd", "--from", begin_s, "--to", end_s, "--out", "plain")
        self.armature("run", scenario, *RTL, *plain, *options, code=code)
        got, wanted = (self.folder / wave).read_bytes(), (self.folder / "plain.vcd").read_bytes()
        self.assertGreater(len(got), 100_000)
        self.assertTrue(got == wanted, f"{wave} has other bytes than a run with --from {begin_s} --to {end_s}")

    def test_a_fault_is_shown_from_before_it(self):
        scenario = self.stopped()
        options = ("--vcd", "w.vcd", "--wave-on", "fault", "--before", "2")
        done = self.armature("run", scenario, *RTL, *BRIEF, *options, "--out", "out", code=1)
        file, begin_s, end_s, what, at_s = self.note(done)
        self.assertEqual((file, what), ("w.vcd", "the fault estop"))
        self.assertTrue(0.012 < float(at_s) < 0.0121, at_s)
        self.assertAlmostEqual(float(begin_s), float(at_s) - 0.002, places=6)
        self.assertAlmostEqual(float(end_s), float(at_s) + 0.001, places=6)
        # To the cycle: the times of the screen are rounded.
        at = self.cycle_of_fault("out")
        wave = json.loads((self.folder / "out" / "summary.json").read_text())["waveform"]
        self.assertEqual((wave["file"], wave["written"], wave["moment"]), ("w.vcd", True, "the fault estop"))
        self.assertEqual(
            [round(wave[key] * 50e6) for key in ("at_s", "from_s", "to_s")], [at, at - 100_000, at + 50_000]
        )
        self.assert_plain_wave("w.vcd", scenario, (at - 100_000) / 50e6, (at + 50_000) / 50e6, *BRIEF)

    def test_the_results_are_those_of_a_run_without_it(self):
        scenario = self.stopped()
        self.armature("run", scenario, *RTL, *BRIEF, "--wave-on", "fault", "--out", "with", code=1)
        self.armature("run", scenario, *RTL, *BRIEF, "--out", "without", code=1)
        for name in ("trace.csv", "load.csv", "log.txt"):
            self.assertEqual(
                (self.folder / "with" / name).read_bytes(), (self.folder / "without" / name).read_bytes(), name
            )
        summaries = [json.loads((self.folder / out / "summary.json").read_text()) for out in ("with", "without")]
        self.assertEqual(summaries[0]["result"], summaries[1]["result"])

    def test_the_model_is_shown_with_the_signals_of_the_rtl(self):
        scenario = self.stopped()
        waves = {}
        for engine in ("rtl", "model", "lockstep"):
            options = ("--engine", engine, "--vcd", f"{engine}.vcd", "--wave-on", "fault", "--before", "0.2")
            self.note(self.armature("run", scenario, *BRIEF, *options, code=1))
            waves[engine] = (self.folder / f"{engine}.vcd").read_bytes()
        self.assertTrue(waves["model"] == waves["rtl"])
        self.assertTrue(waves["lockstep"] == waves["rtl"])
        self.assertIn(b"axi_uart16550", waves["rtl"].split(b"$enddefinitions")[0])

    def test_a_failed_expectation_is_shown_at_its_moment(self):
        """Long after it: the end of the run decides."""
        options = ("--set", "expect.peak_pulses_per_tick=1000", "--vcd", "w.vcd", "--wave-on", "fail")
        done = self.armature("run", TINY, *RTL, *options, "--before", "1", code=1)
        _, begin_s, end_s, what, at_s = self.note(done)
        self.assertEqual(what, "expect.peak_pulses_per_tick")
        tick, told_s = re.search(r"not met .*peak_pulses_per_tick.*tick (\d+), (\S+) s\)", done.stdout).groups()
        self.assertEqual(told_s, at_s)
        at = FIRST_TRIGGER + 2500 * int(tick)
        self.assert_plain_wave("w.vcd", TINY, (at - 50_000) / 50e6, (at + 50_000) / 50e6, *options[:2])

    def test_an_expectation_of_no_moment_is_shown_at_the_end_of_the_run(self):
        options = ("--set", "expect.total_pulses=[1, 2, 3, 4, 5, 6]", "--vcd", "w.vcd", "--wave-on", "fail")
        done = self.armature("run", TINY, *RTL, *BRIEF, *options, "--before", "0.5", code=1)
        _, begin_s, end_s, what, at_s = self.note(done)
        self.assertEqual((begin_s, end_s, at_s), ("0.029500", "0.030000", "0.030000"))
        self.assertRegex(what, r"^expect\.\w+, at the end of the run,$")

    def test_a_mismatch_is_shown_between_two_rows_of_the_golden(self):
        scenario = self.copy_of(TINY)
        golden = (scenario / "golden.csv").read_text().splitlines()
        row = golden[5].split(",")
        row[3] = str(int(row[3]) + 1)
        (scenario / "golden.csv").write_text("\n".join([*golden[:5], ",".join(row), *golden[6:]]) + "\n")
        options = ("--fst", "w.fst", "--wave-on", "mismatch", "--before", "0")
        done = self.armature("run", scenario, *RTL, *options, code=1)
        _, begin_s, end_s, what, at_s = self.note(done)
        self.assertEqual(what, "the difference from the golden")
        self.assertAlmostEqual(float(at_s), float(row[1]), places=6)
        self.assertAlmostEqual(float(begin_s), float(golden[4].split(",")[1]), places=6)
        self.assertAlmostEqual(float(end_s), float(at_s) + 0.001, places=6)
        vcd = subprocess.run(["fst2vcd", self.folder / "w.fst"], check=True, capture_output=True, text=True).stdout
        stamps = [int(line[1:]) * 1e-9 for line in vcd.splitlines() if line.startswith("#")]
        self.assertAlmostEqual(stamps[0], float(begin_s), places=6)
        self.assertAlmostEqual(stamps[-1], float(end_s), places=6)

    def test_without_a_file_it_is_in_the_folder_of_the_results(self):
        scenario = self.stopped()
        run = ("run", scenario, *RTL, *BRIEF, "--out", "out", "--wave-on", "fault", "--before", "0.1")
        file, *_ = self.note(self.armature(*run, code=1))
        self.assertEqual(file, "out/failure.fst")
        self.assertTrue((self.folder / file).exists())
        done = self.armature(*run, "--from", "0.02", code=1)
        self.assertRegex(done.stdout, r"(?m)^no waveform    out/failure\.fst is not written: .*no fault in this time$")
        self.assertFalse((self.folder / file).exists(), "that of the earlier run")
        wave = json.loads(self.armature(*run, "--from", "0.02", "--json", code=1).stdout)["waveform"]
        self.assertEqual((wave["file"], wave["written"]), (file, False))
        self.assertIn("no fault in this time", wave["why_not"])
        # Without the converter it is a VCD file.
        (self.folder / "bin").mkdir()
        (self.folder / "bin/sh").symlink_to("/bin/sh")
        done = self.armature(*run, code=1, PATH=str(self.folder / "bin"))
        self.assertEqual(self.note(done)[0], "out/failure.vcd")

    def test_a_run_without_such_a_moment_says_so(self):
        for reason, why in (("fault", "the controller reported no fault"), ("fail", "no expectation failed")):
            done = self.armature("run", TINY, *RTL, *BRIEF, "--vcd", "w.vcd", "--wave-on", reason)
            self.assertRegex(done.stdout, rf"(?m)^no waveform    w\.vcd is not written: {why}$")
        done = self.armature("run", TINY, *RTL, "--vcd", "w.vcd", "--wave-on", "mismatch")
        self.assertRegex(done.stdout, r"(?m)^no waveform    w\.vcd is not written: no row .* differs from the golden$")
        self.assertFalse((self.folder / "w.vcd").exists())

    def test_wrong_use_is_refused(self):
        no_golden = self.copy_of(TINY)
        (no_golden / "golden.csv").unlink()
        for message, *options in (
            (r"--wave-on.*fault,fail,mismatch", "--wave-on", "error"),
            (r"--before.*needs --wave-on", "--before", "1"),
            (r"--before.*0 to 1000 ms", "--wave-on", "fault", "--before", "-1"),
            (r"--before.*0 to 1000 ms", "--wave-on", "fault", "--before", "1001"),
            (r"--before.*0 to 1000 ms", "--wave-on", "fault", "--before", "nan"),
            (r"--from.*earlier than the end", "--wave-on", "fault", "--from", "0.2"),
            (r"--wave-on.*mismatch needs a run that is compared", "--wave-on", "mismatch", "--set", "seed=2"),
        ):
            with self.subTest(options):
                done = self.armature("run", TINY, *options, code=2)
                self.assertRegex(done.stderr, message)
        done = self.armature("run", no_golden, "--wave-on", "mismatch", code=2)
        self.assertRegex(done.stderr, r"--wave-on.*there is no .*golden\.csv")
        done = self.armature("check", TINY, "--before", "1", code=2)
        self.assertRegex(done.stderr, r"--before.*needs --wave-on")

    def test_check_keeps_the_waveform_of_a_failure(self):
        scenario = self.copy_of(TINY)
        text = (scenario / "scenario.toml").read_text()
        (scenario / "scenario.toml").write_text(text + ESTOP)
        done = self.armature("check", scenario, "--engine", "model", "--wave-on", "fault", "--before", "0.1", code=1)
        note = re.search(r"(?m)^ +waveform: (\S+): \S+ s to \S+ s, of the fault estop at \S+ s$", done.stdout)
        self.assertEqual(note.group(1), f"out/check/{TINY.name}/failure.fst")
        self.assertTrue((self.folder / note.group(1)).exists())
        (scenario / "scenario.toml").write_text(text)
        done = self.armature("check", scenario, "--engine", "model", "--wave-on", "fault")
        self.assertNotIn("waveform", done.stdout)
        self.assertFalse((self.folder / "out/check" / TINY.name).exists())

    def test_what_a_program_at_the_serial_line_sent_is_repeated(self):
        scenario = self.stopped()
        with (scenario / "scenario.toml").open("a") as file:
            file.write("[serial]\n")
        pace = ("--pace", "0.05")
        options = ("--vcd", "w.vcd", "--wave-on", "fault", "--before", "1", "--serial", "pty:uart", *pace)
        run = subprocess.Popen(
            [self.path, "run", scenario, *RTL, *BRIEF, *options, "--out", "live"],
            cwd=self.folder,
            stdout=subprocess.PIPE,
            text=True,
        )
        self.wait_for("uart")
        with open(self.folder / "uart", "wb", buffering=0) as line:
            for _ in range(12):
                line.write(b"armature")
                time.sleep(0.02)
        output, _ = run.communicate(timeout=self.longest_s)
        self.assertEqual(run.returncode, 1, output)
        match = re.search(NOTE, output)
        self.assertIn(",rx,", (self.folder / "live/serial.csv").read_text())
        at = self.cycle_of_fault("live")
        self.assertEqual(match.group(1), "w.vcd")
        replay = ("--serial", "replay:live/serial.csv")
        self.assert_plain_wave("w.vcd", scenario, (at - 50_000) / 50e6, (at + 50_000) / 50e6, *BRIEF, *replay)

    def test_no_process_survives_a_killed_run(self):
        run = subprocess.Popen(
            [self.path, "run", "fig9_joint_move", *RTL, "--wave-on", "fault", "--out", "out"],
            cwd=self.folder,
            stdout=subprocess.DEVNULL,
            start_new_session=True,
        )
        self.wait_until(lambda: len(members_of(run.pid)) > 3)
        run.send_signal(signal.SIGKILL)
        run.wait()
        self.wait_until(lambda: not members_of(run.pid), lambda: str(members_of(run.pid)))

    def test_an_interrupted_run_leaves_no_process(self):
        run = subprocess.Popen(
            [self.path, "run", "fig9_joint_move", *RTL, "--wave-on", "fault", "--out", "out"],
            cwd=self.folder,
            stdout=subprocess.PIPE,
            text=True,
            start_new_session=True,
        )
        self.wait_until(lambda: len(members_of(run.pid)) > 3)
        os.killpg(run.pid, signal.SIGINT)  # as the terminal does
        output, _ = run.communicate(timeout=self.longest_s)
        self.assertEqual(run.returncode, 130)
        self.assertIn("no waveform", output)
        self.assertEqual(members_of(run.pid), [])


def members_of(session):
    """The processes of a session that have not ended."""
    found = []
    for status in pathlib.Path("/proc").glob("[0-9]*/stat"):
        try:
            fields = status.read_text().rsplit(")", 1)[1].split()
        except OSError:
            continue  # it has just ended
        if int(fields[3]) == session and fields[0] not in "ZX":
            found.append(int(status.parent.name))
    return found


if __name__ == "__main__":
    main()
