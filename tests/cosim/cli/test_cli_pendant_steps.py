"""armature run with [pendant]: programs that the pendant sends, their breakpoints, and steps that fail."""

from cli_program import SCENARIOS, Program, main

SCENARIO = """description = "d"
robot = "abb_irb120"
duration_s = {duration_s}
{keys}
[pendant]
{line}
[[pendant.step]]
command = "servo"
parameter = 1
{steps}
"""
JOB = "/JOB\n//NAME PART\n//POS\n///NPOS 0,0,0,0,0,0\n//INST\nNOP\n{}END\n"


class PendantSteps(Program):
    def run_it(self, steps, duration_s=0.05, keys="", line="", code=0):
        text = SCENARIO.format(duration_s=duration_s, keys=keys, line=line, steps=steps)
        (self.folder / "s").mkdir(exist_ok=True)
        (self.folder / "s/scenario.toml").write_text(text)
        return self.armature("run", "s", "--path", SCENARIOS, "--out", "out", code=code)

    def program(self, name, text):
        (self.folder / "s").mkdir(exist_ok=True)
        (self.folder / "s" / name).write_text(text)

    def log(self):
        return (self.folder / "out/log.txt").read_text()

    def test_a_program_is_sent_and_its_lines_have_the_name_of_its_file(self):
        self.program("part.jbi", JOB.format('MSG "hello"\n'))
        steps = '[[pendant.step]]\ndo = "download"\nfile = "part.jbi"\n[[pendant.step]]\ncommand = "run"\n'
        done = self.run_it(steps + '[expect]\nfaults = ["drives_off"]\nprogram_messages = ["hello"]\n')
        self.assertRegex(done.stdout, r'program +line 7 of part.jbi message: "hello"')
        self.assertRegex(self.log(), r"pendant\.step\[1\] \(line 10\) download part\.jbi: ok \(0\) after \d+\.\d ms")

    def test_an_error_of_its_text_is_the_reply_with_its_line(self):
        self.program("part.jbi", JOB.format("INC B000\nMOVE C0\n"))
        step = '[[pendant.step]]\ndo = "download"\nfile = "part.jbi"\n'
        expect = '[expect]\nfaults = ["drives_off"]\n'
        done = self.run_it(step + expect, code=1)
        self.assertIn("(line 10) download part.jbi: the reply is `parse_error` (8), expected `ok`", done.stdout)
        self.run_it(step + 'reply = "parse_error"\n' + expect)

    def test_what_has_no_room_is_refused_before_it_is_sent(self):
        self.program("part.jbi", JOB.format("'" + "x" * 1000 + "\n") * 300)
        step = '[[pendant.step]]\ndo = "download"\nfile = "part.jbi"\nreply = "store_full"\nwithin_ms = 20\n'
        self.run_it(step + '[expect]\nfaults = ["drives_off"]\n')

    def test_a_line_that_loses_bytes_delays_a_program_but_does_not_change_it(self):
        self.program("part.ngc", "(MSG, " + "long " * 12 + ")\n" + "G21\n" * 40 + "M2\n")
        steps = '[[pendant.step]]\ndo = "download"\nfile = "part.ngc"\n[[pendant.step]]\ncommand = "run"\n'
        expect = f'[expect]\nfaults = ["drives_off"]\nprogram_end_line = 42\nprogram_messages = ["{"long " * 12}"]\n'
        times = []
        for percent in (0, 1):
            self.run_it(steps + expect, 0.2, line=f"lost_percent = {percent}\nflipped_percent = {percent}")
            times.append(float(self.log().partition("download part.ngc: ok (0) after ")[2].partition(" ms")[0]))
        self.assertLess(2 * times[0], times[1])

    def test_the_tables_of_programs_are_for_those_that_the_pendant_sends_too(self):
        self.program("part.ngc", "G21 F30000\nT7 M6\nG0 X5\nM3\nM0\nM2\n")
        steps = """[[pendant.step]]
do = "move"
joints_deg = [0, 0, 0, 0, 10, 0]
speed_percent = 100
[[pendant.step]]
do = "wait"
state = "ready"
within_ms = 900
[[pendant.step]]
do = "download"
file = "part.ngc"
[[pendant.step]]
command = "run"
[[frame]]
name = "cell"
xyz_mm = [369, 0, 617.497]
[gcode]
frame = "cell"
tools = [7]
spindle_pin = 3
[expect]
faults = ["drives_off"]
program_end = "paused"
final_outputs = [3]
final_tcp_mm = [{x_mm}, 0, 617.497]
tcp_tolerance_mm = 0.01
"""
        self.run_it(steps.format(x_mm=374), 0.28)
        done = self.run_it(steps.format(x_mm=373), 0.28, code=1)
        self.assertIn("final_tcp_mm", done.stdout)
        without = steps[: steps.index("[[frame]]")].replace("part.ngc", "part.jbi") + '[gcode]\nframe = "base"\n'
        self.program("part.jbi", JOB.format(""))
        self.assertIn("or a .ngc file that the pendant sends", self.run_it(without, code=2).stderr)

    def test_a_message_and_the_reason_of_an_alarm_are_read_over_a_line_that_loses_bytes(self):
        text = "turn the part, then press START."
        self.program("part.jbi", JOB.format(f'MSG "{text}"\nTIMER T=0.30\nSETUALM 8001 "no part"\n'))
        steps = '[[pendant.step]]\ndo = "download"\nfile = "part.jbi"\n[[pendant.step]]\ncommand = "run"\n'
        read = f'[[pendant.step]]\ndo = "read_message"\nmessage = "{text}"\nwithin_ms = 290\n'
        read += '[[pendant.step]]\ndo = "read_message"\nmessage = "SETUALM 8001: no part"\nkind = "alarm"\nwithin_ms = 600\n'
        expect = f'[expect]\nfaults = ["drives_off"]\nprogram_end = "alarm"\nprogram_messages = ["{text}"]\n'
        for percent in (0, 0.5):
            line = f"lost_percent = {percent}\nflipped_percent = {percent}"
            self.run_it(steps + read + expect, 0.8, line=line)
            self.assertIn(f'read_message {text}: message: "{text}" after ', self.log())
            self.assertIn("read_message SETUALM 8001: no part: alarm: SETUALM 8001: no part after ", self.log())

    def test_the_messages_of_gcode_are_read_too(self):
        longest = "64 characters are the most that a message of a program may have."
        self.program("part.ngc", f"G21\n(MSG, {longest})\nM0\nM2\n")
        steps = '[[pendant.step]]\ndo = "download"\nfile = "part.ngc"\n[[pendant.step]]\ncommand = "run"\n'
        steps += f'[[pendant.step]]\ndo = "read_message"\nmessage = "{longest}"\n'
        self.run_it(steps + '[expect]\nfaults = ["drives_off"]\nprogram_end = "paused"\n', 0.2)

    def test_a_message_that_does_not_come_fails_the_step(self):
        self.program("part.jbi", JOB.format('MSG "hello"\nPAUSE\n'))
        steps = '[[pendant.step]]\ndo = "download"\nfile = "part.jbi"\n[[pendant.step]]\ncommand = "run"\n'
        expect = '[expect]\nfaults = ["drives_off"]\nprogram_end = "paused"\n'
        step = '[[pendant.step]]\ndo = "read_message"\nwithin_ms = 40\n'
        self.run_it(steps + step + expect, 0.2)  # any text
        done = self.run_it(steps + step + 'message = "bye"\n' + expect, 0.2, code=1)
        self.assertIn('read_message bye: not complete within 40 ms: the controller has message: "hello"', done.stdout)
        done = self.run_it(steps + step + 'kind = "alarm"\n' + expect, 0.2, code=1)
        self.assertIn('not complete within 40 ms: the controller has message: "hello"', done.stdout)
        done = self.run_it(steps + step + f'message = "{"x" * 65}"\n', code=2)
        self.assertIn("pendant.step[3].message: expected at most 64 characters, found 65", done.stderr)

    def test_a_live_pendant_needs_no_step_that_names_a_file(self):
        keys = "[gcode]\nspindle_pin = 4\n[job]\narc_pin = 3\n"
        self.run_it(keys + '[expect]\nfaults = ["drives_off"]\n', duration_s=0.02)

    def test_the_table_job_is_for_a_program_that_the_pendant_sends(self):
        line = "NOP\nMOVJ C0 VJ=100.00\nMOVL C1 V=200.0\n"
        places = "///NPOS 2,0,0,0,0,0\n///POSTYPE ANGLE\n///ANGLE\nC0=0,0,0,0,10,0\nC1=1,0,0,0,10,0\n"
        self.program("part.jbi", f"/JOB\n//NAME PART\n//POS\n{places}//INST\n{line}END\n")
        steps = '[[pendant.step]]\ndo = "download"\nfile = "part.jbi"\n[[pendant.step]]\ncommand = "run"\n'
        expect = '[expect]\nfaults = ["drives_off"]\n'
        self.run_it(steps + expect, 0.38)
        slow = self.run_it(steps + "[job]\naccel_mm_s2 = 20\n" + expect, 0.38, code=1)
        self.assertIn("got running (line 12 of part.jbi)", slow.stdout)

    def test_a_program_that_fails_fails_the_run_although_the_pendant_sends_another_one_before(self):
        self.program("part.jbi", JOB.format(""))
        self.program("alarm.jbi", JOB.format("ABORT\n"))
        steps = "".join(f'[[pendant.step]]\ndo = "download"\nfile = "{name}.jbi"\n' for name in ("part", "alarm"))
        done = self.run_it(steps + '[[pendant.step]]\ncommand = "run"\n[expect]\nfaults = ["drives_off"]\n', code=1)
        self.assertIn("expect.program_end: expected ended, as it is not stated, got alarm", done.stdout)

    def test_files_that_cannot_be_sent_are_refused(self):
        for text, message in (
            (b"", "pendant.step[1].file: the file is empty: "),
            ("NOP\n'\u00e4\n".encode(), "part.jbi:2: holds a character that is not ASCII"),
            (b"x" * (1 << 20) + b"x", "part.jbi: is too large, expected at most 1 MiB"),
        ):
            with self.subTest(message):
                self.program("part.jbi", "")
                (self.folder / "s/part.jbi").write_bytes(text)
                done = self.run_it('[[pendant.step]]\ndo = "download"\nfile = "part.jbi"\n', code=2)
                self.assertIn(message, done.stderr)

    def test_a_breakpoint_of_the_program_of_the_scenario_pauses_it(self):
        self.program("part.ngc", "G21\n(MSG, before)\n(MSG, behind)\nM2\n")
        steps = """[[pendant.step]]
command = "set_breakpoint"
parameter = 1
payload = 3
[[pendant.step]]
command = "run"
[[pendant.step]]
do = "wait"
state = "hold"
[expect]
faults = ["drives_off"]
program_end = "paused"
program_messages = ["before"]
"""
        self.run_it(steps, keys='program = "part.ngc"')

    def test_a_step_in_the_wrong_state_fails_with_its_line(self):
        done = self.run_it('[[pendant.step]]\ncommand = "resume"\n', code=1)
        self.assertIn("pendant.step[1] (line 10) send resume: the reply is `mode` (0), expected `ok`", done.stdout)


if __name__ == "__main__":
    main()
