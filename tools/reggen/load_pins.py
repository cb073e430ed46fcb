"""Reads and validates the pins of soc_map.toml."""

from __future__ import annotations

import re

from model import WORD_BITS, Pin, PinGroup
from table import Table, check_duplicates

OUTPUT_BITS = 64  # cosim/fabric compares all outputs as one word in each clock
DIRECTIONS = ("in", "out")
PULLS = ("up", "down")
NO_PIN = re.compile(r"clk(_.*)?|rst|active|s_axi_.*")  # ports that are not pins


def _one_of(table: Table, key: str, value: str, allowed) -> str:
    if value not in allowed:
        table.fail(f"`{key}`: {value} is none of {', '.join(allowed)}")
    return value


def _width(table: Table, per: str | None, widths: dict[str, int]) -> int:
    bits = table.pop_optional("bits", int)
    if per is None:
        if bits is not None and not 1 <= bits <= WORD_BITS:
            table.fail(f"bits {bits} is outside 1..{WORD_BITS}")
        return bits or 1
    if bits is not None:
        table.fail(f"`bits` is not for a pin with `per`, which has {widths[per]}")
    if widths[per] == 0:
        table.fail(f"`per`: no block has an {per}")
    return widths[per]


def _pin(where: str, values: dict, widths: dict[str, int]) -> Pin:
    table = Table(f"{where}: pin {values.get('name', '?')}", values)
    name = table.pop_name()
    if NO_PIN.fullmatch(name):
        table.fail("the clocks, the reset and the bus are not pins")
    is_input = _one_of(table, "dir", table.pop("dir", str), DIRECTIONS) == "in"
    per = table.pop_optional("per", str)
    if per is not None:
        _one_of(table, "per", per, widths)
    width = _width(table, per, widths)
    active_low = table.pop("active_low", bool, False)
    idle = table.pop("idle", int, 1 if active_low else 0)
    if idle not in (0, 1):
        table.fail(f"idle {idle} is neither 0 nor 1")
    pull = table.pop_optional("pull", str)
    if pull is not None:
        _one_of(table, "pull", pull, PULLS)
        if not is_input:
            table.fail("`pull` is for inputs")
    desc = table.pop("desc", str)
    table.check_empty()
    return Pin(name, is_input, width, per, active_low, idle, pull, desc)


def load_pins(soc: Table, widths: dict[str, int]) -> tuple[PinGroup, ...]:
    """`widths`: the bits of a pin by its `per`."""
    groups = []
    for values in soc.pop_tables("pins"):
        table = Table(f"{soc.where}: pins of {values.get('group', '?')}", values)
        name = table.pop("group", str)
        pins = tuple(_pin(soc.where, pin, widths) for pin in table.pop_tables("list"))
        table.check_empty()
        groups.append(PinGroup(name, pins))
    pins = [pin for group in groups for pin in group.pins]
    check_duplicates(soc, "group of pins", [group.name for group in groups])
    check_duplicates(soc, "pin", [pin.port for pin in pins])
    for is_input, direction in ((True, "input"), (False, "output")):
        check_duplicates(soc, f"{direction} pin", [pin.member for pin in pins if pin.is_input == is_input])
    output_bits = sum(pin.width for pin in pins if not pin.is_input)
    if output_bits > OUTPUT_BITS:
        soc.fail(f"the output pins have {output_bits} bits, at most {OUTPUT_BITS} are compared in each clock")
    return tuple(groups)
