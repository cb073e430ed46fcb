"""Runs of the held-out targets on the model engine, several at a time. The order of the results does not depend on that."""

import multiprocessing
import resource
from dataclasses import dataclass

import armature
from targets import robot_of, settings_of_arm, settings_of_belt


@dataclass(frozen=True)
class Way:
    """A controller: its settings of [conveyor.policy] besides the file."""

    title: str
    settings: tuple[str, ...]


WAYS = {
    "baseline": Way("baseline", ("conveyor.policy.percent=0",)),
    "arm": Way("network on ARM", ('conveyor.policy.on="arm"',)),
    "logic": Way("network in logic", ('conveyor.policy.on="logic"',)),
}


@dataclass(frozen=True)
class Followed:
    """How a run has followed its part."""

    end: str  # why it stopped following; "never" when it did not begin
    rms_mm: float | None  # of the tool by its encoders; None: the arm was never synchronised for so long
    worst_mm: float | None
    corrected: int  # ticks
    uncorrected: int
    sha256: str  # of all ticks


@dataclass(frozen=True)
class Speed:
    """What runs have cost."""

    runs: int
    simulated_s: float  # of each
    processor_s: float


def run_target(arm, robot, seed, number, more=()):
    settings = [*settings_of_arm(arm, robot), *settings_of_belt(arm, seed, number), *more]
    result = armature.run(arm.kind.scenario, set=settings, engine="model")["result"]
    if result["failure"]:
        raise RuntimeError(f"target {number} of {arm.name}: {result['failure']}")
    ends, worst = result["conveyor_ends"], result["tracking_error"]
    return Followed(
        end=ends[0] if ends else "never",
        rms_mm=result["rms_tracking_error_mm"],
        worst_mm=worst["mm"] if worst else None,
        corrected=result["corrected_ticks"],
        uncorrected=result["uncorrected_ticks"],
        sha256=result["sha256"],
    )


def _run_one(task):
    arm, robot, seed, number, way = task
    return run_target(arm, robot, seed, number, WAYS[way].settings)


def run_all(arm, targets, seed, jobs, folder):
    """{way: [Followed of each target]}, and what it cost."""
    robot = robot_of(arm, folder)
    tasks = [(arm, robot, seed, number, way) for way in WAYS for number in range(targets)]
    results, speed = run_each(_run_one, tasks, jobs, arm.kind.duration_s)
    return {way: results[index * targets :][:targets] for index, way in enumerate(WAYS)}, speed


def run_each(work, tasks, jobs, duration_s):
    """The results of work(task), a run of `duration_s` each, in the order of the tasks; and what they cost."""
    processor_s = _processor_s()
    pool = multiprocessing.Pool(jobs)
    results = pool.map(work, tasks, chunksize=4)
    pool.close()
    pool.join()
    return results, Speed(len(tasks), duration_s, _processor_s() - processor_s)


def _processor_s():
    """Of the processes that have ended."""
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime
