"""The groups of all pins in a GTKWave view, between two comment lines. The rest of the view is hand-written."""

from __future__ import annotations

from model import SocMap
from table import MapError

BEGIN = "[*] Every pin, written by tools/reggen."
END = "[*] End of the pins."
CLOSED_GROUP, END_OF_CLOSED_GROUP, BINARY, HEX = "@c00200", "@1401200", "@28", "@22"


def view(soc: SocMap, where: str, text: str) -> str:
    """`text` with the present groups; `where` is the file name in messages."""
    before, begin, rest = text.partition(f"{BEGIN}\n")
    _, end, after = rest.partition(f"{END}\n")
    if not begin or not end:
        raise MapError(f"{where}: expected a line `{BEGIN}` and below it a line `{END}`")
    lines = []
    for group in soc.pin_groups:
        lines += [CLOSED_GROUP, f"-pins: {group.name}"]
        for pin in group.pins:
            wide = f"[{pin.width - 1}:0]" if pin.width > 1 else ""
            lines += [BINARY if pin.width <= 8 else HEX, f"+{{{pin.port}}} top.{pin.port}{wide}"]
        lines += [END_OF_CLOSED_GROUP, f"-pins: {group.name}"]
    return "".join([before, begin, *[f"{line}\n" for line in lines], end, after])
