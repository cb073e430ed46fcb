"""What comes to the arm from outside: streams, faults, levels of pins, characters of the serial line."""


def put_stream(draft):
    """From where the arm stands at the start: some degrees away, and back."""
    rng = draft.rng
    if rng.random() > 0.1:
        return
    draft.table("stream", "[[stream]]")
    draft.put("at_s", 0 if rng.random() < 0.5 else draft.at())
    draft.put("file", "random.csv")
    draft.maybe("delay_ms", lambda: rng.choice([0.1, 3, 10000]))
    if draft.robot.has_jerk:
        draft.maybe("profile", lambda: rng.choice(["trapezoid", "scurve"]))
    rows = ["time_s," + ",".join(f"j{axis + 1}_deg" for axis in range(draft.robot.axes))]
    size = draft.number(0, 5)
    for i in range(rng.randint(2, 12)):
        rows.append(",".join([f"{0.002 * i:.3f}"] + [f"{size * i * (11 - i) / 30:.6f}"] * draft.robot.axes))
    draft.files["random.csv"] = "\n".join(rows) + "\n"


def duration_of(draft):
    return draft.number(0.00002, 0.01, 6)


def axis_of(draft):
    return draft.integer(1, 6)


def counts_of(draft):
    return draft.rng.choice([-1, 1]) * draft.integer(1, 400)


def line_of(draft):
    return draft.rng.choice(["a", "b", "z"])


def switch_of(draft):
    return draft.rng.choice(["home", "limit_pos", "limit_neg"])


def level_of(draft):
    return draft.rng.choice([0, 1])


# The keys of each kind.
LATER_FAULTS = {
    "extra_pulses": {"axis": axis_of, "count": lambda draft: draft.integer(1, 1000)},
    "drive_alarm": {"axis": axis_of, "duration_s": duration_of},
    "axis_blocked": {"axis": axis_of, "duration_s": duration_of},
    "encoder_stuck": {"axis": axis_of, "line": line_of, "level": level_of, "duration_s": duration_of},
    "encoder_cable": {"axis": axis_of, "duration_s": duration_of},
    "encoder_swapped": {"axis": axis_of, "duration_s": duration_of},
    "encoder_chatter": {
        "axis": axis_of,
        "line": line_of,
        "period_us": lambda draft: draft.number(0.1, 100),
        "duration_s": duration_of,
    },
    "encoder_noise": {
        "axis": axis_of,
        "line": line_of,
        "width_us": lambda draft: draft.number(0.02, 2, 3),
        "mean_gap_us": lambda draft: draft.number(1, 200),
        "duration_s": duration_of,
    },
    "encoder_miscount": {"axis": axis_of, "counts": counts_of},
    "index_slip": {"axis": axis_of, "counts": counts_of},
    "switch_stuck": {"axis": axis_of, "switch": switch_of, "level": level_of, "duration_s": duration_of},
    "switch_bounce": {
        "axis": axis_of,
        "switch": switch_of,
        "period_us": lambda draft: draft.number(1, 1000),
        "duration_s": duration_of,
    },
    "interrupt_lost": {"duration_s": duration_of},
    "core1_stuck": {},
    "slave_error": {
        "address": lambda draft: draft.rng.choice([0x4280_0000, 0x43C1_0008, 0x43C2_0010]),
        "count": lambda draft: draft.integer(1, 3),
    },
    "slow_slave": {"delay_us": lambda draft: draft.number(0.02, 20), "duration_s": duration_of},
    "brake_slip": {"axis": axis_of, "share": lambda draft: draft.number(0, 1), "duration_s": duration_of},
    "collision_torque": {
        "axis": axis_of,
        "torque_nm": lambda draft: draft.rng.choice([-1, 1]) * draft.number(1, 500),
        "duration_s": duration_of,
    },
    "uart_break": {"duration_s": duration_of},
    "uart_noise": {
        "width_us": lambda draft: draft.number(0.02, 20, 3),
        "mean_gap_us": lambda draft: draft.number(1, 200),
        "duration_s": duration_of,
    },
    "register_flip": {
        "address": lambda draft: draft.rng.choice([0x43C1_0014, 0x43C2_0008]),
        "bit": lambda draft: draft.integer(0, 31),
    },
    "uart_overrun": {"duration_s": duration_of},
}


