"""--json, --quiet and colours: what programs read and what people see."""

import json
import os
import pty
import subprocess

from cli_program import BRIEF, SCENARIOS, TINY, Program, main


class Json(Program):
    def json(self, *arguments, **how):
        return json.loads(self.armature(*arguments, "--json", **how).stdout)

    def failing(self):
        scenario = self.copy_of(self.brief())
        self.edit(scenario / "scenario.toml", "underruns = 0", "underruns = 7")
        return scenario

    def test_run_prints_its_summary(self):
        printed = self.json("run", TINY, *BRIEF, "--out", "x")
        self.assertEqual(printed, json.loads((self.folder / "x/summary.json").read_text()))
        self.assertFalse(self.json("run", self.failing(), "--out", "x", code=1)["result"]["passed"])

    def test_check_prints_every_verdict(self):
        document = self.json("check", self.brief(), self.failing(), code=1)
        self.assertEqual([document[key] for key in ("passed", "failed", "not_run")], [1, 1, 0])
        passed, failed = document["scenarios"]
        self.assertEqual((passed["scenario"], passed["passed"], passed["failure"]), (TINY.name, True, ""))
        self.assertFalse(failed["passed"])
        self.assertIn("expect.underruns: expected 7, got 0", failed["failure"])
        self.assertIn("to see it: armature run ", failed["failure"])

    def test_compare_prints_the_first_difference(self):
        self.armature("run", TINY, *BRIEF, "--out", "x")
        text = (self.folder / "x/trace.csv").read_text()
        lines = text.splitlines()
        column = lines[0].split(",").index("j2_enc_counts")
        cells = lines[30].split(",")
        cells[column] = str(int(cells[column]) + 3)
        self.text("b.csv", "\n".join([*lines[:30], ",".join(cells), *lines[31:]]) + "\n")
        equal = self.json("compare", "x/trace.csv", "x/trace.csv")
        self.assertEqual((equal["equal"], equal["rows"], equal["first"]), (True, len(lines) - 1, None))
        document = self.json("compare", "x/trace.csv", "b.csv", code=1)
        self.assertEqual((document["equal"], document["rows_differ"]), (False, 1))
        first = document["first"]
        self.assertEqual((first["tick"], first["column"]), (29 * 20, "j2_enc_counts"))
        self.assertEqual(int(first["b"]) - int(first["a"]), 3)
        self.assertEqual([(c["column"], c["largest"]) for c in document["columns"]], [("j2_enc_counts", 3)])

    def test_list_and_info_describe_what_there_is(self):
        folders = self.json("list", "--path", SCENARIOS)["folders"]
        scenarios = {entry["name"]: entry for entry in folders[0]["scenarios"]}
        self.assertEqual(scenarios.keys(), {path.parent.name for path in SCENARIOS.glob("*/scenario.toml")})
        self.assertEqual(scenarios["fig9_joint_move"]["robot"], "vo2021_6r")
        self.assertEqual(scenarios["fig9_joint_move"]["duration_s"], 1)
        robots = {entry["name"]: entry["axes"] for entry in folders[0]["robots"]}
        self.assertEqual((robots["hu2012_5r"], robots["vo2021_6r"]), (5, 6))
        info = self.json("info")
        self.assertEqual((info["clock_hz"], info["tick_cycles"]), (50_000_000, 2500))
        self.assertEqual({block["name"]: block["base"] for block in info["blocks"]}["axi_timer"], 0x4280_0000)

    def test_a_file_that_cannot_be_read_is_listed_with_its_error(self):
        (self.folder / "mine/bad").mkdir(parents=True)
        self.text("mine/bad/scenario.toml", "x = 1\n")
        folders = self.json("list", "--path", "mine", code=2)["folders"]
        self.assertIn("mine/bad/scenario.toml:1:1: x: ", folders[0]["scenarios"][0]["error"])

    def test_kinematics_go_there_and_back(self):
        joints = [10, 20, -30, 0, 45, 90]
        pose = self.json("fk", "--robot", "abb_irb120", *joints)
        place = ["--xyz", *pose["position_mm"], "--rpy", *pose["rpy_deg"]]
        solutions = self.json("ik", "--robot", "abb_irb120", *place, "--previous", *joints)
        selected = solutions["branches"][solutions["selected"]]
        for found, given in zip(selected["joints_deg"], joints):
            self.assertAlmostEqual(found, given, places=6)
        sides = {key: selected[key] for key in pose["configuration"]}
        self.assertEqual(sides, pose["configuration"])
        nothing = self.json("ik", "--robot", "abb_irb120", "--xyz", 5000, 0, 0, "--rpy", 0, 0, 0, code=1)
        self.assertEqual((nothing["selected"], nothing["branches"]), (None, []))

    def test_quiet_commands_print_only_what_failed(self):
        mine = self.copy_of(self.brief())
        for command in (["run", mine], ["check", mine], ["bless", mine]):
            done = self.armature(*command, "--quiet")
            self.assertEqual((done.stdout, done.stderr), ("", ""), command)
        self.assertEqual(self.armature("compare", *[TINY / "golden.csv"] * 2, "-q").stdout, "")
        self.edit(mine / "scenario.toml", "underruns = 0", "underruns = 7")
        for command in ("run", "check"):
            self.assertIn("expect.underruns: expected 7", self.armature(command, mine, "--quiet", code=1).stdout)
        self.assertIn("--quiet", self.armature("run", TINY, "--quiet", "--json", code=2).stderr)

    def at_a_terminal(self, *arguments, **environment):
        """What the program prints when its standard output is a terminal."""
        terminal, end = pty.openpty()
        program = subprocess.Popen(
            [self.path, *map(str, arguments)],
            cwd=self.folder,
            stdout=end,
            stderr=subprocess.DEVNULL,
            env={**os.environ, "TERM": "xterm", "NO_COLOR": "", **environment},
        )
        os.close(end)
        printed = b""
        try:
            while part := os.read(terminal, 4096):
                printed += part
        except OSError:  # the program has ended
            pass
        os.close(terminal)
        program.wait()
        return printed.decode().replace("\r\n", "\n")

    def test_verdicts_have_colours_on_a_terminal_only(self):
        passing, failing = self.brief(), self.failing()
        for command, green, red in (("run", "PASSED", "FAILED"), ("check", "PASS", "FAIL")):
            self.assertIn(f"\x1b[32m{green}\x1b[0m ", self.at_a_terminal(command, passing))
            self.assertIn(f"\x1b[31m{red}\x1b[0m ", self.at_a_terminal(command, failing))
            self.assertNotIn("\x1b", self.armature(command, passing, TERM="xterm").stdout)
            self.assertNotIn("\x1b", self.at_a_terminal(command, passing, NO_COLOR="1"))
            self.assertNotIn("\x1b", self.at_a_terminal(command, passing, TERM="dumb"))


if __name__ == "__main__":
    main()
