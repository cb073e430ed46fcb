"""The module armature: its environment, its tests of goldens, and the examples of its README."""

import importlib
import re
import sys
import types
from unittest import mock

import numpy
from cli_program import ROOT, SCENARIOS, TINY, Program, main

import armature.testing
from armature.env import ArmEnv
from armature.testing import check_golden

STILL = ["move=[]", "expect={}"]  # without moves and expectations


class Environment(Program):
    def env(self, **options):
        return ArmEnv(SCENARIOS / "jog", set=[*STILL, "duration_s=3"], **options)

    def test_an_episode_reaches_its_target(self):
        env = self.env(step_ms=5)
        observation, info = env.reset(seed=1)
        self.assertEqual(observation.shape, env.observation_space.shape)
        self.assertTrue(env.observation_space.contains(observation))
        for _ in range(600):
            error = observation[12:] - observation[:6]
            observation, reward, terminated, truncated, info = env.step(numpy.clip(error * 4, -80, 80))
            self.assertEqual((type(reward), type(terminated), type(truncated), type(info)), (float, bool, bool, dict))
            if terminated or truncated:
                break
        self.assertTrue(terminated)
        self.assertEqual(info["refused"], 0)
        self.assertLess(-reward, env.tolerance_deg)

    def test_the_seed_gives_the_same_episode(self):
        def episode(seed):
            env = self.env(max_steps=40)
            observations = [env.reset(seed=seed)[0]]
            env.action_space.seed(seed)
            while True:
                observation, _, terminated, truncated, _ = env.step(env.action_space.sample() / 10)
                observations.append(observation)
                if terminated or truncated:
                    return numpy.array(observations), env.run.digest

        (first, digest), (again, same), (other, _) = episode(1), episode(1), episode(2)
        self.assertEqual((len(first), digest), (41, same))
        numpy.testing.assert_array_equal(first, again)
        self.assertFalse(numpy.array_equal(first, other))

    def test_a_fault_ends_an_episode(self):
        env = ArmEnv(SCENARIOS / "jog", set=[*STILL, "duration_s=1", "fault=[{at_s=0.03,kind='estop',duration_s=0.1}]"])
        env.reset(seed=1)
        steps = 1
        while not env.step(numpy.zeros(6))[2]:
            steps += 1
        self.assertTrue(20 <= steps <= 23, steps)


class Goldens(Program):
    def test_a_golden_is_compared(self):
        self.assertEqual(check_golden(TINY, search=[SCENARIOS])["result"]["golden"], "equal")
        with self.assertRaisesRegex(AssertionError, r"(?s)tiny_moves: .*underruns.*golden differs"):
            check_golden(TINY, set=["expect.underruns=1", "move[1].target_deg=[0,0,0,0,0,1e-3]"], search=[SCENARIOS])

    def test_a_scenario_without_a_golden_fails(self):
        folder = self.folder / "new"
        folder.mkdir()
        (folder / "scenario.toml").write_text((TINY / "scenario.toml").read_text().partition("[golden]")[0])
        with self.assertRaisesRegex(AssertionError, "new: golden none"):
            check_golden(folder, search=[SCENARIOS])

    def test_pytest_gets_a_fixture(self):
        pytest = types.ModuleType("pytest")
        pytest.fixture = lambda function: function
        with mock.patch.dict(sys.modules, pytest=pytest):
            module = importlib.reload(armature.testing)
        self.assertIs(module.armature_golden(), module.check_golden)


class Examples(Program):
    def test_the_examples_of_the_readme_do_what_they_say(self):
        text = (ROOT / "cosim/python/README.md").read_text()
        examples = re.findall(r"```python\n(.*?)```", text, re.S)
        self.assertGreater(len(examples), 2)
        for example in examples:
            with self.subTest(example.splitlines()[0]):
                exec(compile(example.replace("scenarios/", f"{SCENARIOS}/"), "README.md", "exec"), {})


if __name__ == "__main__":
    main()
