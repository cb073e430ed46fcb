"""A program of the controller, and [gcode] or [job]. The programs are short, so that some of them end within the run."""

POSITIONS = "//POS\n///NPOS {},0,0,0,0,0\n///POSTYPE ANGLE\n///ANGLE\n{}"


def job(name, lines, places=("C0=0,0,0,0,0,0\n",)):
    """The text of a robot program."""
    return f"/JOB\n//NAME {name}\n{POSITIONS.format(len(places), ''.join(places))}//INST\nNOP\n{''.join(lines)}END\n"


def put_program(draft):
    """The keys of the file."""
    rng = draft.rng
    if rng.random() > 0.2:
        return
    draft.program = rng.choice(["ngc", "jbi"])
    draft.put("program", f"random.{draft.program}")
    draft.maybe("program_at_s", draft.at)
    draft.maybe("program_resumes_after_s", lambda: draft.number(0, 0.02))


def put_program_tables(draft):
    if draft.program == "ngc":
        put_gcode(draft)
    elif draft.program == "jbi":
        put_jobs(draft)


def put_gcode(draft):
    rng = draft.rng
    draft.table("gcode")
    draft.maybe("frame", lambda: rng.choice([frame for frame in draft.frames if frame != "tool"]))
    orientation = rng.choice(["kept", "kept", "normal", "tangent"])
    draft.put("orientation", orientation)
    draft.maybe("rapid_mm_s", lambda: rng.choice([1, 250, 1e6]))
    draft.maybe("rapid_turn_deg_s", lambda: rng.choice([1, 180, 1e6]))
    draft.maybe("accel_mm_s2", lambda: rng.choice([1, 2000, 1e9]))
    draft.maybe("turn_accel_deg_s2", lambda: rng.choice([1, 1200, 1e9]))
    draft.maybe("corner_mm", lambda: draft.number(0, 5))
    draft.maybe("spindle_pin", lambda: draft.integer(1, 16))
    draft.maybe("mist_pin", lambda: draft.integer(1, 16))
    draft.maybe("flood_pin", lambda: draft.integer(1, 16))
    draft.put("tools", [1, 7])
    for number in rng.sample(range(4), rng.choice([0, 1, 4])):
        draft.table("gcode.analog", "[[gcode.analog]]")
        draft.put("number", number)
        draft.put("first_pin", draft.integer(1, 8))
        draft.put("bits", draft.integer(1, 9))
        draft.maybe("full", lambda: rng.choice([0.5, 100]))
        draft.analog.append(number)
    draft.files["random.ngc"] = gcode(draft, orientation == "normal")


def gcode(draft, turns):
    """Small increments from where the tool stands."""
    rng = draft.rng
    lines = ["G21 G91 G94 F" + str(rng.choice([60, 3000, 60000])), rng.choice(["G61", "G64", "G64 P0.5"])]
    analog = [f"{code} E{number} Q0.4" for number in draft.analog for code in ("M67", "M68")]
    for _ in range(rng.choice([1, 3, 10, 40])):
        move = rng.choice(["G0", "G1", "G1"]) + "".join(
            f" {axis}{draft.number(-5, 5)}" for axis in rng.sample("XYZ" + "ABC" * turns, 2)
        )
        others = ["G2 X2 I1", "G3 X1 Z1 I0.5", "G4 P0.001", "M62 P3", "M63 P3", "M64 P0", "M65 P0", "T7 M6", "G43 H1"]
        others += ["(MSG, hello)", "M3 S100", "M5", "M7", "M8", "M9", "M66 P2 L0", "#1=[#1+1]", *analog]
        lines.append(rng.choice([move, move, move, *others]))
    return "\n".join(lines) + rng.choice(["\nM0\nM2\n", "\nM2\n", "\nM2\n"])


def put_jobs(draft):
    rng = draft.rng
    draft.table("job")
    draft.maybe("pl_radius_mm", lambda: [draft.number(0, 300) for _ in range(8)])
    draft.maybe("accel_mm_s2", lambda: rng.choice([1, 1000, 1e9]))
    draft.maybe("turn_accel_deg_s2", lambda: rng.choice([1, 900, 1e9]))
    for pin in ("arc_pin", "weave_pin", "tool_pin"):
        draft.maybe(pin, lambda: draft.integer(1, 16))
    tools = [0, *rng.sample(range(1, 64), rng.choice([0, 1, 3]))]
    for number in tools[1:]:
        draft.table("job.tool", "[[job.tool]]")
        draft.put("number", number)
        draft.maybe("xyz_mm", draft.place)
        draft.maybe("rpy_deg", draft.angles)
    place = ",".join(str(draft.number(-1, 1)) for _ in range(6))
    lines = []
    for _ in range(rng.choice([1, 3, 10])):
        move = f"MOV{rng.choice('JL')} C{rng.randrange(len(tools))} " + rng.choice(["", "PL=0", "PL=8"])
        others = ["TIMER T=0.01", "DOUT OT#(3) ON", 'MSG "hello"', "CALL JOB:SUB", "PULSE OT#(2) T=0.01", "INC B000"]
        others += ["WAIT IN#(1)=ON T=0.01", "SET B001 300", "PAUSE"]
        others += ["ARCON", "ARCOF", "WVON", "WVOF", "TOOLON", "TOOLOF"]
        lines.append(rng.choice([move.rstrip(), *others]) + "\n")
    places = [f"///TOOL {number}\nC{i}={place}\n" for i, number in enumerate(tools)]
    draft.files["random.jbi"] = job("RANDOM", lines, places)
    draft.files["SUB.jbi"] = job("SUB", ["INC B002\n"])
