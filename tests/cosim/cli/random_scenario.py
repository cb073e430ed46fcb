"""Random scenarios that are valid: short, with every key, and values up to the edges of their ranges."""

import json
import tomllib

# The nominal stands of the arms, from which short Cartesian moves are possible [deg].
READY = {
    "vo2021_6r": [0, 20, -30, 0, 45, 0],
    "abb_irb120": [0, 0, 0, 0, 90, 0],
    "kuka_kr6_r900": [0, -90, 90, 0, 30, 0],
    "fanuc_lrmate200id": [0, 0, 0, 0, -90, 0],
    "hu2012_5r": [0, -90, 0, -90, 0],
}
AT_ONCE = 16  # commands that may wait at a time


class Robot:
    def __init__(self, folder, name):
        self.name = name
        spec = tomllib.loads((folder / f"{name}.toml").read_text())
        self.axes = len(spec["axis"])
        self.has_kinematics = "kinematics" in spec
        defaults = spec.get("defaults", {})
        self.has_jerk = all("max_jerk_deg_s3" in axis or "max_jerk_deg_s3" in defaults for axis in spec["axis"])


def text_of(value):
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, str):
        return json.dumps(value, ensure_ascii=False)  # TOML's basic strings know the same escapes
    if isinstance(value, list):
        return "[" + ", ".join(text_of(element) for element in value) + "]"
    return repr(value)


