"""armature-iss flips --in memory: random bits of the memory of the cores."""

import json
import pathlib
import re
import sys

sys.path.insert(0, str(pathlib.Path(__file__).parents[1] / "cli"))
from cli_program import TINY, Program, main

PARTS = {"code", "data", "variables", "page table", "stack of core 0", "stack of core 1", "host memory"}
CHARGED = ("--cpu", "a9", "--set", "cpu.cpi=1.5", "--set", "expect={}")


class MemoryFlips(Program):
    def flips(self, *options, code=None):
        return self.armature("flips", TINY, "--in", "memory", "--seed", "3", *options, code=code)

    def counts(self, table):
        return {part: sum(row["outcomes"].values()) for part, row in table["parts"].items()}

    def test_each_part_has_its_bits_and_shards_give_the_whole(self):
        whole = json.loads(self.flips("--bits", "2", "--jobs", "2", "--json").stdout)
        self.assertEqual(self.counts(whole), dict.fromkeys(PARTS, 2))
        for i in range(2):
            self.flips("--bits", "2", "--shard", f"{i}/2", "--result", f"{i}.json", "-q")
        merged = json.loads(self.armature("flips", "--merge", "0.json", "1.json", "--json", code=None).stdout)
        self.assertEqual(merged, whole)

    def test_a_part_alone(self):
        table = json.loads(self.flips("--bits", "3", "--part", "code", "--json").stdout)
        self.assertEqual(self.counts(table), {"code": 3})
        refused = self.flips("--bits", "3", "--part", "coed", code=2)
        self.assertIn("--part: nothing to flip", refused.stderr)

    def test_the_fault_of_a_scenario(self):
        """The first instruction that both cores execute in each tick becomes one that there is not."""
        place = 'at_s=0.01,kind="memory_flip",symbol="armature_charge",bit=28'
        done = self.armature("run", TINY, *CHARGED, "--set", f"fault=[{{{place}}}]", "--out", "out", code=None)
        self.assertRegex(done.stdout, r"servo enables dropped +watchdog|controller_silent")
        self.assertIn("memory_flip of bit 28 at armature_charge+0", done.stdout)
        wrong = self.armature(
            "run", TINY, *CHARGED, "--set", f'fault=[{{{place.replace("charge", "change")}}}]', code=2
        )
        self.assertRegex(wrong.stderr, r'symbol.*found "armature_change", did you mean "armature_charge"')

    def test_the_host_has_no_such_memory(self):
        place = 'fault=[{at_s=0.01,kind="memory_flip",symbol="page_table",bit=2}]'
        refused = self.armature("run", TINY, "--set", place, code=2)
        self.assertIn('needs processor = "a9" and cpi in [cpu]', re.sub(r"\s+", " ", refused.stderr))


if __name__ == "__main__":
    main()
