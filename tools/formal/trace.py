"""Writes a run of the solver as a VCD file with the names of the design."""

from __future__ import annotations

import re
from pathlib import Path

from synthesis import Design


def _wires(design: Design) -> dict[str, dict[int, int]]:
    """The literal of each bit of each named net."""
    wires: dict[str, dict[int, int]] = {}
    for line in (design.folder / "design.map").read_text().splitlines():
        kind, number, bit, name = line.split(maxsplit=3)
        if "$" in name:
            continue
        if kind == "wire":
            wires.setdefault(name, {})[int(bit)] = int(number)
        elif kind == "latch":
            wires.setdefault(name, {}).setdefault(int(bit), 2 * (1 + design.aiger.inputs + int(number)))
    return wires


def write_vcd(design: Design, run: list[list[int]], path: Path):
    """One time step per clock, with the values before the edge at its end."""
    wires = _wires(design)
    lines = ["$timescale 1 ns $end"]
    for number, (name, bits) in enumerate(sorted(wires.items())):
        *scopes, leaf = name.split(".")
        lines += [f"$scope module {re.sub('[^A-Za-z0-9_]', '_', scope)} $end" for scope in ["top", *scopes]]
        lines.append(f"$var wire {1 + max(bits)} n{number} {leaf} $end")
        lines += ["$upscope $end"] * (1 + len(scopes))
    lines.append("$enddefinitions $end")
    for clock, values in enumerate(run):
        lines.append(f"#{20 * clock}")
        for number, (_, bits) in enumerate(sorted(wires.items())):
            word = "".join(
                str(values[bits[bit] >> 1] ^ (bits[bit] & 1)) if bit in bits else "x"
                for bit in range(max(bits), -1, -1)
            )
            lines.append(f"b{word} n{number}")
    lines.append(f"#{20 * len(run)}")
    path.write_text("\n".join(lines) + "\n")