class Generator:
    """One scenario. `keys` collects the names of all keys that were written, `files` the other files by name."""

    def __init__(self, rng, robots):
        self.rng = rng
        self.robot = rng.choice(robots)
        self.lines = []
        self.keys = set()
        self.files = {}

    # ---- building blocks

    def put(self, key, value):
        self.keys.add(key)
        self.lines.append(f"{key} = {text_of(value)}")

    def maybe(self, key, make, chance=0.4):
        if self.rng.random() < chance:
            self.put(key, make())

    def table(self, name, header=None):
        self.keys.update(name.split("."))
        self.lines.append(header or f"[{name}]")

    def number(self, low, high, digits=3):
        """Now and then an end of the range."""
        return self.rng.choice([low, high]) if self.rng.random() < 0.1 else round(self.rng.uniform(low, high), digits)

    def integer(self, low, high):
        return self.rng.choice([low, high]) if self.rng.random() < 0.1 else self.rng.randint(low, high)

    def count(self):
        return self.integer(0, 1000)

    def per_axis(self, make):
        return [make() for _ in range(self.robot.axes)]

    def place(self, size=50):
        return [self.number(-size, size) for _ in range(3)]

    def angles(self, size=180):
        return [self.number(-size, size) for _ in range(3)]

    def at(self):
        return round(self.rng.uniform(0, self.duration_s) * 0.999, 7)

    # ---- the tables of a scenario

    def scenario(self):
        rng = self.rng
        longest_s = rng.choice([0.0003, 0.012, 0.012, 0.012, 0.012, 0.012, 0.08])
        self.duration_s = 0.00005 if rng.random() < 0.05 else round(rng.uniform(0.0001, longest_s), 7)
        self.put("description", rng.choice(["x", "", "Umlaut ä", 'quote " and <tag>']))
        self.put("robot", self.robot.name)
        self.put("duration_s", self.duration_s)
        self.maybe("seed", lambda: self.integer(0, 2**63 - 1))
        self.maybe("input_jitter", lambda: rng.random() < 0.5, 0.1)
        self.maybe("drop_out_us", lambda: rng.choice([5000, 1_000_000]), 0.1)
        self.maybe("engine", lambda: "rtl", 0.1)
        self.paper = rng.random() < 0.25
        if self.paper or rng.random() < 0.2:
            self.put("variant", "paper" if self.paper else "counts")
        if self.paper and rng.random() < 0.7:
            self.table("paper")
            if rng.random() < 0.5:
                self.put("encoder_axis", self.integer(1, self.robot.axes))
            else:
                self.put("switch_every_ticks", self.integer(2, 20))
        self.costs()
        self.table("trace")
        self.maybe("every_ticks", lambda: self.integer(1, 40))
        if self.robot.has_kinematics:
            self.maybe("tcp", lambda: rng.random() < 0.5)
        self.places()
        if rng.random() < 0.5:
            self.go_to_ready()
        for _ in range(rng.choice([0, 1, 2, 3, 5, 8, 20])):
            self.move()
        self.stream()
        for _ in range(rng.choice([0, 0, 0, 0, 1, 2, 5])):
            self.fault()
        self.inputs()
        self.serial()
        self.expect()
        if rng.random() < 0.05:
            self.table("golden")
            self.put("sha256", "0123456789abcdef" * 4)
        return "\n".join(self.lines) + "\n"

    def costs(self):
        rng = self.rng
        self.table("controller")
        self.maybe("sync", lambda: rng.choice(["fig9", "const_acc", "time_scale"]))
        self.maybe("feedback", lambda: False if self.paper else rng.random() < 0.5)
        self.maybe("max_stretch", lambda: self.number(1, 1000))
        self.table("cpu")
        self.maybe("interrupt_entry_cycles", lambda: self.integer(0, 3000), 0.2)
        self.maybe("tick_compute_cycles", lambda: self.integer(0, 4000), 0.3)
        self.maybe("plan_compute_cycles", lambda: self.integer(0, 100_000), 0.3)
        self.maybe("retarget_compute_cycles", lambda: self.integer(0, 4000), 0.2)
        self.maybe("inverse_compute_cycles", lambda: self.integer(1, 500), 0.5)
        self.table("bus")
        latency = self.integer(0, 150)
        self.put("latency_cycles", latency)
        self.may_time_out = rng.random() < 0.1
        least = 2 * latency + 10
        self.put("timeout_cycles", self.integer(least, least + 50) if self.may_time_out else 1_000_000)
        self.maybe("stall_probability", lambda: self.number(0, 0.9))

    def places(self):
        self.frames = ["base", "tool"]
        if not self.robot.has_kinematics:
            return
        if self.rng.random() < 0.3:
            self.table("tool")
            self.maybe("xyz_mm", self.place)
            self.maybe("rpy_deg", self.angles)
        for i in range(self.rng.choice([0, 0, 1, 3])):
            self.table("frame", "[[frame]]")
            self.put("name", f"frame {i}")
            self.maybe("xyz_mm", lambda: self.place(300))
            self.maybe("rpy_deg", self.angles)
            self.frames.append(f"frame {i}")

    def go_to_ready(self):
        """Paths are planned from there while the arm is still on its way."""
        self.table("move", "[[move]]")
        self.put("at_s", 0)
        self.put("type", "joint")
        self.put("target_deg", READY[self.robot.name])

    def move(self):
        rng = self.rng
        self.table("move", "[[move]]")
        self.put("at_s", 0 if rng.random() < 0.4 else self.at())
        kinematics = self.robot.has_kinematics
        paths = ["line", "line", "arc", "circle", "arc_about", "spline"] if kinematics else []
        others = ["polyline"] if kinematics else []
        others += ["dwell", "jog", "hold", "resume", "override", "stop", "clear_fault", "dout", "wait_din"]
        kind = rng.choice(["joint", "joint", *paths, *paths, *others])
        self.put("type", kind)
        if kind == "joint":
            self.joint_move()
        elif kind in paths:
            self.path(kind)
        elif kind == "polyline":
            self.polyline()
        elif kind == "jog":
            self.jog()
        elif kind == "dwell":
            self.put("duration_s", self.number(0.0001, 0.02, 6))
        elif kind == "override":
            self.put("speed_percent", self.number(1, 100))
        elif kind in ("dout", "wait_din"):
            self.put("pin", self.integer(1, 16))
            self.put("level", rng.randint(0, 1))
        if kind == "wait_din":
            self.maybe("timeout_s", lambda: self.number(0.00005, 0.005, 6))

    def joint_move(self):
        rng = self.rng
        now = False
        if self.robot.has_kinematics and rng.random() < 0.3:
            self.pose("xyz_mm")
            self.configuration()
        else:
            ready = READY[self.robot.name]
            self.put(
                "target_deg",
                rng.choice(
                    [
                        ready,
                        self.per_axis(lambda: self.number(-170, 170)),
                        self.per_axis(lambda: self.number(-0.001, 0.001)),
                        [angle + self.number(-1, 1) for angle in ready],
                    ]
                ),
            )
            now = rng.random() < 0.1
            self.maybe("when", lambda: "now" if now else "in_order", 1 if now else 0.1)
        self.maybe("speed_percent", lambda: self.number(0.1, 100), 0.3)
        self.maybe("accel_percent", lambda: self.number(0.1, 100), 0.2)
        if self.robot.has_jerk:
            self.maybe("profile", lambda: rng.choice(["trapezoid", "scurve"]))
        if rng.random() < 0.3:
            self.put(*rng.choice([("blend_deg", self.number(0, 20)), ("blend_percent", self.number(0, 100))]))
        if not now:
            self.outputs(["before_s", "after_s"])

    def outputs(self, offsets):
        rng = self.rng
        for _ in range(rng.choice([0, 0, 0, 1, 4])):
            self.table("output", "[[move.output]]")
            self.put("pin", self.integer(1, 16))
            self.put("level", rng.randint(0, 1))
            self.maybe("from", lambda: rng.choice(["start", "end"]))
            if rng.random() < 0.7:
                key = rng.choice(offsets)
                self.put(key, rng.choice([0, 0.001, 0.01]) if key.endswith("_s") else self.number(0, 5))

    def pose(self, key):
        """A pose in a frame, at `key`. Returns whether it has an orientation."""
        rng = self.rng
        frame = "tool" if rng.random() < 0.7 else rng.choice(self.frames)
        self.put(key, self.place(rng.choice([1, 30, 100]) if frame == "tool" else 900))
        self.put("frame", frame)
        turns = rng.random() < 0.3
        if turns:
            self.put("rpy_deg", self.angles(5 if frame == "tool" else 180))
        return turns

    def configuration(self):
        rng = self.rng
        self.maybe("shoulder", lambda: rng.choice(["nearest", "front", "back"]), 0.1)
        self.maybe("elbow", lambda: rng.choice(["nearest", "up", "down"]), 0.1)
        if self.robot.axes == 6:
            self.maybe("wrist", lambda: rng.choice(["nearest", "noflip", "flip"]), 0.1)
        self.maybe("turns", lambda: self.per_axis(lambda: rng.choice([-1, 0, 0, 0, 1])), 0.1)

    def path(self, kind):
        rng = self.rng
        if kind == "arc_about":
            turns = self.pose("center_mm")
            self.maybe("axis", lambda: rng.choice([[0, 0, 1], [1, 0, 0], [0.3, -2, 100]]))
            self.maybe("angle_deg", lambda: rng.choice([-36000, -200, 0.01, 90, 720]))
            self.maybe("advance_mm", lambda: self.number(-30, 30))
        else:
            turns = self.pose("xyz_mm")
            self.configuration()
        if kind in ("arc", "circle"):
            self.put("via_mm", self.place(30))
        if kind == "spline":
            self.put("through_mm", [self.place(30) for _ in range(rng.choice([1, 2, 5, 15]))])
        self.maybe("accel_percent", lambda: self.number(0.1, 100), 0.2)
        steady = ["steady", "slerp"]
        orientations = steady if turns else steady + ["fixed"] + ([] if kind == "spline" else ["tangent"])
        self.maybe("orientation", lambda: rng.choice(orientations))
        self.maybe("speed_mm_s", lambda: rng.choice([0.01, 0.3, 20, 1000, 1e6]), 0.6)
        self.maybe("accel_mm_s2", lambda: rng.choice([0.1, 100, 5000, 1e9]))
        self.maybe("turn_speed_deg_s", lambda: rng.choice([0.01, 10, 1e6]))
        self.maybe("turn_accel_deg_s2", lambda: rng.choice([0.1, 100, 1e9]))
        if rng.random() < 0.4:
            self.put("blend_mm", self.number(0, 100))
        else:
            self.maybe("exact_stop", lambda: rng.random() < 0.5, 0.2)
        if rng.random() < 0.4:
            singularity = rng.choice(["refuse", "slow", "bend"])
            self.put("singularity", singularity)
            if singularity == "bend":
                self.maybe("orientation_tolerance_deg", lambda: rng.choice([0.001, 1, 10, 30]))
        if rng.random() < 0.3:
            self.smooth()
        self.outputs(["before_mm", "after_mm", "before_s", "after_s"])

    def polyline(self):
        rng = self.rng
        name = f"points_{len(self.files)}.csv"
        self.put("points_file", name)
        self.maybe("frame", lambda: rng.choice([frame for frame in self.frames if frame != "tool"]))
        self.maybe("speed_mm_s", lambda: rng.choice([0.3, 20, 1000]), 0.6)
        self.maybe("accel_mm_s2", lambda: rng.choice([100, 5000, 1e9]))
        self.maybe("blend_mm", lambda: self.number(0, 1))
        point, step = self.place(600), rng.choice([0, 0.01, 1, 10])
        rows = ["x_mm,y_mm,z_mm"]
        for _ in range(rng.choice([1, 5, 40])):
            rows.append(",".join(f"{value:.6f}" for value in point))
            point = [value + change for value, change in zip(point, self.place(step))]
        self.files[name] = "\n".join(rows) + "\n"

    def smooth(self):
        self.put("profile", "scurve")
        self.put("jerk_mm_s3", self.rng.choice([10, 1e4, 1e12]))
        self.put("turn_jerk_deg_s3", self.rng.choice([10, 1e4, 1e12]))

    def jog(self):
        rng = self.rng
        self.put("duration_s", self.number(0.0001, 0.02, 6))
        if self.robot.axes == 6 and self.robot.has_kinematics and rng.random() < 0.5:
            self.put("tool_mm_s", self.place(rng.choice([1, 100, 10000])))
            self.maybe("tool_deg_s", lambda: self.angles(rng.choice([1, 200])))
            self.maybe("frame", lambda: rng.choice(self.frames))
            self.maybe("accel_mm_s2", lambda: rng.choice([0.1, 1000, 1e9]))
            self.maybe("turn_accel_deg_s2", lambda: rng.choice([0.1, 1000, 1e9]))
            if self.robot.has_jerk and rng.random() < 0.3:
                self.smooth()
        else:
            self.put("joint_deg_s", self.per_axis(lambda: self.number(-200, 200)))
            self.maybe("accel_percent", lambda: self.number(1, 100))
            if self.robot.has_jerk:
                self.maybe("profile", lambda: rng.choice(["trapezoid", "scurve"]))

    def stream(self):
        """From where the arm stands at the start: some degrees away, and back."""
        rng = self.rng
        if rng.random() > 0.1:
            return
        self.table("stream", "[[stream]]")
        self.put("at_s", 0 if rng.random() < 0.5 else self.at())
        self.put("file", "random.csv")
        self.maybe("delay_ms", lambda: rng.choice([0.1, 3, 10000]))
        if self.robot.has_jerk:
            self.maybe("profile", lambda: rng.choice(["trapezoid", "scurve"]))
        rows = ["time_s," + ",".join(f"j{axis + 1}_deg" for axis in range(self.robot.axes))]
        size = self.number(0, 5)
        for i in range(rng.randint(2, 12)):
            rows.append(",".join([f"{0.002 * i:.3f}"] + [f"{size * i * (11 - i) / 30:.6f}"] * self.robot.axes))
        self.files["random.csv"] = "\n".join(rows) + "\n"

    def fault(self):
        self.table("fault", "[[fault]]")
        self.put("at_s", self.at())
        # Not clock_stop: in motion the logic loses pulses that it has committed, which ends a run as failed.
        kind = self.rng.choice(["pulse_loss", "slow_core", "estop", "stray_write", "block_hang"])
        self.put("kind", kind)
        if kind == "pulse_loss":
            self.put("axis", self.integer(1, 6))
            self.put("count", self.integer(1, 1000))
        elif kind == "slow_core":
            self.put("compute_us", self.number(1, 500))
        elif kind == "stray_write":
            self.put("address", 0x4280_0000)  # stops the timer
            self.put("data", 0)
        elif kind == "block_hang":
            self.put("clock", self.rng.choice(["io", "motion", "encoder"]))
        else:
            self.put("duration_s", self.number(0.00002, 0.01, 6))

    def inputs(self):
        for pin in self.rng.sample(range(1, 17), self.rng.choice([0, 0, 1, 3])):
            times = sorted({self.at() for _ in range(self.rng.randint(1, 4))})
            for i, at_s in enumerate(times):
                self.table("input", "[[input]]")
                self.put("at_s", at_s)
                self.put("pin", pin)
                self.put("level", (i + 1) % 2)

    def serial(self):
        rng = self.rng
        self.has_serial = rng.random() < 0.4
        if not self.has_serial:
            return
        self.table("serial")
        self.maybe("baud", lambda: self.integer(1200, 5_000_000))
        bits = self.integer(5, 8)
        self.put("data_bits", bits)
        parity = rng.choice(["none", "even", "odd", "mark", "space"])
        self.put("parity", parity)
        self.maybe("stop_bits", lambda: rng.choice([1, 1.5, 2]))
        for _ in range(rng.choice([0, 1, 3])):
            self.table("serial_send", "[[serial_send]]")
            self.put("at_s", self.at())
            fault = rng.choice([None, None, "framing", "break"] + (["parity"] if parity != "none" else []))
            if fault:
                self.put("fault", fault)
            if fault == "break":
                self.put("break_s", self.number(0.00001, 0.01, 6))
                continue
            if bits >= 7 and rng.random() < 0.4:
                self.put("text", "".join(rng.choice("Hello, arm 6!") for _ in range(rng.randint(1, 40))))
            else:
                self.put("hex", " ".join(f"{rng.randrange(2**bits):02x}" for _ in range(rng.randint(1, 40))))
            self.maybe("baud_error_percent", lambda: self.number(-50, 50))

    def expect(self):
        rng = self.rng
        if rng.random() < 0.3:
            return
        self.table("expect")
        causes = ["estop", "watchdog", "following_error", "drive_alarm", "encoder", "limit_switch", "hardware_id"]
        few = 0.15

        def owned(key, make, tolerance, make_tolerance):
            if rng.random() < few:
                self.put(key, make())
                self.maybe(tolerance, make_tolerance)

        self.maybe("outcome", lambda: rng.choice(["completed"] + ["fault:" + c for c in causes]), few)
        owned(
            "final_joint_deg",
            lambda: self.per_axis(lambda: self.number(-9, 9)),
            "tolerance_deg",
            lambda: self.number(0, 9),
        )
        self.maybe("total_pulses", lambda: self.per_axis(lambda: self.integer(-99, 99)), few)
        self.maybe("final_error_counts", lambda: self.per_axis(lambda: self.integer(-9, 9)), few)
        self.maybe("move_ticks", lambda: [self.count() for _ in range(rng.randint(0, 3))], few)
        self.maybe("taken_ticks", lambda: [self.count() for _ in range(rng.randint(0, 3))], few)
        shapes = ["none", "triangle", "trapezoid", "scurve"]
        self.maybe("profile", lambda: self.per_axis(lambda: rng.choice(shapes)), few)
        owned(
            "peak_speed_deg_s",
            lambda: self.per_axis(lambda: self.number(0, 99)),
            "peak_tolerance_deg_s",
            lambda: self.number(0, 99),
        )
        for key in (
            "peak_pulses_per_tick",
            "refused_moves",
            "unfinished_moves",
            "blended_moves",
            "max_overshoot_counts",
            "max_correction_pulses",
        ):
            self.maybe(key, self.count, few)
        self.maybe(rng.choice(["underruns", "min_underruns"]), self.count, 2 * few)
        self.maybe(
            "refusals", lambda: [rng.choice(["not_ready", "unreachable"]) for _ in range(rng.randint(0, 2))], few
        )
        self.maybe("bus_error", lambda: rng.choice(["none", "SLVERR"]), few)
        self.maybe("jog_ends", lambda: [rng.choice(["duration", "limit"]) for _ in range(rng.randint(0, 2))], few)
        self.maybe("streams", lambda: [rng.choice(["complete", "late"]) for _ in range(rng.randint(0, 2))], few)
        self.maybe("max_stream_deviation_deg", lambda: self.number(0, 1), few)
        self.maybe("min_held_s", lambda: self.number(0, 1), few)
        if self.robot.has_kinematics:
            self.maybe("max_path_error_mm", lambda: self.number(0, 1), few)
            self.maybe("max_command_path_error_mm", lambda: self.number(0, 1), few)
            owned("final_tcp_mm", self.place, "tcp_tolerance_mm", lambda: self.number(0, 9))
            owned("final_rpy_deg", self.angles, "rpy_tolerance_deg", lambda: self.number(0, 9))
        self.maybe("min_stretch", lambda: self.number(1, 2), few)
        self.maybe("max_stretch", lambda: self.number(2, 9), few)
        self.maybe("min_residual_deg", lambda: self.number(0, 1), few)
        self.maybe("max_residual_deg", lambda: self.number(1, 9), few)
        owned("settled_within_s", lambda: self.number(0, 0.01), "settled_counts", self.count)
        if self.paper:
            self.maybe("inexact_ticks", lambda: self.per_axis(self.count), few)
            self.maybe("max_residual_pulses", self.count, few)
            self.maybe("lost_counts", lambda: self.per_axis(lambda: self.integer(-9, 9)), few)
        self.maybe("stopped_by", lambda: rng.choice(causes + ["controller_silent"]), few)
        self.maybe("faults", lambda: [rng.choice(causes) for _ in range(rng.randint(0, 2))], few)
        if self.has_serial and rng.random() < few:
            self.put(*rng.choice([("serial_text", "ok\r\n"), ("serial_hex", "6f 6B 0d")]))
        self.maybe("final_outputs", lambda: sorted(rng.sample(range(1, 17), rng.randint(0, 3))), few)
        for at_s in sorted(self.at() for _ in range(rng.choice([0, 0, 2]))):
            self.table("expect.output", "[[expect.output]]")
            self.put("at_s", at_s)
            self.put("pin", self.integer(1, 16))
            self.put("level", rng.randint(0, 1))
            if self.robot.has_kinematics and rng.random() < 0.5:
                self.put("tcp_mm", self.place(500))
                self.maybe("tcp_tolerance_mm", lambda: self.number(0, 9))
