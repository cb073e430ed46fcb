"""python3 tools/testplan [--check]: checks the test plan of the logic and generates rtl/TESTPLAN.md.

The plan is rtl/*/testplan.toml: a table per feature, with a sentence and the names of the proofs, tests, covers and
mutants that check it. A name may be a pattern. The plan is wrong if

  a feature has neither a proof nor a test, or no mutant that one of them detects,
  a name does not exist,
  a proof, a cover or a mutant of the RTL belongs to no feature.

Exit code: 0 the plan is complete; 1 it is wrong, or `--check` found a stale TESTPLAN.md.
"""

from __future__ import annotations

import argparse
import sys

from items import ROOT, existing
from plan import PlanError, load, problems, table

PAGE = ROOT / "rtl/TESTPLAN.md"


def main(arguments: list[str] | None = None) -> int:
    parser = argparse.ArgumentParser(
        prog="testplan", description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("--check", action="store_true", help="write nothing; fail if rtl/TESTPLAN.md is stale")
    args = parser.parse_args(arguments)
    try:
        features = load(ROOT / "rtl")
    except PlanError as error:
        print(f"testplan: {error}", file=sys.stderr)
        return 1
    items = existing()
    found = problems(features, items)
    text = table(features, items)
    if not args.check:
        PAGE.write_text(text)
    elif not PAGE.is_file() or PAGE.read_text() != text:
        found.append("rtl/TESTPLAN.md is stale (run `python3 tools/testplan`)")
    for problem in found:
        print(f"testplan: {problem}", file=sys.stderr)
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
