"""SystemVerilog: the proof of a register file, and copies of it that the proof must refute.

The proof says what each word does in terms of the map alone, one register and one byte at a time; it shares no code
with emit_sv_reg_top but the names of ports.
"""

from __future__ import annotations

import re

import names
from emit_sv import literal
from emit_sv_ports import _ports
from model import Access, Block, Field, Register
from text import header

HARNESS = """\
`include "assert.svh"
`default_nettype none

module {name}_reg_proof (
{inputs}
);

{outputs}

  {name}_reg_top u_dut (.*);

  `RESET_FIRST

  // The access of the clock before. Outside reset, and the clock before was outside it too: after_q.
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

  // Reads: the word as it was in the clock of the strobe, held until the next one.
  logic [31:0] word, word_q;
  logic        mapped, mapped_q;
  always_comb begin
    mapped = 1'b1;
    case (reg_raddr_i[15:2])
{words}
      default: begin
        mapped = 1'b0;
        word   = 32'hBADACCE5;
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
      default: writable = 1'b0;
    endcase
  end
  `ASSERT(WriteErrorWhereNotWritable, !we_q || reg_werr_o == !writable)
  `REACH(WritesNotWritable, we_q && reg_werr_o)
{writes}
endmodule

`default_nettype wire
"""


def _elements(reg: Register) -> list[tuple[int, int]]:
    """Index and word address of each element."""
    return [(index, offset // 4) for index, offset in enumerate(reg.offsets)]


def _part(port: str, reg: Register, field: Field, index: int) -> str:
    """The element of a flat port."""
    if not reg.is_array:
        return port
    return f"{port}[{index * field.width}+:{field.width}]"


def _word(reg: Register, index: int) -> str:
    """The value that a read gives, each field shifted to its place."""
    if reg.external:
        return names.external_port(reg, "rdata_i")
    terms = []
    for field in reg.fields:
        if field.access is Access.PULSE:
            continue
        value = literal(field) if field.access is Access.CONST else _part(names.port(reg, field), reg, field, index)
        # A concatenation is unsigned and keeps its width.
        terms.append(f"(32'({{{value}}}) << {field.lsb})")
    return " | ".join(terms) or "32'b0"


def _external(reg: Register) -> list[str]:
    label = names.camel(reg.name)
    word = f"14'h{reg.offset // 4:X}"
    lines = [f"  `ASSERT({label}ReadStrobe, {reg.name}_re_o == (reg_re_i && reg_raddr_i[15:2] == {word}))",
             f"  `REACH({label}IsRead, {reg.name}_re_o)"]
    if reg.writable:
        lines += [
            f"  `ASSERT({label}WriteStrobe, {reg.name}_we_o == (reg_we_i && reg_waddr_i[15:2] == {word}))",
            f"  `ASSERT({label}WriteData, {reg.name}_wdata_o == reg_wdata_i && {reg.name}_wstrb_o == reg_wstrb_i)",
            f"  `REACH({label}IsWritten, {reg.name}_we_o)",
        ]
    return lines


def _before(port: str, width: int) -> list[str]:
    return [f"  logic [{width - 1}:0] {port}_before_q;",
            f"  always_ff @(posedge clk_i) {port}_before_q <= {port};"]


def _field(reg: Register, field: Field) -> list[str]:
    """How the port of a writable field moves from one clock to the next."""
    port = names.port(reg, field)
    label = names.camel(reg.name, field.name)
    lines = _before(port, reg.count * field.width)
    if field.access is Access.W1C:
        lines += _before(names.set_port(reg, field), reg.count * field.width)
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
            events = _part(f"{names.set_port(reg, field)}_before_q", reg, field, index)
            expected = f"({events} | ({before} & ~({written} ? ({data} & {mask}) : '0)))"
            if index == 0:
                lines.append(f"  `REACH({label}{suffix}EventMeetsClear, after_q && {written} && "
                             f"({events} & {before} & {data} & {mask}) != '0)")
                lines.append(f"  `REACH({label}{suffix}Clears, after_q && ({before} & ~{value}) != '0)")
        else:
            expected = f"({written} ? ({data} & {mask}) : '0)"
        lines.append(f"  `ASSERT({label}{suffix}Next, !after_q || {value} == {expected})")
        if index in (0, reg.count - 1):
            lines.append(f"  `REACH({label}{suffix}Moves, after_q && {value} != {before})")
    return lines


def _strobe(reg: Register) -> list[str]:
    label = names.camel(reg.name)
    port = names.strobe_port(reg)
    lines = []
    for index, word in _elements(reg):
        value = f"{port}[{index}]" if reg.is_array else port
        suffix = str(index) if reg.is_array else ""
        lines.append(f"  `ASSERT({label}{suffix}Strobe, !after_q || {value} == "
                     f"(we_q && wword_q == 14'h{word:X} && wmask_q != '0))")
        lines.append(f"  `REACH({label}{suffix}Strobes, {value})")
    return lines


def _writes(block: Block) -> list[str]:
    lines = []
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
    """Any sequence of accesses and hardware events, with resets at any time."""
    ports = [port for reg in block.registers for port in _ports(reg)]
    inputs = [f"  input wire {BUS_WIDTHS.get(name, '')}{name}" for name in BUS_INPUTS]
    inputs += [f"  input wire {port.width} {port.name}" for port in ports if port.direction == "input"]
    outputs = ["  logic        reg_werr_o, reg_rerr_o;", "  logic [31:0] reg_rdata_o;"]
    outputs += [f"  logic {port.width} {port.name};" for port in ports if port.direction == "output"]
    words, writable = [], []
    for reg in block.registers:
        for index, word in _elements(reg):
            words.append(f"      14'h{word:X}: word = {_word(reg, index)};")
            if reg.writable:
                writable.append(f"14'h{word:X}")
    text = HARNESS.format(name=block.name, inputs=",\n".join(inputs), outputs="\n".join(outputs),
                          words="\n".join(words), writable=", ".join(writable) or "14'h3FFF, 14'h3FFF",
                          writes="\n".join(_writes(block)))
    return f"{header('//', block.source)}\n{text}"


def _once(text: str, pattern: str) -> str | None:
    """The first match that occurs exactly once."""
    for match in re.finditer(pattern, text, re.M):
        if text.count(match[0]) == 1:
            return match[0]
    return None


def breaks(block: Block, text: str) -> list[tuple[str, str, str, str, str]]:
    """Name, file, old, new and the assertion that refutes it: one of each kind that the map has registers for."""
    file = f"{block.name}_reg_top.sv"
    found = []
    kinds = set()

    def add(name: str, pattern: str, old: str, new: str, assertion: str):
        """`old` becomes `new` in the first unique match of `pattern`."""
        kind = (name.removeprefix(subject), access)
        match = None if kind in kinds else _once(text, pattern)
        if match:
            kinds.add(kind)
            found.append((name, file, match, match.replace(old, new, 1), assertion))

    subject, access = "", None
    add("unmapped_read_is_okay", r"reg_rerr_o  <= 1'b1;", "1'b1", "1'b0", "ReadErrorWhereUnmapped")
    for reg in block.registers:
        label = names.camel(reg.name)
        suffix = "0" if reg.is_array else ""
        subject, access = reg.name, None
        if reg.external and reg.writable:
            add(f"{reg.name}_strobe_without_write", rf"^    {reg.name}_we_o += 1'b0;", "1'b0", "|reg_wstrb_i",
                f"{label}WriteStrobe")
        if reg.external:
            add(f"{reg.name}_read_without_strobe", rf"^ +{reg.name}_re_o += raddr == .*;", "raddr", "16'h0 & raddr",
                f"{label}ReadStrobe")
            continue
        if reg.strobe:
            add(f"{reg.name}_strobe_without_a_byte", rf"^.*{reg.name}_we_o.* <= \|reg_wstrb_i;", "|reg_wstrb_i", "1'b1",
                f"{label}{suffix}Strobe")
        for field in reg.fields:
            port = names.port(reg, field)
            subject, access = port, (field.access, reg.is_array)
            rule = f"{names.camel(reg.name, field.name)}{suffix}Next"
            if field.access is Access.CONST and reg.name == block.registers[0].name:
                add(f"{port}_is_not_constant", rf"16'h{reg.offset:04X}: reg_rdata_o <= .*",
                    literal(field), f"{literal(field)} + {field.width}'d1", "ReadsTheWord")
            if field.access.writable:
                add(f"{port}_ignores_the_strobe", rf"if \(reg_wstrb_i\[\d\]\) {port}\b.*", "if (",
                    "if (1'b1 | ", rule)
            if field.access is Access.W1C:
                event = names.set_port(reg, field)
                add(f"{port}_loses_an_event", rf"~reg_wdata_i[^;]*\) \| {event}[^;]*;", f"| {event}",
                    f"& ~{event}" if not reg.is_array else f"& {event}", rule)
                add(f"{port}_cleared_by_a_zero", rf"{port}[^;=]*& ~reg_wdata_i[^;]*{event}", "~reg_wdata_i",
                    "reg_wdata_i", rule)
            if field.access is Access.PULSE:
                add(f"{port}_stays", rf"^ +{port} +<= '0;$", "'0", port, rule)
            if field.access is Access.RW and field.reset:
                add(f"{port}_wrong_reset", rf"^ +{port} +<= (?!'0)[^;]*{re.escape(literal(field))}[^;]*;",
                    literal(field), f"~{literal(field)}",
                    f"{names.camel(reg.name, field.name)}Resets")
            if field.access is Access.RO and not reg.is_array:
                add(f"{port}_not_read", rf"^ +16'h{reg.offset:04X}: reg_rdata_o <= .*{port}", port,
                    f"{{{field.width}{{1'b0}}}}", "ReadsTheWord")
    subject, access = "", None
    add("write_error_lost", r"default: reg_werr_o <= 1'b1;", "1'b1", "1'b0", "WriteErrorWhereNotWritable")
    add("unmapped_reads_zero", r"reg_rdata_o <= 32'hBADACCE5;", "BADACCE5", "00000000", "ReadsTheWord")
    return found
