"""Scenarios with goldens as tests of Python. With pytest:

from armature.testing import armature_golden

def test_my_scenario(armature_golden):
    armature_golden("scenarios/fig9_joint_move")
"""

from . import run


def check_golden(where, *, set=(), engine="model", search=()):
    """Runs a scenario. Raises AssertionError if it fails, misses an expectation or does not equal its golden, and if it has
    none. Returns what is in summary.json, as a dict."""
    summary = run(where, set=set, engine=engine, search=search, compare_golden=True)
    result = summary["result"]
    if not result["passed"] or result["golden"] != "equal":
        raise AssertionError(f"{summary['scenario']}: " + "\n".join(reasons(result)))
    return summary


def reasons(result):
    """Why a run has not passed, or was not compared."""
    failures = [failure["text"] for failure in result["expect_failures"]]
    golden = [] if result["golden"] == "equal" else [f"golden {result['golden']}: {result['golden_text']}"]
    return [result["failure"]] * bool(result["failure"]) + failures + golden


try:
    import pytest
except ImportError:
    pass
else:

    @pytest.fixture
    def armature_golden():
        return check_golden
