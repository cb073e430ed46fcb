"""A shipped scenario with rounded ways expects how many of its moves begin without a stop. Run by CTest."""

import pathlib
import re
import tempfile
import tomllib
import unittest

SCENARIOS = pathlib.Path(__file__).resolve().parents[2] / "scenarios"
# PL= and CR= of a robot program, path blending of G-code.
ROUNDED_JOB = re.compile(r"^MOV.*\b(PL=[1-8]|CR=)", re.M)
ROUNDED_GCODE = re.compile(r"^[^(;]*\bG64\b", re.M)


def has_rounded_ways(folder):
    """True if a move of the scenario, or of a program beside it, asks for a rounded way."""
    scenario = tomllib.loads((folder / "scenario.toml").read_text())
    moves = scenario.get("move", [])
    if any(move.get(key, 0) > 0 for move in moves for key in ("blend_mm", "blend_deg", "blend_percent")):
        return True
    programs = [(path, ROUNDED_JOB) for path in folder.glob("*.jbi")]
    programs += [(path, ROUNDED_GCODE) for path in folder.glob("*.ngc")]
    return any(words.search(path.read_text()) for path, words in programs)


def unexpected(scenarios):
    """The scenarios with rounded ways that do not expect `blended_moves`."""
    return [
        path.parent.name
        for path in sorted(scenarios.glob("*/scenario.toml"))
        if has_rounded_ways(path.parent) and "blended_moves" not in tomllib.loads(path.read_text()).get("expect", {})
    ]


class RoundedWays(unittest.TestCase):
    def test_each_scenario_with_rounded_ways_expects_them(self):
        self.assertEqual(unexpected(SCENARIOS), [])

    def test_there_are_such_scenarios_of_each_kind(self):
        names = {path.parent.name for path in SCENARIOS.glob("*/scenario.toml") if has_rounded_ways(path.parent)}
        self.assertLessEqual({"job_draw_house", "gcode_short_lines", "joint_blends", "draw_star_blended"}, names)

    def test_a_missing_expectation_is_found(self):
        with tempfile.TemporaryDirectory() as scratch:
            folder = pathlib.Path(scratch) / "a"
            folder.mkdir()
            (folder / "scenario.toml").write_text('program = "a.jbi"\n[expect]\nunderruns = 0\n')
            (folder / "a.jbi").write_text("NOP\nMOVL C00001 V=100.0 PL=0\nEND\n")
            self.assertEqual(unexpected(folder.parent), [])
            (folder / "a.jbi").write_text("NOP\nMOVL C00001 V=100.0 PL=1\nEND\n")
            self.assertEqual(unexpected(folder.parent), ["a"])
            (folder / "scenario.toml").write_text('program = "a.jbi"\n[expect]\nblended_moves = 1\n')
            self.assertEqual(unexpected(folder.parent), [])


if __name__ == "__main__":
    unittest.main()
