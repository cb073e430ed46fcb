"""Input that was written by an enemy or a broken disk: a clear refusal, soon, and nothing that a terminal obeys."""

import os
import resource
import subprocess
import xml.etree.ElementTree as ElementTree

from cli_program import SCENARIOS, Program, main

ROBOT = SCENARIOS / "robots" / "abb_irb120.toml"
HEAD = 'description = "d"\nrobot = "vo2021_6r"\nduration_s = 0.001\n'
# As TOML writes them: ends of lines, escapes of terminals, the end of a CDATA section, NUL, C1, change of direction.
HOSTILE = r"\u001b[2J\u001b]0;title\u0007 <b>&amp; ]]> \u0000 \u007f \u009b31m \uFFFE \u202e \n\r\n::error::x é 手"
SHOWN = "\\x1B[2J\\x1B]0;title\\x07 <b>&amp; ]]> \\x00 \\x7F \\u009B31m \\uFFFE \\u202E \\n\\r\\n::error::x é 手"
MOST_SECONDS = 60  # of a loaded machine; each takes a moment
MOST_BYTES = 1 << 30


def limit_memory():
    resource.setrlimit(resource.RLIMIT_AS, (MOST_BYTES, MOST_BYTES))


class Hostile(Program):
    def setUp(self):
        super().setUp()
        # The robots are looked for beside the scenarios.
        (self.folder / "scenarios" / "robots").mkdir(parents=True)
        for name in ("vo2021_6r", "abb_irb120"):
            (self.folder / f"scenarios/robots/{name}.toml").write_bytes(
                (SCENARIOS / f"robots/{name}.toml").read_bytes()
            )

    def scenario(self, text, name="s"):
        folder = self.folder / "scenarios" / name
        os.makedirs(os.fsencode(folder) if isinstance(name, str) else folder, exist_ok=True)
        (folder / "scenario.toml").write_bytes(text if isinstance(text, bytes) else text.encode())
        return folder

    def refused(self, *arguments, words=(), code=2, stdin=None):
        done = subprocess.run(
            [self.path, *map(str, arguments)],
            cwd=self.folder,
            capture_output=True,
            stdin=stdin,
            timeout=MOST_SECONDS,
            preexec_fn=limit_memory,
        )
        error = done.stderr.decode()  # strictly
        self.assertEqual(done.returncode, code, error[:1000])
        self.assertLess(len(error), 100_000)
        for word in words:
            self.assertIn(word, error)
        self.assertNotRegex(error, r"[\x00-\x09\x0b-\x1f\x7f-\x9f]")
        return error

    def test_text_of_a_scenario_does_not_steer_the_terminal(self):
        folder = self.scenario(HEAD.replace('"d"', f'"{HOSTILE}"'))
        done = self.armature("run", folder, "--out", "x")
        self.assertIn(f"PASSED s: {SHOWN}\n", done.stdout)
        self.assertIn(f"info: s: {SHOWN}\n", (self.folder / "x/log.txt").read_text())
        self.assertIn(SHOWN, self.armature("list").stdout)

    def test_long_text_is_cut_and_says_so(self):
        folder = self.scenario(HEAD.replace('"d"', '"' + "ö" * 1000 + '"'))
        for text in (self.armature("run", folder, "--out", "x").stdout, self.armature("list").stdout):
            self.assertIn("ö" * 200 + "[...]\n", text)
            self.assertNotIn("ö" * 201, text)

    def test_names_of_files_and_robots_do_not_steer_the_terminal(self):
        folder = self.folder / "scenarios" / "evil\x1b[31m\n"
        self.scenario(HEAD, folder.name)
        for text in (
            self.armature("run", folder).stdout,
            self.armature("list").stdout,
            self.armature("check", folder, code=1).stdout,
        ):
            self.assertNotIn("\x1b", text)
            self.assertIn("evil\\x1B[31m\\n", text)
        self.scenario(HEAD + "key\x20= 1\n", folder.name)
        self.refused("run", folder, words=["evil\\x1B[31m\\n/scenario.toml:4:1: key: unknown key"])
        self.scenario(HEAD.replace("vo2021_6r", "r\\u001b"), folder.name)
        self.refused("run", folder, words=['unknown robot "r\\x1B"'])
        self.scenario(HEAD + '"\\u001b[31m" = 1\n[trace]\nevery_ticks = "\\u0007"\n', folder.name)
        self.refused("run", folder, words=["\\x1B[31m: unknown key", 'found the string "\\x07"'])
        self.refused("run", "scenarios/s\x1b", words=["s\\x1B"])
        self.refused("run", "s", "--variant", "\x1b", words=["\\x1B"])
        self.refused("fly\x1b", words=["fly\\x1B"])
        self.text("a.csv", "tick,\x1b[31m\n0,1\n")
        self.text("b.csv", "tick,\x1b[32m\n0,1\n")
        self.assertNotIn("\x1b", self.armature("compare", "a.csv", "b.csv", code=1).stdout)

    def test_junit_is_well_formed_whatever_the_scenarios_hold(self):
        names = [b"plain", b'evil\x1b[31m\n<&">]]>', b"\xff\xfe \xed\xa0\x80 \xc0\xaf", "手臂".encode()]
        for name in names:
            folder = os.path.join(os.fsencode(self.folder), b"scenarios", name)
            os.makedirs(folder)
            with open(os.path.join(folder, b"scenario.toml"), "w", encoding="utf-8") as file:
                file.write(HEAD.replace('"d"', f'"{HOSTILE}"'))
        done = subprocess.run([self.path, "check", "--junit", "j.xml"], cwd=self.folder, capture_output=True)
        self.assertEqual(done.returncode, 1, done.stderr)  # no golden
        self.assertNotIn(b"\x1b", done.stdout)
        done.stdout.decode()
        suite = ElementTree.parse(self.folder / "j.xml").getroot()
        self.assertEqual(
            {case.get("name") for case in suite},
            {"plain", 'evil\\x1B[31m\\n<&">]]>', "\\xFF\\xFE \\xED\\xA0\\x80 \\xC0\\xAF", "手臂"},
        )
        for case in suite:
            self.assertIn(SHOWN, case.find("system-out").text)
            self.assertRegex(case.find("failure").get("message"), r"^no scenarios/.*/golden\.csv$")

    def test_a_scenario_in_a_folder_that_is_no_utf8_runs(self):
        folder = os.path.join(os.fsencode(self.folder), b"scenarios", b"\xff")
        os.makedirs(folder)
        with open(os.path.join(folder, b"scenario.toml"), "w") as file:
            file.write(HEAD)
        done = subprocess.run([self.path, "run", folder, "--out", "x"], cwd=self.folder, capture_output=True)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn(b"PASSED \\xFF: d", done.stdout)
        (self.folder / "x/summary.json").read_text("utf-8")

    def test_encodings(self):
        mark = b"\xef\xbb\xbf"
        self.armature("run", self.scenario(mark + HEAD.encode()))
        self.armature("run", self.scenario(HEAD.replace("\n", "\r\n")))
        self.armature("run", self.scenario(HEAD.rstrip("\n")))
        for encoding in ("utf-16", "utf-16-be", "utf-16-le", "utf-32"):
            text = HEAD.encode(encoding)
            self.refused("run", self.scenario(text), words=["expected UTF-8"])
        self.refused("run", self.scenario(HEAD.encode("utf-16")), words=["scenario.toml: is UTF-16 text"])
        joints = "j1_deg,j2_deg,j3_deg,j4_deg,j5_deg,j6_deg\n0,0,0,0,90,0\n".encode()
        (self.folder / "a.csv").write_bytes(mark + joints)
        self.armature("fk", "--robot", ROBOT, "--in", "a.csv")
        (self.folder / "a.csv").write_bytes(joints.decode().encode("utf-16"))
        self.refused("fk", "--robot", ROBOT, "--in", "a.csv", words=["a.csv: is UTF-16 text, expected UTF-8"])
        (self.folder / "t.csv").write_bytes(mark + b"tick,a\r\n0,1")
        self.text("u.csv", "tick,a\n0,1\n")
        self.armature("compare", "t.csv", "u.csv")

    def test_a_run_of_less_than_a_tick_is_refused(self):
        self.refused(
            "run",
            self.scenario(HEAD.replace("0.001", "4.9e-5")),
            words=["scenario.toml:3:14: duration_s: expected at least 5e-05 (s), one tick"],
        )
        self.armature("run", self.scenario(HEAD.replace("0.001", "5e-5")))

    def test_files_without_end_and_pipes_without_a_writer_are_refused_at_once(self):
        os.mkfifo(self.folder / "pipe.toml")
        folder = self.folder / "scenarios" / "p"
        folder.mkdir()
        os.mkfifo(folder / "scenario.toml")
        other = self.scenario(HEAD, "q")
        os.mkfifo(other / "golden.csv")
        (self.folder / "zero.toml").symlink_to("/dev/zero")
        for command in (("run",), ("check",), ("bless",), ("fk", "0", "0", "0", "0", "0", "0", "--robot")):
            for name in ("pipe.toml", folder, "zero.toml", "/dev/zero", "/dev/null", "."):
                with self.subTest((command, name)):
                    self.refused(*command, name)
        for command in ("bless", "check"):
            digest = "0" * 64
            self.scenario(HEAD + f'[golden]\nsha256 = "{digest}"\n', "q")
            with self.subTest(command):
                done = subprocess.run(
                    [self.path, command, other], cwd=self.folder, capture_output=True, text=True, timeout=MOST_SECONDS
                )
                self.assertIn("golden.csv: is a pipe", done.stdout + done.stderr)
        for name in ("/dev/zero", "/dev/null", "."):
            for command in (("fk", "--robot", ROBOT, "--in"), ("ik", "--robot", ROBOT, "--in"), ("compare", name)):
                with self.subTest((command, name)):
                    self.refused(*command, name)
            self.refused("run", other, "--serial", f"replay:{name}")
        with open("/dev/zero") as zero:
            self.refused("fk", "--robot", ROBOT, "--in", "-", stdin=zero)
        with subprocess.Popen(["yes", "0,0,0,0,0,0"], stdout=subprocess.PIPE) as yes:
            self.refused("fk", "--robot", ROBOT, "--in", "-", stdin=yes.stdout, words=["at most 256 MiB"])
            yes.stdout.close()

    def test_text_of_a_file_of_another_kind_is_not_shown(self):
        """A scenario of somebody else names a link to a file that only the user can read."""
        secrets = ("$6$salt", "hash1", "hash2", "password3", "19700")
        self.text("shadow", "root:$6$salt$hash1:19700:0:99999:7:::\nuser:hash2,hash2:0:\npassword3\n")
        digest = f'[golden]\nsha256 = "{"0" * 64}"\n'
        step = '[serial]\n[pendant]\n[[pendant.step]]\ndo = "download"\nfile = "{}"\n'
        line = '[[move]]\nat_s = 0\ntype = "polyline"\npoints_file = "p.csv"\nspeed_mm_s = 10\n'
        kinds = {
            "part.ngc": 'program = "part.ngc"\n',
            "part.jbi": 'program = "part.jbi"\n',
            "s.csv": '[[stream]]\nat_s = 0\nfile = "s.csv"\n',
            "p.csv": line,
            "golden.csv": digest,
            "d.ngc": step.format("d.ngc"),
            "d.jbi": step.format("d.jbi"),
        }
        head = HEAD.replace("vo2021_6r", "abb_irb120")
        commands = []
        for name, text in kinds.items():
            folder = self.scenario(head + text, "kind_" + name.replace(".", "_"))
            (folder / name).symlink_to(self.folder / "shadow")
            commands.append(("run", folder, "--out", f"out/{name}"))
        folder = self.scenario(HEAD.replace("vo2021_6r", "r.toml"), "robot")
        (folder / "r.toml").symlink_to(self.folder / "shadow")
        whole = self.folder / "scenarios/whole"
        whole.mkdir()
        (whole / "scenario.toml").symlink_to(self.folder / "shadow")
        (self.folder / "results").mkdir()
        (self.folder / "results/trace.csv").symlink_to(self.folder / "shadow")
        commands += [
            ("run", folder),
            ("run", whole),
            ("check", whole),
            ("report", "results"),
            ("compare", "shadow", "shadow"),
            ("fk", "--robot", ROBOT, "--in", "shadow"),
            ("ik", "--robot", ROBOT, "--in", "shadow"),
            ("job", "shadow"),
            ("gcode", "shadow"),
            ("run", self.scenario(HEAD + "[serial]\n"), "--serial", "replay:shadow"),
        ]
        for command in commands:
            with self.subTest(command):
                done = subprocess.run(
                    [self.path, *map(str, command)],
                    cwd=self.folder,
                    text=True,
                    capture_output=True,
                    timeout=MOST_SECONDS,
                )
                self.assertIn(done.returncode, (1, 2))
                for secret in secrets:
                    self.assertNotIn(secret, done.stdout + done.stderr)
        for log in self.folder.glob("out/*/log.txt"):
            for secret in secrets:
                self.assertNotIn(secret, log.read_text(), log)

    def test_large_and_deep_scenarios_are_refused_in_bounded_memory(self):
        cases = [
            (HEAD + '[[move]]\nat_s = 0.0001\ntype = "hold"\n' * 1_000_000, "at most 16 MiB"),
            (HEAD + "[[move]]\n" * 1_000_000, "scenario.toml:10004: expected at most 10000 tables [[move]]"),
            (HEAD + "input = [" + "{}," * 100_000 + "]\n", "input[10000]: expected at most 10000 tables [[input]]"),
            (HEAD + "a." * 1_000_000 + "a = 1\n", "scenario.toml:4: expected keys of at most 16 parts"),
            (HEAD + "a = " + "[" * 1_000_000, "scenario.toml:4: expected at most 32 nested arrays"),
            (HEAD + "a" * 1_000_000 + " = 1\n", "unknown key"),
            (HEAD + "".join(f"k{i} = 1\n" for i in range(400_000)), "more problems"),
        ]
        for text, message in cases:
            with self.subTest(message):
                self.refused("run", self.scenario(text), words=[message])
                self.refused("run", self.scenario(HEAD), "--set", "seed=" + "[" * 100_000, words=["seed"])
                self.refused("run", self.scenario(HEAD), "--set", "a." * 50_000 + "a=1", words=["expected key=value"])
        # Each of the values is from this option, which is as long as the system allows.
        wide = "trace.every_ticks=[" + "0," * 60_000 + "0]"
        self.refused("run", self.scenario(HEAD), "--set", wide, words=["trace.every_ticks: expected an integer"])

    def test_numbers_beyond_all_bounds(self):
        for value in (
            "nan",
            "inf",
            "-inf",
            "1e999",
            "9223372036854775807",
            "9223372036854775808",
            "-1",
            "0x7fffffffffffffff",
            "1" * 10_000,
            '"1"',
            "1979-05-27",
            "[]",
            "{}",
        ):
            with self.subTest(value):
                self.refused("run", self.scenario(HEAD.replace("0.001", value)), words=["scenario.toml:3:"])
                self.refused("run", self.scenario(HEAD), "--set", f"duration_s={value}", words=["duration_s"])

    def test_files_that_may_not_be_read(self):
        self.refused("run", self.scenario(""), words=["description: missing"])
        self.refused("run", self.scenario(b"\xff"), words=["scenario.toml:1"])
        if os.geteuid() != 0:
            folder = self.scenario(HEAD)
            (folder / "scenario.toml").chmod(0)
            self.refused("run", folder, words=["cannot open: Permission denied"])


if __name__ == "__main__":
    main()
