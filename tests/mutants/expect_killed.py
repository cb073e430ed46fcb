#!/usr/bin/env python3
"""expect_killed.py PROGRAM NUMBER FILTER: succeeds if every GoogleTest that FILTER names fails in PROGRAM, whose
models have the mutant NUMBER.

A mutant is killed only if a check fails. A crash, a hang, an exception, a filter that selects nothing and a program
without a result are errors, because they would hide that no check covers the broken behaviour.
"""

import json
import os
import pathlib
import subprocess
import sys
import tempfile

HANG_S = 300  # much longer than any test


def verdict(program: str, number: str, test_filter: str) -> str:
    """Returns an empty string if every test failed in a check, otherwise the problem."""
    with tempfile.TemporaryDirectory() as folder:
        result_file = pathlib.Path(folder) / "result.json"
        command = [program, f"--gtest_filter={test_filter}", f"--gtest_output=json:{result_file}"]
        try:
            run = subprocess.run(
                command,
                stdout=subprocess.PIPE,
                stderr=subprocess.STDOUT,
                text=True,
                errors="replace",
                timeout=HANG_S,
                check=False,
                env={**os.environ, "MUTANT": number},
            )
        except subprocess.TimeoutExpired:
            return "the mutant hangs"
        if run.returncode < 0:
            return f"the mutant crashes with signal {-run.returncode}\n{run.stdout[-2000:]}"
        if not result_file.exists():
            return f"no result, exit code {run.returncode}\n{run.stdout[-2000:]}"
        report = json.loads(result_file.read_text(encoding="utf-8"))

    tests = {}
    for suite in report["testsuites"]:
        for test in suite["testsuite"]:
            tests[f"{suite['name']}.{test['name']}"] = [f["failure"] for f in test.get("failures", [])]
    if not tests:
        return f"no test matches {test_filter}"
    for name, failures in tests.items():
        if not failures:
            return f"{name} passes: it does not detect the mutant"
        if all("exception" in failure and "thrown in" in failure for failure in failures):
            return f"{name} fails with an exception, not in a check: {failures[0]}"
        print(f"{name} fails as expected:\n{failures[0]}\n")
    return ""


def main() -> int:
    if len(sys.argv) != 4:
        print(__doc__, file=sys.stderr)
        return 2
    problem = verdict(*sys.argv[1:])
    if problem:
        print(
            f"NOT KILLED: {problem}\nMUTANT={sys.argv[2]} {sys.argv[1]} --gtest_filter='{sys.argv[3]}'", file=sys.stderr
        )
    return 1 if problem else 0


if __name__ == "__main__":
    sys.exit(main())
