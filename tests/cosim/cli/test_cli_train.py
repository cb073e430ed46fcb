"""armature train, and runs with the network that it makes."""

import json
import re
import shlex

from cli_program import SCENARIOS, Program, main

SCENARIO = SCENARIOS / "policy_conveyor"


class Train(Program):
    def run_it(self, *settings, code=0):
        arguments = [word for setting in settings for word in ("--set", setting)]
        self.armature("run", SCENARIO, "--engine", "model", "--out", "out", *arguments, code=code)
        result = json.loads((self.folder / "out/summary.json").read_text())["result"]
        return result, (self.folder / "out/log.txt").read_text()

    def test_the_command_in_the_network_of_the_scenario_makes_the_same_bytes(self):
        text = (SCENARIO / "belt.policy").read_text()
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
        logic, _ = self.run_it()
        arm, _ = self.run_it('conveyor.policy.on="arm"')
        self.assertEqual(logic["sha256"], arm["sha256"])

    def test_without_a_correction_the_tracking_error_is_larger(self):
        result, _ = self.run_it("conveyor.policy.percent=0", code=1)
        corrected, _ = self.run_it()
        self.assertGreater(result["tracking_error"]["mm"], 1.5 * corrected["tracking_error"]["mm"])

    def with_policy(self, change):
        """A copy of the scenario whose network is changed."""
        folder = self.folder / "s"
        folder.mkdir()
        for name in ("scenario.toml", "golden.csv"):
            (folder / name).write_text((SCENARIO / name).read_text())
        (folder / "belt.policy").write_text(change((SCENARIO / "belt.policy").read_text()))
        return folder

    def check_uncorrected(self, change, *settings):
        folder = self.with_policy(change)
        plain, _ = self.run_it("conveyor.policy.percent=0", code=1)
        for where in ("logic", "arm"):
            self.armature("run", folder, "--path", SCENARIOS, "--engine", "model", "--out", "out",
                          "--set", f'conveyor.policy.on="{where}"', code=1)  # fmt: skip
            result = json.loads((self.folder / "out/summary.json").read_text())["result"]
            self.assertEqual(result["corrected_ticks"], 0)
            self.assertGreater(result["uncorrected_ticks"], 20_000)
            self.assertEqual(result["sha256"], plain["sha256"])

    def test_a_flipped_bit_of_a_weight_switches_the_network_off(self):
        self.check_uncorrected(lambda text: re.sub(r"(image \w{8} \w{8} \w{8} )0", r"\g<1>1", text, count=1))

    def test_a_belt_outside_the_ranges_of_training_is_not_corrected(self):
        self.check_uncorrected(lambda text: re.sub(r"^input -21.*$", "input 500 600", text, flags=re.M))


if __name__ == "__main__":
    main()
