"""C++ headers: offsets, fields, masks and resets as constants."""

from __future__ import annotations

from model import STRIDE, Block, Field, Register, SocMap
from names import camel
from text import comment, header as first_line, noted

U32 = "inline constexpr std::uint32_t"


def _digits(value: int) -> str:
    return f"{value:_}".replace("_", "'")


def _reset(reg: Register, field: Field) -> list[str]:
    if field.reset is None:
        return []
    name = f"k{camel(reg.name, field.name)}Reset"
    if field.signed:
        # The literal 2147483648 does not fit in an int, so the lowest value is written as a difference.
        value = "-2147483647 - 1" if field.reset_value == -(1 << 31) else field.reset_value
        return [f"inline constexpr std::int32_t {name} = {value};"]
    value = str(field.reset) if field.is_quantity else f"0x{field.reset:X}"
    return [f"{U32} {name} = {value};"]


def _register(reg: Register) -> list[str]:
    lines = comment(f"{reg.label}: {reg.desc}.")
    lines.append(f"{U32} k{camel(reg.name)}Offset = 0x{reg.offset:02X};")
    if reg.is_array:
        lines.append(f"{U32} k{camel(reg.name)}Count = {reg.count};")
        lines.append(f"{U32} k{camel(reg.name)}Stride = {STRIDE};")
    for field in reg.fields:
        name = f"k{camel(reg.name, field.name)}"
        unit = f", {field.unit}" if field.unit else ""
        sign = "signed " if field.signed else ""
        lines += noted(
            f"inline constexpr Field {name}{{.lsb = {field.lsb}, .width = {field.width}}};",
            f"{field.name} ({sign}{field.access.value}{unit}): {field.desc}",
        )
        lines.append(f"{U32} {name}Mask = 0x{field.mask:08X};")
        lines += _reset(reg, field)
    if reg.is_const and len(reg.fields) > 1:
        word = sum(field.reset << field.lsb for field in reg.fields)
        lines += ["// The whole register.", f"{U32} k{camel(reg.name)}Word = 0x{word:08X};"]
    if reg.key is not None:
        lines += [
            "// Writing this word unlocks the protected registers.",
            f"{U32} k{camel(reg.name)}Word = 0x{reg.key:08X};",
        ]
    return lines + [""]


def header(block: Block) -> str:
    lines = [
        first_line("//", block.source),
        "//",
        *comment(f"{block.name}: {block.desc}"),
        "// Offsets are in bytes from the base of the block (soc_map.hpp).",
        *comment(block.error_rule),
        *comment(block.lock_rule),
        "#pragma once",
        "",
        "#include <cstdint>",
        "",
        '#include "controller/regs/field.hpp"',
        "",
        f"namespace armature::regs::{block.name} {{",
        "",
    ]
    for reg in block.registers:
        lines += _register(reg)
    lines.append(f"}}  // namespace armature::regs::{block.name}")
    return "\n".join(lines) + "\n"


def soc_header(soc: SocMap) -> str:
    lines = [
        first_line("//", soc.source),
        "//",
        *comment(f"{soc.name}: {soc.desc}"),
        "#pragma once",
        "",
        "#include <cstdint>",
        "#include <string_view>",
        "",
        "namespace armature::regs::soc {",
        "",
        f"{U32} kClkFreqHz = {_digits(soc.clk_freq_hz)};",
        f"{U32} kTickCycles = {_digits(soc.tick_cycles)};",
        f"{U32} kNumBlocks = {len(soc.of('counts'))};",
        f"{U32} kNumPaperBlocks = {len(soc.of('paper'))};",
        f"{U32} kNumAxes = {soc.num_axes};",
        f"{U32} kNumIrqs = {soc.num_irqs};",
        "",
    ]
    for m in soc.mappings:
        name = camel(m.name)
        lines += comment(f"{m.desc}.")
        lines.append(f"{U32} k{name}Base = 0x{m.base:08X};")
        lines.append(f"{U32} k{name}Size = 0x{m.size:X};")
        if m.irq is not None:
            lines.append(f"{U32} k{name}Irq = {m.irq};  // bit of irq_o")
        lines.append("")
    lines += [
        "// All blocks.",
        "struct Block {",
        "  std::string_view name;",
        "  std::uint32_t base;",
        "  std::uint32_t size;        // bytes",
        "  std::string_view variant;  // variant of the logic that has the block; empty: all variants",
        "};",
        "inline constexpr Block kBlocks[]{",
    ]
    for m in soc.mappings:
        name = camel(m.name)
        lines.append(
            f'    {{.name = "{m.name}", .base = k{name}Base, .size = k{name}Size, .variant = "{m.variant or ""}"}},'
        )
    lines += ["};", ""]
    lines.append("}  // namespace armature::regs::soc")
    return "\n".join(lines) + "\n"
