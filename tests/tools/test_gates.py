"""tools/gates: which gates have a valid record, and which processor time is too much."""

import importlib.util
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest
from unittest import mock

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tools/gates"))
sys.path.insert(0, str(ROOT / "tools"))
import cpp_includes  # noqa: E402
import ctest  # noqa: E402
import recorded  # noqa: E402
import same_bytes  # noqa: E402
from build_reads import BuildReads  # noqa: E402
from recorded import Gate  # noqa: E402
from session import BUILD, Outcome, Row, Session, excess  # noqa: E402

spec = importlib.util.spec_from_file_location("gates", ROOT / "tools/gates/__main__.py")
gates = importlib.util.module_from_spec(spec)
spec.loader.exec_module(gates)


class Digests(unittest.TestCase):
    """A gate reads a test, which includes a fixture, and an RTL source."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = pathlib.Path(folder.name)
        (self.root / "block_test.cpp").write_text('#include <vector>\n#include "fixture.hpp"\n#include "Vblock.h"\n')
        (self.root / "fixture.hpp").write_text("int a;\n")
        (self.root / "unrelated.hpp").write_text("int a;\n")
        (self.root / "block.sv").write_text("module block;\nendmodule\n")
        self.description = self.root / "rtl.block_test.gate"
        self.description.write_text(
            f"target block_test\ninclude {self.root}/block_test.cpp\ninput {self.root}/block.sv\npackage dpkg\n"
        )

    def gate(self):
        recorded.file_digest.cache_clear()
        cpp_includes.included.cache_clear()
        return recorded.read_gate(self.description, self.root)

    def test_has_the_name_and_the_programs_of_its_description(self):
        self.assertEqual((self.gate().name, self.gate().targets), ("rtl.block_test", ("block_test",)))

    def test_changes_with_every_file_that_it_reads_and_with_no_other(self):
        before = self.gate()
        (self.root / "unrelated.hpp").write_text("int b;\n")
        self.assertEqual(self.gate(), before)
        for name in ("block_test.cpp", "fixture.hpp", "block.sv"):
            with self.subTest(name):
                path = self.root / name
                path.write_text(path.read_text() + "// a comment\n")
                after = self.gate()
                self.assertNotEqual(after.sources, before.sources)
                self.assertEqual(after.tools, before.tools)
                before = after

    def test_changes_with_the_set_of_its_files(self):
        before = self.gate()
        self.description.write_text(self.description.read_text() + f"input {self.root}/unrelated.hpp\n")
        self.assertNotEqual(self.gate().sources, before.sources)

    def test_changes_with_the_version_of_a_tool(self):
        before = self.gate()
        self.description.write_text(self.description.read_text().replace("package dpkg", "package bash"))
        self.assertEqual(self.gate().sources, before.sources)
        self.assertNotEqual(self.gate().tools, before.tools)

    def test_does_not_depend_on_the_folder_of_the_checkout(self):
        before, root = self.gate(), self.root
        moved = root.with_name(root.name + "_moved")
        root.rename(moved)
        self.addCleanup(lambda: moved.rename(root))
        self.description = moved / self.description.name
        self.description.write_text(self.description.read_text().replace(str(root), str(moved)))
        self.root = moved
        self.assertEqual(self.gate(), before)

    def test_refuses_a_file_and_a_package_that_do_not_exist(self):
        text = self.description.read_text()
        self.description.write_text(f"{text}input {self.root}/missing.sv\n")
        with self.assertRaisesRegex(recorded.GateError, "missing.sv: No such file"):
            self.gate()
        self.description.write_text(f"{text}include {self.root}/missing.cpp\n")
        with self.assertRaisesRegex(recorded.GateError, "missing.cpp: No such file"):
            self.gate()
        self.description.write_text(f"{text}package no-such-package\n")
        with self.assertRaisesRegex(recorded.GateError, "package no-such-package"):
            self.gate()
        self.description.write_text("target block_test\n")
        with self.assertRaisesRegex(recorded.GateError, "reads nothing"):
            self.gate()


class Records(unittest.TestCase):
    SAME, CHANGED, NEW, UPDATED = (Gate(name, f"{name}1", "tool1") for name in ("same", "changed", "new", "updated"))
    GATES = [SAME, CHANGED, NEW, UPDATED]
    RECORDS = {
        "same": ("same1", "tool1"),
        "changed": ("changed0", "tool1"),  # of other sources
        "updated": ("updated1", "tool0"),  # of another version of the tool
        "gone": ("gone1", "tool1"),
    }

    def test_a_gate_runs_unless_its_sources_and_tools_have_a_record(self):
        self.assertEqual(recorded.not_recorded(self.GATES, self.RECORDS), [self.CHANGED, self.NEW, self.UPDATED])

    def test_a_gate_passes_if_it_has_tests_and_each_ran_and_passed(self):
        tests = {"same": {"a", "b"}, "changed": {"c", "d"}, "new": {"e", "f"}}
        passes = recorded.passed(self.GATES, tests, run={"a", "b", "c", "e", "f"}, failed={"f"})
        self.assertEqual(passes, [self.SAME])

    def test_a_gate_without_tests_and_a_test_without_a_gate_are_named(self):
        self.assertEqual(
            recorded.unmatched(self.GATES, [self.SAME, self.NEW], {"same": {"a"}, "other": {"b"}}),
            [
                "new: is described as a recorded gate, but has no test",
                "other: is the label of a test, but is not described",
            ],
        )

    def test_what_passed_is_recorded_and_what_failed_or_is_gone_is_not(self):
        records = recorded.renewed(self.RECORDS, self.GATES, [self.CHANGED, self.NEW, self.UPDATED], [self.CHANGED])
        self.assertEqual(records, {"same": ("same1", "tool1"), "changed": ("changed1", "tool1")})

    def test_every_wrong_record_is_named(self):
        passes = [self.CHANGED, self.NEW, self.UPDATED]
        self.assertEqual(
            recorded.wrong_records(self.RECORDS, self.GATES, passes),
            [
                "gone: has a record, but is no gate",
                "same: has a record of a pass, but does not pass",
                "changed: the record is not that of its sources",
                "new: has no record",
            ],
        )
        right = {"same": ("same1", "tool1"), "updated": ("updated1", "tool0")}
        self.assertEqual(recorded.wrong_records(right, [self.SAME, self.UPDATED], [self.SAME, self.UPDATED]), [])

    def test_a_file_is_read_as_it_was_written_and_a_broken_line_is_no_record(self):
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "passes.txt"
            self.assertEqual(recorded.read_records(path), {})
            recorded.write_records(self.RECORDS, path)
            self.assertEqual(recorded.read_records(path), self.RECORDS)
            self.assertEqual(path.read_text().splitlines()[-1], "updated updated1 tool0")
            path.write_text(path.read_text().replace("gone gone1 tool1", "gone"))
            self.assertNotIn("gone", recorded.read_records(path))


class Runs(unittest.TestCase):
    """tools/test runs gates, whose programs it has built; ctest is a fake."""

    GATE = Gate("rtl.a", "a1", "tool1", ("a",), frozenset({pathlib.Path("a.cpp"), pathlib.Path("a.sv")}))

    def passes_of(self, tests, failed, changed=frozenset(), read=frozenset()):
        records = object.__new__(gates.Records)
        records.gates = [self.GATE]
        result = ctest.Result(1, len(failed), "", "", set(failed), {"old", "new"})
        with (
            mock.patch.object(ctest, "run", lambda *_: result),
            mock.patch.object(ctest, "tests_of_gates", lambda _: tests),
            mock.patch.object(recorded, "changed_since", lambda *_: set(changed)),
            mock.patch.object(gates.BuildReads, "files_of", lambda *_: {pathlib.Path("a.cpp"), *read}),
        ):
            return records._run([self.GATE])

    def test_a_gate_passes_with_all_tests_of_the_program_that_was_built(self):
        tests = {"rtl.a": {"old", "new"}}
        self.assertEqual(self.passes_of(tests, [])[1], [self.GATE])
        self.assertEqual(self.passes_of(tests, ["new"])[1], [])

    def test_a_gate_that_was_edited_during_the_run_does_not_pass(self):
        self.assertEqual(self.passes_of({"rtl.a": {"old", "new"}}, [], changed=["rtl.a"])[1], [])

    def test_a_gate_that_reads_a_file_without_saying_so_fails(self):
        result, passes = self.passes_of({"rtl.a": {"old", "new"}}, [], read=[pathlib.Path("b.hpp")])
        self.assertEqual((result.failed, passes), (1, []))
        self.assertIn("rtl.a: its description does not name b.hpp", result.log)

    def test_a_gate_whose_tests_are_missing_fails(self):
        result, passes = self.passes_of({}, [])
        self.assertEqual((result.failed, passes), (1, []))
        self.assertIn("rtl.a: is described as a recorded gate, but has no test", result.log)

    def test_a_unit_test_that_did_not_run_with_sanitizers_is_named(self):
        result = ctest.Result(2, 0, "", "", set(), {"a_test", "b_test"})
        with (
            mock.patch.object(ctest, "run", lambda *_, **__: result),
            mock.patch.object(gates, "unit_tests", lambda: ["a_test", "c_test"]),
        ):
            self.assertEqual(gates.sanitizer_tests().failed, 1)
        self.assertIn("c_test: did not run with sanitizers", result.log)


class ReadFiles(unittest.TestCase):
    def test_are_sources_headers_and_inputs_of_generators_but_no_files_of_the_build(self):
        with tempfile.TemporaryDirectory() as folder:
            root = pathlib.Path(folder).resolve()
            build = root / "build"
            build.mkdir()
            for name in ("a.cpp", "a.hpp", "words.txt", "other.hpp", "build/made.hpp"):
                (root / name).write_text("")
            (build / "build.ninja").write_text(
                "rule compile\n  command = printf 'a.o: ../a.hpp made.hpp' > a.d && touch a.o\n  depfile = a.d\n"
                "  deps = gcc\nrule make\n  command = cat $in > $out\nrule link\n  command = cat $in > $out\n"
                "build made.hpp: make ../words.txt\nbuild a.o: compile ../a.cpp | made.hpp\nbuild a: link a.o\n"
                "build other: make ../other.hpp\n"
            )
            subprocess.run(["ninja", "-C", build, "--quiet", "a"], check=True)
            files = BuildReads(build, root).files_of(("a",))
            self.assertEqual(files, {root / name for name in ("a.cpp", "a.hpp", "words.txt")})


class SameBytes(unittest.TestCase):
    def test_a_program_that_is_killed_has_a_message(self):
        self.assertEqual(same_bytes._run(["sh", "-c", "exit 1"], 1), "")
        self.assertIn("exit code 2", same_bytes._run(["sh", "-c", "exit 2"], 1))
        self.assertIn("exit code -9", same_bytes._run(["sh", "-c", "kill -9 $$"], 1))


class Budget(unittest.TestCase):
    ROWS = [Row(BUILD, 60, 100), Row("tests", 30, 50), Row("style", 1, 3)]

    def test_a_gate_may_take_twice_its_share(self):
        self.assertEqual(excess(self.ROWS, {BUILD: 1.0, "tests": 0.26, "style": 0.02}), [])

    def test_a_gate_that_takes_more_is_named(self):
        lines = excess(self.ROWS, {BUILD: 1.0, "tests": 0.24, "style": 0.02})
        self.assertEqual(lines, ["tests: 0.50 of the build, its share is 0.24"])

    def test_every_gate_has_a_share_and_every_share_a_gate(self):
        lines = excess(self.ROWS, {BUILD: 1.0, "tests": 0.5, "proofs": 0.5})
        self.assertEqual(
            lines,
            [
                "style: no share in budget.toml; it took 0.03 of the build",
                "proofs: has a share in budget.toml, but is no gate",
            ],
        )

    def test_without_a_build_nothing_is_within_the_budget(self):
        self.assertEqual(excess(self.ROWS[1:], {"tests": 0.5, "style": 0.5}), ["no gate `build` ran"])

    def test_a_gate_is_counted_with_its_processor_time(self):
        session = Session("changes")

        def busy():
            self.assertGreater(sum(i for i in range(3_000_000)), 0)
            return Outcome(2, 1, "three checks", "")

        self.assertFalse(session.gate("busy", busy))
        self.assertEqual((session.passed, session.failed), (2, 1))
        self.assertGreater(session.rows[0].processor_s, 0.02)


class Groups(unittest.TestCase):
    def test_a_group_selects_its_label_and_the_last_group_every_other(self):
        self.assertEqual(ctest.selection("unit tests"), ["-L", "^unit$"])
        for label in ctest.LABELS.values():
            self.assertIn(label, ctest.selection(ctest.OTHERS)[1])

    def test_more_tests_than_processors_run_only_where_tests_wait(self):
        self.assertLessEqual(ctest.WAITING, ctest.LABELS.keys())
        self.assertGreater(ctest.at_a_time("command line and page"), ctest.at_a_time("scenarios"))
        self.assertEqual(ctest.at_a_time("scenarios"), os.cpu_count())

    def test_a_gate_is_selected_by_its_whole_name(self):
        _, pattern = ctest.selection("recorded gates", ["rtl.a", "mutants.b"])
        self.assertRegex("gate:rtl.a", pattern)
        self.assertNotRegex("gate:rtl.ab", pattern)
        self.assertNotRegex("gate:rtlxa", pattern)


if __name__ == "__main__":
    unittest.main()
