"""Reads and validates the TOML files. Every message contains the file, the register and the key."""

from __future__ import annotations

import re
from pathlib import Path

import names
from load_pins import load_pins
from model import ADDR_BITS, STRIDE, VARIANTS, WORD_BITS, Access, Block, Field, Mapping, Register, SocMap
from table import MapError, Table, read, check_duplicates  # noqa: F401 (MapError: for who imports load)

BITS = re.compile(r"(\d+)(?::(\d+))?")


def _bits(table: Table) -> tuple[int, int]:
    text = table.pop("bits", str)
    match = BITS.fullmatch(text)
    if not match:
        table.fail(f'bits "{text}" is neither "bit" nor "msb:lsb"')
    msb = int(match[1])
    lsb = int(match[2] or match[1])
    if msb < lsb:
        table.fail(f'bits "{text}": msb is below lsb')
    if msb >= WORD_BITS:
        table.fail(f'bits "{text}" are outside 0..{WORD_BITS - 1}')
    return msb, lsb


def _reset(table: Table, access: Access, width: int, signed: bool, external: bool) -> int | None:
    reset = table.pop_optional("reset", int)
    if reset is None:
        if access is Access.CONST or (access is Access.RW and not external):
            table.fail(f"missing key `reset` (access {access.value})")
        return None
    if access not in (Access.RW, Access.CONST):
        table.fail(f"`reset` is not for access {access.value}")
    low, high = (-(1 << (width - 1)), (1 << (width - 1)) - 1) if signed else (0, (1 << width) - 1)
    if not low <= reset <= high:
        table.fail(f"reset {reset} does not fit in {width} bits ({low}..{high})")
    return reset & ((1 << width) - 1)


def _field(where: str, values: dict, external: bool) -> Field:
    table = Table(f"{where}, field {values.get('name', '?')}", values)
    name = table.pop_name()
    msb, lsb = _bits(table)
    text = table.pop("access", str)
    allowed = [access.value for access in Access if access is not Access.KEY]
    if text not in allowed:
        table.fail(f"unknown access `{text}` (one of {', '.join(allowed)})")
    access = Access(text)
    signed = table.pop("signed", bool, False)
    reset = _reset(table, access, msb - lsb + 1, signed, external)
    unit = table.pop("unit", str, "")
    desc = table.pop("desc", str)
    protected = table.pop("protected", bool, False)
    table.check_empty()
    if protected and (access is not Access.RW or msb != lsb or external):
        table.fail("`protected` needs a rw field of one bit, and storage that is not in the core")
    return Field(name, msb, lsb, access, reset, signed, unit, desc, protected)


def _check_offset(table: Table, reg: Register):
    if reg.offset % STRIDE:
        table.fail(f"offset 0x{reg.offset:X} is not a multiple of {STRIDE}")
    if not 0 <= reg.offset <= reg.offsets[-1] < 1 << ADDR_BITS:
        table.fail(f"offset {reg.offset:#x} is outside the {ADDR_BITS} address bits of a block")


def _lock(where: str, values: dict) -> tuple[Register, str]:
    """The register KEY, and when the protected registers are protected."""
    table = Table(f"{where}: lock", values)
    offset = table.pop("offset", int)
    key = table.pop("key", int)
    condition = table.pop("while", str)
    table.check_empty()
    if not 0 < key < (1 << WORD_BITS) - 1:
        table.fail(f"key 0x{key:X} is outside 0x1..0x{(1 << WORD_BITS) - 2:X}")
    desc = "Lock of the protected registers. Writing the key word unlocks them, any other write locks them"
    unlocked = Field("unlocked", 0, 0, Access.KEY, None, False, "", "The protected registers are unlocked")
    reg = Register("key", offset, 1, False, False, False, key, f"{desc}. The key word is 0x{key:08X}", (unlocked,))
    _check_offset(table, reg)
    return reg, condition


