"""The keys of paths of the tool."""

from .move_keys import put_configuration, put_jerk, put_outputs, put_pose


def put_path(draft, kind):
    rng = draft.rng
    if kind == "arc_about":
        frame, turns = put_pose(draft, "center_mm", on_conveyor=True)
        draft.maybe("axis", lambda: rng.choice([[0, 0, 1], [1, 0, 0], [0.3, -2, 100]]))
        draft.maybe("angle_deg", lambda: rng.choice([-36000, -200, 0.01, 90, 720]))
        draft.maybe("advance_mm", lambda: draft.number(-30, 30))
    else:
        frame, turns = put_pose(draft, "xyz_mm", on_conveyor=kind != "spline")
        put_configuration(draft)
    if kind in ("arc", "circle"):
        draft.put("via_mm", draft.place(30))
    if kind == "spline":
        draft.put("through_mm", [draft.place(30) for _ in range(rng.choice([1, 2, 5, 15]))])
    draft.maybe("accel_percent", lambda: draft.number(0.1, 100), 0.2)
    steady = ["steady", "slerp"]
    orientations = steady if turns else steady + ["fixed"] + ([] if kind == "spline" else ["tangent"])
    draft.maybe("orientation", lambda: rng.choice(orientations))
    draft.maybe("speed_mm_s", lambda: rng.choice([0.01, 0.3, 20, 1000, 1e6]), 0.6)
    draft.maybe("accel_mm_s2", lambda: rng.choice([0.1, 100, 5000, 1e9]))
    draft.maybe("turn_speed_deg_s", lambda: rng.choice([0.01, 10, 1e6]))
    draft.maybe("turn_accel_deg_s2", lambda: rng.choice([0.1, 100, 1e9]))
    if rng.random() < 0.4:
        draft.put("blend_mm", draft.number(0, 100))
    else:
        draft.maybe("exact_stop", lambda: rng.random() < 0.5, 0.2)
    if rng.random() < 0.4:
        singularity = rng.choice(["refuse", "slow", "bend"])
        draft.put("singularity", singularity)
        if singularity == "bend":
            draft.maybe("orientation_tolerance_deg", lambda: rng.choice([0.001, 1, 10, 30]))
    if rng.random() < 0.3:
        put_jerk(draft)
    if frame != "conveyor":
        put_outputs(draft, ["before_mm", "after_mm", "before_s", "after_s"])


def put_polyline(draft):
    rng = draft.rng
    name = f"points_{len(draft.files)}.csv"
    draft.put("points_file", name)
    draft.maybe("frame", lambda: rng.choice([frame for frame in draft.frames if frame != "tool"]))
    draft.maybe("speed_mm_s", lambda: rng.choice([0.3, 20, 1000]), 0.6)
    draft.maybe("accel_mm_s2", lambda: rng.choice([100, 5000, 1e9]))
    draft.maybe("blend_mm", lambda: draft.number(0, 1))
    point, step = draft.place(600), rng.choice([0, 0.01, 1, 10])
    rows = ["x_mm,y_mm,z_mm"]
    for _ in range(rng.choice([1, 5, 40])):
        rows.append(",".join(f"{value:.6f}" for value in point))
        point = [value + change for value, change in zip(point, draft.place(step))]
    draft.files[name] = "\n".join(rows) + "\n"
