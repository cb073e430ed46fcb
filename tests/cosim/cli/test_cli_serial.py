"""armature run with a serial line: scripts, a pseudo-terminal, a TCP port, replays."""

import hashlib
import json
import os
import pathlib
import re
import shutil
import signal
import socket

from cli_program import SCENARIOS, Program, main

PLACE = re.compile(r"serial line +(\S+)(?: \(link (\S+)\))?, (.*)\n")


class Serial(Program):
    def still(self, duration_s, tables=""):
        """A scenario in which the arm stands."""
        shutil.copytree(SCENARIOS / "robots", self.folder / "scenarios" / "robots", dirs_exist_ok=True)
        folder = self.folder / "scenarios" / "still"
        folder.mkdir(exist_ok=True)
        (folder / "scenario.toml").write_text(
            f'description = "d"\nrobot = "vo2021_6r"\nduration_s = {duration_s}\n{tables}'
        )
        return folder

    def start(self, *arguments):
        """A run that is under way, and the match of the line that tells where its serial line is."""
        return self.listening(PLACE, "run", *arguments)

    def finish(self, run, code=0):
        stdout, stderr = run.communicate(timeout=120)
        self.assertEqual(run.returncode, code, stdout + stderr)
        return stdout

    def log(self, out):
        return (self.folder / out / "serial.csv").read_text()

    def received(self, out):
        return bytes(int(row["byte"], 16) for row in self.rows(f"{out}/serial.csv") if row["direction"] == "rx")

    def test_a_script_is_logged_with_its_faults_and_the_same_twice(self):
        scenario = self.still(
            0.02,
            '[serial]\nparity = "even"\n'
            '[[serial_send]]\nat_s = 0.01\ntext = "A,"\nfault = "parity"\n'
            '[[serial_send]]\nat_s = 0.01\nfault = "break"\nbreak_s = 0.001\n',
        )
        for out in ("a", "b"):
            self.armature("run", scenario, "--out", out)
        self.assertEqual(
            self.log("a"),
            "time_s,direction,byte,char,error,baud_error_percent,break_s\n"
            "0.01000000,rx,41,A,parity,0.0000,\n"
            "0.01009550,rx,2C,\\x2C,parity,0.0000,\n"
            "0.01019098,rx,00,\\x00,break,0.0000,0.00100000\n",
        )
        self.assertEqual(self.log("a"), self.log("b"))

    def test_without_a_serial_line_there_is_no_log_not_even_an_old_one(self):
        (self.folder / "x").mkdir()
        (self.folder / "x/serial.csv").write_text("old\n")
        self.armature("run", self.still(0.01), "--out", "x")
        self.assertFalse((self.folder / "x/serial.csv").exists())

    def test_a_serial_line_does_not_change_the_motion(self):
        self.armature("run", self.still(0.02), "--out", "a")
        self.armature("run", self.still(0.02), "--out", "b", "--serial", "pty")
        self.assertEqual((self.folder / "a/trace.csv").read_bytes(), (self.folder / "b/trace.csv").read_bytes())

    def test_what_a_terminal_sends_is_replayed_on_the_same_cycles(self):
        scenario = self.still(0.3, "[serial]\nbaud = 9600\n")
        run, place = self.start(scenario, "--out", "live", "--serial", "pty:arm")
        self.assertEqual(place[2], "arm")
        self.assertIn("9600 baud", place[3])
        text = bytes(range(64))
        terminal = os.open(self.folder / "arm", os.O_RDWR | os.O_NOCTTY)
        os.write(terminal, text)
        os.close(terminal)
        self.finish(run)
        self.assertFalse((self.folder / "arm").is_symlink())
        self.assertEqual(self.received("live"), text)
        self.armature("run", scenario, "--out", "again", "--serial", "replay:live/serial.csv")
        self.assertEqual(self.log("live"), self.log("again"))
        inputs = json.loads((self.folder / "again/summary.json").read_text())["inputs"]
        self.assertEqual(
            inputs[2:], [{"file": "live/serial.csv", "sha256": hashlib.sha256(self.log("live").encode()).hexdigest()}]
        )

    def test_a_replay_takes_the_place_of_the_script_to_the_last_cycle(self):
        scenario = self.still(0.01008682, '[serial]\n[[serial_send]]\nat_s = 0.01\ntext = "abc"\n')
        done = self.armature("run", scenario, "--out", "a")
        self.assertEqual(self.received("a"), b"ab", "the second begins in the last cycle")
        self.assertRegex(
            done.stdout, r"serial line +1 characters or breaks to the controller were not sent before the end"
        )
        done = self.armature("run", scenario, "--out", "b", "--serial", "replay:a/serial.csv")
        self.assertEqual(self.log("a"), self.log("b"))
        self.assertNotIn("not sent", done.stdout)
        done = self.armature("run", self.still(0.01004), "--out", "c", "--serial", "replay:a/serial.csv")
        self.assertIn("1 characters or breaks of a/serial.csv come after the end of the run", done.stdout)

    def test_a_replay_takes_the_place_of_the_scripted_pendant(self):
        self.armature("run", "pendant_jog", "--out", "a")
        self.armature("run", "pendant_jog", "--out", "b", "--serial", "replay:a/serial.csv")
        self.assertGreater(len(self.received("a")), 100)
        self.assertEqual(self.log("a"), self.log("b"))
        for name in ("trace.csv", "load.csv"):
            self.assertEqual((self.folder / "a" / name).read_bytes(), (self.folder / "b" / name).read_bytes())

    def test_tcp_clients_come_and_go(self):
        run, place = self.start(self.still(0.5), "--out", "x", "--serial", "tcp:0")
        host, port = place[1].split(":")
        self.assertEqual(host, "127.0.0.1")
        token = run.stdout.readline().encode()
        self.assertRegex(token, rb"^token [0-9a-f]{32}\n$")
        for text in (b"one ", b"two"):
            with socket.create_connection((host, int(port)), timeout=30) as client:
                client.sendall(token + text)
        self.finish(run)
        self.assertEqual(self.received("x"), b"one two")

    def test_ctrl_c_leaves_a_whole_log_and_no_link(self):
        run, _ = self.start(self.still(10), "--out", "x", "--serial", "pty:arm")
        run.send_signal(signal.SIGINT)
        run.send_signal(signal.SIGTERM)  # as timeout(1) does: the same request, not a second one
        self.finish(run, code=130)
        self.assertTrue(self.log("x").endswith("\n"))
        self.assertFalse((self.folder / "arm").is_symlink())
        self.assertTrue((self.folder / "x/summary.json").exists())

    def test_bad_input_is_exit_code_2_with_a_message(self):
        self.text("file", "precious")
        self.text("log.csv", "tick\n")
        with socket.socket() as taken:
            taken.bind(("127.0.0.1", 0))
            taken.listen()
            port = taken.getsockname()[1]
            for where, expected in [
                ("modem", '--serial: expected pty, pty:LINK, tcp:PORT or replay:FILE, found "modem"'),
                ("tcp:65536", "tcp:PORT"),
                ("pty:file", "file: cannot create this link: File exists"),
                ("pty:no/such/folder", "no/such/folder"),
                (f"tcp:{port}", "cannot listen: Address already in use"),
                ("replay:log.csv", "log.csv:1:1: expected the header"),
                ("replay:none.csv", "none.csv: cannot open"),
                ("replay:", "--serial: expected a file after replay:"),
            ]:
                with self.subTest(where):
                    done = self.armature("run", self.still(0.01), "--serial", where, code=2)
                    self.assertIn(expected, done.stderr)
        self.assertEqual(pathlib.Path(self.folder / "file").read_text(), "precious")


if __name__ == "__main__":
    main()
