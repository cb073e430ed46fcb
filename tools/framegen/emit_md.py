"""The tables of PROTOCOL.md."""

from __future__ import annotations

from frames import Frames, Opcode, Range


def _table(head: tuple[str, ...], rows: list[tuple[str, ...]]) -> str:
    lines = [head, tuple("---" for _ in head), *rows]
    return "".join(f"| {' | '.join(cells)} |\n" for cells in lines)


def _range(found: Range) -> str:
    if not found.desc:
        return "0"
    if str(found.high) == found.desc or f"0x{found.high:02X}" == found.desc or f"0x{found.high:06X}" == found.desc:
        return found.desc
    unit = f" {found.unit}" if found.unit else ""
    return f"{found.low} .. {found.high}{unit}: {found.desc}"


def _states(opcode: Opcode, all_states: list[str]) -> str:
    if list(opcode.states) == all_states:
        return "any"
    return ", ".join([*opcode.states, *(f"({name})" for name in opcode.extended)])


def sections(frames: Frames) -> dict[str, str]:
    """The text of each generated section, by its name."""
    states = [state.name for state in frames.states]
    commands = [
        (f"`{o.code:02X}`", f"`{o.name}`", o.desc, _range(o.parameter), _range(o.payload), o.reply, _states(o, states))
        for o in frames.opcodes
        if not o.reply_only
    ]
    replies = [(f"`{o.code:02X}`", f"`{o.name}`", o.desc, o.reply) for o in frames.opcodes if o.reply_only]
    pages = [
        (str(p.first) if p.first == p.last else f"{p.first} .. {p.last}", str(p.group), f"`{p.name}`", p.desc, p.value)
        for p in frames.pages
    ]
    return {
        "kinds": _table(
            ("high half of byte 0", "kind", "from", "meaning"),
            [(f"`{k.nibble:X}`", f"`{k.name}`", k.sender, k.desc) for k in frames.kinds],
        ),
        "statuses": _table(
            ("status", "name", "meaning", "payload"),
            [(str(s.code), f"`{s.name}`", s.desc, s.detail) for s in frames.statuses],
        ),
        "states": _table(
            ("number", "state", "meaning", "refuses with"),
            [(str(i), f"`{s.name}`", s.desc, f"`{s.refusal}`") for i, s in enumerate(frames.states)],
        ),
        "opcodes": _table(
            ("opcode", "command", "does", "parameter", "payload", "payload of the reply", "admitted in"), commands
        )
        + "\nOnly in replies:\n\n"
        + _table(("opcode", "name", "meaning", "payload"), replies),
        "pages": _table(("page", "group", "name", "meaning", "payload"), pages),
    }
