"""Where scenarios and robots are found: --path, ARMATURE_PATH, the current folder, the program's own."""

import re
import shutil

from cli_program import ROOT, SCENARIOS, TINY, Program, main

OTHER = "fig9_joint_move"


class Paths(Program):
    def setUp(self):
        super().setUp()
        self.folder = self.folder.resolve()

    def own(self, place, *names):
        """A folder of scenarios: each a copy of a brief one, whose description is the place; its robots."""
        for name in names:
            shutil.copytree(self.brief(), self.folder / place / name)
            self.edit(self.folder / place / name / "scenario.toml", 'description = "', f'description = "{place}: ')
        return place

    def own_robot(self, place, name):
        (self.folder / place).mkdir(parents=True, exist_ok=True)
        self.text(
            f"{place}/{name}.toml",
            (SCENARIOS / "robots/abb_irb120.toml").read_text().replace('name = "abb_irb120"', f'name = "{name}"'),
        )

    def lone_program(self):
        """The program where no data is: neither beside it nor above it."""
        (self.folder / "elsewhere").mkdir()
        return shutil.copy(self.path, self.folder / "elsewhere")

    def test_the_first_of_the_search_path_wins(self):
        for place in ("first", "second", "variable", "here/scenarios"):
            self.own(place, "nod")
        (self.folder / "here/deep").mkdir()
        first, second, variable = (self.folder / name for name in ("first", "second", "variable"))
        cases = [
            ("first", ["--path", first, "--path", second], f"{variable}:"),
            ("second", ["--path", second], variable),
            ("variable", [], f"{variable}:{first}"),
            ("here", [], ""),
        ]
        for expected, arguments, environment in cases:
            listing = self.armature("list", *arguments, folder="here/deep", ARMATURE_PATH=str(environment)).stdout
            self.assertEqual(re.findall(r"(?m)^nod +vo2021_6r .* s  (\w+)", listing), [expected], listing)
        self.assertIn(
            "PASSED nod: second: ",
            self.armature("run", "nod", "--path", second, folder="here/deep", ARMATURE_PATH=str(first)).stdout,
        )

    def test_path_is_understood_before_and_behind_the_command(self):
        self.own("mine", "nod")
        for arguments in (
            ("--path", "mine", "run", "nod"),
            ("run", "--path", "mine", "nod"),
            ("run", "nod", "--path=mine"),
        ):
            self.assertIn("PASSED nod: mine: ", self.armature(*arguments).stdout)
        self.assertTrue((self.folder / "out/nod/trace.csv").exists())

    def test_every_command_looks_up_names_on_the_path(self):
        self.own("mine", "nod")
        self.own_robot("mine/robots", "my_arm")
        path = ("--path", "mine")
        self.assertIn("PASS  nod", self.armature("check", "nod", *path).stdout)
        self.armature("bless", "nod", *path)
        self.assertIn("flange of my_arm", self.armature("fk", "--robot", "my_arm", *path, 0, 0, 0, 0, 0, 0).stdout)
        self.assertIn(
            "flange of my_arm",
            self.armature("ik", "--robot", "my_arm", *path, "--xyz", 302, 0, 558, "--rpy", 0, 90, 0).stdout,
        )
        self.assertRegex(
            self.armature("info", *path).stdout,
            r"(?m)^scenarios +mine \(--path\)\n" rf"scenarios +{SCENARIOS} \(checkout of the program\)$",
        )
        self.edit(self.folder / "mine/nod/scenario.toml", 'robot = "vo2021_6r"', 'robot = "fanuc_lrmate200id"')
        self.assertRegex(self.armature("list", *path).stdout, r"(?m)^nod +fanuc_lrmate200id ", "a robot of the program")

    def test_robots_of_the_current_folder_are_found(self):
        self.own_robot("robots", "my_arm")
        self.assertIn("flange of my_arm", self.armature("fk", "--robot", "my_arm", 0, 0, 0, 0, 0, 0).stdout)
        self.assertRegex(self.armature("list").stdout, r"(?m)^robots in \./robots \(current folder\)\nmy_arm  ")

    def test_list_shows_the_folders_in_their_order_and_what_is_shadowed(self):
        self.own("mine", "nod", OTHER)
        self.own_robot("mine/robots", "abb_irb120")
        lines = self.armature("list", "--path", "mine").stdout.splitlines()
        self.assertEqual(lines[0], "scenarios in mine (--path)")
        self.assertRegex(lines[1], rf"^{OTHER} +vo2021_6r +0\.03 s  mine: ")
        self.assertRegex(lines[2], r"^nod +vo2021_6r ")
        self.assertEqual(lines[3:5], ["", "robots in mine/robots (--path)"])
        self.assertIn(f"scenarios in {SCENARIOS} (checkout of the program)", lines)
        self.assertIn(f"{OTHER:<24} shadowed by mine/{OTHER}/scenario.toml", lines)
        self.assertIn(f"{'abb_irb120':<24} shadowed by mine/robots/abb_irb120.toml", lines)

    def test_a_folder_that_is_named_twice_is_searched_once(self):
        self.own("scenarios", "nod")
        listing = self.armature("list", "--path", self.folder / "scenarios", ARMATURE_PATH="scenarios").stdout
        self.assertEqual(len(re.findall(r"(?m)^nod ", listing)), 1)
        self.assertNotIn("shadowed", listing)

    def test_a_named_folder_that_is_missing_is_an_error(self):
        self.assertEqual(self.armature("list", "--path", "nope", code=2).stderr, "--path: no such folder: nope\n")
        self.own("mine", "nod")
        self.assertEqual(
            self.armature("run", "nod", ARMATURE_PATH="mine:/no/where", code=2).stderr,
            "ARMATURE_PATH: no such folder: /no/where\n",
        )
        self.assertEqual(
            self.armature("fk", "--path", "nope", "--robot", "abb_irb120", 0, code=2).stderr,
            "--path: no such folder: nope\n",
        )

    def test_a_program_without_data_says_where_it_searched(self):
        program = self.lone_program()
        error = self.armature("list", program=program, code=2).stderr
        for text in (f"'scenarios' in {self.folder} and above", "share/armature/scenarios", "--path", "ARMATURE_PATH"):
            self.assertIn(text, error)
        self.assertIn(str(self.folder), self.armature("check", program=program, code=2).stderr)
        self.assertIn(str(self.folder), self.armature("fk", "--robot", "x", 0, program=program, code=2).stderr)
        self.own("mine", "nod")
        error = self.armature("run", "nodd", "--path", "mine", program=program, code=2).stderr
        self.assertIn(f"nodd: no such scenario, did you mean nod? (searched: mine, 'scenarios' in {self.folder}", error)
        self.assertIn(
            "nothing in mine/nod (--path)", self.armature("list", "--path", "mine/nod", program=program, code=2).stdout
        )

    def test_check_takes_a_folder_of_scenarios(self):
        self.own("mine", "nod", "bow")
        done = self.armature("check", "mine")
        self.assertEqual(re.findall(r"PASS  (\w+)", done.stdout), ["bow", "nod"])
        self.assertIn("PASS  nod", self.armature("check", "mine/nod").stdout)
        (self.folder / "empty").mkdir()
        self.assertEqual(self.armature("check", "empty", code=2).stderr, "empty: this folder has no scenario.toml\n")

    def test_check_without_names_takes_all_of_the_users_folders(self):
        self.own("scenarios", "nod", "bow")
        self.own("more", "wave", "nod")
        done = self.armature("check", ARMATURE_PATH="more")
        self.assertEqual(re.findall(r"PASS  (\w+)", done.stdout), ["nod", "wave", "bow"])


