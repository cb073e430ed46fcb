"""[expect] with any values: the checks may fail."""


def put_expect(draft):
    rng = draft.rng
    if rng.random() < 0.3:
        return
    draft.table("expect")
    causes = ["estop", "watchdog", "following_error", "drive_alarm", "encoder", "limit_switch", "hardware_id"]
    few = 0.15

    def owned(key, make, tolerance, make_tolerance):
        if rng.random() < few:
            draft.put(key, make())
            draft.maybe(tolerance, make_tolerance)

    draft.maybe("outcome", lambda: rng.choice(["completed"] + ["fault:" + c for c in causes]), few)
    owned(
        "final_joint_deg",
        lambda: draft.per_axis(lambda: draft.number(-9, 9)),
        "tolerance_deg",
        lambda: draft.number(0, 9),
    )
    draft.maybe("total_pulses", lambda: draft.per_axis(lambda: draft.integer(-99, 99)), few)
    draft.maybe("final_error_counts", lambda: draft.per_axis(lambda: draft.integer(-9, 9)), few)
    draft.maybe("move_ticks", lambda: [draft.count() for _ in range(rng.randint(0, 3))], few)
    draft.maybe("taken_ticks", lambda: [draft.count() for _ in range(rng.randint(0, 3))], few)
    shapes = ["none", "triangle", "trapezoid", "scurve"]
    draft.maybe("profile", lambda: draft.per_axis(lambda: rng.choice(shapes)), few)
    owned(
        "peak_speed_deg_s",
        lambda: draft.per_axis(lambda: draft.number(0, 99)),
        "peak_tolerance_deg_s",
        lambda: draft.number(0, 99),
    )
    for key in (
        "peak_pulses_per_tick",
        "refused_moves",
        "unfinished_moves",
        "blended_moves",
        "max_overshoot_counts",
        "max_correction_pulses",
        "missing_ticks",
        "unanswered_faults",
        "max_stop_ticks",
        "unasked_stops",
    ):
        draft.maybe(key, draft.count, few)
    draft.maybe(rng.choice(["underruns", "min_underruns"]), draft.count, 2 * few)
    draft.maybe("refusals", lambda: [rng.choice(["not_ready", "unreachable"]) for _ in range(rng.randint(0, 2))], few)
    draft.maybe("bus_error", lambda: rng.choice(["none", "SLVERR"]), few)
    draft.maybe("jog_ends", lambda: [rng.choice(["duration", "limit"]) for _ in range(rng.randint(0, 2))], few)
    draft.maybe("homing_ends", lambda: [rng.choice(["homed", "stop"]) for _ in range(rng.randint(0, 2))], few)
    draft.maybe("lost_counts", lambda: draft.per_axis(lambda: draft.integer(-9, 9)), few)
    draft.maybe("streams", lambda: [rng.choice(["complete", "late"]) for _ in range(rng.randint(0, 2))], few)
    draft.maybe("max_stream_deviation_deg", lambda: draft.number(0, 1), few)
    ends = ["released", "window", "cannot_follow"]
    draft.maybe("conveyor_ends", lambda: [rng.choice(ends) for _ in range(rng.randint(0, 2))], few)
    draft.maybe("missed_parts", draft.count, few)
    draft.maybe("min_held_s", lambda: draft.number(0, 1), few)
    if draft.robot.has_kinematics:
        draft.maybe("max_path_error_mm", lambda: draft.number(0, 1), few)
        draft.maybe("max_command_path_error_mm", lambda: draft.number(0, 1), few)
        draft.maybe("max_tracking_error_mm", lambda: draft.number(0, 1), few)
        draft.maybe("max_command_tracking_error_mm", lambda: draft.number(0, 1), few)
        draft.maybe("max_tool_speed_mm_s", lambda: draft.number(0, 999), few)
        draft.maybe("max_tool_accel_mm_s2", lambda: draft.number(0, 9999), few)
        owned("final_tcp_mm", draft.place, "tcp_tolerance_mm", lambda: draft.number(0, 9))
        owned("final_rpy_deg", draft.angles, "rpy_tolerance_deg", lambda: draft.number(0, 9))
    draft.maybe("min_stretch", lambda: draft.number(1, 2), few)
    draft.maybe("max_stretch", lambda: draft.number(2, 9), few)
    draft.maybe("min_residual_deg", lambda: draft.number(0, 1), few)
    draft.maybe("max_residual_deg", lambda: draft.number(1, 9), few)
    owned("settled_within_s", lambda: draft.number(0, 0.01), "settled_counts", draft.count)
    if draft.paper:
        draft.maybe("inexact_ticks", lambda: draft.per_axis(draft.count), few)
        draft.maybe("max_residual_pulses", draft.count, few)
    draft.maybe("stopped_by", lambda: rng.choice(causes + ["controller_silent"]), few)
    draft.maybe("faults", lambda: [rng.choice(causes) for _ in range(rng.randint(0, 2))], few)
    if draft.has_serial and rng.random() < few:
        draft.put(*rng.choice([("serial_text", "ok\r\n"), ("serial_hex", "6f 6B 0d")]))
    if draft.program:
        ends = ["ended", "alarm", "stopped", "aborted", "paused", "held", "running", "waiting"]
        draft.maybe("program_end", lambda: rng.choice(ends), few)
        draft.maybe("program_end_line", lambda: draft.integer(1, 20), few)
        draft.maybe("program_messages", lambda: rng.choice([[], ["hello"]]), few)
    draft.maybe("final_outputs", lambda: sorted(rng.sample(range(1, 17), rng.randint(0, 3))), few)
    draft.maybe("min_solved_poses", draft.count, few)
    draft.maybe("max_solver_difference_pulses", lambda: draft.number(0, 1), few)
    with draft.aside():
        draft.maybe("min_corrected_ticks", draft.count, few)
        draft.maybe("max_uncorrected_ticks", draft.count, few)
        draft.maybe("max_corrected_ticks", draft.count, few)
        draft.maybe("min_uncorrected_ticks", draft.count, few)
    for at_s in sorted(draft.at() for _ in range(rng.choice([0, 0, 2]))):
        draft.table("expect.output", "[[expect.output]]")
        draft.put("at_s", at_s)
        draft.put("pin", draft.integer(1, 16))
        draft.put("level", rng.randint(0, 1))
        if draft.robot.has_kinematics and rng.random() < 0.5:
            draft.put("tcp_mm", draft.place(500))
            draft.maybe("tcp_tolerance_mm", lambda: draft.number(0, 9))
