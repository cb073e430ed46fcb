"""armature compare of runs that have waveforms: the first cycle in which a signal differs."""

import json
import os
import random
import re
import shutil
import subprocess

from cli_program import BRIEF, TINY, Program, main
from vcd import Vcd

CYCLE_NS = 20
WINDOW = ("--from", "0.0205", "--to", "0.02054")  # 2000 cycles, the arm moves
FIRST = re.compile(r"^FAIL (\S+) and (\S+) differ first in cycle (\d+) \((\S+) s\)(?:, tick (\d+))?$", re.M)
TRIALS = 50
SEED = 20261128


class Wave:
    """A VCD file as head, times and the changes of each time, so that a change can be planted into its text."""

    def __init__(self, text):
        self.head, mark, body = text.partition("$enddefinitions $end\n")
        self.head += mark
        self.steps = []  # [time in ns, {code: line}]
        for line in body.splitlines():
            if line.startswith("#"):
                self.steps.append([int(line[1:]), {}])
            elif line:
                self.steps[-1][1][self.code_of(line)] = line
        self.names, scope = {}, []
        for words in map(str.split, self.head.splitlines()):
            if words[:1] == ["$scope"]:
                scope.append(words[2])
            elif words[:1] == ["$upscope"]:
                scope.pop()
            elif words[:1] == ["$var"]:
                self.names.setdefault(words[3], []).append(".".join([*scope, words[4]]) + "".join(words[5:-1]))

    @staticmethod
    def code_of(line):
        return line.split()[1] if line.startswith("b") else line[1:]

    def with_other_cycle(self, code, at):
        """The text with another value of one signal in the cycle that begins at step `at`, and in no other one."""
        time = self.steps[at][0]
        value = next(changes[code] for _, changes in self.steps[at::-1] if code in changes)
        lines = [self.head.rstrip("\n")]
        for now, changes in self.steps:
            lines.append(f"#{now}")
            changes = dict(changes)
            if time <= now < time + CYCLE_NS:
                value = changes.pop(code, value)
            if now == time:
                changes[code] = self.flipped(value)
            if now == time + CYCLE_NS:
                changes.setdefault(code, value)
            lines += changes.values()
        return "\n".join(lines) + "\n"

    @staticmethod
    def flipped(line):
        """The last bit."""
        digits, blank, code = line.partition(" ") if line.startswith("b") else (line[0], "", line[1:])
        return digits[:-1] + ("1" if digits[-1] == "0" else "0") + blank + code


