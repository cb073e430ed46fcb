"""tools/policy: the figures of the network over held-out targets, with few of them."""

import pathlib
import re
import sys
import tempfile
import tomllib
import unittest

import numpy
from cli_program import ROOT, SCENARIOS, main

sys.path[:0] = [str(ROOT / "tools/policy"), str(ROOT / "tools")]
import runs  # noqa: E402
import table  # noqa: E402
import targets  # noqa: E402
import weights  # noqa: E402
from generated import section  # noqa: E402

import armature  # noqa: E402

ARMS = {arm.name: arm for arm in targets.ARMS}
README = ROOT / "tools/policy/README.md"
FEW = 3


class Figures(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = cls.enterClassContext(tempfile.TemporaryDirectory())
        cls.irb = runs.run_all(ARMS["irb120"], FEW, 1, 2, cls.folder)[0]

    def test_the_same_seed_gives_the_same_bytes_with_any_number_of_jobs(self):
        again = runs.run_all(ARMS["irb120"], FEW, 1, 1, self.folder)[0]
        text = table.figures_text(ARMS["irb120"], self.irb, 1)
        self.assertEqual(table.figures_text(ARMS["irb120"], again, 1), text)

    def test_another_seed_has_other_belts(self):
        belts = {
            tuple(targets.settings_of_belt(ARMS["irb120"], seed, number)) for seed in (1, 2) for number in range(50)
        }
        self.assertEqual(len(belts), 100)

    def test_the_baseline_is_a_run_without_a_network(self):
        scenario = pathlib.Path(self.folder, "plain", "scenario.toml")
        scenario.parent.mkdir()
        text = (targets.BELT.scenario / "scenario.toml").read_text()
        plain = re.sub(r"^\[conveyor\.policy\]\n(\w.*\n)+", "", text, flags=re.M)
        self.assertNotEqual(plain, text)
        scenario.write_text(plain)
        arm = ARMS["irb120"]
        settings = targets.settings_of_arm(arm, targets.robot_of(arm, self.folder))
        settings = [setting for setting in settings if "policy" not in setting]
        settings += targets.settings_of_belt(arm, 1, 0)
        result = armature.run(scenario.parent, set=settings, engine="model")["result"]
        self.assertEqual(result["sha256"], self.irb["baseline"][0].sha256)
        self.assertEqual(result["rms_tracking_error_mm"], self.irb["baseline"][0].rms_mm)

    def test_the_network_gives_the_same_bytes_on_the_arm_and_in_the_logic(self):
        digests = {way: [run.sha256 for run in self.irb[way]] for way in runs.WAYS}
        self.assertEqual(digests["arm"], digests["logic"])
        self.assertFalse(set(digests["logic"]) & set(digests["baseline"]))

    def test_the_arm_follows_each_part_to_its_end_with_both_plants(self):
        for name in ("vo_ideal", "vo_dynamic"):
            followed = runs.run_all(ARMS[name], 1, 1, 1, self.folder)[0]
            for run in [followed[way][0] for way in runs.WAYS]:
                self.assertEqual(run.end, "released")
                self.assertGreater(run.worst_mm, run.rms_mm)
                self.assertGreater(run.corrected, 10_000)

    def test_the_ideal_arm_has_the_axes_and_drives_of_the_dynamic_one(self):
        text = (SCENARIOS / "robots/vo2021_6r_dynamic.toml").read_text()
        wanted = tomllib.loads(text)
        for table_of_plant in ("link", "tool"):
            del wanted[table_of_plant]
        for axis in (wanted["defaults"], *wanted["axis"]):
            axis.pop("dynamics", None)
        wanted["plant"] = "ideal"
        self.assertEqual(tomllib.loads(targets.without_dynamics(text)), wanted)


def followed(rms_mm, worst_mm, end="released", uncorrected=0):
    return runs.Followed(end, rms_mm, worst_mm, 100 - uncorrected, uncorrected, f"{rms_mm}")


class Table(unittest.TestCase):
    def test_its_rows_have_means_shares_and_what_was_lost(self):
        results = {
            "baseline": [followed(0.1, 0.5), followed(0.3, 0.6), followed(9, 9), followed(9, 9)],
            "arm": [followed(0.2, 0.4), followed(0.2, 0.5, uncorrected=20), followed(9, 9), followed(9, 9, "window")],
        }
        results["logic"] = results["arm"]
        text = table.figures_text(ARMS["irb120"], results, 7)
        self.assertIn("4 targets of seed 7, of which 3 are compared", text)
        self.assertIn("| baseline | 3.1333 | 9.000 | 9.000 |  |  |  | 0 |", text)
        self.assertIn("| network on ARM | 3.1333 | 9.000 | 9.000 | 33.3 % | 0.0 % | 6.67 % | 1 |  |", text)
        self.assertIn("| network in logic | 3.1333 | 9.000 | 9.000 | 33.3 % | 0.0 % | 6.67 % | 1 | 4 |", text)

    def test_the_sections_of_the_readme_have_its_layout(self):
        for arm in ARMS.values():
            text = section(README, arm.name)
            count = int(re.search(rf"^\*\*{re.escape(arm.title)}\*\*, (\d+) targets of seed \d+, of which", text)[1])
            self.assertIn("\n\n" + table.HEAD, text)
            rows = text.split(table.HEAD)[1].split("\n\n")[0].splitlines()
            cells = [[cell.strip() for cell in row.strip("|").split("|")] for row in rows]
            self.assertEqual([row[0] for row in cells], [way.title for way in runs.WAYS.values()])
            self.assertEqual({len(row) for row in cells}, {table.HEAD.split("\n")[0].count("|") - 1})
            self.assertRegex(text, rf"\n{count * len(runs.WAYS)} runs of ")
        self.assertIn(weights.HEAD, section(README, "weights"))


class Weights(unittest.TestCase):
    def test_a_set_point_beyond_a_limit_is_found(self):
        limits = [numpy.array([limit]) for limit in (100.0, 1000.0, -10.0, 10.0)]
        tick = weights.TICK_S

        def what(*angles):
            return weights.beyond(numpy.array(angles)[:, None], limits)

        self.assertEqual(what(0, 99.9 * tick, 2 * 99.9 * tick), "")
        self.assertEqual(what(9.9999999, 9.9999999, 10.0), "")
        self.assertIn("speed of axis 1 at row 0", what(0, 101 * tick))
        self.assertIn("acceleration of axis 1 at row 0", what(0, 0, 1001 * tick * tick))
        self.assertIn("range of axis 1 at row 1", what(10.0, 10.0001))
        self.assertNotEqual(what(0, float("nan")), "")

    def test_wrong_weights_exceed_no_limit_and_are_refused_when_the_checksum_tells(self):
        with tempfile.TemporaryDirectory() as folder:
            text, beyond = weights.weights_text(1, 1, 2, folder)
        self.assertEqual(beyond, 0)
        rows = [row.split("|")[2:5] for row in text.split(weights.HEAD)[1].splitlines()]
        (_, random, _), (_, flipped, _), (_, corrected, refused) = [[int(cell) for cell in row] for row in rows]
        self.assertGreater(random, 20_000)
        self.assertGreater(flipped, 20_000)
        self.assertEqual(corrected, 0)
        self.assertGreater(refused, 20_000)

    def test_a_flip_changes_neurons_only(self):
        network = weights.policy.read(targets.BELT.scenario / "belt.policy")
        good = network.image.astype("<u4").tobytes()
        draw, flipped = weights.random.Random(1), bytearray(good)
        weights.flip(draw, flipped, 64)
        self.assertEqual(sum((a ^ b).bit_count() for a, b in zip(good, flipped)), 64)
        self.assertEqual(len(weights.neuron_bytes(flipped)), len(good) - 3 * weights.ROW)  # three layers


if __name__ == "__main__":
    main()
