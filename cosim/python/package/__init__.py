"""Runs of the co-simulation of armature, for those who train, measure or test in Python.

armature.run("scenarios/fig9_joint_move")["result"]["sha256"] is what `armature run` writes into summary.json. A Run is
advanced in steps; see the folder's README.
"""

import json

from . import _core
from ._core import STATES, InputError, Scenario, Snapshot

__all__ = ["STATES", "InputError", "Run", "Scenario", "Snapshot", "run"]


class Run(_core.Run):
    """A run of a scenario.

    Run(scenario, *, seed=None, every_ticks=1, compare_golden=False). `seed` replaces that of the scenario, for noise and
    jitter. `every_ticks`: of the rows of the trace, those whose tick is a multiple of it are kept. A row takes 400 bytes.

    A run does not depend on the steps in which it is advanced. A tick is 50 us.

    advance(ms), advance_ticks(ticks), advance_to_end()
        Continue; false when the run is over. Other threads of Python go on meanwhile.
    trace(column)
        The rows so far: a read-only array of the run's own memory. `columns` are their names: tick, time_s, state (an
        index of STATES), and of six axes cmd_pulses, pin_pulses, enc_counts, corr_pulses, ref_deg, enc_deg; tcp_ref_mm
        and tcp_enc_mm, if the scenario records them. An array keeps its rows and never grows: later rows need a new one,
        which begins at the same memory. It keeps this memory until it is deleted, also after the run.
    jog(joint_deg_s, duration_s, accel_percent=100), jog_tool(mm_s, deg_s, duration_s, frame="base")
        Send a velocity: the next one replaces it, and without one the arm comes to rest after duration_s [s].
    set_point(joints_deg, *, last=False, delay_ms=10), set_pose(xyz_mm_rpy_deg, *, last=False, delay_ms=10)
        Send a set-point of a stream, which the arm follows delay_ms later. A set-point that is not there when it is needed
        stops the arm.
    snapshot(), restore(snapshot)
        Go back to an earlier time of a run of the same scenario and seed, by repeating the run up to it.
    time_s, over, digest, refused, last_refusal
        Simulated time; whether the run is over; SHA-256 of the rows so far, as in summary.json; how many commands the
        controller has refused, and why the last one.
    """

    def finish(self):
        """Ends the run and returns what is in summary.json, as a dict. A run that is not over ends as interrupted.
        `host` has no times. Afterwards only the trace and the properties can be used, or a snapshot restored."""
        return json.loads(self.finish_json())


def run(where, *, set=(), engine=None, variant=None, search=(), compare_golden=False):  # the names of the command line
    """Runs a scenario to its end and returns what is in summary.json, as a dict.

    `where`: folder or file of the scenario. `set`: texts as those of --set. `engine`: model, rtl or lockstep; `variant`:
    counts or paper; None: that of the scenario. `search`: folders with more robots, as those of --path. Raises InputError,
    a ValueError, when the scenario is wrong: its text has a line FILE:LINE:COLUMN: KEY: MESSAGE for each problem, and its
    attribute `problems` a dict.
    """
    scenario = Scenario(where, set=list(set), engine=engine, variant=variant, search=list(search))
    run = Run(scenario, every_ticks=1_000_000, compare_golden=compare_golden)
    run.advance_to_end()
    return run.finish()
