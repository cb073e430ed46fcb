"""armature new: a first scenario."""

import re
import shutil
import tomllib

from cli_program import MOMENT, SCENARIOS, Program, main

CANNOT_MOVE = {"vo2021_6r_overloaded"}  # it carries more than its drives can hold
ROBOTS = sorted({path.stem for path in SCENARIOS.glob("robots/*.toml")} - CANNOT_MOVE)
REST_S = 0.25  # of the 0.3 s after the set-points; the runs here end so much earlier


class New(Program):
    def new(self, *arguments, **how):
        """A folder outside the checkout has only the scenarios of the program."""
        return self.armature("new", *arguments, **how)

    def file(self, name):
        return self.folder / "scenarios" / name / "scenario.toml"

    def shorter(self, name):
        """Options of a run that does not wait so long for the drives at the end."""
        return "--set", f"duration_s={tomllib.loads(self.file(name).read_text())['duration_s'] - REST_S}"

    def test_it_runs_and_passes_with_each_robot(self):
        self.assertGreater(len(ROBOTS), 4)
        for robot in ROBOTS:
            with self.subTest(robot):
                said = self.new(robot + "_first", "--robot", robot).stdout.splitlines()
                self.assertEqual(said[0], f"scenarios/{robot}_first/scenario.toml")
                command = said[1].removeprefix("run it with: armature ").split()
                written = tomllib.loads(self.file(robot + "_first").read_text())
                self.assertEqual(written["robot"], robot)
                # With friction the drives need the time that the file gives them.
                options = () if robot.endswith("_dynamic") else self.shorter(robot + "_first")
                self.assertIn("PASSED", self.armature(*command, *options).stdout)
                rows = self.rows(f"out/{robot}_first/trace.csv")
                moved = {key for key in rows[0] if key.endswith("_enc_counts") and rows[0][key] != rows[-1][key]}
                self.assertEqual(len(moved), 5 if robot == "hu2012_5r" else 6)

    def test_the_examples_in_its_comments_can_be_used(self):
        self.new("nod")
        text = self.file("nod").read_text()
        self.assertIn("#[[fault]]", text)
        self.file("nod").write_text(re.sub(r"(?m)^#(?=[^ :])", "", text))
        self.assertIn("injected fault", self.armature("run", "nod", *self.shorter("nod")).stdout)

    def test_it_is_found_by_its_name_and_can_become_a_golden(self):
        self.new("nod")
        text = re.sub(r"(?m)^duration_s = \S+", "duration_s = 0.06", self.file("nod").read_text())  # in mid-move
        text = re.sub(r"(?m)^final_joint_deg = .*\ntolerance_deg = .*$", "unfinished_moves = 1", text)
        self.file("nod").write_text(text)
        self.assertRegex(
            self.armature("check", "nod", code=1).stdout, r"to make this run the golden: armature bless \S*nod\n"
        )
        self.armature("bless", "nod")
        self.armature("check", "nod")

    def test_it_is_written_into_the_first_folder_of_the_user(self):
        (self.folder / "mine/robots").mkdir(parents=True)
        self.assertIn("mine/nod/scenario.toml\n", self.new("nod", "--path", "mine").stdout)
        self.armature("run", "nod", "--path", "mine", *MOMENT)

    def test_a_robot_can_be_a_file(self):
        (self.folder / "arms").mkdir()
        shutil.copy(SCENARIOS / "robots/vo2021_6r.toml", self.folder / "arms/vo2021_6r.toml")
        self.new("nod", "--robot", "arms/vo2021_6r.toml")
        self.assertEqual(tomllib.loads(self.file("nod").read_text())["robot"], "../../arms/vo2021_6r.toml")
        self.armature("run", "nod", *MOMENT)

    def test_its_editor_finds_the_schema_wherever_it_is(self):
        self.new("nod")
        schema = self.folder / "scenarios/scenario.schema.json"
        first = self.file("nod").read_text().splitlines()[0]
        self.assertEqual((self.file("nod").parent / first.removeprefix("#:schema ")).resolve(), schema.resolve())
        self.assertEqual(schema.read_text(), self.armature("schema", "scenario").stdout)
        schema.write_text("mine")
        self.new("nod2")
        self.assertEqual(schema.read_text(), "mine")

    def test_its_numbers_are_the_shortest_ones(self):
        for robot in ROBOTS:
            self.new(robot + "_n", "--robot", robot)
            for number in re.findall(r"\d+\.\d+", self.file(robot + "_n").read_text()):
                self.assertLessEqual(len(number.partition(".")[2]), 3, (robot, number))

    def test_the_name_of_a_scenario_of_the_program_is_refused(self):
        self.assertIn("fig9_joint_move: is the name of ", self.new("fig9_joint_move", code=2).stderr)
        self.assertFalse((self.folder / "scenarios").exists())

    def test_a_robot_without_published_gears_and_motors_runs(self):
        text = (SCENARIOS / "robots/abb_irb120.toml").read_text()
        text = re.sub(r"(?m)^(gear_ratio|pulses_per_rev|encoder_lines) = .*\n", "", text)
        text = re.sub(r"(?ms)^\[defaults.drive\].*?\n\n", "", text)
        text = text.replace('name = "abb_irb120"', 'name = "ideal"\nplant = "ideal"')
        self.text("ideal.toml", text)
        self.new("nod", "--robot", "ideal.toml")
        self.assertIn("PASSED", self.armature("run", "nod", *self.shorter("nod")).stdout)
        self.text("ideal.toml", text.replace('plant = "ideal"', 'plant = "perfect"'))
        error = self.armature("run", "nod", code=2).stderr
        self.assertIn('plant: expected "servo", "ideal" or "dynamic", found "perfect"', error)
        self.assertIn("gear_ratio: missing", error)

    def test_nothing_is_overwritten(self):
        self.new("nod")
        self.file("nod").write_text("mine")
        self.assertIn("scenarios/nod: exists already", self.new("nod", code=2).stderr)
        self.assertEqual(self.file("nod").read_text(), "mine")
        (self.folder / "scenarios/link").symlink_to("nowhere")
        self.assertIn("scenarios/link: exists already", self.new("link", code=2).stderr)

    def test_a_bad_name_is_told(self):
        for name in ("a/b", "..", "", "a b", "n\u00f6d", "a.toml", "a\nb", "x" * 101):
            with self.subTest(name):
                self.assertIn("expected letters, digits", self.new(name, code=2).stderr)
        self.assertIn("is the folder of robots", self.new("robots", code=2).stderr)
        self.assertIn("did you mean vo2021_6r", self.new("nod", "--robot", "vo2021_6", code=2).stderr)
        self.assertFalse((self.folder / "scenarios").exists())


if __name__ == "__main__":
    main()
