"""The run, the controller with its processors and their bus, the tool and the frames."""

from .program import put_program


def put_run(draft):
    rng = draft.rng
    longest_s = rng.choice([0.0003, 0.012, 0.012, 0.012, 0.012, 0.012, 0.08])
    draft.duration_s = 0.00005 if rng.random() < 0.05 else round(rng.uniform(0.0001, longest_s), 7)
    draft.put("description", rng.choice(["x", "", "Umlaut ä", 'quote " and <tag>']))
    draft.put("robot", draft.robot.name)
    draft.put("duration_s", draft.duration_s)
    draft.maybe("seed", lambda: draft.integer(0, 2**63 - 1))
    draft.maybe("input_jitter", lambda: rng.random() < 0.5, 0.1)
    draft.maybe("drop_out_us", lambda: rng.choice([60, 500, 5000, 1_000_000]), 0.1)
    draft.maybe("engine", lambda: rng.choice(["rtl", "model", "lockstep"]), 0.5)
    draft.paper = rng.random() < 0.25
    if draft.paper or rng.random() < 0.2:
        draft.put("variant", "paper" if draft.paper else "counts")
    if not draft.paper:
        draft.maybe("unreferenced_start_deg", lambda: draft.per_axis(lambda: draft.number(-180, 180)), 0.05)
    with draft.aside():
        if "unreferenced_start_deg" not in draft.keys:
            draft.maybe("moved_start_deg", lambda: draft.per_axis(lambda: draft.number(-10, 10)), 0.05)
    put_program(draft)
    if draft.paper and rng.random() < 0.7:
        draft.table("paper")
        if rng.random() < 0.5:
            draft.put("encoder_axis", draft.integer(1, draft.robot.axes))
        else:
            draft.put("switch_every_ticks", draft.integer(2, 20))


def put_machine(draft):
    rng = draft.rng
    draft.table("controller")
    draft.maybe("sync", lambda: rng.choice(["fig9", "const_acc", "time_scale"]))
    draft.maybe("feedback", lambda: False if draft.paper else rng.random() < 0.5)
    draft.maybe("max_stretch", lambda: draft.number(1, 1000))
    draft.table("cpu")
    draft.maybe("interrupt_entry_cycles", lambda: draft.integer(0, 3000), 0.2)
    draft.maybe("tick_compute_cycles", lambda: draft.integer(0, 4000), 0.3)
    draft.maybe("plan_compute_cycles", lambda: draft.integer(0, 100_000), 0.3)
    draft.maybe("retarget_compute_cycles", lambda: draft.integer(0, 4000), 0.2)
    draft.maybe("corner_compute_cycles", lambda: draft.integer(0, 40_000), 0.2)
    draft.maybe("window_compute_cycles", lambda: draft.integer(0, 100_000), 0.3)
    draft.maybe("inverse_compute_cycles", lambda: draft.integer(1, 500), 0.5)
    draft.maybe("program_step_compute_cycles", lambda: draft.integer(1, 2000), 0.2)
    with draft.aside():
        draft.maybe("network_compute_cycles", lambda: draft.integer(0, 500), 0.5)
    draft.maybe("processor", lambda: "host", 0.2)
    draft.table("bus")
    latency = draft.integer(0, 150)
    draft.put("latency_cycles", latency)
    draft.may_time_out = rng.random() < 0.1
    least = 2 * latency + 10
    draft.put("timeout_cycles", draft.integer(least, least + 50) if draft.may_time_out else 1_000_000)
    draft.maybe("stall_probability", lambda: draft.number(0, 0.9))


def put_solver(draft):
    rng = draft.rng
    if draft.robot.has_kinematics and rng.random() < 0.3:
        draft.table("kinematics")
        draft.put("solver", "software" if draft.paper or rng.random() < 0.3 else "cordic")


def put_places(draft):
    draft.frames = ["base", "tool"]
    if not draft.robot.has_kinematics:
        return
    if draft.rng.random() < 0.3:
        draft.table("tool")
        draft.maybe("xyz_mm", draft.place)
        draft.maybe("rpy_deg", draft.angles)
    for i in range(draft.rng.choice([0, 0, 1, 3])):
        draft.table("frame", "[[frame]]")
        draft.put("name", f"frame {i}")
        draft.maybe("xyz_mm", lambda: draft.place(300))
        draft.maybe("rpy_deg", draft.angles)
        draft.frames.append(f"frame {i}")
