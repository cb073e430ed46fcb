"""armature fk and armature ik."""

import csv
import json
import re
import tomllib
from random import Random

from cli_program import SCENARIOS, Program, main


class Kinematics(Program):
    MATRIX = ",".join(f"t{row}{column}" for row in (1, 2, 3) for column in (1, 2, 3, 4))

    @staticmethod
    def robots():
        """Name, number of joints and limits of every robot with kinematics."""
        for path in sorted((SCENARIOS / "robots").glob("*.toml")):
            robot = tomllib.loads(path.read_text())
            if "kinematics" in robot:
                limits = [{**robot["defaults"], **axis} for axis in robot["axis"]]
                yield path.stem, [(axis["min_deg"], axis["max_deg"]) for axis in limits]

    def joints_header(self, joints, before="j"):
        return ",".join(f"{before}{i + 1}_deg" for i in range(joints))

    def test_a_pose_without_its_options_is_told_how_to_give_it(self):
        done = self.armature("ik", "--robot", "abb_irb120", 900, 0, -900, 0, 0, 0, code=2)
        self.assertEqual(
            done.stderr,
            "armature ik: unexpected '900'; give a pose with --xyz X Y Z and --rpy ROLL PITCH YAW\n",
        )

    def test_joints_to_poses_to_joints_and_back(self):
        random = Random(2021)
        for robot, limits in self.robots():
            with self.subTest(robot):
                joints = [[random.uniform(*limit) for limit in limits] for _ in range(50)]
                self.text(
                    "j.csv", "\n".join([self.joints_header(len(limits)), *(",".join(map(repr, row)) for row in joints)])
                )
                self.armature("fk", "--robot", robot, "--in", "j.csv", "--out", "poses.csv")
                poses = (self.folder / "poses.csv").read_text().splitlines()
                self.assertEqual(poses[0], self.MATRIX)
                self.assertEqual(len(poses), 51)
                with_previous = [poses[0] + "," + self.joints_header(len(limits), "prev")]
                with_previous += [f"{pose},{','.join(map(repr, row))}" for pose, row in zip(poses[1:], joints)]
                self.text("poses.csv", "\n".join(with_previous))
                self.armature("ik", "--robot", robot, "--in", "poses.csv", "--out", "solutions.csv")
                solutions = self.rows("solutions.csv")
                self.assertEqual(
                    list(solutions[0]),
                    "pose branch shoulder elbow flip singular within_limits selected".split()
                    + self.joints_header(len(limits)).split(","),
                )
                selected = [row for row in solutions if row["selected"] == "1"]
                self.assertEqual([int(row["pose"]) for row in selected], list(range(50)))
                for row, expected in zip(selected, joints):
                    for i, angle in enumerate(expected):
                        self.assertAlmostEqual(float(row[f"j{i + 1}_deg"]), angle, delta=1e-5)
                # Every branch is a way to the same pose, to the last digits.
                self.text(
                    "j.csv",
                    "\n".join(
                        [
                            self.joints_header(len(limits)),
                            *(",".join(row[f"j{i + 1}_deg"] for i in range(len(limits))) for row in solutions),
                        ]
                    ),
                )
                self.armature("fk", "--robot", robot, "--in", "j.csv", "--out", "again.csv")
                for row, again in zip(solutions, (self.folder / "again.csv").read_text().splitlines()[1:]):
                    for a, b in zip(again.split(","), poses[1 + int(row["pose"])].split(",")):
                        self.assertAlmostEqual(float(a), float(b), delta=1e-10)

    # At all joints 0 the flange of the IRB 120 is at (374, 0, 630) mm, and its z axis is the x axis of the base. So a tool
    # of 100 mm ends at (474, 0, 630). Seen from a frame at (100, 200, 0), turned by 90 degrees about z, x is what was y:
    # (0 - 200, -(474 - 100), 630).
    TOOL = ("--tool", 0, 0, 100, 0, 0, 0)
    FRAME = ("--frame", 100, 200, 0, 0, 0, 90)

    def test_tool_and_frame_of_a_single_pose(self):
        zero = ("fk", "--robot", "abb_irb120", 0, 0, 0, 0, 0, 0)
        cases = [
            ((), "flange of abb_irb120 in its base", "374.000000 0.000000 630.000000"),
            (self.TOOL, "tool of abb_irb120 in its base", "474.000000 0.000000 630.000000"),
            (self.FRAME, "flange of abb_irb120 in the user frame", "-200.000000 -274.000000 630.000000"),
            ((*self.TOOL, *self.FRAME), "tool of abb_irb120 in the user frame", "-200.000000 -374.000000 630.000000"),
        ]
        for options, title, position in cases:
            with self.subTest(title):
                lines = self.armature(*zero, *options).stdout.splitlines()
                self.assertEqual(lines[0], title)
                self.assertEqual(lines[1].split()[2:], position.split())
        # The flange's x axis is -z of the base, its y axis y of the base, its z axis x of the base: rpy 0 90 0. In the
        # frame: x is -z, y is x, z is -y.
        rotation = [
            line.split()[-3:] for line in self.armature(*zero, *self.TOOL, *self.FRAME).stdout.splitlines()[2:5]
        ]
        self.assertEqual([[float(x) for x in row] for row in rotation], [[0, 1, 0], [0, 0, -1], [-1, 0, 0]])

        pose = ("--xyz", -200, -374, 630, "--rpy", 0, 90, -90)
        found = self.armature("ik", "--robot", "abb_irb120", *pose, *self.TOOL, *self.FRAME).stdout
        self.assertTrue(found.startswith("tool of abb_irb120: "), found)
        selected = next(line for line in found.splitlines() if "SELECTED" in line)
        for angle in re.findall(r"-?\d+\.\d{9}", selected):
            self.assertAlmostEqual(float(angle), 0, delta=1e-6)

        # The joints may follow the option.
        self.assertEqual(
            self.armature("fk", "--robot", "abb_irb120", *self.TOOL, 0, 0, 0, 0, 0, 0).stdout,
            self.armature(*zero, *self.TOOL).stdout,
        )

    def test_tool_and_frame_of_files(self):
        self.text("j.csv", self.joints_header(6) + "\n0,0,0,0,0,0\n10,20,-30,40,50,60\n")
        options = ("--robot", "abb_irb120", *self.TOOL, *self.FRAME)
        self.armature("fk", *options, "--in", "j.csv", "--out", "poses.csv")
        lines = (self.folder / "poses.csv").read_text().splitlines()
        expected = (0, 1, 0, -200, 0, 0, -1, -374, -1, 0, 0, 630)
        for value, wanted in zip(lines[1].split(","), expected, strict=True):
            self.assertAlmostEqual(float(value), wanted, delta=1e-9)
        previous = [
            lines[0] + "," + self.joints_header(6, "prev"),
            lines[1] + ",0" * 6,
            lines[2] + ",10,20,-30,40,50,60",
        ]
        self.text("poses.csv", "\n".join(previous))
        self.armature("ik", *options, "--in", "poses.csv", "--out", "solutions.csv")
        selected = [row for row in self.rows("solutions.csv") if row["selected"] == "1"]
        for row, joints in zip(selected, ((0,) * 6, (10, 20, -30, 40, 50, 60)), strict=True):
            for i, angle in enumerate(joints):
                self.assertAlmostEqual(float(row[f"j{i + 1}_deg"]), angle, delta=1e-6)

    def test_a_pose_that_the_frame_shifts_beyond_the_largest_position_is_a_row_with_the_reason(self):
        self.text("p.csv", self.MATRIX + "\n1,0,0,1e9,0,1,0,0,0,0,1,0\n")
        frame = ("--frame", 1000, 0, 0, 0, 0, 0)
        lines = self.armature("ik", "--robot", "abb_irb120", "--in", "p.csv", *frame).stdout.splitlines()
        self.assertRegex(lines[1], r"^0,none,not a rigid pose within 1000000000 mm of the base,{11}$")

    def test_branches_are_numbered_in_their_order(self):
        self.text("p.csv", self.MATRIX + "\n0,0,1,350,0,-1,0,-120,1,0,0,500\n")
        rows = csv.DictReader(self.armature("ik", "--robot", "abb_irb120", "--in", "p.csv").stdout.splitlines())
        flags = [(row["branch"], row["shoulder"], row["elbow"], row["flip"]) for row in rows]
        signs = ("1", "-1")
        self.assertEqual(
            flags,
            [(str(4 * s + 2 * e + f), signs[s], signs[e], signs[f]) for s in (0, 1) for e in (0, 1) for f in (0, 1)],
        )

    def test_a_pose_that_cannot_be_reached_is_a_row_with_the_reason(self):
        self.text("p.csv", self.MATRIX + "\n1,0,0,2000,0,1,0,0,0,0,1,0\n0,0,1,350,0,-1,0,-120,1,0,0,500\n")
        lines = self.armature("ik", "--robot", "abb_irb120", "--in", "p.csv").stdout.splitlines()
        self.assertRegex(lines[1], r"^0,none,unreachable by \d+\.\d{6} mm,{11}$")
        self.assertTrue(lines[2].startswith("1,0,1,1,1,"))
        self.text("q.csv", self.MATRIX + "\n0,0,1,100,0,1,0,50,-1,0,0,100\n")
        lines = self.armature("ik", "--robot", "hu2012_5r", "--in", "q.csv").stdout.splitlines()
        self.assertRegex(lines[1], r"^0,none,orientation off by \d+\.\d{6} deg,{10}$")

    def test_a_pose_outside_the_limits_has_its_branches_and_no_choice(self):
        # Straight behind the robot, lower than the shoulder: joint 1 stops at 165 degrees.
        self.text("p.csv", self.MATRIX + "\n0,0,1,-300,0,-1,0,0,1,0,0,60\n")
        rows = list(csv.DictReader(self.armature("ik", "--robot", "abb_irb120", "--in", "p.csv").stdout.splitlines()))
        self.assertEqual(len(rows), 8)
        self.assertEqual({row["within_limits"] for row in rows}, {"0"})
        self.assertEqual({row["selected"] for row in rows}, {"0"})

    def test_bad_input_names_the_place_and_writes_nothing(self):
        good = self.MATRIX + "\n1,0,0,0,0,1,0,0,0,0,1,0\n"
        cases = [
            ("fk", "j1_deg,j2_deg\n", 'in.csv:1:14: header: expected "j3_deg"'),
            (
                "fk",
                self.joints_header(6) + "\n1,2,3,4,5,six\n1,2,3,4,5,nan\n",
                "in.csv:3:11: j6_deg: expected a number",
            ),
            ("fk", "", "in.csv: is empty"),
            ("ik", good + "1,0,0,0,0,1,0,0,0,0,-1,0\n", "in.csv:3:1: expected a rotation"),
            ("ik", good + "1,0,0,0,0,1,0,0,0,0,1\n", "in.csv:3:22: expected 12 values as in the header, found 11"),
            ("ik", good.replace("t34", "t34,prev1_deg"), 'expected "prev2_deg"'),
        ]
        for command, text, expected in cases:
            with self.subTest(expected):
                self.text("in.csv", text)
                self.text("out.csv", "kept")
                done = self.armature(command, "--robot", "abb_irb120", "--in", "in.csv", "--out", "out.csv", code=2)
                self.assertIn(expected, done.stderr)
                self.assertEqual((self.folder / "out.csv").read_text(), "kept")
                self.assertEqual(done.stdout, "")

    def test_bad_arguments_are_refused(self):
        pose = ("--xyz", 350, -120, 500, "--rpy", 30, 120, -10)
        cases = [
            (("fk", "--robot", "abb_irb12", 0, 0, 0, 0, 0, 0), "did you mean abb_irb120"),
            (("fk", "--robot", "nowhere/x.toml", 0, 0, 0, 0, 0, 0), "nowhere/x.toml: cannot open"),
            (("fk", "--robot", "hu2012_5r", 0, 0, 0, 0, 0, 0), "expected 5 numbers, found 6"),
            (("fk", "--robot", "abb_irb120", 0, 0, 0, 0, 0, "nan"), 'found "nan"'),
            (("fk", "--robot", "abb_irb120"), "--in"),
            (("fk", "--robot", "abb_irb120", 0, 0, 0, 0, 0, 0, "--out", "x"), "--in"),
            (("ik", "--robot", "abb_irb120"), "--xyz"),
            (("ik", "--robot", "abb_irb120", "--xyz", 1, 2, 3), "--rpy"),
            (("ik", "--robot", "abb_irb120", *pose, "--previous", 1, 2, 3), "expected 6 numbers, found 3"),
            (("ik", "--robot", "abb_irb120", *pose, "--in", "p.csv"), "--in"),
            (("ik", "--robot", "abb_irb120", "--in", "p.csv", "--previous", 1, 2, 3, 4, 5, 6), "columns prev1_deg"),
            (("ik", "--robot", "abb_irb120", "--previous", 1, 2, 3, 4, 5, 6), "--xyz"),
            (
                ("fk", "--robot", "abb_irb120", "--in", "j.csv", "--previous", 1, 2, 3, 4, 5, 6),
                "belongs to 'armature ik'",
            ),
            (("ik", "--robot", "abb_irb120", "--in", "no.csv"), "no.csv: cannot open"),
            (("ik", "--robot", "abb_irb120", *pose, "--tool", 0, 0, 100), "--tool"),
            (
                ("ik", "--robot", "abb_irb120", *pose, "--tool", 0, 0, "long", 0, 0, 0),
                '--tool (mm): expected a number from -100000 to 100000, found "long"',
            ),
            (("ik", "--robot", "abb_irb120", *pose, "--on", "nios"), "--on: nios not in {host,a9,cordic}"),
            (
                ("ik", "--robot", "abb_irb120", *pose, "--on", "a9"),
                "expected host or cordic, or the program armature-iss",
            ),
            (("ik", "--robot", "abb_irb120", "--in", "p.csv", "--on", "cordic"), "--on"),
            (("fk", "--robot", "abb_irb120", *[0] * 6, "--frame", 0, 0, 0, 0, 0, 36001), "--frame (deg): expected"),
            (("fk", "--robot", "abb_irb120", "--tool", *[0] * 11), "expected 6 numbers, found 5"),
        ]
        for arguments, expected in cases:
            with self.subTest(arguments):
                self.assertIn(expected, self.armature(*arguments, code=2).stderr)

    def test_a_robot_without_kinematics_has_no_poses(self):
        text = (SCENARIOS / "robots/vo2021_6r.toml").read_text()
        self.text(
            "plain.toml", re.sub(r"(?s)\[kinematics\].*?(?=\[defaults\])", "", text).replace("vo2021_6r", "plain")
        )
        self.assertIn(
            "plain.toml: has no [kinematics]",
            self.armature("fk", "--robot", "plain.toml", 0, 0, 0, 0, 0, 0, code=2).stderr,
        )

    def test_one_pose_of_fk_is_the_argument_of_ik(self):
        pose = self.armature("fk", "--robot", "abb_irb120", 10, 20, -30, 40, 50, 60).stdout
        numbers = lambda label: re.search(rf"{label} +(\S+) +(\S+) +(\S+)", pose).groups()
        found = self.armature(
            "ik",
            "--robot",
            "abb_irb120",
            "--xyz",
            *numbers("position mm"),
            "--rpy",
            *numbers("roll pitch yaw deg"),
            "--previous",
            10,
            20,
            -30,
            40,
            50,
            60,
        ).stdout
        selected = [line for line in found.splitlines() if "SELECTED" in line]
        self.assertEqual(len(selected), 1)
        angles = [float(x) for x in re.findall(r"-?\d+\.\d{9}", selected[0])]
        for angle, expected in zip(angles, (10, 20, -30, 40, 50, 60), strict=True):
            self.assertAlmostEqual(angle, expected, delta=1e-4)
        self.assertIn("outside limits", self.armature("fk", "--robot", "abb_irb120", 0, 0, 71, 0, 0, 0).stdout)

    def test_a_single_pose_that_cannot_be_taken_is_exit_code_1(self):
        far = self.armature("ik", "--robot", "abb_irb120", "--xyz", 2000, 0, 0, "--rpy", 0, 0, 0, code=1)
        self.assertRegex(far.stdout, r"no solution, unreachable by \d+\.\d+ mm")
        behind = self.armature("ik", "--robot", "abb_irb120", "--xyz", -300, 0, 60, "--rpy", 90, 0, 90, code=1)
        self.assertRegex(behind.stdout, r"none of them inside the limits")
        self.assertRegex(behind.stdout, r"joint 1 is outside -165 \.\. 165")

    def test_fk_and_ik_name_the_configuration_in_the_words_of_the_keys(self):
        shown = self.armature("fk", "--robot", "abb_irb120", 10, 20, -30, 0, 45, 200).stdout
        self.assertIn("shoulder front, elbow up, wrist noflip, turns 0 0 0 0 0 1", shown)
        found = self.armature("ik", "--robot", "abb_irb120", "--xyz", 350, -120, 500, "--rpy", 30, 120, -10).stdout
        sides = [line.split()[1:4] for line in found.splitlines()[2:]]
        expected = [
            [shoulder, elbow, wrist]
            for shoulder, elbows in (("front", ("up", "down")), ("back", ("down", "up")))
            for elbow in elbows
            for wrist in ("flip", "noflip")
        ]
        self.assertEqual(sides, expected)
        five = self.armature("fk", "--robot", "hu2012_5r", 0, -90, 0, -90, 0).stdout
        self.assertIn("elbow either, turns", five, "stretched, and without a wrist that flips")

    def test_the_pose_of_figure_2_of_hu_is_one_double_root(self):
        found = self.armature("ik", "--robot", "hu2012_5r", "--xyz", -21, 0, 340, "--rpy", 0, 0, 180).stdout
        self.assertEqual(found.count("singular: elbow"), 2)
        for line in found.splitlines()[2:]:
            angles = [float(x) for x in re.findall(r"-?\d+\.\d{9}", line)]
            for angle, expected in zip(angles, (0, -90, 0, -90, 0), strict=True):
                self.assertAlmostEqual(angle, expected, delta=1e-5)

    def test_a_pose_is_solved_by_the_block_of_the_chip(self):
        pose = ("ik", "--robot", "abb_irb120", "--xyz", 350, -120, 500, "--rpy", 30, 120, -10)
        host = self.armature(*pose).stdout.splitlines()
        self.assertEqual(self.armature(*pose, "--on", "host").stdout.splitlines(), host)
        chip = self.armature(*pose, "--on", "cordic").stdout.splitlines()
        self.assertEqual(len(chip), len(host) + 2)
        numbers = re.compile(r"-?\d+\.\d{9}")
        for by_host, by_chip in zip(host[2:], chip[2:-2], strict=True):
            self.assertEqual(numbers.sub("", by_host).split(), numbers.sub("", by_chip).split())
            self.assertNotEqual(by_host, by_chip, "the block has fewer digits")
            for one, other in zip(numbers.findall(by_host), numbers.findall(by_chip), strict=True):
                self.assertAlmostEqual(float(one), float(other), delta=0.06 * 7.2e-4)
        self.assertRegex(chip[-2], r"^by ik_cordic of the chip: 1241 clocks \(24\.82 us\), \d+ with the bus \(")
        off = re.fullmatch(r"largest difference from the host: (\d\.\d{4}) pulses, joint \d of branch \d", chip[-1])
        self.assertTrue(0 < float(off[1]) < 0.06, chip[-1])
        result = json.loads(self.armature(*pose, "--on", "cordic", "--json").stdout)
        self.assertEqual((result["block_clocks"], result["other_branches"], len(result["branches"])), (1241, 0, 8))
        self.assertGreater(result["clocks"], 1241)

    def test_the_block_of_the_chip_says_when_it_has_no_branch(self):
        far = ("ik", "--robot", "abb_irb120", "--rpy", 0, 0, 0, "--on", "cordic", "--xyz")
        found = self.armature(*far, 2000, 0, 0, code=1).stdout.splitlines()
        self.assertRegex(found[0], "unreachable by 14")
        self.assertRegex(found[1], "^by ik_cordic of the chip: 233 clocks")
        found = self.armature(*far, 90000, 0, 0, code=1).stdout.splitlines()
        self.assertEqual(found[1], "by the host: the pose does not reach ik_cordic")

    def test_the_block_of_the_chip_solves_five_axes(self):
        shown = self.armature("fk", "--robot", "hu2012_5r", 10, -60, 50, -80, 20).stdout
        xyz, rpy = (re.search(rf"{name} +([-0-9. ]+)", shown)[1].split() for name in ("position mm", "yaw deg"))
        found = self.armature("ik", "--robot", "hu2012_5r", "--xyz", *xyz, "--rpy", *rpy, "--on", "cordic").stdout
        self.assertRegex(found, r"(?m)^by ik_cordic of the chip: (505|701) clocks")
        off = re.search(r"largest difference from the host: (\d\.\d{4}) pulses", found)
        self.assertLess(float(off[1]), 0.03)

    def test_output_that_cannot_be_written_is_no_success(self):
        self.text("j.csv", self.joints_header(6) + "\n1,2,3,4,5,6\n")
        self.assertIn(
            "/dev/full",
            self.armature("fk", "--robot", "abb_irb120", "--in", "j.csv", "--out", "/dev/full", code=2).stderr,
        )


if __name__ == "__main__":
    main()
