"""armature live without a browser: its address, its end, and the run that repeats a session. tests/cosim/live has pages."""

import re
import signal
import socket
import subprocess

from cli_program import SCENARIOS, TINY, Program, main

ADDRESS = re.compile(r"http://127\.0\.0\.1:\d+/[0-9a-f]{32}/\n")


class Live(Program):
    def expect_repeated(self, *session):
        """The run that a session prints has the same bytes."""
        shown = self.armature("live", *session, "--pace", "10000", "--for", "0.05", "--out", "x").stdout
        self.assertRegex(shown, ADDRESS)
        command = re.search(r"^to repeat it +armature (.*)$", shown, re.M).group(1)
        digest = re.search(r"^sha256 +(\w+)$", shown, re.M).group(1)
        words = subprocess.run(["sh", "-c", f"printf '%s\\n' {command}"], text=True, capture_output=True).stdout
        again = self.armature(*words.splitlines(), code=None).stdout
        self.assertIn(digest, again)
        logs = [self.folder / "x" / name for name in ("serial.csv", "replay/serial.csv")]
        self.assertGreater(logs[0].stat().st_size, 1000)
        self.assertEqual(logs[0].read_bytes(), logs[1].read_bytes())

    def test_a_session_ends_in_time_and_the_printed_run_repeats_it(self):
        self.expect_repeated(TINY)

    def test_a_robot_needs_no_scenario(self):
        self.expect_repeated("--robot", "hu2012_5r")
        self.assertIn('robot = "hu2012_5r"', (self.folder / "x/hu2012_5r/scenario.toml").read_text())
        robot = self.folder / "mine" / "kuka_kr6_r900.toml"
        robot.parent.mkdir()
        robot.write_bytes((SCENARIOS / "robots" / robot.name).read_bytes())
        self.expect_repeated("--robot", "mine/kuka_kr6_r900.toml")
        for arguments, expected in [
            ((), "expected a scenario"),
            (("--robot", "r2d2"), "r2d2"),
            ((TINY, "--robot", "hu2012_5r"), "excludes"),
        ]:
            self.assertIn(expected, self.armature("live", *arguments, code=2).stderr)

    def test_ctrl_c_ends_it_and_leaves_whole_files(self):
        run = self.beside("live", TINY, "--out", "x", stdout=subprocess.PIPE, stderr=subprocess.PIPE)
        self.assertRegex(run.stdout.readline().decode(), ADDRESS)
        second = self.armature("live", TINY, "--out", "x", code=2)
        self.assertIn("x", second.stderr)
        run.send_signal(signal.SIGINT)
        out, err = run.communicate(timeout=60)
        self.assertEqual((run.returncode, err), (130, b""))
        self.assertIn(b"to repeat it", out)
        self.assertFalse((self.folder / "x/unfinished").exists())
        self.assertTrue((self.folder / "x/serial.csv").read_text().endswith("\n"))

    def test_bad_input_is_exit_code_2_with_a_message(self):
        with socket.socket() as taken:
            taken.bind(("127.0.0.1", 0))
            taken.listen()
            port = taken.getsockname()[1]
            for options, expected in [
                (("--port", str(port)), "cannot listen: Address already in use"),
                (("--port", "65536"), "--port"),
                (("--pace", "0"), "--pace"),
                (("--for", "0"), "--for"),
                (("--set", "pendant.profile=x"), "pendant.profile"),
            ]:
                with self.subTest(options=options):
                    done = self.armature("live", TINY, *options, "--out", "x", code=2)
                    self.assertIn(expected, done.stderr)
                    self.assertEqual(done.stdout, "")


if __name__ == "__main__":
    main()
