"""SystemVerilog: the proof of a register file. emit_formal_breaks has copies of it that the proof must refute.

The proof derives the behaviour of each word from the map alone, one register and one byte at a time. It shares no code
with emit_sv_reg_top except the names of members, which are the ports of <block>_reg_top_flat (tools/flat_ports.py).
"""

from __future__ import annotations

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
{lock}
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
{kept}  logic writable;
  always_comb begin
    case (wword_q)
      {writable}: writable = 1'b1;
{protected}      default: writable = {quiet_write};
    endcase
  end
  `ASSERT(WriteErrorWhereNotWritable, !we_q || reg_werr_o == !writable)
  `REACH(WritesNotWritable, we_q && reg_werr_o)
{writes}
endmodule

`default_nettype wire
"""


LOCK = """
  // The lock, and whether it was closed in the previous clock.
  logic unlocked_q = 1'b0;
  logic locked_q   = 1'b0;
  logic protect_q  = 1'b0;
  always_ff @(posedge clk_i) begin
    protect_q <= protect_i;
    locked_q  <= protect_i && !unlocked_q;
    if (!rst_ni) unlocked_q <= 1'b0;
    else if (reg_we_i && reg_waddr_i[15:2] == 14'h{word:X}) begin
      unlocked_q <= reg_wdata_i == 32'h{key:X} && reg_wstrb_i == 4'b1111;
    end
  end
  `REACH(Unlocks, unlocked_q && protect_i)
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
    if reg.key is not None:
        return "32'(unlocked_q)"
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


def _written(reg: Register, word: int) -> str:
    """The previous clock had a write to the word that the lock accepted."""
    return f"(we_q && wword_q == 14'h{word:X}{' && !locked_q' if reg.protected else ''})"


def _refusals(reg: Register, label: str, value: str, before: str, word: int) -> list[str]:
    """A protected field changes while the lock is open, and does not while it is closed."""
    tried = f"after_q && we_q && wword_q == 14'h{word:X} && protect_q && wmask_q == '1"
    return [
        f"  `ASSERT({label}IsProtected, !(after_q && locked_q) || {value} == {before})",
        f"  `REACH({label}IsRefused, {tried} && locked_q)",
        f"  `REACH({label}IsUnlocked, {tried} && {value} != {before})",
    ]


def _kept(label: str, value: str, before: str, data: str) -> list[str]:
    """A protected field is cleared while the lock is open, and is not while it is closed."""
    return [
        f"  `ASSERT({label}IsProtected, !(after_q && locked_q) || {value} || !{before})",
        f"  `REACH({label}IsRefused, after_q && locked_q && reg_werr_o && {before} && !{data})",
        f"  `REACH({label}IsUnlocked, after_q && protect_q && {before} && !{value})",
    ]


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
        written = _written(reg, word)
        value = _part(port, reg, field, index)
        before = _part(f"{port}_before_q", reg, field, index)
        if field.access is Access.RW:
            kept = f" | ({before} & locked_q)" if field.protected else ""
            expected = f"({written} ? (({before} & ~{mask}) | ({data} & {mask}){kept}) : {before})"
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
        if reg.protected and field.access is Access.RW and index in (0, reg.count - 1):
            lines += _refusals(reg, f"{label}{suffix}", value, before, word)
        if field.protected:
            lines += _kept(label, value, before, data)
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
            f"  `ASSERT({label}{suffix}Strobe, !after_q || {value} == " f"({_written(reg, word)} && wmask_q != '0))"
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
            if field.access.writable and field.access is not Access.KEY:
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
    inputs += ["  input wire protect_i"] if block.key else []
    quiet = block.no_error_below // 4
    quiet_write = f"wword_q < 14'd{quiet}" if quiet else "1'b0"
    words, writable, protected, kept, clears = [], [], [], [], []
    for reg in block.registers:
        for index, word in _elements(reg):
            words.append(f"      14'h{word:X}: word = {_word(reg, index)};")
            if reg.protected_field:
                port, bit = _value(reg, reg.protected_field), reg.protected_field.lsb
                kept += [f"  logic {port}_kept_q;", f"  always_ff @(posedge clk_i) {port}_kept_q <= {port};"]
                clear = f"{port}_kept_q && wmask_q[{bit}] && !wdata_q[{bit}]"
                clears.append(f"      14'h{word:X}: writable = !(locked_q && {clear}) || {quiet_write};\n")
            elif reg.writable:
                (protected if reg.protected else writable).append(f"14'h{word:X}")
    refused = f"      {', '.join(protected)}: writable = !locked_q || {quiet_write};\n" if protected else ""
    text = HARNESS.format(
        name=block.name,
        inputs=",\n".join(inputs),
        outputs="\n".join(outputs),
        words="\n".join(words),
        writable=", ".join(writable) or "14'h3FFF, 14'h3FFF",
        quiet_read=f"reg_raddr_i[15:2] < 14'd{quiet}" if quiet else "1'b0",
        quiet_write=quiet_write,
        protected=refused + "".join(clears),
        kept="".join(f"{line}\n" for line in kept),
        lock=LOCK.format(word=block.key.offset // 4, key=block.key.key) if block.key else "",
        writes="\n".join(_writes(block)),
    )
    return f"{header('//', block.source)}\n{text}"
