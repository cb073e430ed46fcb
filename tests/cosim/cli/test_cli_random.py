"""armature run with random valid scenarios: each ends soon, breaks no invariant and gives the same bytes again.

ARMATURE_RANDOM_SEED and ARMATURE_RANDOM_SCENARIOS choose others, and more of them.
"""

import json
import os
import random
import resource
import subprocess

from cli_program import SCENARIOS, Program, main
from random_scenario import READY, Robot, draw

SEED = int(os.environ.get("ARMATURE_RANDOM_SEED", "1"))
COUNT = int(os.environ.get("ARMATURE_RANDOM_SCENARIOS", "200"))
DRAWS_FOR_EVERY_KEY = 400
NOT_DRAWN = {
    "cpu.cpi",  # needs armature-iss
    "fault.flop",  # needs the RTL
    *("fault.symbol", "fault.offset"),  # need armature-iss
    # of a robot with plant = "dynamic"
    *("expect.final_load_deg", "expect.load_tolerance_deg"),
    *("expect.lost_motion_deg", "expect.lost_motion_tolerance_deg"),
}
# Of processor time, for at most 80 ms of simulated time: 0.1 to 0.5 s are usual.
LIMIT_S = 20
TICK_S = 50e-6


def keys_of(schema, table=""):
    """The keys that a JSON schema describes, as `table.key`."""
    found = set()
    if isinstance(schema, list):
        return found.union(*(keys_of(part, table) for part in schema))
    if not isinstance(schema, dict):
        return found
    for word, value in schema.items():
        if word != "properties":
            found |= keys_of(value, table)
            continue
        for name, part in value.items():
            if part is not False:
                key = f"{table}.{name}" if table else name
                found |= {key} | keys_of(part, key)
    return found


class RandomScenarios(Program):
    def run_it(self, name, out):
        return subprocess.run(
            [self.path, "run", f"{name}.toml", "--out", out],
            cwd=self.folder,
            text=True,
            capture_output=True,
            timeout=50 * LIMIT_S,
            preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_CPU, (LIMIT_S, LIMIT_S)),
        )

    def test_the_draws_write_every_key_of_a_scenario(self):
        robots = [Robot(SCENARIOS / "robots", name) for name in READY]
        written = set()
        for number in range(DRAWS_FOR_EVERY_KEY):
            written |= draw(random.Random(SEED * 1_000_000 + number), robots).keys
        known = keys_of(json.loads((SCENARIOS / "scenario.schema.json").read_text()))
        self.assertEqual(sorted(known - written - NOT_DRAWN), [], "keys that no scenario had")
        self.assertEqual(sorted(written - known), [], "written, but unknown")

    def test_every_one_ends_soon_and_breaks_no_invariant(self):
        (self.folder / "scenarios").symlink_to(SCENARIOS)  # for the robots
        robots = [Robot(SCENARIOS / "robots", name) for name in READY]
        for number in range(COUNT):
            seed = SEED * 1_000_000 + number
            draft = draw(random.Random(seed), robots)
            text = draft.text()
            self.text("random.toml", text)
            for name, content in draft.files.items():
                self.text(name, content)
            with self.subTest(seed=seed):
                done = self.run_it("random", "out")
                said = f"seed {seed}\n{text}\n{done.stdout}\n{done.stderr}"
                self.assertIn(done.returncode, (0, 1), said)
                result = json.loads((self.folder / "out/summary.json").read_text())["result"]
                self.assertEqual(done.returncode, 0 if result["passed"] else 1, said)
                if result["failure"] is not None and result["failure"].startswith("pendant.step["):
                    self.assertTrue(draft.has_pendant, said)
                elif result["failure"] is not None:
                    self.assertTrue(draft.may_time_out, said)
                    self.assertIn("no answer within the time-out", result["failure"], said)
                elif "the run ends here" in done.stdout:  # with its program
                    self.assertLess(result["cycles"], int(draft.duration_s * 50e6 + 0.5), said)
                else:
                    self.assertEqual(result["cycles"], int(draft.duration_s * 50e6 + 0.5), said)
                    self.assertLessEqual(result["ticks"], draft.duration_s / TICK_S, said)
                self.assertFalse((self.folder / "out/unfinished").exists(), said)
                if number % 10 == 0:
                    self.run_it("random", "again")
                    for file in ("trace.csv", "log.txt"):
                        self.assertEqual(
                            (self.folder / "out" / file).read_bytes(), (self.folder / "again" / file).read_bytes(), said
                        )


if __name__ == "__main__":
    main()
