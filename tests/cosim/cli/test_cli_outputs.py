"""What the commands write: where they may not, and what happens to what is there."""

import os
import signal
import socket
import stat
import subprocess
import time

from cli_program import MOMENT, SCENARIOS, TINY, Program, main

ROBOT = SCENARIOS / "robots" / "abb_irb120.toml"
JOINTS = "j1_deg,j2_deg,j3_deg,j4_deg,j5_deg,j6_deg\n0,0,0,0,90,0\n"


class Outputs(Program):
    def run_briefly(self, *arguments, code=0):
        return self.armature("run", TINY, *MOMENT, *arguments, code=code)

    def refused(self, done, *words):
        for word in words:
            self.assertIn(word, done.stderr)

    def test_what_a_waveform_would_replace_stays_what_it_is(self):
        self.text("file", "kept")
        (self.folder / "link").symlink_to("file")
        (self.folder / "nowhere").symlink_to("nothing")
        os.mkfifo(self.folder / "pipe")
        (self.folder / "folder").mkdir()
        with socket.socket(socket.AF_UNIX) as listener:
            listener.bind(str(self.folder / "socket"))
            for name, kind in (
                ("link", "a symbolic link"),
                ("nowhere", "a symbolic link"),
                ("pipe", "a pipe"),
                ("folder", "a folder"),
                ("socket", "a socket"),
            ):
                with self.subTest(name):
                    before = (self.folder / name).lstat().st_mode
                    self.refused(self.run_briefly("--fst", name, code=2), f"{name}: is {kind}")
                    self.assertEqual((self.folder / name).lstat().st_mode, before)
            self.refused(self.run_briefly("--vcd", "socket", code=2), "socket: is a socket")
        self.assertEqual((self.folder / "file").read_text(), "kept")
        self.assertFalse((self.folder / "nothing").exists())

    def test_a_device_is_written_in_place_or_not_at_all(self):
        for name, minor in (("null", 3), ("full", 7)):
            try:
                os.mknod(self.folder / name, 0o600 | stat.S_IFCHR, os.makedev(1, minor))
                (self.folder / name).open("rb").close()
            except PermissionError:
                self.skipTest("needs the right to make device nodes")

        def devices():
            return [stat.S_ISCHR((self.folder / name).lstat().st_mode) for name in ("null", "full")]

        for name in ("null", "full"):
            self.refused(self.run_briefly("--fst", name, code=2), f"{name}: is a device", "--fst")
            self.assertEqual(devices(), [True, True])
        self.run_briefly("--vcd", "null")
        self.refused(self.run_briefly("--vcd", "full", code=2), "full: cannot write the waveform file")
        self.text("a.csv", JOINTS)
        self.armature("fk", "--robot", "abb_irb120", "--in", "a.csv", "--out", "null")
        self.armature("fk", "--robot", "abb_irb120", "--in", "a.csv", "--out", "full", code=2)
        self.armature("check", self.brief(), "--junit", "null")
        self.armature("check", self.brief(), "--junit", "full", code=2)
        self.assertEqual(devices(), [True, True])
        self.assertEqual(sorted(path.name for path in self.folder.iterdir()), ["a.csv", "full", "null", "out"])

    def test_a_pipe_gets_the_waveform(self):
        os.mkfifo(self.folder / "pipe")
        with (self.folder / "got.vcd").open("wb") as got:
            with subprocess.Popen(["cat", "pipe"], cwd=self.folder, stdout=got) as cat:
                self.run_briefly("--vcd", "pipe")
                cat.wait(timeout=60)
        self.assertIn("$enddefinitions", (self.folder / "got.vcd").read_text())
        self.assertTrue((self.folder / "pipe").is_fifo())

    def test_no_command_writes_what_it_reads(self):
        scenario = self.copy_of(TINY)
        toml, golden = scenario / "scenario.toml", scenario / "golden.csv"
        robot = self.folder / "scenarios/robots/vo2021_6r.toml"
        (self.folder / "soft").symlink_to(toml)
        os.link(toml, self.folder / "hard.toml")
        joints = self.folder / self.text("a.csv", JOINTS)
        os.link(joints, self.folder / "b.csv")
        kinematics = ("fk", "--robot", "scenarios/robots/abb_irb120.toml", "--in", "a.csv", "--out")
        cases = [
            ("run", scenario, "--vcd", toml),
            ("run", scenario, "--vcd", "soft"),
            ("run", scenario, "--fst", "hard.toml"),
            ("run", scenario, "--fst", robot),
            ("run", scenario, "--vcd", golden),
            ("check", scenario, "--junit", golden),
            ("check", scenario, "--junit", "soft"),
            ("check", scenario, "--junit", robot),
            ("run", scenario, "--serial", "pty:w.vcd", "--vcd", "w.vcd"),
            (*kinematics, "a.csv"),
            (*kinematics, "b.csv"),
            (*kinematics, "./scenarios/../a.csv"),
            (*kinematics, "scenarios/robots/abb_irb120.toml"),
        ]
        files = {path: path.read_bytes() for path in (toml, golden, robot, joints)}
        for case in cases:
            with self.subTest(case):
                self.refused(self.armature(*case, code=2), "is an input of this command", case[-2])
                self.assertEqual({path: path.read_bytes() for path in files}, files)

    def test_standard_input_is_an_input_too(self):
        self.text("a.csv", JOINTS)
        with (self.folder / "a.csv").open() as stdin:
            done = subprocess.run(
                [self.path, "fk", "--robot", ROBOT, "--in", "-", "--out", "a.csv"],
                cwd=self.folder,
                stdin=stdin,
                capture_output=True,
                text=True,
            )
        self.assertEqual(done.returncode, 2, done.stderr)
        self.assertEqual((self.folder / "a.csv").read_text(), JOINTS)

    def test_a_replay_is_not_overwritten_by_its_own_log(self):
        scenario = ("run", TINY, *MOMENT, "--set", "serial={}", "--out", "x")
        self.armature(*scenario)
        before = (self.folder / "x/serial.csv").read_bytes()
        done = self.armature(*scenario, "--serial", "replay:x/serial.csv", code=2)
        self.refused(done, "x/serial.csv: is an input of this command")
        self.assertEqual((self.folder / "x/serial.csv").read_bytes(), before)

    def test_no_file_is_written_twice(self):
        for option in ("--vcd", "--fst"):
            self.refused(self.run_briefly(option, "x/trace.csv", "--out", "x", code=2), "x/trace.csv: is written as")
        (self.folder / "x").mkdir(exist_ok=True)
        (self.folder / "x/log.txt").unlink(missing_ok=True)
        (self.folder / "x/log.txt").symlink_to("../w.vcd")  # there is no such file yet
        self.refused(self.run_briefly("--vcd", "w.vcd", "--out", "x", code=2), "w.vcd: is written as")
        self.assertFalse((self.folder / "w.vcd").exists())

    def test_a_name_that_no_file_can_have_is_refused_before_the_run(self):
        for name, message in (("", "expected the name of a file"), ("x" * 300, "File name too long")):
            for option in ("--vcd", "--fst"):
                self.refused(self.run_briefly(option, name, "--out", "x", code=2), message)
                self.assertFalse((self.folder / "x/trace.csv").exists())
            done = self.armature("check", self.brief(), "--junit", name, code=2)
            self.refused(done, message)
            self.assertEqual(done.stdout, "")

    def test_a_scenario_is_not_blessed_into_its_own_file(self):
        scenario = self.copy_of(TINY)
        text = (scenario / "scenario.toml").read_text()
        (scenario / "golden.csv").write_text(text)
        self.refused(self.armature("bless", scenario / "golden.csv", code=2), "golden.csv: is written as")
        self.assertEqual((scenario / "golden.csv").read_text(), text)

    def test_bless_finds_out_before_the_run_that_it_cannot_write(self):
        scenario = self.copy_of(TINY)
        (scenario / "golden.csv").unlink()
        (scenario / "golden.csv").mkdir()
        done = self.armature("bless", scenario, code=2)
        self.refused(done, "golden.csv: is a folder")

    def test_an_fst_waveform_has_no_time_of_day(self):
        window = ("--from", "0", "--to", "0.0005")
        self.run_briefly("--fst", "a.fst", *window)
        second = int(time.time())
        self.wait_until(lambda: int(time.time()) > second)
        self.run_briefly("--fst", "b.fst", *window)
        self.run_briefly("--vcd", "c.vcd", *window)
        self.assertEqual((self.folder / "a.fst").read_bytes(), (self.folder / "b.fst").read_bytes())
        back = subprocess.run(["fst2vcd", "a.fst"], cwd=self.folder, capture_output=True, text=True, check=True).stdout
        self.assertRegex(back, r"\$date\s+none\s+\$end")
        self.assertNotIn("$date", (self.folder / "c.vcd").read_text())


