"""[cpu] cpi: the instructions of the firmware take time."""

import json
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).parents[1] / "cli"))
from cli_program import TINY, Program, main

CPI = 1.5
CLOCKS_OF_CYCLE = 2e9 / 3 / 50e6  # of a core in a cycle of the logic
CHARGED = ("--cpu", "a9", "--set", f"cpu.cpi={CPI}", "--set", "trace.every_ticks=1")


class ChargedInstructions(Program):
    def run_on(self, engine, *options):
        self.armature("run", TINY, "--engine", engine, *CHARGED, *options, "--out", engine, code=None)
        return {name: (self.folder / engine / name).read_bytes() for name in ("trace.csv", "load.csv", "log.txt")}

    def test_each_engine_gives_the_same_bytes(self):
        """On the RTL no tick is whole, and core 0 runs ahead less."""
        self.assertEqual(self.run_on("model"), self.run_on("rtl"))

    def test_a_core_is_awake_for_its_instructions_and_its_accesses(self):
        self.run_on("model")
        for row in self.rows("model/load.csv")[1:]:
            computed = int(row["core0_awake_cycles"]) - int(row["core0_bus_cycles"])
            # The last instructions, before it sleeps, may be counted in the tick before their time has passed.
            self.assertAlmostEqual(int(row["core0_instructions"]) * CPI / CLOCKS_OF_CYCLE, computed, delta=2, msg=row)
        most = json.loads((self.folder / "model/summary.json").read_text())["result"]["max_tick_instructions"]
        self.assertEqual(most, max(int(row["core0_instructions"]) for row in self.rows("model/load.csv")[1:]))

    def test_a_fault_adds_its_time(self):
        fault = ("--set", 'fault=[{at_s=0.01,kind="slow_core",compute_us=20}]', "--set", "expect={}")
        self.run_on("model", *fault)
        slow = [int(row["core0_awake_cycles"]) for row in self.rows("model/load.csv")]
        self.assertGreater(min(slow[300:]), max(slow[1:150]) + 500)


if __name__ == "__main__":
    main()
