"""A teach pendant: an operator whose steps may fail, because faults and other moves come between."""

from .program import job

# Parameter and payload of commands that any state may answer with something else than ok.
COMMANDS = {
    "heartbeat": (0, 0),
    "get_status": (17, 0),
    "set_telemetry": (127, 30),
    "servo": (0, 0),
    "stop": (0, 0),
    "set_coordinates": (1, 0),
    "speed_override": (0, 5000),
    "jog_limit": (0, 1000),
    "jog_increment": (2, -50),
    "set_output": (3, 1),
    "read_input": (4, 0),
    "set_breakpoint": (1, 7),
    "run": (0, 0),
    "resume": (0, 0),
    "abort": (0, 0),
    "echo": (7, -123456),
}

SENT = {
    "sent.ngc": "G21 G91 F6000\nG1 X1\nG1 X-1\nM2\n",
    "sent.jbi": job("SENT", ["INC B000\n", "MOVJ C0\n"]),
    "wrong.jbi": job("WRONG", ["MOVE C0\n"]),
}


def put_pendant(draft):
    rng = draft.rng
    draft.has_pendant = rng.random() < 0.3 and "program_resumes_after_s" not in draft.keys
    if not draft.has_pendant:
        return
    draft.table("pendant")
    draft.maybe("profile", lambda: rng.choice(["strict", "extended"]))
    draft.maybe("lost_percent", lambda: draft.number(0, 2), 0.2)
    draft.maybe("flipped_percent", lambda: draft.number(0, 2), 0.2)
    if rng.random() < 0.8:
        put_step(draft, "send")
        draft.put("command", "servo")
        draft.put("parameter", 1)
    for _ in range(rng.randint(0, 5)):
        act = rng.choice([*STEPS, "move"])
        put_step(draft, act)
        STEPS[act](draft)
        draft.maybe("within_ms", lambda: draft.number(1, 50))


def put_step(draft, act):
    draft.table("pendant.step", "[[pendant.step]]")
    draft.put("do", act)
    draft.maybe("at_s", draft.at, 0.2)


def put_send(draft):
    command = draft.rng.choice(list(COMMANDS))
    parameter, payload = COMMANDS[command]
    draft.put("command", command)
    draft.put("parameter", parameter)
    draft.put("payload", payload)
    draft.maybe("reply", lambda: draft.rng.choice(["ok", "not_ready", "busy", "mode"]))


def put_wait(draft):
    draft.put("state", draft.rng.choice(["idle", "ready", "jog", "move", "alarm", "estop"]))


def put_jog(draft):
    draft.put("axis", draft.integer(1, 6))
    draft.put("percent", draft.number(-100, 100))
    draft.put("for_s", draft.number(0.001, 0.05))
    draft.maybe("release", lambda: draft.rng.random() < 0.5)


def put_move(draft):
    path = draft.rng.choice(["joints", "line", "arc"])
    draft.put("path", path)
    if draft.robot.has_kinematics and (path != "joints" or draft.rng.random() < 0.5):
        draft.put("xyz_mm", draft.place(500))
        draft.maybe("rpy_deg", draft.angles)
    else:
        draft.put("joints_deg", draft.per_axis(lambda: draft.number(-5, 5)))
    if path == "arc":
        draft.put("via_mm", draft.place(500))
    draft.maybe("speed_percent", lambda: draft.number(1, 100))
    draft.maybe("accel_percent", lambda: draft.number(1, 100))


def put_download(draft):
    """Short programs; the last one has an error."""
    name = draft.rng.choice(list(SENT))
    draft.files[name] = SENT[name]
    draft.put("file", name)
    if name.endswith(".jbi"):
        draft.maybe("adds_job", lambda: draft.has_job and draft.rng.random() < 0.5)
    draft.has_job = name.endswith(".jbi")


def put_read_message(draft):
    draft.maybe("message", lambda: draft.rng.choice(["hello", "no part"]))
    draft.maybe("kind", lambda: draft.rng.choice(["message", "alarm", "stopped"]))


STEPS = {
    "send": put_send,
    "wait": put_wait,
    "jog": put_jog,
    "move": put_move,
    "download": put_download,
    "estop": lambda draft: None,
    "read_message": put_read_message,
}
