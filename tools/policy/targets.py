"""Held-out targets: belts whose speed changes at random, and the arms that follow them.

The belts have the ranges of those of training (cosim/train/belt_examples.cpp). They come from another generator, so that
none of them is a belt of training: Python's Mersenne Twister, and not SplitMix64. A target depends on seed and number only.
"""

import pathlib
import random
import re
from dataclasses import dataclass

HERE = pathlib.Path(__file__).resolve().parent
SCENARIOS = HERE.parents[1] / "scenarios"
SCENARIO = SCENARIOS / "policy_conveyor"
DURATION_S = 2.0
FOLLOWED_S = (1.05, 1.9)  # the speed changes in this time: the arm has reached the part, and has not left it
BEGIN_MM_S = (110, 130)  # until then: so the part is at its window when the arm is there
SPEED_MM_S = (0, 200)  # as in training, and likewise:
CHANGE_S = (0.1, 0.4)
LEAST_ACCEL = 500
WAVE_MM = (0, 0.3)
WAVE_LENGTH_MM = (300, 600)


@dataclass(frozen=True)
class Arm:
    """An arm with its drives. The network is trained for their lag."""

    name: str
    title: str
    dynamic: bool
    lead_ms: float
    robot: str
    frame_accel: int  # of the frame that follows the belt, mm/s^2
    most_accel: int  # of the belts
    yaw_deg: int  # of the tool: so that joint 6 need not turn far
    network: pathlib.Path


VO = ("vo2021_6r_dynamic", 3000, 1500, 0, HERE / "vo2021_6r_dynamic.policy")
ARMS = (
    Arm("irb120", "IRB 120, ideal plant", False, 5.305, "abb_irb120", 4000, 4000, 180, SCENARIO / "belt.policy"),
    Arm("vo_ideal", "Vo 2021, ideal plant", False, 21.22, *VO),
    Arm("vo_dynamic", "Vo 2021, full plant", True, 21.45, *VO),  # the smoothing and the current loop add 0.2 ms
)


def without_dynamics(text):
    """A robot file with the ideal plant: the same axes and drives, without motors, gears and links."""
    tables = re.split(r"^(?=\[)", text, flags=re.M)
    kept = [table for table in tables if not re.match(r"\[(\w+\.)?dynamics\]|\[\[link\]\]|\[tool\]", table)]
    return "".join(kept).replace('plant = "dynamic"', 'plant = "ideal"')


def robot_of(arm, folder):
    """The robot as scenarios name it. A file of it is written into `folder` if there is none."""
    robot = SCENARIOS / "robots" / f"{arm.robot}.toml"
    text = robot.read_text()
    if arm.dynamic or 'plant = "dynamic"' not in text:
        return str(robot)
    ideal = pathlib.Path(folder) / f"{arm.robot}_ideal.toml"
    ideal.write_text(without_dynamics(text).replace(f'name = "{arm.robot}"', f'name = "{ideal.stem}"'))
    return str(ideal)


def settings_of_belt(arm, seed, number):
    """Of [conveyor], as texts of --set."""
    draw = random.Random(f"belt {number} of seed {seed}")

    def between(low, high):
        return round(draw.uniform(low, high), 3)

    begin, accel = between(*BEGIN_MM_S), between(LEAST_ACCEL, arm.most_accel)
    changes, at_s = [], FOLLOWED_S[0]
    while at_s < FOLLOWED_S[1]:
        changes.append(f"{{at_s={at_s:.3f}, speed_mm_s={between(*SPEED_MM_S)}}}")
        at_s += between(*CHANGE_S)
    return [
        f"conveyor.speed_mm_s={begin}",
        f"conveyor.belt_accel_mm_s2={accel}",
        f"conveyor.speed=[{', '.join(changes)}]",
        f"conveyor.wave_mm={between(*WAVE_MM)}",
        f"conveyor.wave_length_mm={between(*WAVE_LENGTH_MM)}",
    ]


def settings_of_arm(arm, robot):
    """The arm waits above the belt, goes to the part, moves slowly along it, and leaves it."""
    rpy_deg = [180, 0, arm.yaw_deg]
    on_part = 'at_s=0.02, type="line", frame="conveyor", accel_mm_s2=1000'
    moves = (
        f'at_s=0.01, type="joint", xyz_mm=[380, -130, 260], rpy_deg={rpy_deg}',
        f"{on_part}, xyz_mm=[0, 0, -40], speed_mm_s=200",
        f"{on_part}, xyz_mm=[20, 0, -40], speed_mm_s=40",
        f'at_s=0.02, type="joint", xyz_mm=[380, 50, 260], rpy_deg={rpy_deg}',
    )
    return [
        f'robot="{robot}"',
        f"duration_s={DURATION_S}",
        "expect={}",
        f"conveyor.lead_ms={arm.lead_ms}",
        f"conveyor.accel_mm_s2={arm.frame_accel}",
        "conveyor.window_mm=[100, 400]",
        f"conveyor.rpy_deg={rpy_deg}",
        f"move=[{', '.join('{' + move + '}' for move in moves)}]",
        f'conveyor.policy.file="{arm.network}"',
    ]
