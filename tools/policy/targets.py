"""Held-out targets: belts whose speed changes at random, targets of a hand, and the arms that follow them.

They have the ranges of those of training (cosim/train/belt_examples.cpp). They come from another generator, so that
none of them is one of training: Python's Mersenne Twister, and not SplitMix64. A target depends on seed and number only.
"""

import pathlib
import random
import re
from dataclasses import dataclass

HERE = pathlib.Path(__file__).resolve().parent
SCENARIOS = HERE.parents[1] / "scenarios"
WAVE_LENGTH_MM = (300, 600)


@dataclass(frozen=True)
class Kind:
    """What the targets of an arm do, and how the arm follows them. Speeds, changes and waves are those of training."""

    scenario: pathlib.Path
    duration_s: float
    followed_s: tuple  # the speed changes in this time: the arm has reached the part, and has not left it
    begin_mm_s: tuple  # until then: a part on a belt is at its window when the arm is there
    speed_mm_s: tuple
    change_s: tuple
    least_accel: int
    wave_mm: tuple
    window_mm: tuple
    start_mm: tuple  # the arm waits there
    along_mm_s: int  # from the first point on the part to the second one
    along_mm: int
    starts_s: float  # the first move
    begins_s: float  # the moves on the part


BELT = Kind(
    scenario=SCENARIOS / "policy_conveyor",
    duration_s=2.0,
    followed_s=(1.05, 1.9),
    begin_mm_s=(110, 130),
    speed_mm_s=(0, 200),
    change_s=(0.1, 0.4),
    least_accel=500,
    wave_mm=(0, 0.3),
    window_mm=(100, 400),
    start_mm=(380, -130, 260),
    along_mm_s=40,
    along_mm=20,
    starts_s=0.01,
    begins_s=0.02,
)
HAND = Kind(
    scenario=SCENARIOS / "policy_moving_target",
    duration_s=3.0,
    followed_s=(0.8, 2.4),
    begin_mm_s=(0, 0),
    speed_mm_s=(-150, 150),
    change_s=(0.2, 0.8),
    least_accel=300,
    wave_mm=(0, 0),
    window_mm=(-250, 250),
    start_mm=(380, 0, 260),
    along_mm_s=30,
    along_mm=40,
    starts_s=0.01003,  # core 0 then sees the move in the same tick, with and without the time for a network
    begins_s=0.31,
)


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
    kind: Kind = BELT


VO = ("vo2021_6r_dynamic", 3000, 1500, 0, HERE / "vo2021_6r_dynamic.policy")
ARMS = (
    Arm("irb120", "IRB 120, ideal plant", False, 5.305, "abb_irb120", 4000, 4000, 180, BELT.scenario / "belt.policy"),
    Arm("vo_ideal", "Vo 2021, ideal plant", False, 21.22, *VO),
    Arm("vo_dynamic", "Vo 2021, full plant", True, 21.45, *VO),  # the smoothing and the current loop add 0.2 ms
    Arm(
        "hand",
        "IRB 120, target of a hand",
        False,
        5.305,
        "abb_irb120",
        4000,
        1500,
        180,
        HAND.scenario / "target.policy",
        HAND,
    ),
    Arm(
        "hand_vo",
        "Vo 2021, full plant, target of a hand",
        True,
        21.45,
        "vo2021_6r_dynamic",
        3000,
        1500,
        0,
        HERE / "vo2021_6r_dynamic_hand.policy",
        HAND,
    ),
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
    kind = arm.kind
    draw = random.Random(f"belt {number} of seed {seed}")

    def between(low, high):
        return round(draw.uniform(low, high), 3)

    begin, accel = between(*kind.begin_mm_s), between(kind.least_accel, arm.most_accel)
    changes, at_s = [], kind.followed_s[0]
    while at_s < kind.followed_s[1]:
        changes.append(f"{{at_s={at_s:.3f}, speed_mm_s={between(*kind.speed_mm_s)}}}")
        at_s += between(*kind.change_s)
    return [
        f"conveyor.speed_mm_s={begin}",
        f"conveyor.belt_accel_mm_s2={accel}",
        f"conveyor.speed=[{', '.join(changes)}]",
        f"conveyor.wave_mm={between(*kind.wave_mm)}",
        f"conveyor.wave_length_mm={between(*WAVE_LENGTH_MM)}",
        f"seed={number}",
    ]


def settings_of_arm(arm, robot):
    """The arm waits above the belt, goes to the part, moves slowly along it, and leaves it."""
    kind = arm.kind
    rpy_deg = [180, 0, arm.yaw_deg]
    on_part = f'at_s={kind.begins_s}, type="line", frame="conveyor", accel_mm_s2=1000'
    moves = (
        f'at_s={kind.starts_s}, type="joint", xyz_mm={list(kind.start_mm)}, rpy_deg={rpy_deg}',
        f"{on_part}, xyz_mm=[0, 0, -40], speed_mm_s=200",
        f"{on_part}, xyz_mm=[{kind.along_mm}, 0, -40], speed_mm_s={kind.along_mm_s}",
        f'at_s={kind.begins_s}, type="joint", xyz_mm=[380, 50, 260], rpy_deg={rpy_deg}',
    )
    return [
        f'robot="{robot}"',
        f"duration_s={kind.duration_s}",
        "expect={}",
        f"conveyor.lead_ms={arm.lead_ms}",
        f"conveyor.accel_mm_s2={arm.frame_accel}",
        f"conveyor.window_mm={list(kind.window_mm)}",
        f"conveyor.rpy_deg={rpy_deg}",
        f"move=[{', '.join('{' + move + '}' for move in moves)}]",
        f'conveyor.policy.file="{arm.network}"',
    ]
