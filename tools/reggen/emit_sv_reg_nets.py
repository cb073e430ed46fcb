"""SystemVerilog: the ports of a register file, the nets behind their members, and their bits."""

from __future__ import annotations

from typing import NamedTuple

import names
from emit_sv_types import REG2HW, members, structs, type_name, write_data
from model import Block, Field, Register
from text import columns, comment

BYTES = 4

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


LOCK = """
  // A protected register is read only while locked is 1.
  logic key_unlocked_q, locked;
  assign locked = protect_i && !key_unlocked_q;"""


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


def protect_port(block: Block) -> list[str]:
    if not block.key:
        return []
    return comment(f"Level, 1 while {block.protected_while}: the protected registers need the key.", "  ") + [
        "  input logic protect_i,",
        "",
    ]


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
    lock = LOCK.split("\n") if block.key else []
    return [*BUS.split("\n"), *lock, *(["", *columns(declared), *columns(assigned)] if assigned else [])]


class Slice(NamedTuple):
    """The part of a field that one byte strobe writes."""

    byte: int
    low: int  # bit of the field
    width: int


def slices(field: Field) -> list[Slice]:
    slices = []
    for byte in range(BYTES):
        low, high = max(field.lsb, 8 * byte), min(field.msb, 8 * byte + 7)
        if low <= high:
            slices.append(Slice(byte, low - field.lsb, high - low + 1))
    return slices


def bit_range(name: str, low: int, width: int) -> str:
    return f"{name}[{low + width - 1}:{low}]" if width > 1 else f"{name}[{low}]"


def unread(used: int, name: str, width: int) -> list[str]:
    """The maximal ranges of `name` whose bits are not in the mask `used`."""
    ranges = []
    bit = 0
    while bit < width:
        end = bit
        while end < width and not used >> end & 1:
            end += 1
        if end > bit:
            ranges.append(name if end - bit == width else bit_range(name, bit, end - bit))
        bit = end + 1
    return ranges


def unused(block: Block) -> list[str]:
    """Unused input bits, collected for lint."""
    data = strobes = 0
    for reg in block.registers:
        if reg.external and reg.writable:
            data, strobes = 0xFFFFFFFF, 0xF
        if reg.strobe:
            strobes = 0xF
        if reg.key is not None:
            data, strobes = 0xFFFFFFFF, 0xF
    for _, field in stored(block):
        data |= field.mask
        for part in slices(field):
            strobes |= 1 << part.byte
    bits = ["reg_i.waddr[1:0]", "reg_i.raddr[1:0]"]
    bits += unread(data, "wdata", 32) + unread(strobes, "wstrb", 4)
    return ["  logic unused;", f"  assign unused = ^{{{', '.join(bits)}}};"]
