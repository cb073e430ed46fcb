"""[conveyor], [[conveyor.speed]], [conveyor.camera] and [conveyor.policy]."""

import zlib

# The flange of each arm, where all joints are at 0 and at READY [mm].
FLANGE_MM = {
    "vo2021_6r": [[430, 0, 645], [321, 0, 621]],
    "abb_irb120": [[374, 0, 630], [302, 0, 558]],
    "kuka_kr6_r900": [[980, 0, 435], [514, 0, 850]],
    "fanuc_lrmate200id": [[465, 0, 695], [385, 0, 615]],
}


def put_conveyor(draft):
    """A belt at the tool. It is often so slow that a part can be followed within the short run."""
    rng = draft.rng
    if draft.robot.name not in FLANGE_MM or rng.random() > 0.25:
        return
    draft.has_conveyor = True
    draft.table("conveyor")
    draft.put("xyz_mm", [mm + draft.number(-20, 20) for mm in rng.choice(FLANGE_MM[draft.robot.name])])
    draft.maybe("rpy_deg", draft.angles)
    draft.maybe("direction", lambda: rng.choice([[0, 1, 0], [0.3, -2, 100], [-1, 0, 0.001]]))
    draft.put("window_mm", rng.choice([[-1, 300], [-100, 0.01], [50, 60]]))
    draft.put("part_s", sorted({draft.at() for _ in range(rng.choice([0, 1, 1, 1, 3, 20]))}))
    draft.maybe("mm_per_count", lambda: rng.choice([0.0001, 0.1, 10]))
    draft.maybe("max_speed_mm_s", lambda: rng.choice([1, 200, 10000]))
    draft.maybe("accel_mm_s2", lambda: rng.choice([1, 5000, 1e6]))
    draft.maybe("speed_tolerance_percent", lambda: draft.number(0, 50))
    draft.maybe("lead_ms", lambda: draft.number(0, 100))
    draft.maybe("speed_mm_s", lambda: rng.choice([0, 0.5, 100, 10000]))
    draft.maybe("belt_accel_mm_s2", lambda: rng.choice([10, 10000, 1e6]))
    if rng.random() < 0.3:
        length = rng.choice([0.1, 30, 500])
        draft.put("wave_length_mm", length)
        draft.put("wave_mm", rng.choice([0, 0.1]) * length)
    for at_s in sorted({draft.at() for _ in range(rng.choice([0, 0, 1, 3]))}):
        draft.table("conveyor.speed", "[[conveyor.speed]]")
        draft.put("at_s", at_s)
        draft.put("speed_mm_s", rng.choice([0, 0.5, -50, 50, -10000, 10000]))
    if rng.random() < 0.3:
        draft.table("conveyor.camera")
        draft.maybe("period_ms", lambda: rng.choice([0.05, 20, 33.33, 1000]))
        draft.maybe("dead_time_ms", lambda: rng.choice([0, 40, 1000]))
        draft.maybe("noise_mm", lambda: rng.choice([0, 0.01, 100]))
        draft.maybe("hidden_s", lambda: rng.choice([[0, 0], [0, 86400], [0.05, 0.07]]))


def put_policy(draft):
    """[conveyor.policy] with a network of any weights. Its checksum is nearly always right."""
    rng = draft.rng
    if not draft.has_conveyor or draft.paper or rng.random() < 0.4:
        return
    draft.table("conveyor.policy")
    draft.put("file", "random.policy")
    draft.maybe("on", lambda: rng.choice(["logic", "arm"]), 0.6)
    draft.maybe("percent", lambda: draft.number(0, 100))
    draft.files["random.policy"] = policy_text(rng)


def policy_text(rng):
    words = [0x0002_0100, 0, rng.getrandbits(28), rng.getrandbits(16), *(rng.getrandbits(32) for _ in range(4))]
    if rng.random() < 0.1:
        words[0] = rng.getrandbits(32)
    data = b"".join(word.to_bytes(4, "little") for word in words)
    lines = ["full_mm " + rng.choice(["0.25", "100"])]
    lines += ["input -1e9 1e9" if rng.random() < 0.9 else "input -1 1" for _ in range(10)]
    lines += [f"crc {zlib.crc32(data) if rng.random() < 0.9 else 1:08x}"]
    return "\n".join([*lines, "image " + " ".join(f"{word:08x}" for word in words)]) + "\n"
