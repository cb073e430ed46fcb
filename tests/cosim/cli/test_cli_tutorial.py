"""scenarios/TUTORIAL.md: its commands do what it says, and print what it quotes."""

import re
import subprocess

from cli_program import ROOT, SCENARIOS, Program, main

TUTORIAL = (SCENARIOS / "TUTORIAL.md").read_text()
BLOCK = re.compile(r"(?ms)^```(\w*)\n(.*?)^```$")


def squeezed(text):
    return " ".join(text.split())


class Tutorial(Program):
    def run_line(self, line):
        command, _, comment = line.partition("   # ")
        code = re.match(r"exits with (\d)", comment)
        done = subprocess.run(
            command.replace("armature ", self.path + " ", 1),
            shell=True,
            cwd=self.folder,
            text=True,
            capture_output=True,
        )
        self.assertEqual((done.returncode, done.stderr), (int(code.group(1)) if code else 0, ""), line + done.stdout)
        return done.stdout

    def test_it_can_be_followed(self):
        scenario = self.folder / "scenarios/nod/scenario.toml"
        printed = {}
        latest = quoted = 0
        for language, text in BLOCK.findall(TUTORIAL):
            if language == "toml":
                self.added = text
                scenario.write_text(scenario.read_text() + "\n" + text)
            elif text.startswith("gtkwave "):
                self.check_view(*text.split()[1:])
                scenario.write_text(scenario.read_text().replace(self.added, ""))  # as the last chapter says
            elif text.startswith("armature "):
                for line in text.splitlines():
                    latest = printed[line] = squeezed(self.run_line(line))
            else:
                for line in text.splitlines():
                    self.assertIn(squeezed(line), latest)
                    quoted += 1
        self.assertEqual(len(printed), 6)
        self.assertEqual(quoted, 5)
        self.assertTrue(printed["armature run nod --report"].startswith("PASSED nod"))
        self.check_what_it_says_of_the_cores()

    def check_view(self, wave, view):
        """The waveform has the signals of the view, and the event that the tutorial describes."""
        lines = (ROOT / view).read_text().splitlines()
        names = [re.sub(r"^\+\{.*\} (\(\d\))?", "", line) for line in lines if line.startswith("+{")]
        self.assertGreater(len(names), 5)
        scopes, codes, changes, now = [], {}, {}, 0
        with open(self.folder / wave) as file:
            for line in file:
                words = line.split()
                if line.lstrip().startswith("$scope"):
                    scopes.append(words[2])
                elif line.lstrip().startswith("$upscope"):
                    scopes.pop()
                elif line.lstrip().startswith("$var"):
                    codes[".".join([*scopes, words[4]]) + (words[5] if words[5] != "$end" else "")] = words[3]
                elif line.startswith("#"):
                    now = int(line[1:])
                elif line.startswith("1"):
                    changes.setdefault(line[1:].strip(), []).append(now)
        for name in names:
            self.assertIn(name, codes)
        rises = lambda end: next(changes.get(codes[name], []) for name in names if name.endswith(end))
        trigger = 200_062_160
        self.assertIn(str(trigger), (ROOT / view).read_text())
        self.assertIn(trigger, rises("trigger_o"))
        self.assertIn(trigger, rises("underrun_event_o"))
        late_ns = min(at - trigger for at in rises("commit_i") if at > trigger)
        self.assertEqual(late_ns, 40)
        self.assertIn(trigger - 20, rises("wvalid_i"))

    def check_what_it_says_of_the_cores(self):
        rows = self.rows("out/nod/load.csv")
        before = {row["core0_awake_cycles"] for row in rows if 0.1 < float(row["time_s"]) < 0.2}
        after = {row["core0_awake_cycles"] for row in rows if 0.21 < float(row["time_s"]) < 0.22}
        self.assertEqual(before, {"800"})
        self.assertLessEqual(after, {"2499", "2500"})


if __name__ == "__main__":
    main()