def put_later_fault(draft):
    """Of the kinds that came after the others: last in the draft, so that the rest of a seed stays as it was."""
    if draft.rng.random() > 0.3:
        return
    draft.table("fault", "[[fault]]")
    draft.put("at_s", draft.at())
    kind = draft.rng.choice(list(LATER_FAULTS))
    draft.put("kind", kind)
    for key, value in LATER_FAULTS[kind].items():
        draft.put(key, value(draft))
    put_condition(draft)


def put_condition(draft):
    """What the fault waits for."""
    if draft.rng.random() > 0.3:
        return
    when = draft.rng.choice(["time", "passes", "speed", "move_begins"])
    draft.put("when", when)
    if when in ("passes", "speed"):
        draft.put("when_axis", axis_of(draft))
    if when == "passes":
        draft.put("when_deg", draft.number(-2, 2))
    elif when == "speed":
        draft.put("when_deg_s", draft.number(0.1, 20))
    elif when == "move_begins":
        draft.put("when_move", draft.integer(0, 3))


def put_fault(draft):
    draft.table("fault", "[[fault]]")
    draft.put("at_s", draft.at())
    kind = draft.rng.choice(["pulse_loss", "slow_core", "estop", "clock_stop", "stray_write", "block_hang"])
    draft.put("kind", kind)
    if kind == "pulse_loss":
        draft.put("axis", draft.integer(1, 6))
        draft.put("count", draft.integer(1, 1000))
    elif kind == "slow_core":
        draft.put("compute_us", draft.number(1, 500))
    elif kind == "stray_write":
        draft.put("address", 0x4280_0000)  # stops the timer
        draft.put("data", 0)
    elif kind == "block_hang":
        draft.put("clock", draft.rng.choice(["io", "motion", "encoder"]))
    else:
        draft.put("duration_s", draft.number(0.00002, 0.01, 6))


def put_inputs(draft):
    for pin in draft.rng.sample(range(1, 17), draft.rng.choice([0, 0, 1, 3])):
        times = sorted({draft.at() for _ in range(draft.rng.randint(1, 4))})
        for i, at_s in enumerate(times):
            draft.table("input", "[[input]]")
            draft.put("at_s", at_s)
            draft.put("pin", pin)
            draft.put("level", (i + 1) % 2)


def put_serial(draft):
    rng = draft.rng
    draft.has_serial = rng.random() < 0.4
    if not draft.has_serial:
        return
    draft.table("serial")
    draft.maybe("baud", lambda: draft.integer(1200, 5_000_000))
    bits = draft.integer(5, 8)
    draft.put("data_bits", bits)
    parity = rng.choice(["none", "even", "odd", "mark", "space"])
    draft.put("parity", parity)
    draft.maybe("stop_bits", lambda: rng.choice([1, 1.5, 2]))
    for _ in range(rng.choice([0, 1, 3])):
        draft.table("serial_send", "[[serial_send]]")
        draft.put("at_s", draft.at())
        fault = rng.choice([None, None, "framing", "break"] + (["parity"] if parity != "none" else []))
        if fault:
            draft.put("fault", fault)
        if fault == "break":
            draft.put("break_s", draft.number(0.00001, 0.01, 6))
            continue
        if bits >= 7 and rng.random() < 0.4:
            draft.put("text", "".join(rng.choice("Hello, arm 6!") for _ in range(rng.randint(1, 40))))
        else:
            draft.put("hex", " ".join(f"{rng.randrange(2**bits):02x}" for _ in range(rng.randint(1, 40))))
        draft.maybe("baud_error_percent", lambda: draft.number(-50, 50))
