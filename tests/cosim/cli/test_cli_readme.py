"""What the READMEs quote of the program's output, and their examples."""

import re
import shutil

from cli_program import ROOT, SCENARIOS, Program, main

README = (ROOT / "README.md").read_text()
PATHS = (SCENARIOS / "PATHS.md").read_text()
KINEMATICS = (ROOT / "cosim/poses/README.md").read_text()
# The pictures that README.md shows, each of a run of its own.
PICTURES = {"fig9_joint_move": "joints", "draw_star_blended": "path"}
# What PATHS.md quotes of a run is known before this time. Such a run does not come to what the scenario expects.
PLANNED = ("--set", "duration_s=0.45")


class Readme(Program):
    def test_what_a_comment_quotes_is_printed(self):
        quotes = re.findall(r'^armature run (\w+) +# "([^"]+)"', PATHS, re.M)
        self.assertEqual(
            [scenario for scenario, _ in quotes], ["through_wrist_singularity", "near_reach_limit_refused"]
        )
        for scenario, quote in quotes:
            with self.subTest(scenario):
                printed = self.armature("run", SCENARIOS / scenario, *PLANNED, code=1).stdout
                self.assertIn(quote, " ".join(printed.split()))

    def test_the_examples_of_kinematics_run_as_printed(self):
        shutil.copytree(SCENARIOS, self.folder / "scenarios")
        examples = re.findall(r"^armature ((?:fk|ik) [^#\n]*)", KINEMATICS, re.M)
        self.assertGreaterEqual(len(examples), 4)
        for example in examples:
            with self.subTest(example):
                self.armature(*example.split())
        self.assertEqual(len(self.rows("poses.csv")), len(self.rows("scenarios/robots/examples/joints.csv")))
        self.assertEqual({row["selected"] for row in self.rows("solutions.csv")}, {"0", "1"})

    def test_readme_fits_on_a_few_screens(self):
        lines = README.splitlines()
        self.assertLessEqual(len(lines), 126)
        self.assertLessEqual(max(map(len, lines)), 100)

    def test_every_link_of_a_readme_leads_somewhere(self):
        readmes = [file for file in ROOT.rglob("*.md") if "build" not in file.relative_to(ROOT).parts]
        self.assertGreater(len(readmes), 40)
        for file in readmes:
            for link in re.findall(r"\]\((?!http)([^)#]+)[^)]*\)", file.read_text()):
                with self.subTest(file=file, link=link):
                    self.assertTrue((file.parent / link).exists())

    def test_the_summary_of_the_first_run_is_what_is_printed(self):
        block = re.search(r"^The first command prints:\n\n```\n(.*?)^```$", README, re.M | re.S).group(1)
        machine = re.compile(r"^(  host time  +)\d.* s, .* Mcycles/s, .*$|^(results  +).*$", re.M)
        same = lambda text: machine.sub(lambda found: found.group(1) or found.group(2), text)
        self.assertIn("host time", block)
        _, printed = self.run_once(SCENARIOS / "fig9_joint_move")
        self.assertEqual(same(printed), same(block))

    def test_the_pictures_of_the_readme_are_those_of_the_program(self):
        for scenario, figure in PICTURES.items():
            with self.subTest(scenario):
                out, _ = self.run_once(SCENARIOS / scenario)
                self.armature("plot", out, "--figure", figure, "-o", "picture.svg")
                committed = SCENARIOS / scenario / f"{figure}.svg"
                drawn = (self.folder / "picture.svg").read_text()
                self.assertEqual(drawn, committed.read_text(), f"renew it: armature plot ... -o {committed}")
                self.assertIn(f"(scenarios/{scenario}/{figure}.svg)", README)


if __name__ == "__main__":
    main()
