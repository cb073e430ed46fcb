#!/usr/bin/env python3
"""table.py BUILD: prints the speed of the simulation on this machine as one table.

The number of instructions does not depend on the load of the machine. perf counts them, or callgrind where perf has no
hardware counter. Instructions per clock: the difference of two runs of the same scenario with different ends. A time is
processor time, the best of several runs, so that other load hardly matters. Quote the ratios. All rows run the same RTL.
"""

import os
import re
import shutil
import subprocess
import sys
import tempfile
import time
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path[:0] = [str(ROOT / "tools"), str(ROOT / "cosim/serve/client")]
from armature_client import Soc  # noqa: E402
from processor_time import processor_s  # noqa: E402
from rtl_list import gated_clocks, rtl_sources  # noqa: E402

CLOCK_HZ = 50_000_000
# Name, scenario, and the simulated times between which clocks are counted [s]. In "idle" no move has started.
LOADS = (
    ("idle", "fig9_joint_move", 0.02, 0.05),
    ("fig9", "fig9_joint_move", 0.02, 0.05),
    ("max_rate", "max_rate_4mpps", 0.15, 0.17),
)
ICARUS = """
module tb;
  reg clk = 0, rst_n = 0;
  always #10 clk = !clk;
  arm_soc dut (.clk_i(clk), .rst_ni(rst_n), {clocks}, {inputs});
  integer clocks;
  initial begin
    if (!$value$plusargs("clocks=%d", clocks)) clocks = 0;
    repeat (16) @(posedge clk);
    rst_n <= 1;
    repeat (clocks) @(posedge clk);
    $finish;
  end
endmodule
"""


def run(*command, **options):
    done = subprocess.run([str(word) for word in command], capture_output=True, text=True, check=False, **options)
    if done.returncode not in (0, 1):  # 1: a shortened scenario misses its expectations
        raise SystemExit(f"{command[0]} ends with {done.returncode}\n{done.stderr[-1000:]}")
    return done.stdout + done.stderr


def instructions(command, folder):
    """Number of instructions that the whole program executes."""
    if shutil.which("perf"):
        counted = run("perf", "stat", "-x,", "-e", "instructions:u", *command)
        found = re.search(r"^(\d+),,instructions", counted, re.MULTILINE)
        if found:
            return int(found[1])
    counted = run("valgrind", "--tool=callgrind", f"--callgrind-out-file={folder}/callgrind", *command)
    return int(re.search(r"Collected : (\d+)", counted)[1])


def scenario(program, load, name, end_s, folder):
    start = ("--set", f"move[0].at_s={end_s - 0.0001}") if load == "idle" else ()
    return [program, "run", ROOT / "scenarios" / name, "--set", f"duration_s={end_s}", *start, "--out", folder / "out"]


def best_s(work, runs=3):
    times = []
    for _ in range(runs):
        start = processor_s()
        work()
        times.append(processor_s() - start)
    return min(times)


def icarus_s(folder):
    """Time per clock of the idle logic in Icarus Verilog."""
    text = (ROOT / "rtl/soc/arm_soc.sv").read_text() + (ROOT / "rtl/common/arm_soc_pins.svh").read_text()
    names = re.findall(r"^  input +logic +(?:\[[^\]]*\] +)?(\w+)", text, re.MULTILINE)
    clocks = ", ".join(f".{name}(clk)" for name in gated_clocks(ROOT))
    high = {name for name in names if name.endswith("_ni")} | {"uart_rxd_i"}
    pins = [name for name in names if name != "rst_ni" and not name.startswith("clk_")]
    inputs = ", ".join(f".{name}('{int(name in high)})" for name in pins)
    (folder / "tb.sv").write_text(ICARUS.format(clocks=clocks, inputs=inputs))
    sources = [ROOT / "rtl" / source for source in rtl_sources(ROOT)]
    run(
        "iverilog", "-g2012", "-s", "tb", "-I", ROOT / "rtl/common", "-o", folder / "tb.vvp", *sources, folder / "tb.sv"
    )
    few, many = (best_s(lambda: run("vvp", "-n", folder / "tb.vvp", f"+clocks={n}"), 2) for n in (1_000, 21_000))
    return (many - few) / 20_000


def client_s(program, folder):
    """Time per clock of a Python test bench and its server. It runs one clock and reads one pin per call.

    Both share a processor: to wake another one that is idle costs several times as much, and depends on the machine.
    """
    path, clocks = folder / "socket", 20_000
    processors = os.sched_getaffinity(0)

    def connected():
        for _ in range(1000):
            try:
                return Soc(str(path))
            except (FileNotFoundError, ConnectionRefusedError):  # the server does not listen yet
                time.sleep(0.01)
        raise SystemExit("armature serve does not listen")

    def each_clock():
        os.sched_setaffinity(0, {min(processors)})
        server = subprocess.Popen([str(program), "serve", "--listen", str(path)], stdout=subprocess.DEVNULL)
        try:
            with connected() as soc:
                for _ in range(clocks):
                    soc.run(1)
                    soc.pin("irq_o")
        finally:
            server.terminate()
            server.wait()
            path.unlink(missing_ok=True)
            os.sched_setaffinity(0, processors)

    return best_s(each_clock) / clocks


def nanoseconds(program, name):
    """Time that a benchmark prints after its name."""
    printed = run(program, f"--benchmark_filter=^{name}/")
    return float(re.search(rf"^{name} +([\d.]+) ns", printed, re.MULTILINE)[1])


def show(name, value):
    print(f"{name:56}  {value:>8}", flush=True)


def main():
    build = Path(sys.argv[1])
    benches = build / "tests/bench"
    program = build / "armature"
    os.chdir(ROOT)
    with tempfile.TemporaryDirectory() as scratch:
        folder = Path(scratch)
        for name, scene, begin_s, end_s in LOADS:
            few, many = (instructions(scenario(program, name, scene, end, folder), folder) for end in (begin_s, end_s))
            show(f"instructions per clock, {name}", f"{(many - few) / (CLOCK_HZ * (end_s - begin_s)):.0f}")
        clock_s = {}
        for name, scene, begin_s, end_s in LOADS[1:]:
            few, many = (
                best_s(lambda end=end: run(*scenario(program, name, scene, end, folder)))
                for end in (begin_s, end_s + 0.1)
            )
            clock_s[name] = (many - few) / (CLOCK_HZ * (end_s + 0.1 - begin_s))
            show(f"real-time factor, {name}", f"{1 / (CLOCK_HZ * clock_s[name]):.3f}")
        loop = run(benches / "cycle_loop_bench", "5", "bare")
        for name, ratio in re.findall(r"^(\w+) / bare model +([\d.]+)", loop, re.MULTILINE):
            show(f"{name} / bare model with the same pins and bus", ratio)
        show("Icarus 11, idle / fig9", f"{icarus_s(folder) / clock_s['fig9']:.0f}")
        show("Python client, a call per clock and pin / fig9", f"{client_s(program, folder) / clock_s['fig9']:.0f}")
    show(
        "inverse kinematics of six axes, tracked [ns]", f"{nanoseconds(benches / 'kinematics_bench', 'Arm track'):.0f}"
    )
    show("software of a tick, joint move [ns]", f"{nanoseconds(benches / 'tick_bench', 'joint move'):.0f}")


if __name__ == "__main__":
    main()
