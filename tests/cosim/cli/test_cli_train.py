"""armature train, and runs with the network that it makes."""

import json
import os
import re
import shlex
import tomllib

from cli_program import ROOT, SCENARIOS, Program, main

SCENARIO = SCENARIOS / "policy_conveyor"
# Of scenarios, and those that tools/policy measures besides.
NETWORKS = [SCENARIO / "belt.policy", SCENARIOS / "policy_moving_target/target.policy"]
if "ARMATURE_FEW_DRAWS" not in os.environ:
    NETWORKS += sorted((ROOT / "tools/policy").glob("*.policy"))


class Train(Program):
    def run_it(self, *settings, code=0, scenario=SCENARIO):
        arguments = [word for setting in settings for word in ("--set", setting)]
        self.armature("run", scenario, "--engine", "model", "--out", "out", *arguments, code=code)
        result = json.loads((self.folder / "out/summary.json").read_text())["result"]
        return result, (self.folder / "out/log.txt").read_text()

    def test_the_command_in_a_network_makes_the_same_bytes(self):
        for network in NETWORKS:
            with self.subTest(network=network.name):
                text = network.read_text()
                command = shlex.split(re.search(r"^#   armature (.*)$", text, re.M).group(1))
                self.armature(*command, "--test", 0, "--out", "made.policy")
                self.assertEqual((self.folder / "made.policy").read_text(), text)

    def test_the_network_halves_what_a_tuned_controller_leaves(self):
        """The table, with few belts."""
        out = self.armature("train", "--belts", 30, "--epochs", 6, "--test", 4).stdout
        rows = [line.split()[-3:] for line in out.splitlines()[2:]]
        (plain, _, _), (tuned, _, unrest), (network, _, network_unrest) = [map(float, row) for row in rows]
        self.assertLessEqual(unrest, network_unrest)
        self.assertLess(network, 0.75 * min(plain, tuned))

    def test_the_network_in_software_gives_the_same_run(self):
        for name in (SCENARIO.name, "policy_moving_target"):
            with self.subTest(scenario=name):
                logic, _ = self.run_it(scenario=SCENARIOS / name)
                arm, _ = self.run_it('conveyor.policy.on="arm"', scenario=SCENARIOS / name)
                self.assertEqual(logic["sha256"], arm["sha256"])

    def test_without_a_correction_the_tracking_error_is_larger(self):
        for name, factor in ((SCENARIO.name, 1.5), ("policy_moving_target", 1.3)):
            with self.subTest(scenario=name):
                result, _ = self.run_it("conveyor.policy.percent=0", scenario=SCENARIOS / name, code=1)
                corrected, _ = self.run_it(scenario=SCENARIOS / name)
                self.assertGreater(result["tracking_error"]["mm"], factor * corrected["tracking_error"]["mm"])

    def test_software_switches_the_correction_off_where_the_logic_does(self):
        for name in ("policy_out_of_range", "policy_corrupt_weights"):
            golden = tomllib.loads((SCENARIOS / name / "scenario.toml").read_text())["golden"]["sha256"]
            result, _ = self.run_it('conveyor.policy.on="arm"', scenario=SCENARIOS / name)
            self.assertEqual(result["sha256"], golden)

    def test_the_arm_stops_when_the_target_of_a_hand_is_hidden(self):
        hand = SCENARIOS / "policy_moving_target"
        for hidden, end in (("[1.5, 1.56]", "released"), ("[1.5, 1.58]", "unseen"), ("[0, 3]", "unseen")):
            with self.subTest(hidden=hidden):
                result, log = self.run_it(f"conveyor.camera.hidden_s={hidden}", "expect={}", scenario=hand, code=None)
                self.assertEqual(result["conveyor_ends"], [end])
                self.assertNotIn("fault", log)
        self.assertNotIn("begins to follow", log, "of a target that was never seen")

    def test_a_hand_is_expected_to_turn_before_its_target_leaves_the_window(self):
        """The second move is planned while the target moves at 100 mm/s, and takes 2 s."""
        hand = SCENARIOS / "policy_moving_target"
        turns = "{at_s=0.5, speed_mm_s=100}, {at_s=0.9, speed_mm_s=-100}, {at_s=1.6, speed_mm_s=80}"
        for window, end in (([-60, 60], "released"), ([-25, 25], "window")):
            settings = (
                f"conveyor.speed=[{turns}, {{at_s=2.2, speed_mm_s=0}}]",
                f"conveyor.window_mm={window}",
                "expect={}",
            )
            result, _ = self.run_it(*settings, scenario=hand, code=None)
            self.assertEqual(result["conveyor_ends"], [end])

    def test_a_refused_network_leaves_the_run_without_one(self):
        plain, _ = self.run_it("conveyor.policy.percent=0", code=1)
        refused, _ = self.run_it(scenario=SCENARIOS / "policy_corrupt_weights")
        self.assertEqual(refused["sha256"], plain["sha256"])


if __name__ == "__main__":
    main()