def _register(where: str, values: dict) -> Register:
    table = Table(f"{where}: register {values.get('name', '?')}", values)
    name = table.pop_name()
    offset = table.pop("offset", int)
    count = table.pop_optional("count", int)
    strobe = table.pop("strobe", bool, False)
    external = table.pop("external", bool, False)
    protected = table.pop("protected", bool, False)
    desc = table.pop("desc", str)
    fields = [_field(table.where, values, external) for values in table.pop_tables("fields")]
    table.check_empty()

    if count is not None and count < 2:
        table.fail(f"count {count} is below 2")
    ascending = tuple(sorted(fields, key=lambda field: field.lsb))
    reg = Register(name, offset, count or 1, strobe, external, protected, None, desc, ascending)
    _check_offset(table, reg)
    if reg.is_array and offset % (2 << reg.index_msb):
        table.fail(
            f"offset 0x{offset:X}: an array of {count} starts at a multiple of 0x{2 << reg.index_msb:X}, "
            "so that its index is a slice of the address"
        )
    if external and (reg.is_array or strobe):
        table.fail("an external register has neither `count` nor `strobe`")
    if strobe and not any(field.access is Access.RW for field in fields):
        table.fail("`strobe` needs a rw field")
    if protected and (external or not reg.writable):
        table.fail("`protected` needs a writable field, and storage that is not in the core")

    if sum(field.protected for field in fields) + protected > 1 or (reg.protected_field and reg.is_array):
        table.fail("one field can be `protected`, in a register that is not, and that is no array")

    check_duplicates(table, "field", [field.name for field in fields])
    for below, above in zip(reg.fields, reg.fields[1:]):
        if above.lsb <= below.msb:
            table.fail(f"field {above.name} (bits {above.bits}) overlaps field {below.name} (bits {below.bits})")
    return reg


def load_block(root: Path, path: Path) -> Block:
    table = read(root, path)
    name = table.pop_name()
    if path != root / "rtl" / name / f"{name}_regs.toml":
        table.fail(f"name `{name}` does not match the file, expected rtl/{name}/{name}_regs.toml")
    desc = table.pop("desc", str)
    no_error_below = table.pop_optional("no_error_below", int) or 0
    lock = table.pop_optional("lock", dict)
    registers = [_register(table.where, values) for values in table.pop_tables("register")]
    table.check_empty()
    protected = [reg.name for reg in registers if reg.protected]
    if protected and lock is None:
        table.fail(f"register {protected[0]}: `protected` needs a table [lock]")
    if lock is not None and not protected:
        table.fail("lock: no register is `protected`")
    kept = [reg.name for reg in registers if reg.protected_field]
    if kept and lock is None:
        table.fail(f"register {kept[0]}: a `protected` field needs a table [lock]")
    key, protected_while = _lock(table.where, lock) if lock is not None else (None, "")
    if key:
        registers.append(key)
    if no_error_below & (no_error_below - 1) or not 0 <= no_error_below < 1 << ADDR_BITS:
        table.fail(f"no_error_below {no_error_below:#x} is not a power of two below {1 << ADDR_BITS:#x}")

    check_duplicates(table, "register", [reg.name for reg in registers])
    check_duplicates(table, "member", [name for reg in registers for name in names.members(reg)])
    check_duplicates(table, "constant", [constant for reg in registers for constant in names.constants(reg)])
    registers.sort(key=lambda reg: reg.offset)
    for below, above in zip(registers, registers[1:]):
        if above.offset <= below.offsets[-1]:
            table.fail(
                f"register {above.name} (0x{above.offset:X}) overlaps register {below.name} "
                f"(0x{below.offset:X}..0x{below.offsets[-1] + STRIDE - 1:X})"
            )
    return Block(name, desc, table.where, tuple(registers), no_error_below, protected_while)


