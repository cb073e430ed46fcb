"""SystemVerilog: the register file of a block."""

from __future__ import annotations

import textwrap

import names
from emit_sv import key_literal, literal
from emit_sv_reg_nets import Slice, bit_range, nets, ports, protect_port, slices, stored, unused
from model import ADDR_BITS, Access, Block, Field, Register
from text import LINE, columns, comment, header

ROOM = LINE - 8  # columns left for an item of a case


def _select(name: str, reg: Register, field: Field, part: Slice) -> str:
    """The part of the net `name` that belongs to the register, or to its element i."""
    if reg.is_array:
        if field.width == 1:
            return f"{name}[i]"
        low = f" + {part.low}" if part.low else ""
        return f"{name}[{field.width}*i{low} +: {part.width}]"
    if part.width == field.width:
        return name
    high = part.low + part.width - 1
    return f"{name}[{high}:{part.low}]" if part.width > 1 else f"{name}[{high}]"


def _for_element(reg: Register, address: str, statements: list[str]) -> list[str]:
    """`statements` for the addressed element i. A comparison with each i is an enable per element. A part select at a
    computed index would be a multiplier and a shifter."""
    if not reg.is_array:
        return statements
    bits = reg.index_msb - 1
    head = [f"for (int i = 0; i < {reg.count}; i++) begin", f"  if ({bit_range(address, 2, bits)} == {bits}'(i)) begin"]
    return [*head, *(f"    {line}" for line in statements), "  end", "end"]


def _write_statements(block: Block, reg: Register) -> list[str]:
    if reg.key is not None:
        return [f"{names.net(reg, reg.fields[0])} <= wstrb == 4'hF && wdata == {key_literal(reg)};"]
    rows = []
    for field in reg.fields:
        if not field.access.writable:
            continue
        for part in slices(field):
            target = _select(names.net(reg, field), reg, field, part)
            value = bit_range("wdata", field.lsb + part.low, part.width)
            if field.access is Access.W1C:
                event = _select(names.event(reg, field), reg, field, part)
                value = f"({target} & ~{value}) | {event}"
            if field.protected:
                error = f" & {_is_error(block, 'waddr')}" if block.no_error_below else ""
                rows.append((f"if (wstrb[{part.byte}])", "werr_q", "<=", f"locked & {target} & ~{value}{error};"))
                value = f"{value} | ({target} & locked)"
            rows.append((f"if (wstrb[{part.byte}])", target, "<=", f"{value};"))
    lines = columns(rows)
    if max(map(len, lines)) > ROOM - (8 if reg.is_array else 4) - (2 if reg.protected else 0):
        lines = [line for *head, value in rows for line in (" ".join(head), f"    {value}")]
    if reg.strobe:
        index = "[i]" if reg.is_array else ""
        lines.append(f"{names.strobe(reg)}_q{index} <= |wstrb;")
    return _for_element(reg, "waddr", lines)


def _labels(reg: Register) -> list[str]:
    """The addresses of all elements as case labels."""
    return textwrap.wrap(", ".join(f"16'h{offset:04X}" for offset in reg.offsets) + ":", ROOM - 40)


def _item(reg: Register, statement: list[str], note: str) -> list[str]:
    """A case item of one statement, on one line if it fits; `note` is a comment."""
    *above, labels = _labels(reg)
    note = f"  // {note}" if note else ""
    one_line = f"{labels} {statement[0]}{note}"
    if len(statement) == 1 and not above and len(one_line) <= ROOM:
        return [one_line]
    return [*above, f"{labels}{note}", *(f"  {line}" for line in statement)]


def _block_item(reg: Register, statements: list[str]) -> list[str]:
    *above, labels = _labels(reg)
    return [*above, f"{labels} begin  // {reg.label}", *(f"  {line}" for line in statements), "end"]


def _is_error(block: Block, address: str) -> str:
    """The condition under which an access to no register is an error."""
    if not block.no_error_below:
        return "1'b1"
    return f"{address}[{ADDR_BITS - 1}:{block.no_error_below.bit_length() - 1}] != '0"


def _unless_locked(block: Block, statements: list[str]) -> list[str]:
    """`statements`, or while the block is locked the answer of a read-only register."""
    locked = f"if (locked) werr_q <= {_is_error(block, 'waddr')};"
    if len(statements) == 1:
        return [locked, f"else {statements[0]}"]
    return [locked, "else begin", *(f"  {line}" for line in statements), "end"]


def _write_case(block: Block) -> list[str]:
    lines = ["werr_q <= 1'b0;", "case (waddr)"]
    for reg in block.registers:
        if not reg.writable:
            continue
        statements = [";"] if reg.external else _write_statements(block, reg)
        note = f"{reg.label}: kept by the core" if reg.external else ""
        if reg.protected:
            item = _item(reg, _unless_locked(block, statements), f"{reg.label}, protected")
        else:
            item = _item(reg, statements, note) if len(statements) == 1 else _block_item(reg, statements)
        lines += [f"  {line}" for line in item]
    return lines + [f"  default: werr_q <= {_is_error(block, 'waddr')};", "endcase"]


def _idle(block: Block) -> list[str]:
    """The assignments in a cycle without a write."""
    rows = []
    for reg, field in stored(block):
        name = names.net(reg, field)
        if field.access is Access.W1C:
            rows.append((name, f"<= {name} | {names.event(reg, field)};"))
        elif field.access is Access.PULSE:
            rows.append((name, "<= '0;"))
    rows += [(f"{names.strobe(reg)}_q", "<= '0;") for reg in block.registers if reg.strobe]
    return columns(rows)


