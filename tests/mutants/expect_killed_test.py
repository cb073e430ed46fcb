"""expect_killed distinguishes a failing check from a crash, a hang, an exception and a test that passes."""

import json
import os
import pathlib
import tempfile
import textwrap
import unittest

import expect_killed


def report(*failures):
    """A JSON report of GoogleTest with one suite; `failures` has one text per test, or None for a test that passes."""
    tests = [{"name": f"T{i}", "failures": [{"failure": text}] if text else []} for i, text in enumerate(failures)]
    return json.dumps({"testsuites": [{"name": "S", "testsuite": tests}] if tests else []})


class ExpectKilled(unittest.TestCase):
    def verdict(self, body):
        """Runs `body` as the test program; `out` is the path of its report."""
        with tempfile.TemporaryDirectory() as folder:
            program = pathlib.Path(folder) / "program"
            program.write_text(
                "#!/usr/bin/env python3\nimport os, sys, time\n"
                "out = sys.argv[2].removeprefix('--gtest_output=json:')\n" + textwrap.dedent(body)
            )
            os.chmod(program, 0o755)
            return expect_killed.verdict(str(program), "7", "S.*")

    def writes(self, text):
        return self.verdict(f"open(out, 'w').write({text!r}); sys.exit(1)")

    def test_failing_checks_kill(self):
        self.assertEqual(self.writes(report("a.cpp:1: Expected 3, got 2", "a.cpp:9: no")), "")

    def test_mutant_is_chosen_by_its_number(self):
        self.assertIn("exit code 7", self.verdict("sys.exit(int(os.environ['MUTANT']))"))

    def test_one_passing_test_is_a_survivor(self):
        self.assertIn("S.T1 passes", self.writes(report("a.cpp:1: no", None)))

    def test_exception_is_no_check(self):
        text = "unknown file\nC++ exception with description x thrown in the test body."
        self.assertIn("exception", self.writes(report(text)))

    def test_crash_is_no_check(self):
        self.assertIn("signal 6", self.verdict("os.abort()"))

    def test_crash_after_a_report_is_no_check(self):
        self.assertIn("signal 6", self.verdict(f"open(out, 'w').write({report('no')!r}); os.abort()"))

    def test_no_report_is_no_check(self):
        self.assertIn("no result", self.verdict("sys.exit(1)"))

    def test_filter_without_a_test_is_an_error(self):
        self.assertIn("no test matches", self.writes(report()))

    def test_hang_is_no_check(self):
        limit, expect_killed.HANG_S = expect_killed.HANG_S, 1
        try:
            self.assertIn("hangs", self.verdict("time.sleep(60)"))
        finally:
            expect_killed.HANG_S = limit


if __name__ == "__main__":
    unittest.main()
