"""Runs with wrong weights: every set-point of every run is compared with the limits of the joints."""

import pathlib
import random
import tomllib
from dataclasses import dataclass

import armature
import numpy
from armature import policy
from runs import run_each
from table import line
from targets import ARMS, SCENARIOS, robot_of, settings_of_arm, settings_of_belt

TICK_S = 50e-6
ROUNDING = 1e-6  # of the limits
ROW = 8  # bytes of a row of the image; rtl/policy_mlp/README.md
WEIGHED = ("irb120", "vo_dynamic")  # arms of the campaign
HEAD = (
    "| weights | runs | corrected ticks | uncorrected ticks | worst tracking error mm | parts given up | limits exceeded |\n"
    "|---|---:|---:|---:|---:|---:|---:|\n"
)


@dataclass(frozen=True)
class Kind:
    title: str
    change: object  # of the image, as bytes: change(draw, image)
    right_crc: bool  # the controller cannot see the change


def neuron_bytes(image):
    """Where parameters and weights of neurons are in an image: everything but the rows that begin a layer."""
    at, places = 0, []
    while True:
        head = int.from_bytes(image[at : at + ROW], "little")
        end = at + ROW * (1 + ((head & 63) + 1) * ((head >> 8 & 7) + 2))
        places += range(at + ROW, end)
        if head >> 17 & 1:
            return places
        at = end


def random_weights(draw, image):
    """Any bytes as weights, and shifts with which a neuron neither vanishes nor is always at its limit."""
    for place in neuron_bytes(image):
        image[place] = draw.randrange(256)
    at = 0
    while True:
        head = int.from_bytes(image[at : at + ROW], "little")
        neurons, stride = (head & 63) + 1, ROW * ((head >> 8 & 7) + 2)
        for neuron in range(neurons):
            parameters = at + ROW + neuron * stride
            bias = draw.randrange(-20_000, 20_000)
            image[parameters : parameters + 4] = (bias & 0xFFFFFF | draw.randrange(4, 12) << 24).to_bytes(4, "little")
        if head >> 17 & 1:
            return
        at += ROW + neurons * stride


def flip(draw, image, bits):
    for place in draw.sample(neuron_bytes(image), bits):
        image[place] ^= 1 << draw.randrange(8)


KINDS = (
    Kind("random, with their checksum", random_weights, True),
    Kind("1 to 64 bits flipped, with their checksum", lambda draw, image: flip(draw, image, draw.randint(1, 64)), True),
    Kind("1 bit flipped, with the checksum of before", lambda draw, image: flip(draw, image, 1), False),
)


def wrong_network(source, kind, draw, path):
    """Writes the file of a network whose image is changed."""
    network = policy.read(source)
    image = bytearray(network.image.astype("<u4").tobytes())
    kind.change(draw, image)
    words = numpy.frombuffer(bytes(image), dtype="<u4")
    lines = [f"full_mm {network.full_mm!r}"]
    lines += [f"input {float(low)!r} {float(high)!r}" for low, high in network.inputs]
    lines += [f"crc {policy.checksum(words) if kind.right_crc else network.crc:08x}"]
    lines += ["image " + " ".join(f"{word:08x}" for word in words[at : at + 8]) for at in range(0, len(words), 8)]
    path.write_text("\n".join(lines) + "\n")


def limits_of(arm):
    """Speed, acceleration, and range of each joint, in degrees, as the robot file has them."""
    robot = tomllib.loads((SCENARIOS / "robots" / f"{arm.robot}.toml").read_text())
    axes = [{**robot["defaults"], **axis} for axis in robot["axis"]]
    keys = ("max_speed_deg_s", "max_accel_deg_s2", "min_deg", "max_deg")
    return [numpy.array([axis[key] for axis in axes]) for key in keys]


def beyond(angles, limits):
    """What exceeds a limit first, in words; empty: nothing. `angles`: a row of set-points for each tick."""
    speed, accel, low, high = limits
    checks = {
        "speed": numpy.abs(numpy.diff(angles, axis=0)) / TICK_S / speed,
        "acceleration": numpy.abs(numpy.diff(angles, n=2, axis=0)) / TICK_S**2 / accel,
        "range": numpy.abs(angles - (low + high) / 2) / ((high - low) / 2),
    }
    for name, shares in checks.items():
        if not (shares <= 1 + ROUNDING).all():  # also what is not a number
            row, axis = numpy.argwhere(~(shares <= 1 + ROUNDING))[0]
            return f"{name} of axis {axis + 1} at row {row}"
    return ""


def _run(task):
    arm, robot, seed, kind, number, folder = task
    draw = random.Random(f"weights {kind} {number} of seed {seed}")
    network = pathlib.Path(folder) / f"{arm.name}_{kind}_{number}.policy"
    wrong_network(arm.network, KINDS[kind], draw, network)
    settings = [*settings_of_arm(arm, robot), *settings_of_belt(arm, seed, number)]
    settings.append(f'conveyor.policy.file="{network}"')
    run = armature.Run(armature.Scenario(arm.kind.scenario, set=settings, engine="model"))
    run.advance_to_end()
    problem = beyond(run.trace("ref_deg"), limits_of(arm))
    result = run.finish()["result"]
    network.unlink()
    problem = problem or result["failure"] or result["first_fault"]
    where = f"{arm.name}, kind {kind}, run {number} of seed {seed}"
    return result, f"{where}: {problem}" if problem else ""


def row(kind, outcomes):
    results = [result for result, _ in outcomes]
    worst = max((result["tracking_error"]["mm"] for result in results if result["tracking_error"]), default=0)
    ended = [result["conveyor_ends"] for result in results]
    return line([
        kind.title,
        len(results),
        sum(result["corrected_ticks"] for result in results),
        sum(result["uncorrected_ticks"] for result in results),
        f"{worst:.2f}",
        sum(ends != ["released"] for ends in ended),
        sum(bool(problem) for _, problem in outcomes),
    ])  # fmt: skip


def weights_text(runs, seed, jobs, folder):
    """The table, and how many runs are beyond a limit."""
    arms = [arm for arm in ARMS if arm.name in WEIGHED]
    tasks = [
        (arm, robot_of(arm, folder), seed, kind, number, folder)
        for kind in range(len(KINDS))
        for arm in arms
        for number in range(runs)
    ]
    outcomes, _ = run_each(_run, tasks, jobs, max(arm.kind.duration_s for arm in arms))
    each = runs * len(arms)
    rows = "".join(row(kind, outcomes[index * each :][:each]) for index, kind in enumerate(KINDS))
    problems = [problem for _, problem in outcomes if problem]
    text = f"Seed {seed}, {runs} runs of each kind with {' and with '.join(arm.title for arm in arms)}:\n\n"
    return text + HEAD + rows + "".join(f"\n{problem}\n" for problem in problems), len(problems)
