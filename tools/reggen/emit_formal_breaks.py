"""Broken copies of a generated register file, each of which the proof of emit_formal must refute."""

from __future__ import annotations

import re

import names
from emit_sv import literal
from model import Access, Block


def _once(text: str, pattern: str) -> str | None:
    """The first match that occurs exactly once."""
    for match in re.finditer(pattern, text, re.M):
        if text.count(match[0]) == 1:
            return match[0]
    return None


def breaks(block: Block, text: str) -> list[tuple[str, str, str, str, str]]:
    """Name, file, old text, new text and refuting assertion: one broken copy for each kind of register in the map."""
    file = f"{block.name}_reg_top.sv"
    found = []
    kinds = set()

    def add(name: str, pattern: str, old: str, new: str, assertion: str):
        """Replaces `old` by `new` in the first unique match of `pattern`."""
        kind = (name.removeprefix(subject), access)
        match = None if kind in kinds else _once(text, pattern)
        if match:
            kinds.add(kind)
            found.append((name, file, match, match.replace(old, new, 1), assertion))

    subject, access = "", None
    if block.key:
        protected = next(reg for reg in block.registers if reg.protected)
        field = next(field for field in protected.fields if field.access is Access.RW)
        rule = f"{names.camel(protected.name, field.name)}{'0' if protected.is_array else ''}IsProtected"
        add("lock_ignored", r"locked = protect_i && !key_unlocked_q;", "protect_i", "1'b0", rule)
        add("key_unlocks_by_one_byte", r"wstrb == 4'hF && wdata ==", "wstrb == 4'hF", "wstrb[0]", "ReadsTheWord")
        add("any_word_unlocks", r"&& wdata == 32'h[0-9A-F_]+;", "== 32'h", ">= 32'h", "ReadsTheWord")
        refused = rf"16'h{protected.offset:04X}[^\n]*\n +if \(locked\) werr_q <= 1'b1;"
        add("locked_write_is_okay", refused, "<= 1'b1", "<= 1'b0", "WriteErrorWhereNotWritable")
    for reg in block.registers:
        if reg.protected_field:
            net = names.net(reg, reg.protected_field)
            rule = f"{names.camel(reg.name, reg.protected_field.name)}IsProtected"
            add(f"{net}_can_be_cleared", rf"\| \({net} & locked\)", "locked", "1'b0", rule)
            add(f"{net}_clear_is_okay", rf"locked & {net} & ~", "locked", "1'b0", "WriteErrorWhereNotWritable")
    quiet = r"\[15:\d+\] != '0;"
    add(
        "ignored_write_is_an_error", rf"default: werr_q <= waddr{quiet}", "!= '0", ">= '0", "WriteErrorWhereNotWritable"
    )
    add("unmapped_read_is_okay", r"rerr_q  <= 1'b1;", "1'b1", "1'b0", "ReadErrorWhereUnmapped")
    for reg in block.registers:
        label = names.camel(reg.name)
        suffix = "0" if reg.is_array else ""
        subject, access = reg.name, None
        if reg.external and reg.writable:
            add(
                f"{reg.name}_strobe_without_write",
                rf"^    {reg.name}_we += 1'b0;",
                "1'b0",
                "|wstrb",
                f"{label}WriteStrobe",
            )
        if reg.external:
            add(
                f"{reg.name}_read_without_strobe",
                rf"^ +{reg.name}_re += raddr == .*;",
                "raddr",
                "16'h0 & raddr",
                f"{label}ReadStrobe",
            )
            continue
        if reg.strobe:
            add(
                f"{reg.name}_strobe_without_a_byte",
                rf"^.*{reg.name}_we_q.* <= \|wstrb;",
                "|wstrb",
                "1'b1",
                f"{label}{suffix}Strobe",
            )
        for field in reg.fields:
            net = names.net(reg, field)
            subject, access = net, (field.access, reg.is_array)
            rule = f"{names.camel(reg.name, field.name)}{suffix}Next"
            if field.access is Access.CONST and reg.name == block.registers[0].name:
                add(
                    f"{net}_is_not_constant",
                    rf"16'h{reg.offset:04X}: rdata_q <= .*",
                    literal(field),
                    f"{literal(field)} + {field.width}'d1",
                    "ReadsTheWord",
                )
            if field.access.writable:
                add(f"{net}_ignores_the_strobe", rf"if \(wstrb\[\d\]\) {net}\b.*", "if (", "if (1'b1 | ", rule)
            if field.access is Access.W1C:
                event = names.event(reg, field)
                add(
                    f"{net}_loses_an_event",
                    rf"~wdata[^;]*\) \| {event}[^;]*;",
                    f"| {event}",
                    f"& ~{event}" if not reg.is_array else f"& {event}",
                    rule,
                )
                add(f"{net}_cleared_by_a_zero", rf"{net}[^;=]*& ~wdata[^;]*{event}", "~wdata", "wdata", rule)
            if field.access is Access.PULSE:
                after_reset = r"(?![\s\S]*^    end else begin$)"
                add(f"{net}_stays", rf"^ +{net} +<= '0;$" + after_reset, "'0", net, rule)
            if field.access is Access.RW and field.reset:
                add(
                    f"{net}_wrong_reset",
                    rf"^ +{net} +<= (?!'0)[^;]*{re.escape(literal(field))}[^;]*;",
                    literal(field),
                    f"~{literal(field)}",
                    f"{names.camel(reg.name, field.name)}Resets",
                )
            if field.access is Access.RO and not reg.is_array:
                add(
                    f"{net}_not_read",
                    rf"^ +16'h{reg.offset:04X}: rdata_q <= .*{net}",
                    net,
                    f"{{{field.width}{{1'b0}}}}",
                    "ReadsTheWord",
                )
    subject, access = "", None
    add("byte_strobes_lost", r"^  assign reg2hw_o\.wstrb += wstrb;", "= wstrb", "= 4'hF", "WriteData")
    add("write_error_lost", r"default: werr_q <= 1'b1;", "1'b1", "1'b0", "WriteErrorWhereNotWritable")
    add("unmapped_reads_zero", r"rdata_q <= 32'hBADACCE5;", "BADACCE5", "00000000", "ReadsTheWord")
    return found
