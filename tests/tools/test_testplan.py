"""tools/testplan: each reason for which the test plan is wrong is reported, and the plan of the logic is complete."""

import contextlib
import importlib.util
import io
import pathlib
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tools/testplan"))
import items  # noqa: E402
import plan  # noqa: E402

spec = importlib.util.spec_from_file_location("testplan", ROOT / "tools/testplan/__main__.py")
testplan = importlib.util.module_from_spec(spec)
spec.loader.exec_module(testplan)

GOOD = """
[period]
feature = "The period is exact."
proofs = ["counter"]
tests = ["Timer.Period*"]
covers = ["timer.Wraps"]
mutants = ["one_short", "counter.map_*"]
"""


def some_items():
    return items.Items(
        proofs={"counter"},
        tests={"Timer.PeriodIsExact", "Timer.PeriodDoesNotDrift", "Other.Works"},
        covers={"timer.Wraps"},
        mutants={"one_short": {"Timer.PeriodIsExact"}, "counter.map_wrong": {"counter"}},
    )


class Problems(unittest.TestCase):
    def features(self, text):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        folder = pathlib.Path(scratch.name) / "timer"
        folder.mkdir()
        (folder / "testplan.toml").write_text(text)
        return plan.load(folder.parent)

    def problems(self, old="", new="", change=lambda found: None):
        self.assertIn(old, GOOD)
        found = some_items()
        change(found)
        return plan.problems(self.features(GOOD.replace(old, new)), found)

    def test_a_complete_plan_is_good(self):
        self.assertEqual(self.problems(), [])

    def test_a_feature_without_a_proof_and_without_a_test(self):
        without = 'proofs = ["counter"]\ntests = ["Timer.Period*"]\n'
        self.assertIn("timer.period: neither a proof nor a test", self.problems(without))

    def test_a_test_alone_is_enough(self):
        found = self.problems('proofs = ["counter"]\n', "", lambda found: found.proofs.clear())
        self.assertEqual(found, ["timer.period: none of its proofs and tests detects the mutant counter.map_wrong"])

    def test_a_feature_without_a_mutant(self):
        found = self.problems('mutants = ["one_short", "counter.map_*"]\n', "", lambda found: found.mutants.clear())
        self.assertEqual(found, ["timer.period: no mutant"])

    def test_names_that_do_not_exist(self):
        for kind, old in {
            "proof": '"counter"]',
            "test": '"Timer.Period*"',
            "cover": '"timer.Wraps"',
            "mutant": '"one_short"',
        }.items():
            new = old.replace('"', '"Ghost*", "', 1)
            self.assertEqual(self.problems(old, new), [f"timer.period: there is no {kind} Ghost*"])

    def test_items_that_no_feature_has(self):
        def add(found):
            found.proofs.add("p")
            found.covers.add("c")
            found.mutants["m"] = {"Other.Works"}

        expected = ["no feature has the proof p", "no feature has the cover c", "no feature has the mutant m"]
        self.assertEqual(self.problems(change=add), expected)

    def test_a_mutant_that_the_tests_of_its_feature_do_not_detect(self):
        def change(found):
            found.mutants["one_short"] = {"Other.Works"}

        expected = ["timer.period: none of its proofs and tests detects the mutant one_short"]
        self.assertEqual(self.problems(change=change), expected)

    def test_a_file_in_another_form_is_an_error(self):
        for text in ("[a]\n", "[a]\nfeature = 'x'\ntest = ['T.a']\n", "[a]\nfeature = 'x'\ntests = 'T.a'\n", "[a\n"):
            with self.assertRaisesRegex(plan.PlanError, "rtl/timer/testplan.toml"):
                self.features(text)

    def test_the_table_has_the_names_and_the_numbers_of_patterns(self):
        row = "| period | The period is exact. | `counter` | `Timer.Period*` (2) | `timer.Wraps` | `one_short`, `counter.map_*` |"
        self.assertIn(row, plan.table(self.features(GOOD), some_items()).splitlines())


class Names(unittest.TestCase):
    def test_a_filter_becomes_names_without_instance_and_parameter(self):
        self.assertEqual(
            items.plain_tests("*/Uart.Sends*:Timer.Ends:Stalls/Bus.Waits/*"), {"Uart.Sends*", "Timer.Ends", "Bus.Waits"}
        )

    def test_each_kind_is_found(self):
        found = items.existing()
        self.assertIn("pulse_gen", found.proofs)
        self.assertNotIn("registers.example", found.proofs)
        self.assertLessEqual({"Debounce.ChatterRestartsTheCount", "scenario.late_core"}, found.tests)
        self.assertIn("timer_counter.WrapsDown", found.covers)
        self.assertIn("registers.encoder_switch.unmapped_read_is_okay", found.mutants)


class Tool(unittest.TestCase):
    def run_tool(self, *arguments):
        errors = io.StringIO()
        with contextlib.redirect_stderr(errors):
            code = testplan.main(list(arguments))
        return code, errors.getvalue()

    def test_the_plan_of_the_logic_is_complete_and_its_table_fresh(self):
        self.assertEqual(self.run_tool("--check"), (0, ""))

    def test_an_old_table_is_stale_until_it_is_written(self):
        page = testplan.PAGE
        self.addCleanup(setattr, testplan, "PAGE", page)
        with tempfile.TemporaryDirectory() as scratch:
            testplan.PAGE = pathlib.Path(scratch) / "TESTPLAN.md"
            testplan.PAGE.write_text(page.read_text().replace("## axi\n", ""))
            stale = (1, "testplan: rtl/TESTPLAN.md is stale (run `python3 tools/testplan`)\n")
            self.assertEqual(self.run_tool("--check"), stale)
            self.assertEqual(self.run_tool(), (0, ""))
            self.assertEqual(self.run_tool("--check"), (0, ""))


if __name__ == "__main__":
    unittest.main()
