"""The proof that no flop of a gated clock changes while active_o of the block is 0.

The proof gives every flop every clock edge, as hardware does. If the input of a flop equals its output before each edge
at which active_o is 0, the block without these edges behaves the same. The flops come from the netlist: all whose clock
is the gated pin.
"""

from __future__ import annotations

import re

import flat_ports
import harness

CLOCK = "clk_gated_i"
XBAR = "axi/axi_lite_xbar.sv"
XBAR_REQUESTS = ("s_axi_awvalid_i", "s_axi_wvalid_i", "s_axi_arvalid_i")  # active_o depends on flops only
ASSERTION = "StableWhileIdle"
IDLE = "idle"  # net of the proof's top; 1 while no flop may change
FLOP = re.compile(r"^  cell (\$\S*ff\S*|\$\S*latch\S*) \S+\n(.*?)^  end$", re.MULTILINE | re.DOTALL)
GUARD = """
  wire \\{name}.holds
  cell $eq \\{name}.eq
    parameter \\A_SIGNED 0
    parameter \\A_WIDTH {width}
    parameter \\B_SIGNED 0
    parameter \\B_WIDTH {width}
    parameter \\Y_WIDTH 1
    connect \\A {next}
    connect \\B {state}
    connect \\Y \\{name}.holds
  end
  cell $assert \\{name}.proved
    connect \\A \\{name}.holds
    connect \\EN \\{idle}
  end
"""


def has_gate(text: str) -> bool:
    return CLOCK in flat_ports.head(text)


def gate_proof(block: str, text: str, requests: tuple[str, ...] = ()) -> str:
    """The top of the proof: <block>_flat with free inputs. It has every output, so that Yosys removes no flop.

    A block without clk_gated_i has one clock, clk_i, which is gated. `requests`: inputs that request the clock too.
    """
    flat = flat_ports.flat_module(text, harness.HEADERS)
    ports = [f"  {port.direction} wire {port.range} {port.name}" for port in harness.ports(flat)]
    clock = ""
    if not has_gate(text):
        ports.append(f"  input wire {CLOCK}")
        clock = f", .clk_i({CLOCK})"
    parameters = [f"  parameter {parameter}" for parameter in flat_ports.parameters(text)]
    passed = [re.search(r"(\w+)\s*=", parameter)[1] for parameter in flat_ports.parameters(text)]
    return "\n".join(
        [
            f"module {block}_gate_proof",
            *(["#(", ",\n".join(parameters), ")"] if parameters else []),
            "(",
            ",\n".join(ports),
            ");",
            f"  {block}_flat #({', '.join(f'.{name}({name})' for name in passed)}) u_dut (.*{clock});",
            "  logic running_q = 1'b0;",
            "  always_ff @(posedge clk_i) running_q <= 1'b1;",
            "  formal_rule #(.Assume(1'b1)) ResetFirst (.live(1'b1), .holds(running_q || !rst_ni));",
            f"  (* keep *) wire {IDLE} = rst_ni && !({' || '.join(['active_o', *requests])});",
            f"  formal_reach Idle (.live(rst_ni), .seen({IDLE}));",
            "  formal_reach Active (.live(rst_ni), .seen(active_o));",
            "endmodule",
            "",
        ]
    )


def with_guards(netlist: str) -> str:
    """The RTLIL of one flat module of plain flops, with an assertion for each flop of the gated clock."""
    guards = []
    for kind, body in FLOP.findall(netlist):
        found = {name: value for name, value in re.findall(r"connect \\(\w+) (.*)", body)}
        clock = found.get("CLK", "").lstrip("\\")
        if clock not in ("clk_i", CLOCK) or kind != "$dff":
            raise ValueError(f"{kind} with the clock {clock or 'none'}")
        if clock == CLOCK:
            net = re.sub(r"[^\w.\[\]]", "", found["Q"])
            guards.append(
                GUARD.format(
                    name=f"{net}.{len(guards)}.{ASSERTION}",
                    width=re.search(r"parameter \\WIDTH (\d+)", body)[1],
                    next=found["D"],
                    state=found["Q"],
                    idle=IDLE,
                )
            )
    if not guards:
        raise ValueError("no flop has the gated clock")
    end = netlist.rindex("end\n")
    return netlist[:end] + "".join(guards) + "end\n"
