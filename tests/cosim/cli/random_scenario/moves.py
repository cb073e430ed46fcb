"""[[move]] of every type."""

from .move_keys import put_configuration, put_jerk, put_outputs, put_pose
from .paths import put_path, put_polyline
from .robots import READY


def put_move_to_ready(draft):
    """Paths are planned from there while the arm is still on its way."""
    draft.table("move", "[[move]]")
    draft.put("at_s", 0)
    draft.put("type", "joint")
    draft.put("target_deg", READY[draft.robot.name])


def put_move(draft):
    rng = draft.rng
    draft.table("move", "[[move]]")
    draft.put("at_s", 0 if rng.random() < 0.4 else draft.at())
    kinematics = draft.robot.has_kinematics
    paths = ["line", "line", "arc", "circle", "arc_about", "spline"] if kinematics else []
    others = ["polyline"] if kinematics else []
    others += ["dwell", "jog", "hold", "resume", "override", "stop", "clear_fault", "dout", "wait_din"]
    others += ["home"] if draft.robot.can_home else []
    kind = rng.choice(["joint", "joint", *paths, *paths, *others])
    draft.put("type", kind)
    if kind == "joint":
        put_joint_move(draft)
    elif kind in paths:
        put_path(draft, kind)
    elif kind == "polyline":
        put_polyline(draft)
    elif kind == "jog":
        put_jog(draft)
    elif kind == "home":
        draft.maybe("axes", lambda: sorted(rng.sample(range(1, draft.robot.axes + 1), rng.randint(1, 3))))
    elif kind == "dwell":
        draft.put("duration_s", draft.number(0.0001, 0.02, 6))
    elif kind == "override":
        draft.put("speed_percent", draft.number(1, 100))
    elif kind == "stop":
        draft.maybe("mode", lambda: rng.choice(["quick", "soft"]))
    elif kind in ("dout", "wait_din"):
        draft.put("pin", draft.integer(1, 16))
        draft.put("level", rng.randint(0, 1))
    if kind == "wait_din":
        draft.maybe("timeout_s", lambda: draft.number(0.00005, 0.005, 6))


def put_joint_move(draft):
    rng = draft.rng
    now = False
    if draft.robot.has_kinematics and rng.random() < 0.3:
        put_pose(draft, "xyz_mm")
        put_configuration(draft)
    else:
        ready = READY[draft.robot.name]
        draft.put(
            "target_deg",
            rng.choice(
                [
                    ready,
                    draft.per_axis(lambda: draft.number(-170, 170)),
                    draft.per_axis(lambda: draft.number(-0.001, 0.001)),
                    [angle + draft.number(-1, 1) for angle in ready],
                ]
            ),
        )
        now = rng.random() < 0.1
        draft.maybe("when", lambda: "now" if now else "in_order", 1 if now else 0.1)
    draft.maybe("speed_percent", lambda: draft.number(0.1, 100), 0.3)
    draft.maybe("accel_percent", lambda: draft.number(0.1, 100), 0.2)
    if draft.robot.has_jerk:
        draft.maybe("profile", lambda: rng.choice(["trapezoid", "scurve"]))
    if rng.random() < 0.3:
        draft.put(*rng.choice([("blend_deg", draft.number(0, 20)), ("blend_percent", draft.number(0, 100))]))
    if not now:
        put_outputs(draft, ["before_s", "after_s"])


def put_jog(draft):
    rng = draft.rng
    draft.put("duration_s", draft.number(0.0001, 0.02, 6))
    if draft.robot.axes == 6 and draft.robot.has_kinematics and rng.random() < 0.5:
        draft.put("tool_mm_s", draft.place(rng.choice([1, 100, 10000])))
        draft.maybe("tool_deg_s", lambda: draft.angles(rng.choice([1, 200])))
        draft.maybe("frame", lambda: rng.choice(draft.frames))
        draft.maybe("accel_mm_s2", lambda: rng.choice([0.1, 1000, 1e9]))
        draft.maybe("turn_accel_deg_s2", lambda: rng.choice([0.1, 1000, 1e9]))
        if draft.robot.has_jerk and rng.random() < 0.3:
            put_jerk(draft)
    else:
        draft.put("joint_deg_s", draft.per_axis(lambda: draft.number(-200, 200)))
        draft.maybe("accel_percent", lambda: draft.number(1, 100))
        if draft.robot.has_jerk:
            draft.maybe("profile", lambda: rng.choice(["trapezoid", "scurve"]))