class StandardOutput(Program):
    def commands(self):
        self.text("a.csv", JOINTS)
        return [
            ("list",),
            ("info",),
            ("--help",),
            ("run", "--help"),
            ("run", TINY, *MOMENT),
            ("check", self.brief()),
            ("compare", TINY / "golden.csv", TINY / "golden.csv"),
            ("bless", self.copy_of(self.brief())),
            ("fk", "--robot", ROBOT, "0", "0", "0", "0", "90", "0"),
            ("fk", "--robot", ROBOT, "--in", "a.csv"),
            ("ik", "--robot", ROBOT, "--xyz", "350", "-120", "500", "--rpy", "30", "120", "-10"),
        ]

    def start(self, arguments, **options):
        return subprocess.run(
            [self.path, *map(str, arguments)], cwd=self.folder, stderr=subprocess.PIPE, text=True, **options
        )

    def test_output_that_cannot_be_written_is_exit_code_3(self):
        for command in self.commands():
            with self.subTest(command), open("/dev/full", "w") as full:
                done = self.start(command, stdout=full)
                self.assertEqual(done.returncode, 3, done.stderr)
                self.assertIn("armature: cannot write to standard output", done.stderr)
                done = self.start(command, preexec_fn=lambda: os.close(1))
                self.assertEqual(done.returncode, 3, done.stderr)
                self.assertIn("armature: cannot write to standard output", done.stderr)

    def test_no_result_takes_the_number_of_a_closed_stream(self):
        os.mkfifo(self.folder / "pipe")
        command = [self.path, "run", TINY, *MOMENT, "--out", "x", "--vcd", "pipe"]
        with subprocess.Popen(command, cwd=self.folder, preexec_fn=lambda: os.closerange(0, 3)) as run:
            # It waits for the reader of the pipe when its other files are open.
            descriptors = f"/proc/{run.pid}/fd"
            links = lambda: {name: os.readlink(f"{descriptors}/{name}") for name in os.listdir(descriptors)}
            deadline = time.monotonic() + 60
            while not any(path.endswith("trace.csv") for path in links().values()) and time.monotonic() < deadline:
                time.sleep(0.02)
            standard = [links().get(name) for name in "012"]
            with (self.folder / "pipe").open("rb") as pipe:
                while pipe.read(1 << 16):
                    pass
            self.assertEqual(run.wait(timeout=60), 3)
        self.assertEqual(standard, ["/dev/null"] * 3)

    def test_no_result_gets_the_text_meant_for_a_closed_output(self):
        for closed in ((1,), (2,), (0, 1, 2)):
            self.start(
                ("run", TINY, *MOMENT, "--out", "x", "--vcd", "w.vcd"),
                stdout=subprocess.DEVNULL,
                preexec_fn=lambda: [os.close(number) for number in closed],
            )
            names = {path.name: path.read_text() for path in (self.folder / "x").iterdir()}
            names["w.vcd"] = (self.folder / "w.vcd").read_text()
            for name, text in names.items():
                with self.subTest((closed, name)):
                    self.assertNotIn("worst tick", text)
                    self.assertNotIn("cannot write", text)

    def test_a_refusal_stays_a_refusal_without_output(self):
        done = self.start(("run", "no_such_scenario"), preexec_fn=lambda: os.close(1))
        self.assertEqual(done.returncode, 2, done.stderr)

    def test_a_reader_that_has_gone_ends_the_program_quietly(self):
        for command in (("list",), ("run", TINY, *MOMENT), ("run", TINY, *MOMENT, "--fst", "w.fst")):
            for ignored in (False, True):
                with self.subTest((command, ignored)):
                    reader, writer = os.pipe()
                    os.close(reader)
                    done = self.start(
                        command,
                        stdout=writer,
                        preexec_fn=lambda: signal.signal(signal.SIGPIPE, signal.SIG_IGN if ignored else signal.SIG_DFL),
                    )
                    os.close(writer)
                    self.assertEqual((done.returncode, done.stderr), (-signal.SIGPIPE, ""))

    def test_a_closed_standard_input_is_no_empty_file(self):
        done = self.start(("fk", "--robot", ROBOT, "--in", "-"), preexec_fn=lambda: os.close(0), stdout=subprocess.PIPE)
        self.assertEqual((done.returncode, done.stderr), (2, "standard input: cannot read\n"))


if __name__ == "__main__":
    main()
