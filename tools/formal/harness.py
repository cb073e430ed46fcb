"""SystemVerilog around a block, made from its port list: one port a line, as everywhere in rtl/."""

from __future__ import annotations

import re

PORT = re.compile(r"^\s*(input|output)\s+logic\s*(signed)?\s*(\[[^\]]*(?:\[[^\]]*\][^\]]*)*\])?\s*(\w+)", re.M)
PARAMETER = re.compile(r"^\s*parameter\s+(.*?),?\s*$", re.M)
AXI = re.compile(r"s_axi_\w+")


def _header(text: str) -> str:
    """From `module` to the end of the port list."""
    match = re.search(r"^module\b.*?^\);", text, re.M | re.S)
    if not match:
        raise ValueError("no module header")
    return re.sub(r"//[^\n]*", "", match[0])


def ports(text: str) -> list[tuple[str, str, str]]:
    """Direction, range and name."""
    return [(direction, width or "", name) for direction, _, width, name in PORT.findall(_header(text))]


def stub(text: str) -> str:
    """The module with free outputs, except what a register file promises: what it read holds until the next read."""
    lines = [_header(text)]
    held = {"reg_rdata_o", "reg_rerr_o"}
    names = {name for _, _, name in ports(text)}
    for direction, width, name in ports(text):
        if direction == "input":
            continue
        lines.append(f"  (* anyseq *) logic {width} any_{name};")
        if name in held and "reg_re_i" in names:
            lines.append(f"  always_ff @(posedge clk_i) if (!rst_ni || reg_re_i) {name} <= any_{name};")
        else:
            lines.append(f"  assign {name} = any_{name};")
    return "\n".join([*lines, "endmodule", ""])


def port_proof(block: str, text: str) -> str:
    """The block with free pins under the rules of AXI4-Lite."""
    found = ports(text)
    if not any(name == "s_axi_awaddr_i" for _, _, name in found):
        raise ValueError(f"{block} has no AXI4-Lite port")
    # A gated clock has every edge here.
    gated = {"clk_gated_i"}
    inputs = [f"  input wire {width} {name}" for direction, width, name in found
              if direction == "input" and name not in gated]
    clocks = [f"  wire {name} = clk_i;" for _, _, name in found if name in gated]
    outputs = [f"  logic {width} {name};" for direction, width, name in found if direction == "output"]
    rules = []
    for _, _, name in found:
        if AXI.fullmatch(name):
            rules.append(f"    .{name.removeprefix('s_axi_')[:-2]}({name})")
    # The ranges of the ports may need them.
    parameters = [f"  parameter {parameter}" for parameter in PARAMETER.findall(_header(text))]
    return "\n".join([
        '`include "assert.svh"',
        "`default_nettype none",
        f"module {block}_port_proof",
        *(["#(", ",\n".join(parameters), ")"] if parameters else []),
        "(",
        ",\n".join(inputs),
        ");",
        *clocks,
        *outputs,
        f"  {block} u_dut (.*);",
        "  `RESET_FIRST",
        "  axi_lite_properties #(.AddrWidth($bits(s_axi_awaddr_i))) u_rules (",
        "    .clk_i, .rst_ni,",
        ",\n".join(rules),
        "  );",
        "endmodule",
        "`default_nettype wire",
        "",
    ])
