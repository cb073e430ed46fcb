"""check_firmware.py ARMATURE_ISS SCENARIO: the firmware, executed instruction by instruction, gives the bytes that the
controller gives as compiled for the host, and those of the golden."""

import json
import pathlib
import subprocess
import sys
import tempfile


def results(folder):
    """The files of a run; of the summary all but what depends on the time of day."""
    files = {path.name: path.read_bytes() for path in folder.iterdir()}
    summary = json.loads(files["summary.json"])
    del summary["host"]
    return {**files, "summary.json": json.dumps(summary, indent=1).encode()}


def main(program, scenario):
    with tempfile.TemporaryDirectory() as scratch:
        found = {}
        for cpu in ("host", "a9"):
            out = pathlib.Path(scratch, cpu)
            words = [program, "run", scenario, "--engine", "model", "--cpu", cpu, "--out", out]
            done = subprocess.run(words, text=True, stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
            if done.returncode:
                print(f"--cpu {cpu}:\n{done.stdout}")
                return 1
            found[cpu] = results(out)
    host, a9 = found["host"], found["a9"]
    different = sorted(name for name in host.keys() | a9.keys() if host.get(name) != a9.get(name))
    if different:
        print(f"--cpu a9 differs from --cpu host in {', '.join(different)}")
    return int(bool(different) or "trace.csv" not in host)


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