class Words(Program):
    def test_the_version_is_printed(self):
        version = re.search(r"project\(armature VERSION (\S+)", (ROOT / "CMakeLists.txt").read_text()).group(1)
        self.assertEqual(self.armature("--version").stdout, f"armature {version}\n")

    def test_a_mistyped_command_or_option_gets_a_suggestion(self):
        cases = [
            (("chekc",), "armature: unknown command 'chekc', did you mean check?"),
            (("--path", ".", "lst"), "armature: unknown command 'lst', did you mean list?"),
            (("wallpaper",), "armature: unknown command 'wallpaper'; 'armature --help' lists the commands"),
            (("run", TINY.name, "--otu", "x"), "armature run: unknown option '--otu', did you mean --out?"),
            (
                ("run", TINY.name, "--varient=paper"),
                "armature run: unknown option '--varient', did you mean --variant?",
            ),
            (("fk", "--robt", "abb_irb120", 0), "armature fk: unknown option '--robt', did you mean --robot?"),
            (("list", "--pth", "."), "armature list: unknown option '--pth', did you mean --path?"),
            (("--vresion",), "armature: unknown option '--vresion', did you mean --version?"),
            (
                ("info", "--colour"),
                "armature info: unknown option '--colour'; 'armature info --help' lists the options",
            ),
        ]
        for arguments, message in cases:
            with self.subTest(message):
                self.assertEqual(self.armature(*arguments, code=2).stderr, message + "\n")


if __name__ == "__main__":
    main()
