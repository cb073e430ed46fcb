"""Every example of every --help does what the help says."""

import re
import shutil
import subprocess

from cli_program import ROOT, SCENARIOS, SHORT, TINY, Program, main

SOURCES = {path.name.removesuffix("_command.cpp"): path for path in (ROOT / "cosim/cli/commands").glob("*_command.cpp")}
# Commands whose examples this test runs. serve waits for clients: test_cli_serve.py. watch waits for changes:
# test_cli_watch.py.
COMMANDS = sorted(SOURCES.keys() - {"serve", "watch"})
# A short one for examples that fail, with a move in which pulses are lost. It passes: feedback corrects the error, and
# each axis has its decoder.
CORRECTED = """description = "d"
robot = "vo2021_6r"
duration_s = 0.25
[[move]]
at_s = 0.01
type = "joint"
target_deg = [3, -2.5, 2, 1, -1, 2]
[[fault]]
at_s = 0.05
kind = "pulse_loss"
axis = 3
count = 100
[expect]
final_error_counts = [0, 0, 0, 0, 0, 0]
"""


class Help(Program):
    def setUp(self):
        super().setUp()
        shutil.copytree(SCENARIOS / "robots", self.folder / "failing/scenarios/robots")
        for name in ("pulse_loss_recovered", "fig9_joint_move"):
            self.assertTrue((SCENARIOS / name).exists())
            (self.folder / "failing/scenarios" / name).mkdir()
            self.text(f"failing/scenarios/{name}/scenario.toml", CORRECTED)
        shutil.copytree(SCENARIOS, self.folder / "brief/scenarios")
        for scenario in (self.folder / "brief/scenarios").glob("*/scenario.toml"):
            # An example has a waveform of fig9_joint_move from 0.1 s on.
            whole = scenario.parent.name == "fig9_joint_move"
            shutil.copytree(TINY if whole else self.brief(), scenario.parent, dirs_exist_ok=True)
        # Its fault is what an example waits for. The golden would be that of the whole run.
        late = self.folder / "brief/scenarios/late_core/scenario.toml"
        shutil.copy(SCENARIOS / "late_core/scenario.toml", late)
        self.edit(late, "duration_s = 1.0", "duration_s = 0.04")
        self.edit(late, "at_s = 0.30", "at_s = 0.03")
        late.write_text(late.read_text().partition("[golden]")[0])
        (late.parent / "golden.csv").unlink()

    def examples(self, *command):
        """The lines of the shell, each with the exit code that its comment tells."""
        text = self.armature(*command, "--help").stdout
        for line in re.findall(r"(?m)^  (\S.*)$", re.search(r"(?s)\nExamples?:\n(.*?)\n\n", text + "\n\n").group(1)):
            shell, _, comment = line.partition("   # ")
            code = re.match(r"exits with (\d)", comment)
            yield shell, int(code.group(1)) if code else 0

    def few_scenarios(self):
        """Enough for the examples that take all of them."""
        for scenario in (self.folder / "brief/scenarios").glob("*/scenario.toml"):
            if scenario.parent.name != SHORT:
                shutil.rmtree(scenario.parent)

    def run_example(self, shell, code):
        """On brief scenarios in place of those that it names."""
        with self.subTest(shell):
            self.assertIn("armature ", shell)
            shell = shell.replace("/tmp/", f"{self.folder}/")
            shell = re.sub(r"\barmature (?=\w)", self.path + " ", shell)
            done = subprocess.run(
                shell, shell=True, cwd=self.folder / ("failing" if code else "brief"), text=True, capture_output=True
            )
            self.assertEqual((done.returncode, done.stderr), (code, ""), done.stdout)

    def test_the_scenario_of_the_failing_examples_passes_without_their_options(self):
        self.armature("run", "pulse_loss_recovered", folder="failing")

    def test_each_command_file_is_a_command_in_the_order_that_it_states(self):
        listed = re.findall(r"(?m)^  (\w+)  ", self.armature("--help").stdout.partition("Subcommands:")[2])
        order = {name: int(re.search(r"[.]order = (\d+)", path.read_text()).group(1)) for name, path in SOURCES.items()}
        self.assertEqual(listed, sorted(order, key=lambda name: (order[name], name)))
        self.assertEqual(listed[0], "run")

    def test_the_program_without_arguments_prints_the_help(self):
        self.assertEqual(self.armature().stdout, self.armature("--help").stdout)
        self.assertIn("A subcommand is required", self.armature("--path", SCENARIOS, code=2).stderr)

    def test_every_help_has_an_example(self):
        self.assertIn("Example", self.armature("--help").stdout)
        for command in SOURCES:
            self.assertIn("armature " + command, self.armature(command, "--help").stdout)

    def test_every_example_runs_with_the_exit_code_that_it_tells(self):
        for shell, code in self.examples():
            self.run_example(shell, code)
        takes_all = []
        for command in COMMANDS:
            examples = list(self.examples(command))
            self.assertGreater(len(examples), 0, command)
            for shell, code in examples:
                if re.match(r"armature check( scenarios| --junit \S+)?$", shell):
                    takes_all.append((shell, code))
                else:
                    self.run_example(shell, code)
        self.assertEqual(len(takes_all), 3)
        self.few_scenarios()
        for shell, code in takes_all:
            self.run_example(shell, code)


if __name__ == "__main__":
    main()
