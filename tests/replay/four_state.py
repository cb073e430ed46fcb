"""four_state.py PAPER VECTORS...: arm_soc in a four-state simulator (Icarus Verilog) gives the recorded outputs, no X.

PAPER is 0 or 1. Each file is replayed from power-up with all flops X, with a reset and then the recorded inputs. A copy
of the last file with one wrong bit in each output shows that the comparison can fail.
"""

import pathlib
import re
import subprocess
import sys
import tempfile
from dataclasses import dataclass

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tools"))

sys.path.insert(0, str(ROOT / "tools/reggen"))
sys.dont_write_bytecode = True

from load import load_all  # noqa: E402
from rtl_list import gated_clocks, rtl_sources  # noqa: E402

PREFIX_CLOCKS = 1000
# Ports of the bus with their bits, in the order of a line (vectors.hpp).
BUS_INPUTS = {
    "awaddr": 32,
    "wdata": 32,
    "araddr": 32,
    "wstrb": 4,
    "awvalid": 1,
    "wvalid": 1,
    "bready": 1,
    "arvalid": 1,
    "rready": 1,
}
BUS_OUTPUTS = {"rdata": 32, "bresp": 2, "rresp": 2, "awready": 1, "wready": 1, "bvalid": 1, "arready": 1, "rvalid": 1}


@dataclass(frozen=True)
class Field:
    port: str
    bits: int
    lsb: int  # bit of the line
    is_input: bool
    idle: int = 0  # idle level of each bit

    @property
    def part(self):
        return f"vector[{self.lsb} +: {self.bits}]"


def fields_of_a_line():
    """From bit 0: inputs of the bus, input pins, outputs of the bus, output pins."""
    pins = load_all(ROOT)[0].pins
    rows = [(f"s_axi_{name}_i", bits, True, 0) for name, bits in BUS_INPUTS.items()]
    rows += [(pin.port, pin.width, True, pin.idle) for pin in pins if pin.is_input]
    rows += [(f"s_axi_{name}_o", bits, False, 0) for name, bits in BUS_OUTPUTS.items()]
    rows += [(pin.port, pin.width, False, pin.idle) for pin in pins if not pin.is_input]
    fields, lsb = [], 0
    for port, bits, is_input, idle in rows:
        fields.append(Field(port, bits, lsb, is_input, idle))
        lsb += bits
    return fields


def digits_of_a_line(fields):
    return (sum(field.bits for field in fields) + 31) // 32 * 8


def wiring(fields):
    """The text of replay_dut.svh, which replay_tb.sv includes."""
    inputs = [field for field in fields if field.is_input]
    outputs = [field for field in fields if not field.is_input]
    idle = sum((((1 << field.bits) - 1) * field.idle) << field.lsb for field in inputs)
    bits = 4 * digits_of_a_line(fields)
    lines = [
        f"  localparam Bits = {bits};",
        f"  localparam [Bits-1:0] Idle = {bits}'h{idle:x};",
        "  reg [Bits-1:0] vector;",
    ]
    lines += [f"  wire [{field.bits - 1}:0] {field.port};" for field in outputs]
    clocks = ["clk_i", *gated_clocks(ROOT)]  # none is gated here
    ports = [*(f".{clock}(clk)" for clock in clocks), ".rst_ni(rst_n)", ".active_o()"]
    ports += [f".{field.port}({field.part if field.is_input else field.port})" for field in fields]
    lines += ["  arm_soc #(.PaperFabric(PaperFabric)) dut (", "    " + ",\n    ".join(ports), "  );"]
    lines += ["  task check_outputs;", "    begin"]
    lines += [f'      check("{field.port}", {field.port}, {field.part});' for field in outputs]
    return "\n".join([*lines, "    end", "  endtask"]) + "\n"


def compile_bench(folder, paper, fields):
    (folder / "replay_dut.svh").write_text(wiring(fields), encoding="ascii")
    bench = folder / "replay.vvp"
    run = subprocess.run(
        [
            "iverilog",
            "-g2012",
            "-o",
            bench,
            f"-Preplay_tb.PaperFabric={paper}",
            "-s",
            "replay_tb",
            "-I",
            folder,
            "-I",
            ROOT / "rtl/common",
            *(ROOT / "rtl" / source for source in rtl_sources(ROOT)),
            ROOT / "tests/replay/replay_tb.sv",
        ],
        capture_output=True,
        text=True,
        check=False,
    )
    if run.returncode:
        sys.exit(run.stdout + run.stderr)
    return bench


def replay(bench, vectors):
    """Returns the number of clocks, the number of differences and the whole output."""
    run = subprocess.run(["vvp", "-n", bench, f"+vectors={vectors}"], capture_output=True, text=True, check=False)
    counts = re.search(r"^(\d+) clocks, (\d+) differences$", run.stdout, re.MULTILINE)
    if not counts:
        sys.exit(f"{vectors}: the bench did not finish\n{run.stdout}{run.stderr}")
    return int(counts[1]), int(counts[2]), run.stdout


def with_wrong_outputs(line, fields):
    """The line with the lowest bit of each output inverted."""
    flips = sum(1 << field.lsb for field in fields if not field.is_input)
    return f"{int(line, 16) ^ flips:0{digits_of_a_line(fields)}x}\n"


def main():
    paper, *files = sys.argv[1:]
    failed = False
    fields = fields_of_a_line()
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        bench = compile_bench(folder, paper, fields)
        for vectors in files:
            with open(vectors, encoding="ascii") as file:
                lines = sum(1 for _ in file)
            clocks, differences, output = replay(bench, vectors)
            good = clocks == lines > 0 and differences == 0
            failed |= not good
            print(f"{'ok    ' if good else 'FAILED'}  {vectors}: {clocks} of {lines} clocks, {differences} differences")
            if not good:
                print(output)
        # The bench must detect a wrong level of each output.
        with open(files[-1], encoding="ascii") as file:
            lines = [line for _, line in zip(range(PREFIX_CLOCKS), file)]
        if {len(line) for line in lines} != {digits_of_a_line(fields) + 1}:
            sys.exit(f"{files[-1]}: expected {digits_of_a_line(fields)} digits in a line")
        broken = folder / "broken.txt"
        broken.write_text("".join(lines[:-1]) + with_wrong_outputs(lines[-1], fields), encoding="ascii")
        clocks, _, output = replay(bench, broken)
        noticed = re.findall(r"^clock (\d+): (\w+) is ", output, re.MULTILINE)
        expected = [(str(PREFIX_CLOCKS), field.port) for field in fields if not field.is_input]
        if clocks != PREFIX_CLOCKS or noticed != expected:
            print(f"FAILED  a wrong bit in each output: expected {expected}, the bench reports {noticed}")
            failed = True
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
