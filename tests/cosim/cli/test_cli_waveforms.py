"""armature run --vcd and --fst."""

import re
import subprocess

from cli_program import BRIEF, ROOT, TINY, Program, main


class Waveforms(Program):
    def test_waveform_window(self):
        self.armature("run", TINY, *BRIEF, "--vcd", "w.vcd", "--from", "0.012", "--to", "0.0121")
        text = (self.folder / "w.vcd").read_text()
        for name in ("step_o", "dir_o", "enc_a_i", "s_axi_awaddr_i"):
            self.assertRegex(text, rf"\$var \w+ +\d+ \S+ {name}\b")
        times = [int(t) for t in re.findall(r"^#(\d+)", text, re.M)]
        self.assertGreaterEqual(times[0], 12_000_000)
        self.assertLessEqual(times[-1], 12_100_000 + 20)
        self.assertGreater(len(times), 9_000)

    def test_every_signal_of_the_views_exists(self):
        for variant, name in (("counts", "tools/arm_soc"), ("paper", "tools/arm_soc_paper")):
            with self.subTest(variant):
                signals = self.signals(variant)
                self.check_view(signals, (ROOT / f"{name}.gtkw").read_text())
                self.check_surfer_view(signals, (ROOT / f"{name}.sucl").read_text())

    def signals(self, variant):
        window = ("--from", "0.012", "--to", "0.012001")
        self.armature("run", TINY, *BRIEF, "--variant", variant, "--vcd", "w.vcd", *window)
        scope, signals = [], set()
        for line in (self.folder / "w.vcd").read_text().split("$enddefinitions")[0].splitlines():
            words = line.split()
            if words[:2] == ["$scope", "module"]:
                scope.append(words[2])
            elif words[:1] == ["$upscope"]:
                scope.pop()
            elif words[:1] == ["$var"]:
                signals.add(".".join(scope + words[4:-1]).replace(".[", "["))
        return signals

    def check_surfer_view(self, signals, view):
        names = {re.sub(r"(?<=\w)\[\d+:0\]$", "", name) for name in signals}
        shown = re.findall(r"^variable_add (\S+)$", view, re.M)
        self.assertGreater(len(shown), 30)
        self.assertEqual([name for name in shown if name not in names], [])

    def check_view(self, signals, view):
        shown = re.findall(r"^\+\{[^}]+\} (?:\(\d+\))?(\S+)$", view, re.M)
        self.assertGreater(len(shown), 120)
        for bits in re.findall(r"^#\{[^}]+\} (.+)$", view, re.M):
            shown += {re.sub(r"^\(\d+\)", "", bit) for bit in bits.split()}
        self.assertIn("top.software.tick[31:0]", shown)
        self.assertEqual([name for name in shown if name not in signals], [])

    def test_a_window_that_was_written_is_not_missing(self):
        window = ("--from", "0.02", "--to", "0.0201")
        self.assertNotIn("no waveform", self.armature("run", TINY, *BRIEF, "--vcd", "w.vcd", *window).stdout)

    def test_fst_without_its_converter_is_refused_before_the_run(self):
        (self.folder / "bin").mkdir()
        (self.folder / "bin" / "sh").symlink_to("/bin/sh")
        done = subprocess.run(
            [self.path, "run", TINY, "--fst", "w.fst"],
            cwd=self.folder,
            text=True,
            capture_output=True,
            env={"PATH": str(self.folder / "bin")},
        )
        self.assertEqual(done.returncode, 2, done.stderr)
        self.assertIn("vcd2fst", done.stderr)


if __name__ == "__main__":
    main()
