"""armature completion: what shells offer."""

import os
import pty
import re
import select
import shlex
import shutil
import subprocess
import time
import unittest

from cli_program import SCENARIOS, Program, main

ZSH, FISH = shutil.which("zsh"), shutil.which("fish")
CALL = """
. ./armature.bash
COMP_WORDS=({words})
COMP_CWORD=$((${{#COMP_WORDS[@]}} - 1))
_armature {program}
printf '%s\\n' "${{COMPREPLY[@]}}"
"""


class Completion(Program):
    def setUp(self):
        super().setUp()
        self.text("armature.bash", self.armature("completion", "bash").stdout)

    def offered(self, *words):
        """What bash offers for the last word."""
        line = " ".join(shlex.quote(word) for word in ("armature", *words))
        done = subprocess.run(
            ["bash", "--norc", "-uc", CALL.format(words=line, program=shlex.quote(self.path))],
            cwd=self.folder,
            text=True,
            capture_output=True,
        )
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        return set(done.stdout.split("\n")) - {""}

    def options_of(self, *command):
        """Those that the help lists."""
        text = self.armature(*command, "--help").stdout.partition("\nOptions:")[2].partition("\n\n")[0]
        names = re.findall(r"(?m)^  (-\S+)", text)
        return {name for group in names for name in group.split(",") if name != "-h"}

    def test_every_command_and_every_option_of_the_help_is_offered(self):
        help_text = self.armature("--help").stdout
        commands = set(re.findall(r"(?m)^  (\w+)  ", help_text.partition("Subcommands:")[2]))
        self.assertIn("completion", commands)
        self.assertEqual(self.offered(""), commands)
        common = self.options_of()
        self.assertIn("--path", common)
        self.assertEqual(self.offered("-"), common)
        for command in commands:
            with self.subTest(command):
                self.assertEqual(self.offered(command, "-"), self.options_of(command) | common)

    def test_what_has_begun_is_completed(self):
        self.assertEqual(self.offered("comp"), {"compare", "completion"})
        self.assertEqual(self.offered("run", "--v"), {"--vcd", "--variant", "--version"})
        self.assertEqual(self.offered("--path", "mine", "comp"), {"compare", "completion"})

    def test_values_are_offered_by_their_kind(self):
        self.text("poses.csv", "")
        self.text("arm.toml", "")
        (self.folder / "mine").mkdir()
        files = {"poses.csv", "arm.toml", "armature.bash", "mine"}
        names = {path.parent.name for path in SCENARIOS.glob("*/scenario.toml")}
        robots = {path.stem for path in SCENARIOS.glob("robots/*.toml")}
        for words, offered in {
            ("run", ""): names | files,
            ("run", "--report", "draw_l"): {"draw_line"},
            ("check", "jog", "draw_l"): {"draw_line"},
            ("run", "--variant", ""): {"counts", "paper"},
            ("run", "--variant", "=", "p"): {"paper"},
            ("run", "--variant", "="): {"counts", "paper"},
            ("run", "--out", ""): {"mine"},
            ("run", "--pace", ""): set(),
            ("fk", "--robot", ""): robots | files,
            ("fk", "--robot", "abb_irb120", "1", ""): set(),
            ("fk", "--tool", "1", "2", "3", "4", "5", ""): set(),
            ("gcode", ""): {"check", "canon", "codes"} | files,
            ("gcode", "check", "a.ngc", "b.ngc", "pos"): {"poses.csv"},
            ("gcode", "a.ngc", "c"): set(),
            ("compare", "poses.csv", "pos"): {"poses.csv"},
            ("compare", "a", "b", ""): set(),
            ("job", ""): {"check", "print", "list", "instructions"} | files,
            ("job", "print", "pos"): {"poses.csv"},
            ("plot", "--figure", "p"): {"path"},
            ("plot", "--figure", "path", "m"): {"mine"},
            ("nonsense", ""): set(),
        }.items():
            with self.subTest(words):
                self.assertEqual(self.offered(*words), offered)

    def test_the_folders_of_path_are_searched(self):
        (self.folder / "my data").mkdir()
        for name in ("alpha", "beta"):
            (self.folder / "my data" / name).mkdir()
            self.text(f"my data/{name}/scenario.toml", "")
        self.assertEqual(self.offered("run", "--path", "my data", "al"), {"alpha"})
        self.assertEqual(self.offered("--path", "my data", "run", "bet"), {"beta"})
        self.assertEqual(self.offered("run", "--path", "my"), {"my data"})

    def type_at(self, shell, *options):
        """A function that types keys at an interactive shell and waits until it has shown a text."""
        environment = {
            "PATH": f"{os.path.dirname(self.path)}:{os.environ['PATH']}",
            "TERM": "dumb",
            "PS1": "> ",
            "HOME": str(self.folder),
        }
        pid, terminal = pty.fork()
        if pid == 0:
            os.chdir(self.folder)
            os.execve(shell, [shell, *options, "-i"], environment)
        self.addCleanup(os.waitpid, pid, 0)
        self.addCleanup(os.close, terminal)
        shown = ""

        def type_and_wait(keys, expected):
            nonlocal shown
            os.write(terminal, keys.encode())
            deadline = time.monotonic() + 60
            while expected not in shown:
                self.assertTrue(select.select([terminal], [], [], max(0, deadline - time.monotonic()))[0], shown)
                shown += os.read(terminal, 4096).decode()
            shown = shown.partition(expected)[2]

        return type_and_wait

    def test_the_tab_key_of_an_interactive_bash_completes(self):
        """As a user types it, at a terminal."""
        type_and_wait = self.type_at("/bin/bash", "--norc", "--noprofile")
        type_and_wait(". ./armature.bash; echo re''ady\n", "ready")
        type_and_wait("armature plot --fig\t", "armature plot --figure ")
        type_and_wait("jo\t", "joints ")
        type_and_wait("\x15armature run fig9\t", "armature run fig9_joint_move ")
        type_and_wait("\x15exit\n", "exit")

    @unittest.skipUnless(ZSH, "zsh is not installed")
    def test_the_tab_key_of_an_interactive_zsh_completes(self):
        """The script is a file that a user reads, and one of a folder of $fpath, as it is installed."""
        (self.folder / "mine").mkdir()
        (self.folder / "mine/colon:a").mkdir()
        for file, load in {
            "armature.zsh": "compinit -D -u; . ./armature.zsh",
            "_armature": "fpath=($PWD $fpath); compinit -D -u",
        }.items():
            with self.subTest(load):
                self.text(file, self.armature("completion", "zsh").stdout)
                type_and_wait = self.type_at(ZSH, "-f")
                type_and_wait(f"autoload -U compinit; {load}; echo re''ady\n", "ready\r\n")
                type_and_wait("armature plot --fig\t", "armature plot --figure ")
                type_and_wait("jo\t", "joints ")
                type_and_wait("\x15armature run fig9\t", "_joint_move ")
                type_and_wait("\x15armature run --variant=p\t", "--variant=paper ")
                type_and_wait("\x15armature run --out mi\t", "--out mine/")
                type_and_wait("\x15exit\n", "exit")

    @unittest.skipUnless(FISH, "fish is not installed")
    def test_fish_completes(self):
        self.text("armature.fish", self.armature("completion", "fish").stdout)
        self.text("poses.csv", "")
        (self.folder / "mine").mkdir()
        environment = {**os.environ, "PATH": f"{os.path.dirname(self.path)}:{os.environ['PATH']}"}
        for line, offered in {
            "armature plot --fig": ["--figure\tWhat to draw"],
            "armature comp": [
                "compare\tCompare two runs: traces and waveforms",
                "completion\tPrint a script that lets a shell complete commands",
            ],
            "armature plot --figure path --figure jo": ["joints"],
            "armature run fig9": ["fig9_joint_move"],
            "armature run --variant=p": ["--variant=paper"],
            "armature run --out mi": ["mine/\tDirectory"],
            "armature compare pos": ["poses.csv"],
            "armature compare a b ": [],
        }.items():
            with self.subTest(line):
                done = subprocess.run(
                    [FISH, "--no-config", "-c", f"source armature.fish; complete -C {shlex.quote(line)}"],
                    cwd=self.folder,
                    env=environment,
                    text=True,
                    capture_output=True,
                )
                self.assertEqual((done.returncode, done.stderr), (0, ""))
                self.assertEqual(done.stdout.splitlines(), offered)

    def test_each_shell_is_told_in_its_own_way(self):
        for shell, lines in {
            "bash": ["none", "--engine", "--to", "--help"],
            "zsh": ["none", "--to:Waveform", "--help:Print"],
            "fish": ["none", "--to\tWaveform", "--help\tPrint"],
        }.items():
            answer = self.armature("completion", shell, "--", "run", "-").stdout.splitlines()
            for line in lines:
                self.assertTrue(any(said.startswith(line) for said in answer), (shell, line, answer))
        self.assertEqual(self.armature("completion", "bash", "--", "run", "--out", "").stdout, "folders\n")
        self.assertEqual(self.armature("completion", "bash", "--", "run", "--path", "nowhere", "").stdout, "files\n")
        self.assertEqual(self.armature("completion", "bash", "--", "ik", "--xyz", "-1", "2").stdout, "none\n")


if __name__ == "__main__":
    main()
