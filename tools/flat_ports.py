#!/usr/bin/env python3
"""tools/flat_ports.py MODULE.sv FLAT.sv: generates <module>_flat, which wraps <module> with plain ports.

C++ tests, proofs and test benches use a plain port for each member of a struct port. Member m of the port `<bus>_i` is
the port `<bus>_m_i`; the same holds for `_o`. Members of reg2hw and hw2reg have no bus name in front, because their
names already begin with the register. A port of `<Type>Bits` bits times a number is a vector of structs. Its member m
is a vector too, with element i at [i*W +: W].
"""

from __future__ import annotations

import re
import sys
from dataclasses import dataclass
from pathlib import Path

HEADERS = Path(__file__).resolve().parents[1] / "rtl/common"  # where the files are that rtl/ includes
TYPEDEF = re.compile(r"typedef struct packed \{(.*?)\} (\w+);", re.DOTALL)
MEMBER = re.compile(r"^\s*logic\s*(?:\[([^\]]*):0\])?\s*(\w+);", re.MULTILINE)
INCLUDE = re.compile(r'^`include "(\w+\.svh)"', re.MULTILINE)
COMMENT = re.compile(r"//[^\n]*|/\*.*?\*/", re.DOTALL)
PORT = re.compile(r"^\s*(input|output)\s+(\w+)\s*(?:signed)?\s*(\[.*\])?\s*(\w+)\s*,?\s*$", re.MULTILINE)
VECTOR = re.compile(r"\[(\w+)\*(\w+)Bits-1:0\]")
PARAMETER = re.compile(r"^\s*parameter\s+(.*?),?\s*$", re.MULTILINE)
NAMELESS = ("reg2hw", "hw2reg")


@dataclass(frozen=True)
class Member:
    name: str
    bits: int


@dataclass(frozen=True)
class Port:
    direction: str
    name: str
    range: str  # range of a plain port, "" for one bit
    struct: tuple[Member, ...] = ()  # members of a struct port; empty: a plain port
    count: str = ""  # number of structs in a vector; "": not a vector

    def flat(self, member: Member) -> str:
        bus, _, suffix = self.name.rpartition("_")
        return f"{member.name}_{suffix}" if bus in NAMELESS else f"{bus}_{member.name}_{suffix}"

    def flat_range(self, member: Member) -> str:
        if self.count:
            return f"[{self.count}*{member.bits}-1:0]"
        return f"[{member.bits - 1}:0]" if member.bits > 1 else ""

    @property
    def bits(self) -> int:
        """Number of bits of one struct."""
        return sum(member.bits for member in self.struct)


def _product(text: str) -> int:
    """The value of `6*16-1` or `31`."""
    factors = text.removesuffix("-1").split("*")
    value = 1
    for factor in factors:
        value *= int(factor)
    return value - 1 if text.endswith("-1") else value


def structs(text: str, folders: list[Path]) -> dict[str, tuple[Member, ...]]:
    """The struct types in the headers that `text` includes directly or indirectly."""
    found = {}
    for name in INCLUDE.findall(text):
        path = next((folder / name for folder in folders if (folder / name).is_file()), None)
        if path is None:
            continue
        header = path.read_text()
        found |= structs(header, folders)
        for body, kind in TYPEDEF.findall(COMMENT.sub("", header)):
            found[kind] = tuple(Member(member, _product(msb or "0") + 1) for msb, member in MEMBER.findall(body))
    return found


def head(text: str) -> str:
    """The text from `module` to the end of the port list, without comments."""
    match = re.search(r"^module\b.*?^\);", COMMENT.sub("", text), re.MULTILINE | re.DOTALL)
    if not match:
        raise ValueError("no module with a port list")
    return match[0]


def ports(text: str, folders: list[Path]) -> list[Port]:
    """The ports of the module in `text`."""
    types = structs(text, folders)
    by_vector = {
        "".join(word.capitalize() for word in kind.removesuffix("_t").split("_")): members
        for kind, members in types.items()
    }
    found = []
    for direction, kind, width, name in PORT.findall(head(text)):
        vector = VECTOR.fullmatch(width or "")
        if kind in types:
            found.append(Port(direction, name, "", types[kind]))
        elif vector and vector[2] in by_vector:
            found.append(Port(direction, name, "", by_vector[vector[2]], vector[1]))
        elif kind == "logic":
            found.append(Port(direction, name, width or ""))
        else:
            raise ValueError(f"port {name}: unknown type {kind}")
    return found


def parameters(text: str) -> list[str]:
    """The declarations `bit Name = value` of the module's parameters."""
    return PARAMETER.findall(head(text))


def module_name(text: str) -> str:
    return re.match(r"module\s+(\w+)", head(text))[1]


def has_struct_ports(text: str, folders: list[Path]) -> bool:
    return any(port.struct for port in ports(text, folders))


def _bus(port: Port) -> list[str]:
    """The net of a struct port and its members."""
    lines = [f"  logic [{port.count + '*' if port.count else ''}{port.bits}-1:0] {port.name};"]
    loop = f"  for (genvar i = 0; i < {port.count}; i++) begin : gen_{port.name}"
    lines += [loop] if port.count else []
    low = port.bits
    for member in port.struct:
        low -= member.bits
        flat = port.flat(member)
        if port.count:
            part = f"{port.name}[i*{port.bits}+{low} +: {member.bits}]"
            flat += f"[i*{member.bits} +: {member.bits}]"
        else:
            part = f"{port.name}[{low} +: {member.bits}]"
        left, right = (part, flat) if port.direction == "input" else (flat, part)
        lines.append(f"  {'  ' if port.count else ''}assign {left} = {right};")
    return lines + (["  end"] if port.count else [])


def flat_module(text: str, folders: list[Path]) -> str:
    """The source of <module>_flat."""
    name = module_name(text)
    declared = parameters(text)
    plain, nets = [], []
    for port in ports(text, folders):
        if not port.struct:
            plain.append(f"  {port.direction} logic {port.range} {port.name}")
            continue
        plain += [f"  {port.direction} logic {port.flat_range(member)} {port.flat(member)}" for member in port.struct]
        nets += _bus(port)
    passed = [re.search(r"(\w+)\s*=", parameter)[1] for parameter in declared]
    return "\n".join(
        [
            f"// Generated by tools/flat_ports.py from {name}.sv.",
            f"module {name}_flat" + (" #(" if declared else " ("),
            *([",\n".join(f"  parameter {parameter}" for parameter in declared), ") ("] if declared else []),
            ",\n".join(plain),
            ");",
            *nets,
            f"  {name} " + (f"#({', '.join(f'.{one}({one})' for one in passed)}) " if passed else "") + "u_flat (.*);",
            "endmodule",
            "",
        ]
    )


if __name__ == "__main__":
    source, target = map(Path, sys.argv[1:])
    target.write_text(flat_module(source.read_text(), [HEADERS]))
