"""armature run with faults: a run in which a stop had no effect, or in which ticks are missing, does not pass."""

import json
import random
import subprocess

from cli_program import SCENARIOS, Program, main
from vcd import Vcd

DURATION_S = 0.03
TICK_S = 50e-6
SCENARIO = f"""description = "An arm at rest, or in a move"
robot = "vo2021_6r"
duration_s = {DURATION_S}
[trace]
every_ticks = 1
"""
MOVE = '[[move]]\nat_s = 0.002\ntype = "joint"\ntarget_deg = [3, 0, 0, 0, 0, 0]\n'
HANG = '[[fault]]\nat_s = 0.01\nkind = "block_hang"\nclock = "motion"\n'
ESTOP = '[[fault]]\nat_s = 0.012\nkind = "estop"\nduration_s = 0.002\n'
STOPPED_CLOCK = '[[fault]]\nat_s = 0.01\nkind = "clock_stop"\nduration_s = 0.01\n'
LOST_RUN = '[[fault]]\nat_s = 0.005\nkind = "stray_write"\naddress = 0x43C10004\ndata = 0x3F\n'
CTRL_WORDS = [0x00, 0x3F, 0x13F, 0x100, 0x101, 0x01]


class Faults(Program):
    def scenario(self, tables):
        (self.folder / "s").mkdir(exist_ok=True)
        (self.folder / "s/scenario.toml").write_text(SCENARIO + tables)
        return "s", "--path", SCENARIOS, "--out", "out"

    def run_any(self, *arguments):
        """With any exit code."""
        return subprocess.run([self.path, *map(str, arguments)], cwd=self.folder, text=True, capture_output=True)

    def result(self):
        return json.loads((self.folder / "out/summary.json").read_text())["result"]

    def test_an_emergency_stop_that_drops_no_servo_enable_fails_the_run(self):
        done = self.armature("run", *self.scenario(HANG + ESTOP), code=1)
        self.assertIn("expect.unanswered_faults: expected 0, as it is not stated, got 2", done.stdout)
        self.assertIn("block_hang of clock motion, 0.010000 s; estop for 0.002 s, 0.012000 s", done.stdout)
        self.assertIn("expect.missing_ticks: expected 0, as it is not stated, got 400", done.stdout)
        self.assertEqual([fault["answered"] for fault in self.result()["injected_faults"]], [False, False])

    def test_servos_that_stay_on_fail_the_run_whatever_is_stated(self):
        stated = "[expect]\nunanswered_faults = 2\nmissing_ticks = 400\n"
        done = self.armature("run", *self.scenario(HANG + ESTOP + stated), code=1)
        self.assertIn("missed_stop: expected none, in any run, got the stop by estop: the servos stay on", done.stdout)
        # A relay takes the power away.
        relay = 'outcome = "fault:controller_silent"\n'
        tables = f"{HANG}{ESTOP}[expect]\nmissing_ticks = 400\n{relay}"
        self.armature("run", *self.scenario(tables), "--set", "drop_out_us=500")

    def test_servos_that_stay_on_after_an_error_response_fail_the_run_whatever_is_stated(self):
        error = '[[fault]]\nat_s = 0.012\nkind = "slave_error"\naddress = 0x43C10008\ncount = 1\n'
        stated = '[expect]\nbus_error = "SLVERR"\nunanswered_faults = 0\nmissing_ticks = 400\nunderruns = 0\n'
        hang = HANG.replace("0.01\n", "0.0121\n")  # core 0 has stopped, the watchdog has not
        done = self.armature("run", *self.scenario(error + hang + stated), code=1)
        self.assertIn("got the stop by core 0 stopped: the servos stay on", done.stdout)

    def test_an_emergency_stop_within_a_stopped_clock_fails_the_run(self):
        done = self.armature("run", *self.scenario(STOPPED_CLOCK + ESTOP), code=1)
        self.assertIn("expect.missing_ticks: expected 0, as it is not stated, got 200", done.stdout)
        self.assertIn("expect.outcome: expected completed, got fault:clock", done.stdout)
        # The controller drops the servo enables when the clock runs again.
        stop = self.result()["injected_faults"][1]
        self.assertAlmostEqual((stop["servo_off_cycle"] - stop["cycle"]) * 20e-9, 0.008, delta=2 * TICK_S)

    def test_a_stray_write_does_not_take_the_watchdog_from_a_drive_that_is_on(self):
        late = '[[fault]]\nat_s = 0.02\nkind = "slow_core"\ncompute_us = 1000000\n'
        done = self.armature("run", *self.scenario(MOVE + LOST_RUN + late), code=1)
        # The bus refuses the write, which stops core 1. The watchdog sees that core 0 hangs later.
        self.assertIn("expect.bus_error: expected none, as it is not stated, got SLVERR", done.stdout)
        self.assertIn("expect.outcome: expected completed, got fault:controller_silent", done.stdout)
        write, hang = self.result()["injected_faults"]
        self.assertTrue(write["answered"])
        self.assertIsNone(write["servo_off_cycle"])
        self.assertAlmostEqual((hang["servo_off_cycle"] - hang["cycle"]) / 2500, 4, delta=1.1)  # ticks

    def random_fault(self, rng):
        kind = rng.choice(["estop", "estop", "clock_stop", "block_hang", "stray_write"])
        lines = ["[[fault]]", f"at_s = {rng.uniform(0.003, 0.025):.6f}", f'kind = "{kind}"']
        if kind == "block_hang":
            lines.append(f'clock = "{rng.choice(["io", "motion", "encoder"])}"')
        elif kind == "stray_write":
            lines += ["address = 0x43C10004", f"data = {rng.choice(CTRL_WORDS)}"]
        else:
            lines.append(f"duration_s = {rng.uniform(0.0001, 0.02):.6f}")
        return kind, "\n".join(lines) + "\n"

    def stated(self, tables):
        """[expect] with everything that a run gives by itself, but not what this test is about."""
        self.run_any("run", *self.scenario(tables))
        result = self.result()
        lines = ["[expect]"]
        stated = {key: result[key] for key in ("outcome", "stopped_by", "underruns")}
        stated["faults"] = [fault["cause"] for fault in result["faults"]]
        stated["bus_error"] = next((abort["error"] for abort in result["bus_aborts"]), "none")
        stated["unfinished_moves"] = result["moves_waiting"] + result["moves_under_way"]
        lines += [f"{key} = {json.dumps(value)}" for key, value in stated.items() if value is not None]
        return "\n".join(lines) + "\n"

    def test_no_run_with_random_faults_passes_with_a_stop_without_effect_or_missing_ticks(self):
        seed = 20261125
        rng = random.Random(seed)
        passed, cases = 0, 12
        for case in range(cases):
            faults = [self.random_fault(rng) for _ in range(rng.choice([1, 1, 2]))]
            tables = (MOVE if rng.random() < 0.5 else "") + "".join(text for _, text in faults)
            tables += self.stated(tables)
            window = ("--vcd", "end.vcd", "--from", DURATION_S - 2 * TICK_S, "--to", DURATION_S)
            with self.subTest(seed=seed, case=case, tables=tables):
                run = self.run_any("run", *self.scenario(tables), *window)
                self.assertIn(run.returncode, (0, 1), run.stdout + run.stderr)
                if run.returncode:
                    continue
                passed += 1
                self.assertGreaterEqual(len(self.rows("out/trace.csv")), DURATION_S / TICK_S - 2)
                if any(kind == "estop" for kind, _ in faults):
                    wave = Vcd((self.folder / "end.vcd").read_text())
                    self.assertEqual(wave.at("top.arm_soc.servo_on_o", wave.times[-1]), 0)
        print(f"seed {seed}: {passed} of {cases} runs with faults passed")
        self.assertGreater(passed, 0)


if __name__ == "__main__":
    main()
