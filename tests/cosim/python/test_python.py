"""The module armature: its runs are those of the command line."""

import csv
import gc
import json
import signal
import threading
import time

import numpy
from cli_program import SCENARIOS, TINY, Program, main

import armature

STILL = ["move=[]", "expect={}"]  # without moves and expectations


def still(name="jog", duration_s=0.3, **options):
    return armature.Scenario(SCENARIOS / name, set=[*STILL, f"duration_s={duration_s}"], engine="model", **options)


class Runs(Program):
    def test_a_run_has_the_summary_of_the_command_line(self):
        self.armature("run", TINY, "--path", SCENARIOS, "--set", "seed=7", "--out", "out")
        wanted = json.loads((self.folder / "out/summary.json").read_text())
        got = armature.run(str(TINY), set=["seed=7"], engine="model", search=[str(SCENARIOS)])
        for summary in (got, wanted):
            del summary["host"]
            for key in ("golden", "golden_text"):
                del summary["result"][key]
        self.assertEqual(got, wanted)

    def test_the_engine_and_the_steps_change_no_bit(self):
        digests = set()
        for engine in ("model", "rtl"):
            for step_ms in (0.0123, 1, 1000):
                run = armature.Run(armature.Scenario(TINY, engine=engine, search=[SCENARIOS]))
                while run.advance(step_ms):
                    pass
                digests.add(run.digest)
        self.assertEqual(digests, {armature.Scenario(TINY, search=[SCENARIOS]).golden_sha256})

    def test_a_seed_replaces_that_of_the_scenario(self):
        def digest(seed, *set):
            run = armature.Run(armature.Scenario(SCENARIOS / "encoder_noise_sweep", set=set, engine="model"), seed=seed)
            run.advance_to_end()
            return run.digest

        self.assertEqual(digest(5), digest(None, "seed=5"))
        self.assertNotEqual(digest(5), digest(6))

    def test_a_step_ends_in_its_cycle(self):
        run = armature.Run(still(), every_ticks=10)
        self.assertTrue(run.advance(1))
        self.assertEqual(run.time_s, 0.001)
        run.advance_ticks(20)
        self.assertEqual(run.time_s, 0.002)
        self.assertFalse(run.advance_to_end())
        self.assertTrue(run.over)
        self.assertEqual(list(run.trace("tick")[:3]), [0, 10, 20])

    def test_two_threads_run_at_the_same_time_but_not_in_one_run(self):
        run = armature.Run(still("jog", 2))
        other = threading.Thread(target=run.advance_to_end)
        other.start()
        with self.assertRaisesRegex(RuntimeError, "another thread uses this run"):
            while not run.over:
                time.sleep(0.001)
            raise AssertionError("the run was over at once")
        other.join()
        alone = armature.Run(still("jog", 2))
        alone.advance_to_end()
        self.assertEqual(run.digest, alone.digest)

    def test_ctrl_c_ends_a_step(self):
        run = armature.Run(still("jog", 30), every_ticks=100_000)
        signal.setitimer(signal.ITIMER_REAL, 0.05)
        self.addCleanup(signal.signal, signal.SIGALRM, signal.signal(signal.SIGALRM, signal.default_int_handler))
        with self.assertRaises(KeyboardInterrupt):
            run.advance_to_end()
        self.assertTrue(run.finish()["result"]["interrupted"])


class Traces(Program):
    def test_the_columns_are_those_of_the_trace_file(self):
        move = "move=[{at_s=0.01,type='joint',target_deg=[5,-5,0,0,30,0]}]"
        set = [move, "expect={}", "duration_s=0.3", "trace.tcp=true"]
        settings = [word for setting in (*set, "trace.every_ticks=1") for word in ("--set", setting)]
        self.armature("run", SCENARIOS / "jog", *settings, "--out", "out")
        with (self.folder / "out/trace.csv").open() as file:
            rows = list(csv.DictReader(file))
        run = armature.Run(armature.Scenario(SCENARIOS / "jog", set=set, engine="model"))
        run.advance_to_end()
        self.assertGreater(numpy.abs(run.trace("cmd_pulses")).max(), 1000)
        for column in run.columns:
            got = run.trace(column)
            self.assertEqual(len(got), len(rows))
            names = [column]
            if column.startswith("tcp_"):
                names = [column.replace("_mm", f"_{letter}_mm") for letter in "xyz"]
            elif got.ndim == 2:
                names = [f"j{axis}_{column}" for axis in range(1, 7)]
            wanted = [[row[name] for name in names] for row in rows]
            if column == "state":
                self.assertEqual([[armature.STATES[state]] for state in got], wanted)
            else:
                wanted = numpy.array(wanted, dtype=float).reshape(got.shape)
                numpy.testing.assert_allclose(got, wanted, rtol=0, atol=0 if got.dtype == numpy.int64 else 5.1e-7)

    def test_an_array_is_a_view_of_the_run_that_nobody_can_write(self):
        run = armature.Run(still())
        run.advance(10)
        first = run.trace("enc_deg")
        self.assertFalse(first.flags.owndata or first.flags.writeable)
        with self.assertRaises(ValueError):
            first[0] = 1
        run.advance(10)
        second = run.trace("enc_deg")
        self.assertEqual((len(first) + 200, first.ctypes.data), (len(second), second.ctypes.data))

    def test_an_array_keeps_its_values_when_the_run_goes_back_or_is_gone(self):
        run = armature.Run(still())
        start = run.snapshot()
        run.advance(200)
        ticks = run.trace("tick")
        run.restore(start)
        self.assertEqual(len(run.trace("tick")), 0)
        self.assertEqual(len(ticks), ticks[-1] + 1)
        del run
        gc.collect()
        filler = [numpy.full(100_000, -1) for _ in range(20)]
        numpy.testing.assert_array_equal(ticks, numpy.arange(len(ticks)))
        del filler

    def test_an_unknown_column_is_a_key_error(self):
        with self.assertRaisesRegex(KeyError, "no column speed"):
            armature.Run(still()).trace("speed")


