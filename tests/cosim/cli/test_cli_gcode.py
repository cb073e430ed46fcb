"""armature gcode without another interpreter: values from Python, errors with their places, hostile files."""

import math
import re
import string
import subprocess
from random import Random

import gcode_oracle
import gcode_programs
from cli_program import ROOT, Program, main

SEED = 15
ENDLESS = "o1 while [1]\n#1=[#1+1]\no1 endwhile\nM2\n"

# Program -> place, code and a part of the message.
ERRORS = {
    "G0 X1\nG41 D1\n": ("2:1: G41:", "not supported: cutter compensation left"),
    "G0 X1\nG5.2\n": ("2:1: G5.2:", "not supported"),
    "G0 X1\n  G12.5\n": ("2:3: G12.5:", "unknown"),
    "M72\n": ("1: M72:", "no modal state"),
    "G0 U1\n": ("1:4:", "letter"),
    "G0 X1 Y[1+]\n": ("1:11:", "expected"),
    "G0 X1 Y[1\n": ("1:10:", "']' is missing"),
    "G0 X[2 MOD]\n": ("1:11:", "expected"),
    "G0 X[1 2 4 FOO 5]\n": ("1:12:", "operator"),
    "G1 X5\n": ("1: G1:", "feed rate is zero"),
    "G0 X1\nG0 X1 X2\n": ("2:7: X:", "two words"),
    "G0 X1 R2\n": ("1: R:", "no code of the line uses"),
    "G2 X5 R1 F1\n": ("1: G2:", "too small"),
    "#5421=1\n": ("1:1:", "only be read"),
    "#<a>=1 X#<b> G0\n": ("1:9:", "no value"),
    "G0 X" + "[" * 40 + "\n": ("1:37:", "nested"),
    "X" + "1" * 300 + "\n": ("1:256:", "255"),
    "G0 X1234567890123456789\n": ("1:5:", "18 digits"),
    "o1 if [1]\nG0 X1\n": ("1:", "not closed"),
    "o1 while [1]\no2 if [1]\no1 endwhile\n": ("3:1:", "innermost"),
    "o1 repeat [2]\no2 break\no1 endrepeat\n": ("2:1:", "no loop"),
    "o1 sub\no1 endsub\no1 sub\no1 endsub\n": ("3:1:", "twice"),
    "o1 sub\no1 call\no1 endsub\no1 call\nM2\n": ("2:", "10 deep"),
    "o1 foo\n": ("1:1:", "keyword"),
    "G0 X1\no1 if [1] G0 X5\no1 endif\nM2\n": ("2:11:", "nothing may follow"),
    "G0 X1\n(abort, no part)\nX2\n": ("2:", "stops itself"),
    "G0 X1 M98 P1\n": ("1:7: M98:", "first in its line"),
    "o#1 if [1]\n": ("1:1:", "only CALL"),
    "M98 P1\nM2\nO1\nG0 X1\n": ("4:", "without M99"),
    "M62 P-1\n": ("1: P:", "out of range"),
    "G0 X1 \x7f\n": ("1:7:", "the byte 127 has no meaning here"),
    "G1 X1 F100 $\n": ("1:12:", "'$' has no meaning here"),
    "G21\nT7 M6\n": ("2:", "T7: the tool is not in the tool table; name it with --tool 7"),
}


