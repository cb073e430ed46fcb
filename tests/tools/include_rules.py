"""Who may include whom: the rules that test_include_arrows.py checks."""

import re

# Folder -> project folders that it may include, besides itself.
CONTROLLER = {
    "base": set(),
    "regs": set(),
    "hal": {"base"},
    "robot": {"base"},
    "drivers": {"base", "hal", "regs"},
    "kinematics": {"base", "robot"},
    "trajectory": {"base", "robot", "kinematics"},
    "message": {"base", "kinematics", "trajectory"},
    "policy": {"base", "hal", "drivers"},
    "cell": {"base", "robot", "kinematics", "trajectory", "message"},
    "motion": {"base", "hal", "robot", "kinematics", "trajectory", "drivers", "message", "cell"},
}
CONTROLLER["activity"] = CONTROLLER["motion"] | {"motion", "policy"}
CONTROLLER["command"] = CONTROLLER["activity"] | {"activity"}
CONTROLLER["language"] = {
    "base",
    "robot",
    "kinematics",
    "trajectory",
    "message",
    "cell",
    "motion",
    "activity",
    "command",
}
CONTROLLER["pendant"] = CONTROLLER["command"] | {"command", "language"}
CONTROLLER["host_memory"] = CONTROLLER["pendant"] | {"pendant"}
CONTROLLER["app"] = CONTROLLER["host_memory"] | {"host_memory"}
CONTROLLER["board"] = CONTROLLER["app"] | {"app"}
# Folders within a folder, with what they may include of it; of other folders, what the folder may.
TRAJECTORY = {
    "profile": set(),
    "state": {"profile"},
    "path": {"profile"},
    "law": {"profile"},
    "joint": {"profile", "state", "path"},
    "cartesian": {"profile", "state", "path", "law", "joint"},
    "check": {"path", "law", "cartesian"},
    "grid": {"profile", "law", "cartesian", "check"},
    "plan": {"path", "joint", "cartesian", "check", "grid"},
    "run": {"profile", "path", "law", "joint", "cartesian", "plan"},
}
# From the bytes of a frame to what the pendant may do with the arm.
PENDANT = {
    "protocol": set(),
    "parts": {"protocol"},
    "client": {"protocol", "parts"},
}
# What all languages share, and each language.
LANGUAGE = {
    "text": set(),
    "program": {"text"},
    "job": {"text", "program"},
    "gcode": {"text", "program"},
    "store": {"text", "program", "job", "gcode"},
}
# From the text of a program of G-code to the arm.
GCODE = {
    "reader": set(),
    "canon": {"reader"},
    "execute": {"reader", "canon"},
    "flow": {"reader", "canon", "execute"},
    "run": {"reader", "canon", "execute", "flow"},
}
# From a file of the robot language to the arm.
JOB = {
    "memory": set(),
    "loader": {"memory"},
    "state": {"memory", "loader"},
    "execute": {"memory", "loader", "state"},
}
# The same for the simulator. Bottom up, without a cycle.
COSIM = {
    "time": set(),
    "text": set(),
    "logic": set(),
    "belt": {"time"},
    "net": {"text"},
    "dynamics": set(),
    "robot": {"text"},
    "mesh": {"text"},
    "poses": {"text"},
    "programs": {"text", "poses"},
    "fabric": {"time", "logic"},
    "bus": {"time", "logic", "fabric"},
    "soc": {"logic", "fabric", "bus"},
    "model": {"time", "logic", "fabric", "bus", "soc"},
    "engine": {"logic", "fabric", "bus", "soc", "model"},
    "cpu": {"time", "text", "bus"},
    "iss": {"time", "text", "net", "logic", "fabric", "cpu", "scenario", "report", "kernel", "run", "snapshot", "cli"},
    "servo": {"logic", "robot", "dynamics"},
    "plant": {"time", "logic", "robot", "servo"},
    "fault": {"time", "logic", "soc", "cpu", "plant"},
    "check": {"logic", "bus", "plant"},
    "serial": {"time", "text", "net"},
    "pendant": {"time", "text", "net", "robot", "programs", "serial"},
    "console": {"logic", "bus", "soc", "engine", "cpu", "serial"},
    "trace": {"time", "text"},
    "waves": {"time", "text"},
    "scenario": {
        "text",
        "mesh",
        "poses",
        "logic",
        "robot",
        "belt",
        "programs",
        "bus",
        "cpu",
        "fault",
        "serial",
        "pendant",
    },
    "golden": {"time", "text", "trace", "scenario"},
    "schema": {"text", "robot", "scenario"},
    "keydoc": {"text", "scenario", "schema", "report"},
    "report": {"time", "text", "logic", "robot", "belt", "programs", "bus", "trace", "waves", "scenario", "golden"},
    "recording": {"text", "trace"},
    "plot": {"text", "recording"},
    "exports": {"text", "trace", "recording"},
    "page": {"text", "mesh", "trace", "recording", "report"},
    "kernel": {
        "time",
        "text",
        "belt",
        "programs",
        "fabric",
        "bus",
        "soc",
        "engine",
        "cpu",
        "plant",
        "fault",
        "check",
        "serial",
        "pendant",
        "trace",
        "scenario",
    },
    "run": {"time", "text", "net", "soc", "serial", "trace", "scenario", "golden", "report", "kernel"},
    "campaign": {"time", "text", "fabric", "robot", "fault", "scenario", "trace", "report", "kernel", "run"},
    "train": {"time", "text", "belt"},
    "snapshot": {"net"},
    "serve": {"text", "net", "logic", "soc"},
}
COSIM["flips"] = COSIM["campaign"] | {"campaign", "cpu", "snapshot", "net"}
COSIM["rewind"] = COSIM["run"] | {"run", "logic", "snapshot"}
COSIM["live"] = COSIM["run"] | {"run", "robot", "mesh", "programs", "poses", "logic", "fault", "pendant", "page"}
COSIM["live"] |= {"snapshot"}
COSIM["steer"] = COSIM["run"] | {"run"}
COSIM["python"] = COSIM["steer"] | {"steer"}
COSIM["cli"] = COSIM.keys() - {
    "steer",
    "python",
    "keydoc",
    "kernel",
    "bus",
    "iss",
    "dynamics",
    "servo",
    "plant",
    "fault",
    "check",
    "model",
    "snapshot",
}
# The rooms of cosim/report: what is measured, the list of facts, what [expect] says about them, how they are written.
REPORT = {
    "measure": set(),
    "facts": {"measure"},
    "judge": {"measure", "facts"},
    "format": {"measure", "facts", "judge"},
}
# The command line: what a command is, what its options have, waveforms of runs, what runs and keeps files, texts of
# single commands, the loop of a live session, the commands.
CLI = {
    "command": set(),
    "options": {"command"},
    "main": {"command", "options"},
    "waves": {"command", "options"},
    "kinematics": {"command", "options"},
    "run": {"command", "options", "waves"},
    "texts": {"command", "options"},
    "live": {"command", "options", "waves", "run"},
    "commands": {"command", "options", "waves", "kinematics", "run", "texts", "live"},
}
# Folders whose own folders have rules.
NESTED = {
    "controller/trajectory": TRAJECTORY,
    "controller/pendant": PENDANT,
    "controller/language": LANGUAGE,
    "controller/language/gcode": GCODE,
    "controller/language/job": JOB,
    "cosim/report": REPORT,
    "cosim/cli": CLI,
}
MAX_SOURCES = 25  # of a folder of the product
# What the plant, which sees pins and never registers, may include.
PLANT = {
    "controller/base/",
    "cosim/plant/",
    "cosim/logic/axis_bits.hpp",
    "cosim/logic/axis_pairs.hpp",
    "cosim/logic/pins.hpp",
    "cosim/logic/whole_tick.hpp",
    "cosim/robot/motor_step.hpp",
    "cosim/robot/robot_spec.hpp",
    "cosim/servo/",
    "cosim/time/never.hpp",
}
# Of the parts that a scenario describes, the scenario may include their descriptions only.
DESCRIBED = {"bus", "cpu", "fault", "serial", "pendant"}
DESCRIPTION = re.compile(r"_spec\.hpp$|/bus_error\.hpp$")
# The libraries that the freestanding-capable controller may use.
HOST_ONLY = re.compile(r"^(iostream|fstream|sstream|filesystem|thread|mutex|chrono|fmt/|spdlog/|boost/|toml)")