class Commands(Program):
    def test_jogs_give_the_run_of_a_scenario_that_has_them(self):
        self.armature("run", SCENARIOS / "jog", "--set", "expect={}", "--set", "duration_s=0.3", "--set",
                      "move=[{at_s=0.02,type='jog',joint_deg_s=[30,0,0,0,0,-10],duration_s=0.1},"
                      "{at_s=0.1,type='jog',joint_deg_s=[0,5,0,0,0,0],duration_s=0.1,accel_percent=50}]",
                      "--out", "out")  # fmt: skip
        wanted = json.loads((self.folder / "out/summary.json").read_text())["result"]
        run = armature.Run(still())
        run.advance(20)
        run.jog([30, 0, 0, 0, 0, -10], 0.1)
        run.advance(80)
        run.jog(numpy.array([0, 5, 0, 0, 0, 0]), 0.1, accel_percent=50)
        run.advance_to_end()
        got = run.finish()["result"]
        self.assertEqual(got["sha256"], wanted["sha256"])
        self.assertEqual(got["jogs"], wanted["jogs"])
        self.assertGreater(got["final_joint_deg"][0], 1)

    def test_a_stream_moves_the_joints_and_the_tool(self):
        run = armature.Run(still(duration_s=0.6))
        run.advance(20)
        for i in range(101):
            run.set_point([i * 0.01, 0, 0, 0, 30 * (i / 100) ** 2, 0], last=i == 100, delay_ms=3)
            run.advance(1)
        run.advance(200)
        self.assertAlmostEqual(run.trace("enc_deg")[-1, 0], 1, places=2)
        run.set_pose([1e4, 0, 0, 0, 0, 0])  # out of reach
        run.advance(1)
        self.assertEqual((run.refused, run.last_refusal), (1, "unreachable"))

    def test_a_velocity_of_the_tool_moves_it(self):
        move = "move=[{at_s=0.01,type='joint',target_deg=[0,10,10,0,60,0]}]"
        set = [move, "expect={}", "duration_s=1", "trace.tcp=true"]
        run = armature.Run(armature.Scenario(SCENARIOS / "jog", set=set, engine="model"))
        run.advance(480)
        start = run.trace("tcp_enc_mm")[-1]
        run.jog_tool([0, 0, 50], [0, 0, 0], 0.1)
        run.advance(400)
        moved = run.trace("tcp_enc_mm")[-1] - start
        self.assertGreater(moved[2], 2)
        self.assertLess(numpy.abs(moved[:2]).max(), 0.1)

    def test_what_is_wrong_is_an_input_error(self):
        run = armature.Run(still())
        with self.assertRaisesRegex(armature.InputError, r"^joint_deg_s: expected 6 numbers"):
            run.jog([1, 2], 0.1)
        with self.assertRaisesRegex(ValueError, r"jog: joint_deg_s\[1\]: .* found nan"):
            run.jog([1, numpy.nan, 0, 0, 0, 0], 0.1)
        with self.assertRaisesRegex(ValueError, "advance: expected 0 to 1e9 ms"):
            run.advance(-1)

    def test_a_snapshot_is_reached_again(self):
        scenario = still()
        run = armature.Run(scenario, seed=3)
        run.advance(12)
        run.jog([20] * 6, 0.05)
        run.advance(13.37)
        snapshot, digest, angles = run.snapshot(), run.digest, run.trace("enc_deg")
        run.jog([-20] * 6, 0.05)
        run.advance(50)
        self.assertNotEqual(run.digest, digest)
        run.restore(snapshot)
        self.assertEqual((run.digest, run.time_s, snapshot.sent), (digest, snapshot.time_s, 1))
        numpy.testing.assert_array_equal(run.trace("enc_deg"), angles)


class Errors(Program):
    def test_a_wrong_scenario_names_file_line_and_key(self):
        path = self.folder / "wrong/scenario.toml"
        path.parent.mkdir()
        text = (SCENARIOS / "jog/scenario.toml").read_text()
        path.write_text(text.replace("duration_s = 5.2", "duration_s = -1").replace("seed = 1", "sead = 1"))
        with self.assertRaises(armature.InputError) as caught:
            armature.Scenario(path, search=[SCENARIOS])
        self.assertIsInstance(caught.exception, ValueError)
        done = self.armature("run", path, "--path", SCENARIOS, code=2)
        for problem, (line, key) in zip(caught.exception.problems, [(4, "duration_s"), (5, "sead")], strict=True):
            self.assertEqual((problem["file"], problem["line"], problem["key"]), (str(path), line, key))
            self.assertIn(f"{path}:{line}:{problem['column']}: {key}: ", str(caught.exception))
            self.assertIn(problem["text"], done.stderr)

    def test_a_word_of_no_engine_is_refused(self):
        with self.assertRaisesRegex(armature.InputError, "engine: unknown word: fast"):
            armature.Scenario(TINY, engine="fast", search=[SCENARIOS])


if __name__ == "__main__":
    main()
