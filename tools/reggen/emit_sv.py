"""SystemVerilog: the packages of constants, and the pins in the port list of the top."""

from __future__ import annotations

from model import ADDR_BITS, VARIANTS, Block, Field, Register, SocMap
from names import camel
from text import columns, comment, header, trailing

INT = "int"
WORD = "logic [31:0]"


def literal(field: Field) -> str:
    """The reset value as a sized literal."""
    if not field.is_quantity:
        return f"{field.width}'h{field.reset:0{(field.width + 3) // 4}X}"
    if field.width == 1:
        return f"1'b{field.reset}"
    sign = "-" if field.reset_value < 0 else ""
    return f"{sign}{field.width}'d{abs(field.reset_value)}"


def key_literal(reg: Register) -> str:
    """The key word of the register KEY."""
    return f"32'h{reg.key >> 16:04X}_{reg.key & 0xFFFF:04X}"


def _params(rows: list[tuple[str, str, str]]) -> list[str]:
    """Rows of type, name, value as aligned localparams."""
    return [f"  {line}" for line in columns([("localparam", kind, name, f"= {value};") for kind, name, value in rows])]


def _register(reg: Register) -> list[str]:
    rows = [(f"logic [{ADDR_BITS - 1}:0]", camel(reg.name) + "Offset", f"16'h{reg.offset:04X}")]
    if reg.is_array:
        rows.append((INT, camel(reg.name) + "Count", str(reg.count)))
    for field in reg.fields:
        name = camel(reg.name, field.name)
        rows.append((INT, name + "Lsb", str(field.lsb)))
        rows.append((INT, name + "Width", str(field.width)))
        if field.reset is not None:
            kind = f"logic [{field.width - 1}:0]" if field.width > 1 else "logic"
            rows.append((kind, name + "Reset", literal(field)))
    if reg.key is not None:
        rows.append((WORD, camel(reg.name) + "Word", key_literal(reg)))
    return ["", *comment(f"{reg.label}: {reg.desc}.", "  "), *_params(rows)]


def package(block: Block) -> str:
    lines = [
        header("//", block.source),
        "//",
        f"// Offsets (bytes), fields and resets of {block.name}.",
        f"package {block.name}_reg_pkg;",
    ]
    for reg in block.registers:
        lines += _register(reg)
    lines += ["", "endpackage"]
    return "\n".join(lines) + "\n"


def _words(name: str, words: list[str], count: int) -> list[str]:
    """A flat array of `count` words: element i at [32*i +: 32]; unused elements are zero."""
    padded = ["32'h0000_0000"] * (count - len(words)) + words[::-1]
    return [
        f"  localparam logic [MaxBlocks*32-1:0] {name} = {{",
        *[f"    {word}," for word in padded[:-1]],
        f"    {padded[-1]}}};",
    ]


def _crossbar(soc: SocMap) -> list[str]:
    """The ports of the crossbar, and the addresses that each claims in each variant."""
    ports = {m.name: index for variant in VARIANTS for index, m in enumerate(soc.crossbar_of(variant))}
    count = max(len(soc.of(variant)) for variant in VARIANTS)
    lines = [
        "",
        *comment("The crossbar port of each block. It is the same in every variant that has the block.", "  "),
        *_params([(INT, f"{camel(name)}Port", str(port)) for name, port in ports.items()]),
        "",
        *comment("Port i claims an address if (address & Mask) == Base, with word i of both arrays.", "  "),
    ]
    for variant in VARIANTS:
        blocks = soc.crossbar_of(variant)
        prefix = "" if variant == VARIANTS[0] else camel(variant)
        masks = [(1 << 32) - m.size for m in blocks]
        lines += _words(f"{prefix}XbarBase", [f"{camel(m.name)}Base" for m in blocks], count)
        lines += _words(f"{prefix}XbarMask", [f"32'h{mask >> 16:04X}_{mask & 0xFFFF:04X}" for mask in masks], count)
    return lines


def pin_ports(soc: SocMap) -> str:
    """The last ports of the top, for an `include in its port list."""
    lines = [
        header("//", soc.source),
        "//",
        *comment(f"The pins of {soc.name}. Its port list includes this file."),
    ]
    last = soc.pins[-1]
    codes = {
        pin: f"  {'input' if pin.is_input else 'output':6} logic {f'[{pin.width - 1}:0]' if pin.width > 1 else '':6} "
        f"{pin.port}{'' if pin is last else ','}"
        for pin in soc.pins
    }
    column = max(len(code) for code in codes.values()) + 2
    for group in soc.pin_groups:
        lines += ["", f"  // {group.name}"]
        for pin in group.pins:
            lines += trailing(codes[pin], pin.desc, column)
    return "\n".join(lines) + "\n"


def soc_package(soc: SocMap) -> str:
    lines = [
        header("//", soc.source),
        "//",
        *comment(f"{soc.name}: {soc.desc}"),
        "package soc_map_pkg;",
        "",
        *_params(
            [
                (INT, "ClkFreqHz", f"{soc.clk_freq_hz:_}"),
                (INT, "TickCycles", f"{soc.tick_cycles:_}"),
                (INT, "NumBlocks", str(len(soc.of("counts")))),
                (INT, "NumPaperBlocks", str(len(soc.of("paper")))),
                (INT, "MaxBlocks", str(max(len(soc.of(variant)) for variant in VARIANTS))),
                (INT, "NumIrqs", str(soc.num_irqs)),
            ]
        ),
    ]
    for m in soc.mappings:
        name = camel(m.name)
        base = f"{m.base:08X}"
        rows = [
            (WORD, f"{name}Base", f"32'h{base[:4]}_{base[4:]}"),
            (WORD, f"{name}Size", f"32'h{m.size >> 16:04X}_{m.size & 0xFFFF:04X}"),
        ]
        if m.irq is not None:
            rows.append((INT, f"{name}Irq", str(m.irq)))
        lines += ["", *comment(f"{m.desc}.", "  "), *_params(rows)]
    lines += [*_crossbar(soc), "", "endpackage"]
    return "\n".join(lines) + "\n"
