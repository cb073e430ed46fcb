"""rtl/REGISTERS.md: the address map, the pins, then one table per block."""

from __future__ import annotations

from model import Access, Block, Field, Register, SocMap
from text import header as first_line

INTRO = """\
# Registers

| access  | meaning |
|---------|---------|
| `rw`    | read and write, with byte strobes |
| `ro`    | read only |
| `const` | reads its reset value |
| `w1c`   | sticky flag: set by a hardware event, cleared by writing 1; the event wins over a clear in the same cycle |
| `pulse` | writing 1 gives a pulse of one cycle; reads 0 |
| `key`   | reads 1 while the protected registers of the block are unlocked |

Words have 32 bits. A read of an unmapped offset returns `0xBADACCE5` and SLVERR. A write to an unmapped offset, or to a
register without a writable field, returns SLVERR and changes nothing. The sections of blocks with a vendor's register map
state their exception from these two rules, those of blocks with a lock their protected registers. Bits without a field
read 0 and ignore writes. Element i of an array is at its first offset + 4 i. The core of the block stores the bits of an
external register."""


def _escape(text: str) -> str:
    return text.replace("|", "\\|")


def _table(rows: list[tuple[str, ...]]) -> list[str]:
    """Pads all columns except the last, so that the source is readable as a table."""
    widths = [max(len(row[i]) for row in rows) for i in range(len(rows[0]) - 1)]
    lines = []
    for row in rows:
        cells = [cell.ljust(width) for cell, width in zip(row, widths)]
        lines.append("| " + " | ".join([*cells, row[-1]]) + " |")
    rule = "|" + "|".join("-" * (width + 2) for width in widths) + "|---|"
    return [lines[0], rule, *lines[1:]]


def _reset(field: Field) -> str:
    if field.access in (Access.W1C, Access.PULSE, Access.KEY):
        return "0"
    if field.reset is None:
        return ""
    return str(field.reset_value) if field.is_quantity else f"0x{field.reset:X}"


def _rows(reg: Register) -> list[tuple[str, ...]]:
    offset = f"0x{reg.offset:02X}" + (f"..0x{reg.offsets[-1]:02X}" if reg.is_array else "")
    desc = reg.desc + (" (external)" if reg.external else "") + (" (protected)" if reg.protected else "")
    rows = [(offset, f"**{reg.label}**", "", "", "", "", _escape(desc))]
    for field in reg.fields:
        access = field.access.value + (", signed" if field.signed else "")
        desc = field.desc + (" (protected)" if field.protected else "")
        rows.append(("", field.name, field.bits, access, _reset(field), field.unit, _escape(desc)))
    return rows


def _block(block: Block) -> list[str]:
    rows = [("offset", "**register** / field", "bits", "access", "reset", "unit", "description")]
    for reg in block.registers:
        rows += _rows(reg)
    lines = ["", f"## {block.name}", "", f"{block.desc} Source: `{block.source}`."]
    for rule in (block.error_rule, block.lock_rule):
        if rule:
            lines += ["", rule]
    return [*lines, "", *_table(rows)]


def _pins(soc: SocMap) -> list[str]:
    rows = [("pin", "direction", "bits", "idle", "pull", "description")]
    for group in soc.pin_groups:
        rows.append((f"**{group.name}**", "", "", "", "", ""))
        for pin in group.pins:
            bits = f"{pin.width}, one per {pin.per}" if pin.per else str(pin.width)
            rows.append(
                (
                    pin.port,
                    "input" if pin.is_input else "output",
                    bits,
                    str(pin.idle),
                    pin.pull or "",
                    _escape(pin.desc),
                )
            )
    return [
        "",
        "## Pins",
        "",
        f"Every port of {soc.name} except clocks, reset and bus. If `per axis`, axis 1 is bit 0. `_ni` is active low.",
        "",
        *_table(rows),
    ]


def tables(soc: SocMap, blocks: list[Block]) -> str:
    rows = [("block", "base", "size", "irq", "variant", "registers", "description")]
    for m in soc.mappings:
        irq = "" if m.irq is None else str(m.irq)
        rows.append(
            (
                m.name,
                f"0x{m.base:08X}",
                f"0x{m.size:X}",
                irq,
                m.variant or "both",
                f"[{m.regs}](#{m.regs})",
                _escape(m.desc),
            )
        )
    lines = [
        first_line("<!--", f"{soc.source} and rtl/*/*_regs.toml") + " -->",
        INTRO,
        "",
        f"## {soc.name}",
        "",
        f"{soc.desc} Clock {soc.clk_freq_hz / 1e6:g} MHz, tick {soc.tick_cycles} cycles. Source: `{soc.source}`.",
        "",
        *_table(rows),
    ]
    lines += _pins(soc)
    for block in blocks:
        lines += _block(block)
    return "\n".join(lines) + "\n"
