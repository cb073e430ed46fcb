"""armature run with a program: when it begins and pauses, what it waits for, and when the run ends because of it."""

import json
import re

from cli_program import SCENARIOS, Program, main

HEAD = 'description = "d"\nrobot = "abb_irb120"\nprogram = "{name}"\n{keys}'
MOVE = '[[move]]\nat_s = 0.01\ntype = "joint"\ntarget_deg = [0, 0, 0, 0, 10, 0]\n'
JOB = "/JOB\n//NAME PART\n//POS\n///NPOS 0,0,0,0,0,0\n//INST\nNOP\n{}END\n"


class EndsOfPrograms(Program):
    longest_s = 60  # a run without duration_s would simulate 600 s if its program did not end it

    def run_it(self, program, keys="", tables=MOVE, name="part.ngc", code=0):
        (self.folder / "s").mkdir(exist_ok=True)
        (self.folder / "s" / name).write_text(program)
        (self.folder / "s/scenario.toml").write_text(HEAD.format(name=name, keys=keys) + tables)
        done = self.armature("run", "s", "--path", SCENARIOS, "--out", "out", code=code)
        if code != 2:
            self.log = (self.folder / "out/log.txt").read_text()
            self.result = json.loads((self.folder / "out/summary.json").read_text())["result"]
            self.seconds = self.result["cycles"] / 50e6
        return done

    def time_of(self, text):
        return float(re.search(rf"\[([0-9.]+) s\] {text}", self.log)[1])

    def test_it_begins_behind_the_moves_of_the_scenario_whatever_its_time_is(self):
        for keys in ("", "program_at_s = 0\n", "program_at_s = 0.01\n"):
            with self.subTest(keys):
                self.run_it("G21 F6000\nG91 G1 Z-1\nM2\n", "duration_s = 0.5\n" + keys)
                self.assertEqual([move["command"] for move in self.result["moves"]], ["move[0]", "line 2 of part.ngc"])
                self.assertGreater(self.time_of("line 1 of part.ngc interpreted"), 0.1)

    def test_a_run_without_duration_ends_with_its_program_and_the_script(self):
        self.run_it("G21 F6000\nG91 G1 Z-1\nM2\n")
        self.assertAlmostEqual(self.seconds, self.time_of("line 3 of part.ngc ended") + 0.1, delta=1e-4)
        self.run_it("G21\nM2\n", tables="[[input]]\nat_s = 0.3\npin = 1\nlevel = 1\n")
        self.assertAlmostEqual(self.seconds, 0.4, delta=1e-4)
        done = self.armature("list", "--path", self.folder, code=0)
        self.assertRegex(done.stdout, r"s +abb_irb120 +program  d")

    def test_its_duration_is_stated_in_messages_about_later_times(self):
        done = self.run_it("M2\n", tables="[[expect.output]]\nat_s = 700\npin = 1\nlevel = 1\n", code=2)
        self.assertIn("expected less than 600, the longest run without duration_s, found 700", done.stderr)
        done = self.run_it("M2\n", tables="[pendant]\n", code=2)
        self.assertIn("duration_s: missing, needed with [pendant]", done.stderr)

    def test_an_unexpected_end_ends_the_run(self):
        for program, end in (("G21 F6000\n(ABORT, no part)\n", "alarm"), ("G21\nM0\nM2\n", "paused")):
            with self.subTest(end):
                done = self.run_it(program, "duration_s = 3\n", tables="", code=1)
                self.assertLess(self.seconds, 0.2)
                self.assertIn("the run ends here: ", done.stdout)
                self.assertIn("the run ends here: ", self.log)
                self.run_it(program, "duration_s = 0.3\n", tables=f'[expect]\nprogram_end = "{end}"\n')
                self.assertEqual(self.seconds, 0.3)
                self.run_it(program, tables=f'[expect]\nprogram_end = "{end}"\n')
                self.assertLess(self.seconds, 0.2)
        self.assertIn("see program_resumes_after_s and [pendant]", done.stdout)

    def test_what_was_sent_before_an_alarm_is_executed_before_the_run_ends(self):
        self.run_it("G21 F600\nG91 G1 Z-5\nG4 P0.3\n(ABORT, stop)\n", "duration_s = 3\n", code=1)
        self.assertGreater(self.seconds, self.time_of("line 4 of part.ngc program is over") + 0.09)
        self.assertGreater(self.seconds, 0.9)
        self.assertEqual(self.result["moves_finished"], 3)

    def test_a_pause_ends_after_the_stated_time(self):
        for name, program in (("part.ngc", "G21\nM0\nM1\nM2\n"), ("part.jbi", JOB.format("PAUSE\nPAUSE\n"))):
            with self.subTest(name):
                self.run_it(program, "program_resumes_after_s = 0.05\n", tables="", name=name)
                times = re.findall(r"\[([0-9.]+) s\] .* (paused|resumed)", self.log)
                self.assertEqual([word for _, word in times], ["paused", "resumed"] * 2)
                for (paused, _), (resumed, _) in (times[:2], times[2:]):
                    self.assertAlmostEqual(float(resumed) - float(paused), 0.05, delta=2e-4)
        done = self.run_it("M2\n", "duration_s = 1\nprogram_resumes_after_s = 1\n", tables="[pendant]\n", code=2)
        self.assertIn("program_resumes_after_s: not allowed with [pendant]", done.stderr)

    def test_its_waits_are_in_the_log_and_accept_inputs(self):
        inputs = "".join(f"[[input]]\nat_s = {at_s}\npin = {pin}\nlevel = 1\n" for at_s, pin in ((0.05, 3), (0.06, 5)))
        for name, program, line in (
            ("part.ngc", "G21\nM66 P2 L3 Q1\nM2\n", 2),
            ("part.jbi", JOB.format("WAIT IN#(3)=ON\n"), 7),
        ):
            with self.subTest(name):
                done = self.run_it(program, tables=inputs, name=name)
                where = f"line {line} of {name}"
                self.assertIn(f"{where} waits for input 3\n", self.log)
                self.assertRegex(self.log, rf"\[0\.05\d+ s\] {where} waited for input 3\n")
                self.assertRegex(done.stdout, rf"pin 3 = 1 at .*: {where} accepted it after [0-9.]+ (us|ms)")
                self.assertRegex(done.stdout, r"pin 5 = 1 at .*: no move and no line of a program waited for it")
                self.assertEqual([one["accepted_by_line"] for one in self.result["inputs"]], [where, None])

    def test_a_wait_that_ends_with_its_time_accepts_no_input(self):
        inputs = "[[input]]\nat_s = 0.01\npin = 5\nlevel = 1\n"
        for name, program in (
            ("part.ngc", "G21\nM66 P2 L3 Q0.02\nM2\n"),
            ("part.jbi", JOB.format("WAIT IN#(3)=ON T=0.02\n")),
        ):
            with self.subTest(name):
                self.run_it(program, tables=inputs, name=name)
                self.assertIn("waited for input 3: its time is over\n", self.log)
                self.assertEqual(self.result["inputs"][0]["accepted_by_line"], None)


if __name__ == "__main__":
    main()
