"""SystemVerilog: the proof of a register file, and copies of it that the proof must refute.

The proof derives the behaviour of each word from the map alone, one register and one byte at a time. It shares no code
with emit_sv_reg_top except the names of members, which are the ports of <block>_reg_top_flat (tools/flat_ports.py).
"""

from __future__ import annotations

import re

import names
from emit_sv import literal
from emit_sv_types import HW2REG, REG2HW, members, write_data
from model import Access, Block, Field, Register
from text import header

HARNESS = """\
`include "assert.svh"
`default_nettype none

module {name}_reg_proof (
{inputs}
);

{outputs}

  {name}_reg_top_flat u_dut (.*);

  `RESET_FIRST

  // The access in the previous clock. after_q: the previous clock was outside reset.
  logic        after_q = 1'b0;
  logic        we_q, re_q;
  logic [13:0] wword_q;
  logic [31:0] wdata_q, wmask_q;
  always_ff @(posedge clk_i) begin
    after_q <= rst_ni;
    we_q    <= rst_ni && reg_we_i;
    re_q    <= rst_ni && reg_re_i;
    wword_q <= reg_waddr_i[15:2];
    wdata_q <= reg_wdata_i;
    wmask_q <= {{{{8{{reg_wstrb_i[3]}}}}, {{8{{reg_wstrb_i[2]}}}}, {{8{{reg_wstrb_i[1]}}}}, {{8{{reg_wstrb_i[0]}}}}}};
  end

  // Reads: the value of the word in the clock of the read strobe, held until the next read strobe.
  logic [31:0] word, word_q;
  logic        mapped, mapped_q;
  always_comb begin
    mapped = 1'b1;
    case (reg_raddr_i[15:2])
{words}
      default: begin
        mapped = {quiet_read};
        word   = mapped ? 32'b0 : 32'hBADACCE5;
      end
    endcase
  end
  always_ff @(posedge clk_i) begin
    if (!rst_ni) {{mapped_q, word_q}} <= {{1'b1, 32'b0}};
    else if (reg_re_i) {{mapped_q, word_q}} <= {{mapped, word}};
  end
  `ASSERT(ReadsTheWord, reg_rdata_o == word_q)
  `ASSERT(ReadErrorWhereUnmapped, reg_rerr_o == !mapped_q)
  `REACH(ReadsUnmapped, re_q && reg_rerr_o)
  `REACH(ReadsMapped, re_q && !reg_rerr_o)

  // Writes.
  logic writable;
  always_comb begin
    case (wword_q)
      {writable}: writable = 1'b1;
      default: writable = {quiet_write};
    endcase
  end
  `ASSERT(WriteErrorWhereNotWritable, !we_q || reg_werr_o == !writable)
  `REACH(WritesNotWritable, we_q && reg_werr_o)
{writes}
endmodule

`default_nettype wire
"""


def _out(member: str) -> str:
    return f"{member}_o"


def _in(member: str) -> str:
    return f"{member}_i"


def _value(reg: Register, field: Field) -> str:
    """The port with the value of a field."""
    name = names.member(reg, field)
    return _in(name) if field.access is Access.RO else _out(name)


