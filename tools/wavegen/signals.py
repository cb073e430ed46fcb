"""The content of cosim/fabric/software_signals.toml, and the rules for it."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

from table import Table, check_duplicates, read

SOURCE = "cosim/fabric/software_signals.toml"
CHARACTER_BITS = 8
WIDEST = 512
# Kind -> the key that gives the width; None: one bit.
KINDS = {"bit": None, "number": "bits", "signed": "bits", "hex": "bits", "text": "characters"}
COLORS = ("normal", "red", "orange", "yellow", "green", "blue", "indigo", "violet")  # of GTKWave, in its order


@dataclass(frozen=True)
class Signal:
    name: str
    kind: str
    bits: int
    unit: str
    color: str
    desc: str


@dataclass(frozen=True)
class Group:
    name: str
    signals: tuple[Signal, ...]


def _signal(group: str, values: dict) -> Signal:
    table = Table(f"{SOURCE}: [[group]] {group}, signal {values.get('name', '?')}", values)
    name = table.pop_name()
    kind = table.pop("kind", str)
    if kind not in KINDS:
        table.fail(f"`kind` must be one of {', '.join(KINDS)}, is {kind!r}")
    bits = 1
    if width := KINDS[kind]:
        bits = table.pop(width, int) * (CHARACTER_BITS if kind == "text" else 1)
        most = WIDEST if kind == "text" else 32
        if not 0 < bits <= most:
            table.fail(f"`{width}` must give 1 .. {most} bits, gives {bits}")
    unit = table.pop("unit", str) if kind in ("number", "signed") else ""
    color = table.pop("color", str, "normal")
    if color not in COLORS:
        table.fail(f"`color` must be one of {', '.join(COLORS)}, is {color!r}")
    desc = table.pop("desc", str)
    table.check_empty()
    return Signal(name, kind, bits, unit, color, desc)


def load(root: Path) -> list[Group]:
    table = read(root, root / SOURCE)
    groups = []
    for values in table.pop_tables("group"):
        group = Table(f"{SOURCE}: [[group]]", values)
        name = group.pop("name", str)
        signals = tuple(_signal(name, signal) for signal in group.pop_tables("signals"))
        group.check_empty()
        groups.append(Group(name, signals))
    table.check_empty()
    check_duplicates(table, "name of a signal", [signal.name for group in groups for signal in group.signals])
    return groups
