"""The stand-alone G-code interpreter `rs274` of LinuxCNC, if this machine has it, and the form in which calls compare.

It is found in the PATH, or by the environment variable RS274, which names the program. It is no part of the project.
"""

import os
import pathlib
import re
import shutil
import subprocess
import tempfile

# One tool of no length: lengths of tools come from G43.1 and G10 L1.
TOOLS = "T1 P1\nT2 P2\nT3 P3\n"
NUMBER = re.compile(r"-?\d+\.\d+|-?\d+")
# Both print 4 digits. The last one may differ where the sums have another order.
TOLERANCE = 1.01e-4
LINE = re.compile(r"^ *\d+ N\S* *(.*)$")
# Calls that only one of them makes: remarks, resets, tools in inches, waits without an answer.
SKIPPED = re.compile(
    r'COMMENT\("interpreter:|ON_RESET|SET_FEED_REFERENCE|SET_TOOL_TABLE_ENTRY|WAIT\(|LOG\(|PRINT\(|FINISH'
)


def find():
    """The path of rs274; None if there is none."""
    named = os.environ.get("RS274")
    return named if named else shutil.which("rs274")


def calls_of(output):
    """The canonical calls of an output, without what only one of both prints."""
    calls = []
    for line in output.splitlines():
        match = LINE.match(line)
        if match and not SKIPPED.match(match[1]):
            calls.append(match[1])
    return calls


def run_oracle(program, text):
    """(ended well, calls) of a program's text."""
    with tempfile.TemporaryDirectory() as folder:
        path = pathlib.Path(folder)
        (path / "tool.tbl").write_text(TOOLS, encoding="ascii")
        (path / "program.ngc").write_text(text, encoding="ascii")
        done = subprocess.run(
            [program, "-t", "tool.tbl", "-g", "program.ngc"],
            cwd=folder,
            capture_output=True,
            text=True,
            timeout=60,
            check=False,
        )
    return done.returncode == 0, calls_of(done.stdout)


def difference(ours, theirs):
    """The first difference of two lists of calls as text; None if there is none."""
    for index in range(max(len(ours), len(theirs))):
        mine = ours[index] if index < len(ours) else "(nothing)"
        other = theirs[index] if index < len(theirs) else "(nothing)"
        if not same(mine, other):
            return f"call {index + 1}: armature {mine}, rs274 {other}"
    return None


def same(mine, other):
    if NUMBER.sub("", mine) != NUMBER.sub("", other):
        return False
    pairs = zip(NUMBER.findall(mine), NUMBER.findall(other), strict=True)
    return all(abs(float(a) - float(b)) <= TOLERANCE * max(1.0, abs(float(b)) * 1e-6) for a, b in pairs)