def _resets(block: Block) -> list[str]:
    rows = [("werr_q", "<= 1'b0;")]
    for reg, field in stored(block):
        value = "'0"
        if field.reset:
            value = f"{{{reg.count}{{{literal(field)}}}}}" if reg.is_array else literal(field)
        rows.append((names.net(reg, field), f"<= {value};"))
    rows += [(f"{names.strobe(reg)}_q", "<= '0;") for reg in block.registers if reg.strobe]
    return columns(rows)


def _write_process(block: Block) -> list[str]:
    lines = ["  always_ff @(posedge clk_i) begin", "    if (!rst_ni) begin"]
    lines += [f"      {line}" for line in _resets(block)]
    idle = _idle(block)
    if idle:
        lines.append("    end else begin")
        lines += [f"      {line}" for line in idle]
        lines.append("      if (we) begin")
        lines += [f"        {line}" for line in _write_case(block)]
        lines.append("      end")
    else:
        lines.append("    end else if (we) begin")
        lines += [f"      {line}" for line in _write_case(block)]
    return lines + ["    end", "  end"]


def _word(reg: Register) -> list[str]:
    """The parts of the read value, most significant bit first."""
    if reg.external:
        return [names.external(reg, "rdata")]
    if all(field.access is Access.PULSE for field in reg.fields):
        return ["32'b0"]
    parts = []
    top = 31
    for field in reversed(reg.fields):
        if field.msb < top:
            parts.append(f"{top - field.msb}'b0")
        if field.access is Access.PULSE:
            parts.append(f"{field.width}'b0")
        elif field.access is Access.CONST:
            parts.append(literal(field))
        else:
            parts.append(_select(names.net(reg, field), reg, field, Slice(0, 0, field.width)))
        top = field.lsb - 1
    return parts + ([f"{top + 1}'b0"] if top >= 0 else [])


def _read_item(reg: Register) -> list[str]:
    parts = _word(reg)
    word = parts[0] if len(parts) == 1 else f"{{{', '.join(parts)}}}"
    assignment = [f"rdata_q <= {word};"]
    if len(assignment[0]) > ROOM - 2:
        rows = textwrap.wrap(", ".join(parts), ROOM - 4)
        assignment = ["rdata_q <= {", *(f"  {row}" for row in rows), "};"]
    if reg.is_array:
        return _block_item(reg, _for_element(reg, "raddr", assignment))
    names_itself = any(name in word for name in names.members(reg))
    return _item(reg, assignment, "" if names_itself else reg.label)


def _read_process(block: Block) -> list[str]:
    lines = [
        "  always_ff @(posedge clk_i) begin",
        "    if (!rst_ni) begin",
        "      rdata_q <= 32'b0;",
        "      rerr_q  <= 1'b0;",
        "    end else if (re) begin",
        "      rerr_q <= 1'b0;",
        "      case (raddr)",
    ]
    for reg in block.registers:
        lines += [f"        {line}" for line in _read_item(reg)]
    is_error = _is_error(block, "raddr")
    word = f"{is_error} ? 32'hBADACCE5 : 32'b0" if block.no_error_below else "32'hBADACCE5"
    return lines + [
        "        default: begin",
        f"          rdata_q <= {word};",
        f"          rerr_q  <= {is_error};",
        "        end",
        "      endcase",
        "    end",
        "  end",
    ]


def _external_strobes(block: Block) -> list[str]:
    """Strobes of the registers that the core stores. Addresses are compared only while the bus is active."""
    external = [reg for reg in block.registers if reg.external]
    if not external:
        return []
    written = [reg for reg in external if reg.writable]
    strobes = [(reg, "we") for reg in written] + [(reg, "re") for reg in external]
    lines = ["", "  always_comb begin"]
    lines += columns([(f"    {names.external(reg, role)}", "= 1'b0;") for reg, role in strobes])
    for registers, role, address in ((written, "we", "waddr"), (external, "re", "raddr")):
        if not registers:
            continue
        lines.append(f"    if ({role}) begin")
        lines += columns(
            [(f"      {names.external(reg, role)}", f"= {address} == 16'h{reg.offset:04X};") for reg in registers]
        )
        lines.append("    end")
    return [*lines, "  end"]


def register_file(block: Block) -> str:
    lines = [
        header("//", block.source),
        "//",
        *comment(
            f"Register file of {block.name}. It decodes whole words: address bits 1:0 have no effect. {block.error_rule}"
        ),
        *comment(block.lock_rule),
        f'`include "{block.name}_reg_types.svh"',
        "",
        f"module {block.name}_reg_top (",
        "  input logic clk_i,",
        "  input logic rst_ni,",
        "",
        *protect_port(block),
        "  /* verilator tracing_off */  // waveforms show the nets below instead",
        *ports(block),
        "  /* verilator tracing_on */",
        ");",
        *nets(block),
        *_external_strobes(block),
        "",
        *_write_process(block),
        "",
        "  // The read strobe enables the process: no read multiplexer toggles while the bus is idle.",
        *_read_process(block),
        "",
        *unused(block),
        "",
        "endmodule",
    ]
    return "\n".join(lines) + "\n"
