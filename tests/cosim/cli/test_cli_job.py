"""armature job: diagnostics of robot programs, and what it prints of them."""

import subprocess

from cli_program import Program, main

HEAD = "/JOB\n//NAME {}\n//POS\n///NPOS 0,0,0,0,0,0\n//INST\nNOP\n"


class Job(Program):
    def job(self, name, instructions, end="\n"):
        file = self.folder / f"{name.lower()}.jbi"
        text = HEAD.format(name) + instructions + "END\n"
        file.write_bytes(text.replace("\n", end).encode("latin-1"))
        return file

    def test_check_reports_all_errors_of_all_files_with_line_and_column(self):
        a = self.job("A", "MOVJ C00001\nDOUT OT#(1)\n")
        b = self.job("B", "JUMP *NONE\n")
        done = self.armature("job", "check", a, b, code=2)
        self.assertEqual(
            done.stderr,
            f"{a}:8:12: expected a value\n{a}:7:6: the job has no position C1\n{b}:7:6: no label *NONE in this job\n",
        )
        self.assertEqual(done.stdout, "")

    def test_check_wants_the_files_of_all_jobs_that_are_called(self):
        a, b = self.job("A", "CALL JOB:B\n"), self.job("B", "RET\n")
        self.assertEqual(self.armature("job", "check", b, a).stdout, "2 jobs, 6 instructions, 0 positions\n")
        self.assertEqual(self.armature("job", "check", a, code=2).stderr, f"{a}:7:6: no job named B is loaded\n")

    def test_a_file_without_an_action_is_checked(self):
        a = self.job("A", "MOVJ C00001\n")
        self.assertEqual(self.armature("job", a, code=2).stderr, self.armature("job", "check", a, code=2).stderr)

    def test_a_move_of_a_station_is_told_as_such(self):
        a = self.job("A", "+MOVJ EC00001 VJ=1.00\n")
        error = self.armature("job", "check", a, code=2).stderr
        self.assertEqual(error, f"{a}:7:1: '+' moves a station, and stations are not supported\n")

    def test_check_prints_warnings_and_succeeds(self):
        a = self.job("A", "'\xe9\n")
        a.write_bytes(a.read_bytes().replace(b"//INST", b"///NEW 1\n//INST"))
        done = self.armature("job", "check", a)
        self.assertEqual(done.stderr, f"{a}:5:1: warning: unknown line 'NEW' is kept and has no effect\n")

    def test_print_is_equal_to_the_file_but_for_line_ends(self):
        instructions = "'A  comment\n\t SET B000  5 \nTIMER T=0.050\n"
        for end in "\n", "\r\n", "\r":
            a = self.job("A", instructions, end)
            done = subprocess.run([self.path, "job", "print", a], capture_output=True, check=True)
            self.assertEqual(done.stdout, (HEAD.format("A") + instructions + "END\n").replace("\n", "\r\n").encode())

    def test_list_shows_the_records(self):
        lines = self.armature("job", "list", self.job("A", "*L\nJUMP *L\n")).stdout.splitlines()
        self.assertEqual(lines[0].split(), ["record", "line", "operation", "flags", "target", "partner", "operands"])
        self.assertEqual(lines[3].split(), ["2", "8", "JUMP", "1", "-", "|", "*L"])

    def test_check_warns_of_what_will_be_an_alarm(self):
        file = self.job("A", "DOUT OT#(1) ON\nARCON ASF#(1)\nMACRO1 MJ#(2)\n")
        done = self.armature("job", "check", file)
        self.assertIn("1 jobs, 5 instructions", done.stdout)
        self.assertIn(f"{file}:8:1: warning: ARCON: not supported without its output in [job]; ", done.stderr)
        self.assertEqual(done.stderr.count("when executed, it is an alarm\n"), 2)

    def test_instructions_shows_the_table(self):
        self.assertRegex(
            self.armature("job", "instructions").stdout, r"(?m)^MOVJ +mt\?y +VJ= PL= ACC= DEC= +moves all joints;"
        )

    def test_needs_a_file_and_a_known_action(self):
        self.assertIn("A file to check is required", self.armature("job", "check", code=2).stderr)
        self.assertIn("destroy", self.armature("job", "destroy", "a.jbi", code=2).stderr)
        self.assertIn("nowhere.jbi", self.armature("job", "check", "nowhere.jbi", code=2).stderr)


if __name__ == "__main__":
    main()