def _elements(reg: Register) -> list[tuple[int, int]]:
    """Index and word address of each element."""
    return [(index, offset // 4) for index, offset in enumerate(reg.offsets)]


def _part(port: str, reg: Register, field: Field, index: int) -> str:
    """The element of a flat port."""
    if not reg.is_array:
        return port
    return f"{port}[{index * field.width}+:{field.width}]"


def _word(reg: Register, index: int) -> str:
    """The value of a read, with each field shifted to its bits."""
    if reg.external:
        return _in(names.external(reg, "rdata"))
    terms = []
    for field in reg.fields:
        if field.access is Access.PULSE:
            continue
        value = literal(field) if field.access is Access.CONST else _part(_value(reg, field), reg, field, index)
        # A concatenation is unsigned and keeps its width.
        terms.append(f"(32'({{{value}}}) << {field.lsb})")
    return " | ".join(terms) or "32'b0"


def _external(reg: Register) -> list[str]:
    label = names.camel(reg.name)
    word = f"14'h{reg.offset // 4:X}"
    lines = [
        f"  `ASSERT({label}ReadStrobe, {reg.name}_re_o == (reg_re_i && reg_raddr_i[15:2] == {word}))",
        f"  `REACH({label}IsRead, {reg.name}_re_o)",
    ]
    if reg.writable:
        lines += [
            f"  `ASSERT({label}WriteStrobe, {reg.name}_we_o == (reg_we_i && reg_waddr_i[15:2] == {word}))",
            f"  `REACH({label}IsWritten, {reg.name}_we_o)",
        ]
    return lines


def _before(port: str, width: int) -> list[str]:
    return [f"  logic [{width - 1}:0] {port}_before_q;", f"  always_ff @(posedge clk_i) {port}_before_q <= {port};"]


def _field(reg: Register, field: Field) -> list[str]:
    """The next value of the port of a writable field, as assertions."""
    port = _value(reg, field)
    label = names.camel(reg.name, field.name)
    lines = _before(port, reg.count * field.width)
    if field.access is Access.W1C:
        lines += _before(_in(names.event(reg, field)), reg.count * field.width)
    reset = f"{{{reg.count}{{{literal(field)}}}}}" if field.reset else "'0"
    lines.append(f"  formal_rule {label}Resets (.live(running_q && !after_q), .holds({port} == {reset}));")
    for index, word in _elements(reg):
        suffix = str(index) if reg.is_array else ""
        mask, data = (f"{name}[{field.msb}:{field.lsb}]" for name in ("wmask_q", "wdata_q"))
        written = f"(we_q && wword_q == 14'h{word:X})"
        value = _part(port, reg, field, index)
        before = _part(f"{port}_before_q", reg, field, index)
        if field.access is Access.RW:
            expected = f"({written} ? (({before} & ~{mask}) | ({data} & {mask})) : {before})"
        elif field.access is Access.W1C:
            events = _part(f"{_in(names.event(reg, field))}_before_q", reg, field, index)
            expected = f"({events} | ({before} & ~({written} ? ({data} & {mask}) : '0)))"
            if index == 0:
                lines.append(
                    f"  `REACH({label}{suffix}EventMeetsClear, after_q && {written} && "
                    f"({events} & {before} & {data} & {mask}) != '0)"
                )
                lines.append(f"  `REACH({label}{suffix}Clears, after_q && ({before} & ~{value}) != '0)")
        else:
            expected = f"({written} ? ({data} & {mask}) : '0)"
        lines.append(f"  `ASSERT({label}{suffix}Next, !after_q || {value} == {expected})")
        if index in (0, reg.count - 1):
            lines.append(f"  `REACH({label}{suffix}Moves, after_q && {value} != {before})")
    return lines


def _strobe(reg: Register) -> list[str]:
    label = names.camel(reg.name)
    port = _out(names.strobe(reg))
    lines = []
    for index, word in _elements(reg):
        value = f"{port}[{index}]" if reg.is_array else port
        suffix = str(index) if reg.is_array else ""
        lines.append(
            f"  `ASSERT({label}{suffix}Strobe, !after_q || {value} == "
            f"(we_q && wword_q == 14'h{word:X} && wmask_q != '0))"
        )
        lines.append(f"  `REACH({label}{suffix}Strobes, {value})")
    return lines


def _writes(block: Block) -> list[str]:
    lines = []
    if write_data(block):
        lines.append("  `ASSERT(WriteData, wdata_o == reg_wdata_i && wstrb_o == reg_wstrb_i)")
    for reg in block.registers:
        lines += ["", f"  // {reg.label}"]
        if reg.external:
            lines += _external(reg)
            continue
        if reg.strobe:
            lines += _strobe(reg)
        for field in reg.fields:
            if field.access.writable:
                lines += _field(reg, field)
        if len(lines) and lines[-1].startswith("  //"):
            del lines[-2:]
    return lines


BUS_INPUTS = ("clk_i", "rst_ni", "reg_we_i", "reg_waddr_i", "reg_wdata_i", "reg_wstrb_i", "reg_re_i", "reg_raddr_i")
BUS_WIDTHS = {"reg_waddr_i": "[15:0] ", "reg_raddr_i": "[15:0] ", "reg_wdata_i": "[31:0] ", "reg_wstrb_i": "[3:0] "}


def proof(block: Block) -> str:
    """The proof, for any sequence of accesses and hardware events, with a reset at any time."""
    found = members(block)
    inputs = [f"  input wire {BUS_WIDTHS.get(name, '')}{name}" for name in BUS_INPUTS]
    inputs += [f"  input wire {member.width} {_in(member.name)}" for member in found if member.struct == HW2REG]
    outputs = ["  logic        reg_werr_o, reg_rerr_o;", "  logic [31:0] reg_rdata_o;"]
    outputs += [f"  logic {member.width} {_out(member.name)};" for member in found if member.struct == REG2HW]
    quiet = block.no_error_below // 4
    words, writable = [], []
    for reg in block.registers:
        for index, word in _elements(reg):
            words.append(f"      14'h{word:X}: word = {_word(reg, index)};")
            if reg.writable:
                writable.append(f"14'h{word:X}")
    text = HARNESS.format(
        name=block.name,
        inputs=",\n".join(inputs),
        outputs="\n".join(outputs),
        words="\n".join(words),
        writable=", ".join(writable) or "14'h3FFF, 14'h3FFF",
        quiet_read=f"reg_raddr_i[15:2] < 14'd{quiet}" if quiet else "1'b0",
        quiet_write=f"wword_q < 14'd{quiet}" if quiet else "1'b0",
        writes="\n".join(_writes(block)),
    )
    return f"{header('//', block.source)}\n{text}"


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
                add(f"{net}_stays", rf"^ +{net} +<= '0;$", "'0", net, rule)
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