def _mapping(where: str, values: dict, blocks: dict[str, Block]) -> Mapping:
    table = Table(f"{where}: block {values.get('name', '?')}", values)
    mapping = Mapping(
        name=table.pop_name(),
        regs=table.pop("regs", str),
        base=table.pop("base", int),
        size=table.pop("size", int),
        irq=table.pop_optional("irq", int),
        variant=table.pop_optional("variant", str),
        desc=table.pop("desc", str),
    )
    table.check_empty()

    if mapping.variant is not None and mapping.variant not in VARIANTS:
        table.fail(f"`variant`: {mapping.variant} is none of {', '.join(VARIANTS)}")
    if mapping.regs not in blocks:
        table.fail(f"`regs`: rtl/{mapping.regs}/{mapping.regs}_regs.toml does not exist")
    size = mapping.size
    if size < STRIDE or size & (size - 1):
        table.fail(f"size 0x{size:X} is not a power of two of at least {STRIDE}")
    if size > 1 << ADDR_BITS:
        table.fail(f"size 0x{size:X} is above the 0x{1 << ADDR_BITS:X} that a register file decodes")
    if mapping.base % size:
        table.fail(f"base 0x{mapping.base:08X} is not a multiple of size 0x{size:X}")
    if not 0 <= mapping.base <= (1 << 32) - size:
        table.fail(f"base 0x{mapping.base:X} is outside the 32-bit address space")
    last = blocks[mapping.regs].registers[-1]
    if last.offsets[-1] >= size:
        table.fail(f"size 0x{size:X} does not hold register {last.name} (0x{last.offsets[-1]:X})")
    if mapping.irq is not None and not 0 <= mapping.irq < WORD_BITS:
        table.fail(f"irq {mapping.irq} is outside 0..{WORD_BITS - 1}")
    return mapping


def load_soc_map(root: Path, path: Path, blocks: dict[str, Block]) -> SocMap:
    table = read(root, path)
    name = table.pop_name()
    desc = table.pop("desc", str)
    clk_freq_hz = table.pop("clk_freq_hz", int)
    tick_cycles = table.pop("tick_cycles", int)
    num_axes = table.pop("num_axes", int)
    for key, value in (("clk_freq_hz", clk_freq_hz), ("tick_cycles", tick_cycles)):
        if not 0 < value < 1 << 31:
            table.fail(f"{key} {value} is outside 1..2^31-1")
    if not 1 <= num_axes <= WORD_BITS:
        table.fail(f"num_axes {num_axes} is outside 1..{WORD_BITS}")
    mappings = [_mapping(table.where, values, blocks) for values in table.pop_tables("block")]
    num_irqs = 1 + max((mapping.irq for mapping in mappings if mapping.irq is not None), default=-1)
    pins = load_pins(table, {"axis": num_axes, "irq": num_irqs})
    table.check_empty()

    check_duplicates(table, "block", [mapping.name for mapping in mappings])
    irq_owner: dict[int, str] = {}
    for mapping in mappings:
        if mapping.irq is not None and irq_owner.setdefault(mapping.irq, mapping.name) != mapping.name:
            table.fail(f"block {mapping.name}: irq {mapping.irq} is already used by block {irq_owner[mapping.irq]}")
    mappings.sort(key=lambda mapping: mapping.base)
    soc = SocMap(name, desc, table.where, clk_freq_hz, tick_cycles, num_axes, num_irqs, tuple(mappings), pins)
    for variant in VARIANTS:
        of_variant = soc.of(variant)
        for below, above in zip(of_variant, of_variant[1:]):
            if above.base < below.base + below.size:
                table.fail(
                    f"block {above.name} (base 0x{above.base:08X}) overlaps block {below.name} "
                    f"(0x{below.base:08X}, size 0x{below.size:X})"
                )
    return soc


def load_all(root: Path) -> tuple[SocMap, list[Block]]:
    """The address map and every block under root/rtl, in order of name."""
    paths = sorted((root / "rtl").glob("*/*_regs.toml"))
    blocks = {block.name: block for block in (load_block(root, path) for path in paths)}
    return load_soc_map(root, root / "rtl" / "soc" / "soc_map.toml", blocks), list(blocks.values())
