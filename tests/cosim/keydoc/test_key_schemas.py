"""The JSON Schemas of scenario and robot files: our files pass, and files with a mistake fail where the loader says."""

import json
import pathlib
import re
import sys
import tomllib
import unittest

try:
    import jsonschema
except ImportError:  # another Python than Debian's, which has the package
    sys.path.append("/usr/lib/python3/dist-packages")
    import jsonschema

ROOT = pathlib.Path(__file__).resolve().parents[3]
SCENARIOS = ROOT / "scenarios"
SCHEMAS = {"scenario": SCENARIOS / "scenario.schema.json", "robot": SCENARIOS / "robots/robot.schema.json"}
FILES = {
    "scenario": sorted([*SCENARIOS.glob("*/scenario.toml"), *ROOT.glob("tests/cosim/scenarios/*/scenario.toml")]),
    "robot": sorted(SCENARIOS.glob("robots/*.toml")),
}

# What the loader alone knows: the robot, other tables and files, the order of entries, sums of keys, and numbers that JSON
# has not (nan) or does not tell apart (2 and 2.0).
ONLY_LOADER = re.compile(
    "|".join(
        [
            r"needs \[kinematics\]",
            r"needs six axes",
            r"needs max_jerk",
            r"wrist of a six-axis arm",
            r"does not stop",
            r"variant = ",
            r"needs engine = ",
            r"needs a table",
            r"needs a serial\.parity",
            r"unknown robot",
            r"no such file",
            r"array of [56] (numbers|integers)",
            r"tables \[\[axis\]\]",
            r"^axis\S+ missing",
            r"missing in every \[\[axis\]\]",
            r"name of (the|a) file",
            r"(only with|sends) a \.jbi file",
            r"expected \d+ to \d+ for ",
            r"unknown frame",
            r"name other than",
            r"another frame",
            r"expected less than",
            r"expected a multiple of",
            r"listed in their order",
            r"at the same time",
            r"has no effect, pin",
            r"one tick",
            r"more than twice",
            r"data_bits = 7",
            r"at least one byte",
            r"needs [0-9.]+ ",
            r"drive's own lag",
            r"expected more than max_(speed|accel)_deg",
            r"expected a magnitude",
            r"forearm",
            r"found nan",
            r"found 2\.0",
            r"together with before_mm",
            r"found a distance in mm",
            r"does not begin at once",
            r"needs a path without rpy_deg",
            r"a spline has no orientation",
            r"not allowed with (type = .polyline|frame)",
            r"a robot with six axes",
            r"can(not)? move with the conveyor",
            r"expected a direction",
            r"expected a torque that is not 0",
            r"needs processor = ",
            r"an end (above|that is not before) the start",
            r"at most a tenth",
            r"the time (of the change )?before",
            r"has no \[axis\.homing\]",
            r"unreferenced_start_deg: the variant paper",
            r"not allowed with unreferenced_start_deg",
            r"(limit_switch_deg|homing\.position_deg): expected .* m(in|ax)_deg = ",
            r"needs (a key program,|program = )",
            r"gcode\.frame: a program needs",
            r"the last pin is",
            r"another table of this output",
            r"expected a file that ends in",
        ]
    )
)


def validator(kind):
    schema = json.loads(SCHEMAS[kind].read_text(encoding="utf-8"))
    jsonschema.Draft7Validator.check_schema(schema)
    return jsonschema.Draft7Validator(schema)


def path_text(error):
    text = ""
    for step in error.absolute_path:
        text += f"[{step}]" if isinstance(step, int) else f".{step}"
    return text.lstrip(".")


def cases(kind):
    """Title, document and expected problems of each case of bad_input that is TOML."""
    for file in sorted((ROOT / "tests/cosim/bad_input" / kind).glob("*.toml")):
        for case in re.split(r"(?m)^#=== ", file.read_text(encoding="utf-8"))[1:]:
            title, _, text = case.partition("\n")
            problems = re.findall(r"(?m)#! (?:\d+:)?\d+: (\S+): (.*)$", text)
            try:
                yield f"{kind}/{file.name}: {title}", tomllib.loads(text), problems
            except tomllib.TOMLDecodeError:
                continue


class KeySchemas(unittest.TestCase):
    def test_every_file_of_ours_names_its_schema_in_the_first_line(self):
        for kind, files in FILES.items():
            self.assertTrue(files)
            for file in files:
                with self.subTest(file=file.name, folder=file.parent.name):
                    first = file.read_text(encoding="utf-8").splitlines()[0]
                    self.assertTrue(first.startswith("#:schema "), first)
                    self.assertEqual((file.parent / first.split()[1]).resolve(), SCHEMAS[kind])

    def test_every_file_of_ours_is_valid(self):
        for kind, files in FILES.items():
            check = validator(kind)
            for file in files:
                with self.subTest(file=str(file)):
                    errors = [
                        f"{path_text(e)}: {e.message}" for e in check.iter_errors(tomllib.loads(file.read_text()))
                    ]
                    self.assertEqual(errors, [])

    def test_mistakes_fail_at_the_key_that_the_loader_names(self):
        seen = 0
        for kind in SCHEMAS:
            check = validator(kind)
            for title, document, problems in cases(kind):
                places = {path_text(error) for error in check.iter_errors(document)}
                for key, message in problems:
                    problem = f"{key}: {message}"
                    if ONLY_LOADER.search(problem):
                        continue
                    seen += 1
                    # The schema reports unknown and missing keys at their table, and too many tables at their array.
                    around = {key, key.rpartition(".")[0], key.rpartition("[")[0]}
                    with self.subTest(case=title, problem=problem):
                        self.assertTrue(around & places, sorted(places))
        self.assertGreater(seen, 190)

    def test_an_unknown_key_a_wrong_type_and_a_value_out_of_range_fail(self):
        good = tomllib.loads((SCENARIOS / "draw_line/scenario.toml").read_text())
        check = validator("scenario")
        self.assertEqual(list(check.iter_errors(good)), [])
        for change in (
            {"colour": "red"},
            {"duration_s": "1 s"},
            {"duration_s": 0},
            {"bus": {"stall_probability": 0.95}},
        ):
            with self.subTest(change=change):
                self.assertTrue(list(check.iter_errors({**good, **change})))

    def test_the_reasons_of_refusals_in_the_document_are_all_that_there_are(self):
        schema = json.loads(SCHEMAS["scenario"].read_text())
        reasons = schema["properties"]["expect"]["properties"]["refusals"]["items"]["enum"]
        section = (SCENARIOS / "KEYS.md").read_text().partition("### Reasons of refusals")[2].partition("\n## ")[0]
        self.assertEqual(re.findall(r"(?m)^\| `(\w+)`", section), reasons)


if __name__ == "__main__":
    unittest.main()
