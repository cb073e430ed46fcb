"""The table of the software's signals in scenarios/WAVEFORMS.md."""

from __future__ import annotations

from signals import Group, Signal


def _width(signal: Signal) -> str:
    return f"{signal.bits // 8} characters" if signal.kind == "text" else f"{signal.bits}"


def table(groups: list[Group]) -> str:
    lines = ["| signal | bits | meaning |", "|---|---|---|"]
    for group in groups:
        for signal in group.signals:
            unit = f" [{signal.unit}]" if signal.unit else ""
            lines.append(f"| `{signal.name}` | {_width(signal)} | {signal.desc}{unit} |")
    return "\n".join(lines) + "\n"
