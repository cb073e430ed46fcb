"""SystemVerilog: the structs between a register file and its core."""

from __future__ import annotations

from typing import NamedTuple

import names
from model import Access, Block, Field, Register
from text import columns, comment, header, trailing

REG2HW = "reg2hw"  # from the register file to the core
HW2REG = "hw2reg"


class Member(NamedTuple):
    struct: str  # REG2HW or HW2REG
    width: str  # a range, empty for one bit
    name: str
    desc: str


# Shared by all external registers that can be written.
WRITE_DATA = (
    Member(REG2HW, "[31:0]", "wdata", "write data, valid with <register>_we"),
    Member(REG2HW, "[3:0]", "wstrb", "byte enables, valid with <register>_we"),
)


def _range(reg: Register, field: Field) -> str:
    if reg.is_array:
        return f"[{reg.count}*{field.width}-1:0]" if field.width > 1 else f"[{reg.count - 1}:0]"
    return f"[{field.width - 1}:0]" if field.width > 1 else ""


def _of_field(reg: Register, field: Field) -> list[Member]:
    if field.access in (Access.CONST, Access.KEY):  # of KEY, the core needs nothing
        return []
    width = _range(reg, field)
    unit = f"[{field.unit}] " if field.unit else ""
    struct = HW2REG if field.access is Access.RO else REG2HW
    found = [Member(struct, width, names.member(reg, field), unit + field.desc)]
    if field.access is Access.W1C:
        found.append(Member(HW2REG, width, names.event(reg, field), "event, one cycle; sets the flag"))
    return found


def members_of(reg: Register) -> list[Member]:
    if reg.external:
        write = [Member(REG2HW, "", names.external(reg, "we"), "write strobe, one cycle")] if reg.writable else []
        return [
            *write,
            Member(REG2HW, "", names.external(reg, "re"), "read strobe, one cycle"),
            Member(HW2REG, "[31:0]", names.external(reg, "rdata"), "sampled in the cycle of the read strobe"),
        ]
    found = [member for field in reg.fields for member in _of_field(reg, field)]
    if reg.strobe:
        width = f"[{reg.count - 1}:0]" if reg.is_array else ""
        found.append(Member(REG2HW, width, names.strobe(reg), "one cycle, when the fields have the written value"))
    return found


def write_data(block: Block) -> tuple[Member, ...]:
    return WRITE_DATA if any(reg.external and reg.writable for reg in block.registers) else ()


def members(block: Block) -> list[Member]:
    """The members of both structs, in order."""
    return [*write_data(block), *(member for reg in block.registers for member in members_of(reg))]


def structs(block: Block) -> list[str]:
    """The structs that have members."""
    used = {member.struct for member in members(block)}
    return [struct for struct in (REG2HW, HW2REG) if struct in used]


def type_name(block: Block, struct: str) -> str:
    return f"{block.name}_{struct}_t"


def _typedef(block: Block, struct: str) -> list[str]:
    groups = [("Write access to an external register.", write_data(block))]
    groups += [(f"0x{reg.offset:02X} {reg.label}: {reg.desc}.", members_of(reg)) for reg in block.registers]
    groups = [(title, [member for member in found if member.struct == struct]) for title, found in groups]
    rows = columns([("logic", member.width, f"{member.name};") for _, found in groups for member in found])
    codes = iter(rows)
    column = max(map(len, rows)) + 4
    lines = ["", "typedef struct packed {"]
    for title, found in groups:
        if found:
            lines += comment(title, "  ")
            for member in found:
                lines += trailing(f"  {next(codes)}", member.desc, column)
    return [*lines, f"}} {type_name(block, struct)};"]


def types(block: Block) -> str:
    guard = f"{block.name.upper()}_REG_TYPES_SVH"
    lines = [
        header("//", block.source),
        "//",
        f"// Signals from the registers of {block.name} to the core (reg2hw) and from the core (hw2reg).",
        "// Element i of an array is at [i*W +: W] of its member, W bits wide.",
        f"`ifndef {guard}",
        f"`define {guard}",
        "",
        '`include "reg_access_types.svh"',
    ]
    for struct in structs(block):
        lines += _typedef(block, struct)
    return "\n".join([*lines, "", "`endif"]) + "\n"
