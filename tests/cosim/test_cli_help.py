"""Every example of every --help does what the help says."""

import re
import shutil
import subprocess

from cli_program import SCENARIOS, SHORT, Program, main

# Commands whose examples this test runs. serve waits for clients: test_cli_serve.py.
COMMANDS = ("run", "check", "compare", "bless", "fk", "ik", "list", "info")


class Help(Program):
    def setUp(self):
        super().setUp()
        shutil.copytree(SCENARIOS, self.folder / "scenarios")

    def examples(self, *command):
        """The lines of the shell, each with the exit code that its comment tells."""
        text = self.armature(*command, "--help").stdout
        for line in re.findall(r"(?m)^  (\S.*)$", re.search(r"(?s)\nExamples?:\n(.*?)\n\n", text + "\n\n").group(1)):
            shell, _, comment = line.partition("   # ")
            code = re.match(r"exits with (\d)", comment)
            yield shell, int(code.group(1)) if code else 0

    def few_scenarios(self):
        """Enough for the examples that take all of them."""
        for scenario in (self.folder / "scenarios").glob("*/scenario.toml"):
            if scenario.parent.name != SHORT:
                shutil.rmtree(scenario.parent)

    def run_example(self, shell, code):
        with self.subTest(shell):
            self.assertIn("armature ", shell)
            shell = shell.replace("/tmp/", f"{self.folder}/")
            shell = re.sub(r"\barmature (?=\w)", self.path + " ", shell)
            done = subprocess.run(shell, shell=True, cwd=self.folder, text=True, capture_output=True)
            self.assertEqual((done.returncode, done.stderr), (code, ""), done.stdout)

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
