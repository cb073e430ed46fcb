"""SystemVerilog: the ports of a register file and the nets behind their members."""

from __future__ import annotations

import names
from emit_sv_types import REG2HW, members, structs, type_name, write_data
from model import Block, Field, Register
from text import columns

BUS = """
  logic        we, re, werr_q, rerr_q;
  logic [15:0] waddr, raddr;
  logic [31:0] wdata, rdata_q;
  logic [3:0]  wstrb;
  assign we          = reg_i.we;
  assign waddr       = {reg_i.waddr[15:2], 2'b00};
  assign wdata       = reg_i.wdata;
  assign wstrb       = reg_i.wstrb;
  assign re          = reg_i.re;
  assign raddr       = {reg_i.raddr[15:2], 2'b00};
  assign reg_o.werr  = werr_q;
  assign reg_o.rdata = rdata_q;
  assign reg_o.rerr  = rerr_q;"""


def stored(block: Block) -> list[tuple[Register, Field]]:
    """The fields with a flop in the register file."""
    registers = (reg for reg in block.registers if not reg.external)
    return [(reg, field) for reg in registers for field in reg.fields if field.access.writable]


def ports(block: Block) -> list[str]:
    rows = [("  input", "reg_req_t", "reg_i"), ("  output", "reg_rsp_t", "reg_o")]
    for struct in structs(block):
        direction, suffix = ("output", "o") if struct == REG2HW else ("input", "i")
        rows.append((f"  {direction}", type_name(block, struct), f"{struct}_{suffix}"))
    return [line + "," for line in columns(rows)[:-1]] + columns(rows)[-1:]


def nets(block: Block) -> list[str]:
    """One net per member of the structs: part of a struct takes more simulation time than a net."""
    flops = {names.member(reg, field) for reg, field in stored(block)}
    flops |= {names.strobe(reg) for reg in block.registers if reg.strobe}
    shared = {member.name for member in write_data(block)}
    declared, assigned = [], []
    for member in members(block):
        net = f"{member.name}_q" if member.name in flops else member.name
        if member.name not in shared:
            declared.append(("  logic", member.width, f"{net};"))
        if member.struct == REG2HW:
            assigned.append((f"  assign reg2hw_o.{member.name}", f"= {net};"))
        else:
            assigned.append((f"  assign {net}", f"= hw2reg_i.{member.name};"))
    return [*BUS.split("\n"), *(["", *columns(declared), *columns(assigned)] if assigned else [])]