class CompareWaves(Program):
    def recorded(self, name, *options, wave="--vcd", scenario=TINY, code=0):
        """The file of a run of the window; `code` None: whether the run passes does not matter."""
        file = f"{name}/w.{wave[2:]}"
        (self.folder / name).mkdir()
        self.armature("run", scenario, *BRIEF, "--out", name, wave, file, *(options or WINDOW), "-q", code=code)
        return file

    def first(self, *arguments):
        """The first difference that is said: cycle and tick; and all that is said."""
        text = self.armature("compare", *arguments, code=1).stdout
        found = FIRST.search(text)
        self.assertTrue(found, text)
        cycle, tick = int(found[3]), int(found[5])
        self.assertEqual(found[4], f"{cycle * CYCLE_NS / 1e9:.8f}")
        return cycle, tick, text

    def test_one_cycle_of_one_signal_is_named_wherever_it_is_planted(self):
        wave = Wave((self.folder / self.recorded("a")).read_text())
        tick_code = next(code for code, names in wave.names.items() if "top.software.tick[31:0]" in names)
        rising = [i for i, (time, _) in enumerate(wave.steps) if time % CYCLE_NS == 0][:-1]
        rng = random.Random(SEED)
        (self.folder / "b").mkdir()
        for trial in range(TRIALS):
            code, at = rng.choice(sorted(wave.names)), rng.choice(rising)
            with self.subTest(seed=SEED, trial=trial, code=code, at=at):
                (self.folder / "b/w.vcd").write_text(wave.with_other_cycle(code, at))
                cycle, tick, text = self.first("a/w.vcd", "b/w.vcd")
                self.assertEqual(cycle, wave.steps[at][0] // CYCLE_NS)
                signals = re.findall(r"^  (\S+): a/w\.vcd: \S+, b/w\.vcd: \S+$", text, re.M)
                self.assertEqual(len(signals), 1, text)
                self.assertIn(signals[0], wave.names[code])
                if code != tick_code:
                    known = next(c[tick_code] for _, c in wave.steps[at::-1] if tick_code in c)
                    self.assertEqual(tick, int(known[1:].split()[0], 2))

    def test_hardware_that_acts_one_cycle_later_is_named_with_its_pin(self):
        estop = '\n[[fault]]\nkind = "estop"\nduration_s = 0.001\nat_s = {}\n'
        tool = "\n[[input]]\npin = 7\nlevel = 1\nat_s = {}\n"
        stray = '\n[[fault]]\nkind = "stray_write"\naddress = 0x43C10004\ndata = 0\nat_s = {}\n'
        serial = '\n[serial]\n[[serial_send]]\ntext = "x"\nat_s = {}\n'
        compute = "\n[cpu]\ntick_compute_cycles = {}\n"
        times = ("0.0205102", "0.02051022")
        for number, (table, values, signal) in enumerate(
            (
                (estop, times, "top.estop_ni"),
                (tool, times, "top.gpio_i[15:0]"),
                (stray, times, "top.software.bus_busy"),
                (serial, times, "top.uart_rxd_i"),
                (compute, (250, 251), "top.software.core0[71:0]"),
            )
        ):
            with self.subTest(table):
                waves = []
                for value, name in zip(values, (f"a{number}", f"b{number}")):
                    scenario = self.copy_of(TINY)
                    with (scenario / "scenario.toml").open("a") as file:
                        file.write(table.format(value))
                    waves.append(self.recorded(name, scenario=scenario, code=None))
                    shutil.rmtree(self.folder / "scenarios")
                cycle, _, text = self.first(*waves)
                at, names = self.first_of(*(Vcd((self.folder / wave).read_text()) for wave in waves))
                self.assertEqual(cycle, at // CYCLE_NS, text)
                self.assertRegex(text, rf"\n  {re.escape(signal)}")
                said = re.findall(r"^  (top\.[^[:]+)\S*: ", text, re.M)
                self.assertLessEqual(set(said), names)

    def first_of(self, a, b):
        """The first time at which two waveforms of one window differ, and the names of the signals that do."""
        found = {}
        for name, changes in a.changes.items():
            others = b.changes[name]
            times = [min(x[0], y[0]) for x, y in zip(changes, others) if x != y]
            times += [change[0] for change in changes[len(others) :] + others[len(changes) :]]
            if times:
                found.setdefault(min(times), set()).add(name)
        return min(found.items())

    def test_two_folders_of_results_are_compared_with_their_waveforms(self):
        self.recorded("a")
        self.recorded("b", wave="--fst")
        done = self.armature("compare", "a", "b")
        self.assertRegex(done.stdout, r"^PASS a/trace\.csv and b/trace\.csv are equal: ")
        self.assertRegex(done.stdout, r"\nPASS a/w\.vcd and b/w\.fst are equal: \d+ signals from cycle 1025001 ")
        document = json.loads(self.armature("compare", "a", "b", "--json").stdout)
        self.assertEqual((document["equal"], document["waveforms"][0]["equal"]), (True, True))

    def test_the_part_of_time_that_both_have_is_compared(self):
        self.recorded("a")
        self.recorded("later", "--from", "0.02052", "--to", "0.02056")
        self.recorded("other", "--from", "0.022", "--to", "0.02201")
        done = self.armature("compare", "a/w.vcd", "later/w.vcd")
        self.assertRegex(done.stdout, r"from cycle 1026001 \(0\.02052002 s\) to cycle 1027000 \(0\.02054000 s\)\n$")
        done = self.armature("compare", "other/w.vcd", "a/w.vcd", code=1)
        self.assertEqual(
            done.stdout,
            "FAIL other/w.vcd and a/w.vcd have no time in common\n"
            "  a/w.vcd ends in cycle 1027000 (0.02054000 s), other/w.vcd begins in cycle 1100001 (0.02200002 s)\n",
        )

    def test_the_pins_of_the_model_are_compared_with_those_of_the_rtl(self):
        self.recorded("a")
        self.recorded("m", *WINDOW, "--engine", "model")
        done = self.armature("compare", "a/w.vcd", "m/w.vcd")
        self.assertRegex(done.stdout, r"^PASS .* are equal: \d\d signals .*\n  \d{4} signals only in a/w\.vcd: .*\n$")

    def test_views_of_the_difference_can_be_opened(self):
        wave = Wave((self.folder / self.recorded("a")).read_text())
        code = next(code for code, names in wave.names.items() if "top.step_o[5:0]" in names)
        (self.folder / "b").mkdir()
        (self.folder / "b/w.vcd").write_text(wave.with_other_cycle(code, 1000))
        time = wave.steps[1000][0]
        text = self.first("a/w.vcd", "b/w.vcd")[2]
        self.assertIn("  to see it: armature compare a/w.vcd b/w.vcd --views out/views\n", text)
        (self.folder / "bin").mkdir()
        self.text("bin/gtkwave", '#!/bin/sh\necho "$*" >> started\n')  # two of them: a line is one write
        (self.folder / "bin/gtkwave").chmod(0o755)
        path = f"{self.folder}/bin:{os.environ['PATH']}"
        done = self.armature("compare", "a/w.vcd", "b/w.vcd", "--views", "v", "--open", code=1, PATH=path)
        self.assertIn("  to see it:\n  gtkwave a/w.vcd v/a.gtkw\n  gtkwave b/w.vcd v/b.gtkw\n", done.stdout)
        started = self.folder / "started"
        self.wait_until(lambda: started.exists() and started.read_text().count("\n") == 2)
        self.assertEqual(sorted(started.read_text().splitlines()), ["a/w.vcd v/a.gtkw", "b/w.vcd v/b.gtkw"])
        for name in ("v/a.gtkw", "v/b.gtkw"):
            view = (self.folder / name).read_text()
            self.assertRegex(view, rf"\n\*-\d+\.\d+ {time}( -1){{26}}\n\[timestart\] {time - 1400}\n")
            self.assertIn("\ntop.step_o[5:0]\n", view)
            signals = re.findall(r"^(top\.\S+)$", view, re.M)
            self.assertEqual([s for s in signals if not any(s in names for names in wave.names.values())], [])

    def test_what_cannot_be_compared_is_said(self):
        self.recorded("a")
        self.recorded("b")
        self.armature("run", TINY, *BRIEF, "--out", "none", "-q")
        self.assertRegex(self.armature("compare", "a", "none").stdout, r"\nno waveform in none\n$")
        (self.folder / "b/w.vcd").rename(self.folder / "b/x.vcd")
        (self.folder / "b/y.fst").touch()
        self.assertRegex(
            self.armature("compare", "a", "b").stdout,
            r"\nwaveforms are not compared: those in a and b have other names; name two files\n$",
        )
        for arguments, reason in (
            (("a/w.vcd", "b/trace.csv"), "b/trace.csv: expected a waveform (.vcd or .fst), as a/w.vcd is one"),
            (("a/w.vcd", "no.vcd"), "no.vcd: cannot open: No such file"),
            (("a/w.vcd", "b/y.fst"), "b/y.fst: fst2vcd cannot read it"),
            (("a/w.vcd", "b/x.vcd", "--report", "r.html"), "--report: needs traces or folders of results"),
            (("a/w.vcd", "b/x.vcd", "--open"), "--open requires --views"),
        ):
            with self.subTest(arguments):
                self.assertIn(reason, self.armature("compare", *arguments, code=2).stderr)

    def test_fst_without_its_reader_is_refused(self):
        self.recorded("a", wave="--fst")
        (self.folder / "bin").mkdir()
        (self.folder / "bin/sh").symlink_to("/bin/sh")
        done = subprocess.run(
            [self.path, "compare", "a/w.fst", "a/w.fst"],
            cwd=self.folder,
            text=True,
            capture_output=True,
            env={"PATH": str(self.folder / "bin")},
        )
        self.assertEqual((done.returncode, done.stdout), (2, ""))
        self.assertIn("a/w.fst: needs the program fst2vcd (Debian package gtkwave)", done.stderr)


if __name__ == "__main__":
    main()
