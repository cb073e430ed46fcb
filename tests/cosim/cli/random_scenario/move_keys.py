"""Keys that moves of several types have."""


def put_outputs(draft, offsets):
    rng = draft.rng
    for _ in range(rng.choice([0, 0, 0, 1, 4])):
        draft.table("move.output", "[[move.output]]")
        draft.put("pin", draft.integer(1, 16))
        draft.put("level", rng.randint(0, 1))
        draft.maybe("from", lambda: rng.choice(["start", "end"]))
        if rng.random() < 0.7:
            key = rng.choice(offsets)
            draft.put(key, rng.choice([0, 0.001, 0.01]) if key.endswith("_s") else draft.number(0, 5))


def put_pose(draft, key, on_conveyor=False):
    """A pose at `key`, also on the conveyor if that is allowed. Returns its frame, and whether it has an orientation."""
    rng = draft.rng
    if on_conveyor and draft.has_conveyor and rng.random() < 0.6:
        frame = "conveyor"
    else:
        frame = "tool" if rng.random() < 0.7 else rng.choice(draft.frames)
    draft.put(key, draft.place(rng.choice([1, 30, 100]) if frame in ("tool", "conveyor") else 900))
    draft.put("frame", frame)
    turns = rng.random() < 0.3
    if turns:
        draft.put("rpy_deg", draft.angles(5 if frame == "tool" else 180))
    return frame, turns


def put_configuration(draft):
    rng = draft.rng
    draft.maybe("shoulder", lambda: rng.choice(["nearest", "front", "back"]), 0.1)
    draft.maybe("elbow", lambda: rng.choice(["nearest", "up", "down"]), 0.1)
    if draft.robot.axes == 6:
        draft.maybe("wrist", lambda: rng.choice(["nearest", "noflip", "flip"]), 0.1)
    draft.maybe("turns", lambda: draft.per_axis(lambda: rng.choice([-1, 0, 0, 0, 1])), 0.1)


def put_jerk(draft):
    draft.put("profile", "scurve")
    draft.put("jerk_mm_s3", draft.rng.choice([10, 1e4, 1e12]))
    draft.put("turn_jerk_deg_s3", draft.rng.choice([10, 1e4, 1e12]))