class Gcode(Program):
    def canon(self, text, *options, code=0):
        self.text("program.ngc", text)
        return self.armature("gcode", *options, "--canon", "program.ngc", code=code)

    def calls(self, text, *options):
        return gcode_oracle.calls_of(self.canon(text, *options).stdout)

    def places(self, text, *options):
        return [
            [float(n) for n in gcode_oracle.NUMBER.findall(call)][:3]
            for call in self.calls(text, *options)
            if call.startswith("STRAIGHT")
        ]

    def test_a_program_without_an_end_ends_there_with_a_note(self):
        for text in gcode_programs.WITHOUT_END.values():
            done = self.canon(text)
            self.assertIn("STRAIGHT_TRAVERSE(1.0000", done.stdout)
            self.assertTrue(done.stdout.endswith("PROGRAM_END()\n"))
            self.assertIn(f"program.ngc:{len(text.splitlines())}: note: the program ends without M2", done.stderr)
            self.assertEqual(done.stderr.count("\n"), 1)
        self.assertEqual(self.canon("G0 X1\nM30\n").stderr, "")

    def test_an_abort_says_its_text_and_stops(self):
        done = self.canon("#1=2.5\nG0 X1\nM3 S1 (ABORT,no part #1)\nX2\nM2\n", code=2)
        self.assertIn('MESSAGE("no part 2.500000")', done.stdout)
        self.assertNotIn("START_SPINDLE", done.stdout)
        self.assertNotIn("(2.0000", done.stdout)

    def test_subroutines_come_from_files_beside_the_program(self):
        self.text("probe.ngc", "%\no<probe> sub\nG0 X#1\nM98 P0020\no<probe> endsub [#1+1]\n%\n")
        self.text("20.NGC", "O0020 (of a file)\nG0 Y#1\nM99")
        self.assertEqual(self.places("o<Probe> call [3]\nG0 Z#<_value>\nM2\n"), [[3, 0, 0], [3, 3, 0], [3, 3, 4]])

    def test_an_error_in_the_file_of_a_subroutine_names_that_file(self):
        self.text("probe.ngc", "o<probe> sub\nG41 D1\no<probe> endsub\n")
        error = self.canon("G0 X1\no<probe> call\nM2\n", code=2).stderr
        self.assertTrue(error.startswith("probe.ngc:2:1: G41:"), error)
        self.text("probe.ngc", "o<probe> sub\no1 if [1]\n")
        error = self.canon("G0 X1\no<probe> call\nM2\n", code=2).stderr
        self.assertTrue(error.startswith("probe.ngc:2: the block is not closed"), error)
        error = self.canon("G0 X1\no<other> call\nM2\n", code=2).stderr
        self.assertIn("neither in this program nor in a file beside it", error)

    def test_expressions_have_the_values_of_python(self):
        random = Random(SEED)
        print(f"seed {SEED}")
        functions = {
            "SIN": lambda x: math.sin(math.radians(x)),
            "COS": lambda x: math.cos(math.radians(x)),
            "EXP": lambda x: math.exp(x),
            "ABS": abs,
            "FIX": math.floor,
            "FUP": math.ceil,
        }
        lines, expected = [], []
        for _ in range(400):
            a, b, c = (round(random.uniform(0.1, 9.0), 3) for _ in range(3))
            name, function = random.choice(list(functions.items()))
            # Operators of three levels, so that a wrong order gives another value.
            lines.append(f"(DEBUG,#1 #2 #3 #4) #1=[{a}-{b}*{c}**1.5+{name}[{a}*-{b}]]")
            lines.append(
                f"#2=[LN[{a}]/{b}-{c}] #3=[{a}**-{b}] #4=[ATAN[{a}]/[-{b}]+ASIN[{c}/10]-ACOS[{c}/-10]-TAN[{a}]]"
            )
            lines.append("(DEBUG,#1 #2 #3 #4)")
            tangents = math.degrees(math.atan2(a, -b) + math.asin(c / 10) - math.acos(c / -10)) - math.tan(
                math.radians(a)
            )
            expected.append([a - b * c**1.5 + function(a * -b), math.log(a) / b - c, a**-b, tangents])
        messages = [call for call in self.calls("\n".join([*lines, "M2", ""])) if call.startswith("MESSAGE")][1::2]
        self.assertEqual(len(messages), len(expected))
        for message, values in zip(messages, expected, strict=True):
            got = [float(n) for n in re.findall(r"-?\d+\.\d+", message)]
            for mine, other in zip(got, values, strict=True):
                self.assertLessEqual(abs(mine - other), 1e-6 + 1e-12 * abs(other), message)

    def test_each_error_names_its_place_and_code(self):
        for text, (place, part) in ERRORS.items():
            with self.subTest(text[:60]):
                error = self.canon(text, code=2).stderr
                self.assertTrue(error.startswith(f"program.ngc:{place}"), error)
                self.assertIn(part, error)
                self.assertEqual(error.count("\n"), 1)

    def test_each_code_without_support_is_named(self):
        lines = self.armature("gcode", "--codes").stdout.splitlines()[1:]
        refused = [line.split()[0] for line in lines if " not supported " in line]
        self.assertGreater(len(refused), 30)
        for code in refused:
            error = self.canon(f"G0 X1\n{code}\nM2\n", code=2).stderr
            self.assertIn(f":2:1: {code}: the code is not supported", error)

    def test_the_document_has_the_table_of_codes(self):
        document = (ROOT / "controller/language/gcode/CODES.md").read_text(encoding="utf-8")
        block = re.search(r"(?s)```\n(.*?)```", document).group(1)
        self.assertEqual(block, self.armature("gcode", "--codes").stdout)

    def test_check_reports_each_wrong_file(self):
        self.text("good.ngc", "G0 X1\nM2\n")
        self.text("bad.ngc", "G0 X\n")
        self.text("worse.ngc", "G1 X1\n")
        done = self.armature("gcode", "--check", "bad.ngc", "good.ngc", "worse.ngc", code=2)
        self.assertEqual(done.stdout, "")
        self.assertEqual([line.split(":")[0] for line in done.stderr.splitlines()], ["bad.ngc", "worse.ngc"])
        self.armature("gcode", "--check", "good.ngc")
        for action in ((), ("check",), ("--check",)):
            self.assertEqual(
                self.armature("gcode", *action, "bad.ngc", "good.ngc", "worse.ngc", code=2).stderr, done.stderr
            )
        self.assertIn(
            "chek: no such file, did you mean check?", self.armature("gcode", "chek", "bad.ngc", code=2).stderr
        )
        self.assertIn("A file to check is required", self.armature("gcode", code=2).stderr)

    def test_loops_of_a_number_of_turns_can_be_left_and_continued(self):
        text = "o1 repeat [5]\n#1=[#1+1]\no2 if [#1 EQ 2]\no1 continue\no2 endif\no3 if [#1 EQ 4]\no1 break\no3 endif\n"
        text += "o4 repeat [2]\no5 if [#1 EQ 3]\no4 break\no5 endif\nG0 X#1\no4 endrepeat\no1 endrepeat\nG0 Y#1\nM2\n"
        self.assertEqual(self.places(text), [[1, 0, 0], [1, 0, 0], [1, 4, 0]])

    def test_lines_may_end_with_any_line_end(self):
        lines = ["%", "G0 X1", "(text)", "G0 Y2", "%", "nothing of this is read"]
        for end in ("\n", "\r\n", "\r"):
            self.assertEqual(self.places(end.join(lines) + end), [[1, 0, 0], [1, 2, 0]])

    def test_lines_with_a_slash_are_skipped_on_request(self):
        text = "/G0 X1\nG0 Y2\nM2\n"
        self.assertEqual(self.places(text), [[1, 0, 0], [1, 2, 0]])
        self.assertEqual(self.places(text, "--block-delete"), [[0, 2, 0]])

    def test_a_parameter_of_the_command_line_is_global(self):
        text = "o1 sub\nG0 X#<_hal[a.b]>\no1 endsub\no1 call\nM2\n"
        self.assertEqual(self.places(text, "--define", "_hal[a.b]=2.5"), [[2.5, 0, 0]])
        for wrong in ("_a", "a=1", "_a=x", "_metric=0", "=1"):
            error = self.canon(text, "--define", wrong, code=2).stderr
            self.assertIn("--define", error)

    def test_an_endless_program_is_stopped(self):
        self.assertIn("has not ended after 1000 lines", self.canon(ENDLESS, "--most-lines", "1000", code=2).stderr)

    def test_a_wait_for_an_input_is_a_call(self):
        raw = self.canon("M66 P3 L3 Q2.5\nM66 E1 L0\nM2\n").stdout
        self.assertIn("WAIT(3, DIGITAL_INPUT, HIGH, 2.5000)", raw)
        self.assertIn("WAIT(1, ANALOG_INPUT, IMMEDIATE, 0.0000)", raw)

    def test_no_text_crashes_it(self):
        random = Random(SEED)
        print(f"seed {SEED}")
        programs = [gcode_programs.START + text + "M2\n" for text in gcode_programs.GOOD.values()]
        words = [
            "o1",
            "if",
            "while",
            "endwhile",
            "[",
            "]",
            "#",
            "<",
            ">",
            "**",
            "ATAN",
            "G81",
            "R",
            "L9",
            "-",
            ".",
            "\n",
        ]
        names = []
        for number in range(250):
            text = random.choice(programs)
            for _ in range(random.randrange(1, 6)):
                at, kind = random.randrange(len(text) + 1), random.randrange(4)
                new = random.choice(
                    [random.choice(words), random.choice(string.printable), chr(random.randrange(1, 255))]
                )
                end = min(len(text), at + random.randrange(6))
                text = text[:at] + (new if kind else "") + text[end if kind < 2 else at :]
            (self.folder / f"{number}.ngc").write_bytes(text.encode("latin-1"))
            names.append(f"{number}.ngc")
        for number in range(50):
            text = "".join(random.choice(string.printable + "gGxX[]#o") for _ in range(random.randrange(2000)))
            names.append(self.text(f"garbage{number}.ngc", text))
        for name in names:
            self.assertIn(self.any_code("gcode", "--most-lines", "20000", "--check", name), (0, 2), name)

    def any_code(self, *arguments):
        done = subprocess.run([self.path, *arguments], cwd=self.folder, capture_output=True, timeout=60, check=False)
        return done.returncode


if __name__ == "__main__":
    main()
