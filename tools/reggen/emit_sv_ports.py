"""SystemVerilog: the port list of a register file."""

from __future__ import annotations

from typing import NamedTuple

import names
from model import Access, Block, Field, Register
from text import columns, comment, trailing

BUS = """\
  input  logic        clk_i,
  input  logic        rst_ni,

  // Write: one-cycle strobe; the error follows in the next cycle.
  input  logic        reg_we_i,
  input  logic [15:0] reg_waddr_i,
  input  logic [31:0] reg_wdata_i,
  input  logic [3:0]  reg_wstrb_i,
  output logic        reg_werr_o,   // unmapped, or no writable field

  // Read: one-cycle strobe; data and error follow in the next cycle and hold until the next strobe.
  input  logic        reg_re_i,
  input  logic [15:0] reg_raddr_i,
  output logic [31:0] reg_rdata_o,
  output logic        reg_rerr_o"""


class Port(NamedTuple):
    direction: str
    width: str
    name: str
    desc: str


def _range(reg: Register, field: Field) -> str:
    if reg.is_array:
        return f"[{reg.count}*{field.width}-1:0]" if field.width > 1 else f"[{reg.count - 1}:0]"
    return f"[{field.width - 1}:0]" if field.width > 1 else ""


def _field_ports(reg: Register, field: Field) -> list[Port]:
    width = _range(reg, field)
    unit = f"[{field.unit}] " if field.unit else ""
    value = Port("input" if field.access is Access.RO else "output", width, names.port(reg, field), unit + field.desc)
    if field.access is Access.CONST:
        return []
    if field.access is Access.W1C:
        return [Port("input", width, names.set_port(reg, field), "event that sets the flag"), value]
    return [value]


def _ports(reg: Register) -> list[Port]:
    if reg.external:
        write = [
            Port("output", "", names.external_port(reg, "we_o"), "in the cycle of reg_we_i"),
            Port("output", "[31:0]", names.external_port(reg, "wdata_o"), ""),
            Port("output", "[3:0]", names.external_port(reg, "wstrb_o"), ""),
        ]
        return (write if reg.writable else []) + [
            Port("output", "", names.external_port(reg, "re_o"), "in the cycle of reg_re_i"),
            Port("input", "[31:0]", names.external_port(reg, "rdata_i"), "sampled with it"),
        ]
    ports = [port for field in reg.fields for port in _field_ports(reg, field)]
    if reg.strobe:
        width = f"[{reg.count - 1}:0]" if reg.is_array else ""
        ports.append(Port("output", width, names.strobe_port(reg), "one cycle, when the fields hold the written value"))
    return ports


def port_list(block: Block) -> list[str]:
    groups = [(reg, _ports(reg)) for reg in block.registers]
    groups = [(reg, ports) for reg, ports in groups if ports]
    rows = [(p.direction, "logic", p.width, p.name) for _, ports in groups for p in ports]
    codes = iter(columns(rows))
    last = groups[-1][1][-1] if groups else None
    column = max((len(line) for line in columns(rows)), default=0) + 5
    lines = BUS.split("\n")
    if groups:
        lines[-1] += ","
    for reg, ports in groups:
        lines += ["", *comment(f"0x{reg.offset:02X} {reg.label}: {reg.desc}.", "  ")]
        for port in ports:
            lines += trailing(f"  {next(codes)}{'' if port is last else ','}", port.desc, column)
    return lines
