"""Generates SystemVerilog around a block from its port list, which has one port per line, as everywhere in rtl/."""

from __future__ import annotations

import re
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tools"))
import flat_ports  # noqa: E402
from flat_ports import Member, Port  # noqa: E402

HEADERS = [flat_ports.HEADERS]
AXI = re.compile(r"s_axi_\w+")


def ports(text: str, folders: list[Path] = HEADERS) -> list[Port]:
    return flat_ports.ports(text, folders)


def _held(port: Port, member: Member) -> bool:
    """Whether the member is read data, which a register file holds until the next read."""
    return port.name == "reg_o" and member.name in ("rdata", "rerr")


def stub(text: str) -> str:
    """A copy of the module with free outputs, except that read data of a register file is held."""
    headers = [f'`include "{name}"' for name in flat_ports.INCLUDE.findall(text)]
    lines = [*headers, flat_ports.head(text)]
    for port in ports(text):
        if port.direction == "input":
            continue
        if not port.struct:
            lines += [f"  (* anyseq *) logic {port.range} any_{port.name};", f"  assign {port.name} = any_{port.name};"]
        for member in port.struct:
            width = f"[{member.bits - 1}:0]"
            value = f"any_{port.name}_{member.name}"
            lines.append(f"  (* anyseq *) logic {width} {value};")
            if _held(port, member):
                lines += [
                    f"  logic {width} held_{member.name};",
                    f"  always_ff @(posedge clk_i) if (!rst_ni || reg_i.re) held_{member.name} <= {value};",
                ]
                value = f"held_{member.name}"
            lines.append(f"  assign {port.name}.{member.name} = {value};")
    return "\n".join([*lines, "endmodule", ""])


def port_proof(block: str, text: str) -> str:
    """A proof of the AXI4-Lite rules of the block, with free pins. It instantiates <block>_flat."""
    flat = flat_ports.flat_module(text, HEADERS)
    found = ports(flat)
    if not any(port.name == "s_axi_awaddr_i" for port in found):
        raise ValueError(f"{block} has no AXI4-Lite port")
    # In the proof a gated clock is the clock itself.
    gated = {"clk_gated_i"}
    inputs = [
        f"  input wire {port.range} {port.name}"
        for port in found
        if port.direction == "input" and port.name not in gated
    ]
    clocks = [f"  wire {port.name} = clk_i;" for port in found if port.name in gated]
    outputs = [f"  logic {port.range} {port.name};" for port in found if port.direction == "output"]
    rules = [f"    .{port.name.removeprefix('s_axi_')[:-2]}({port.name})" for port in found if AXI.fullmatch(port.name)]
    # The ranges of the ports may use the parameters.
    parameters = [f"  parameter {parameter}" for parameter in flat_ports.parameters(text)]
    return "\n".join(
        [
            '`include "assert.svh"',
            "`default_nettype none",
            f"module {block}_port_proof",
            *(["#(", ",\n".join(parameters), ")"] if parameters else []),
            "(",
            ",\n".join(inputs),
            ");",
            *clocks,
            *outputs,
            f"  {block}_flat u_dut (.*);",
            "  `RESET_FIRST",
            "  axi_lite_properties #(.AddrWidth($bits(s_axi_awaddr_i))) u_rules (",
            "    .clk_i, .rst_ni,",
            ",\n".join(rules),
            "  );",
            "endmodule",
            "`default_nettype wire",
            "",
        ]
    )
