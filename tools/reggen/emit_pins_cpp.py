"""C++: the pins of the logic for the simulator (structs, a table, the wiring to a verilated model)."""

from __future__ import annotations

from model import Pin, SocMap
from text import comment, header

NAMESPACE = "namespace armature::cosim {"
END = "}  // namespace armature::cosim"


def _type(pin: Pin) -> str:
    if pin.width == 1 and pin.per is None:
        return "bool"
    return next(f"std::uint{bits}_t" for bits in (8, 16, 32) if pin.width <= bits)


def _idle(pin: Pin) -> str:
    if _type(pin) == "bool":
        return "true" if pin.idle else "false"
    return f"0x{(1 << pin.width) - 1:X}" if pin.idle else "0"


def _split(soc: SocMap) -> tuple[list[Pin], list[Pin]]:
    """Returns inputs, outputs."""
    return [pin for pin in soc.pins if pin.is_input], [pin for pin in soc.pins if not pin.is_input]


def _start(soc: SocMap, about: str, includes: list[str]) -> list[str]:
    return [header("//", soc.source), "//", *comment(about), "#pragma once", "", *includes, "", NAMESPACE, ""]


def _text(lines: list[str]) -> str:
    return "\n".join([*lines, "", END]) + "\n"


def _struct(name: str, pins: list[Pin]) -> list[str]:
    lines = [f"struct {name} {{"]
    for pin in pins:
        facts = [
            text
            for text, true in (
                ("One bit per axis", pin.per == "axis"),
                ("Active low", pin.active_low),
                ("Idle high", pin.idle and not pin.active_low),
            )
            if true
        ]
        lines += comment(". ".join([pin.desc, *facts]) + ".", "  ")
        lines.append(f"  {_type(pin)} {pin.member} = {_idle(pin)};")
    return [*lines, "", f"  friend bool operator==(const {name}&, const {name}&) = default;", "};"]


def structs(soc: SocMap) -> str:
    """pins.hpp"""
    inputs, outputs = _split(soc)
    about = f"The levels of the pins of {soc.name}. In pins with one bit per axis, axis 1 is bit 0."
    lines = _start(soc, about, ["#include <cstdint>"])
    lines += [
        "// Levels that the environment drives. The next rising clock edge samples them.",
        *_struct("SocInputs", inputs),
    ]
    lines += [
        "",
        "// Registered levels that the logic drives, valid after each clock edge.",
        *_struct("SocOutputs", outputs),
    ]
    return _text(lines)


def table(soc: SocMap) -> str:
    """pin_list.hpp"""
    lines = _start(soc, f"Every pin of {soc.name} in the order of its ports.", ['#include "cosim/logic/pin_table.hpp"'])
    lines += ["// clang-format off", "inline constexpr Pin kPins[] = {"]
    for pin in soc.pins:
        make, struct = ("input_pin", "SocInputs") if pin.is_input else ("output_pin", "SocOutputs")
        lines.append(f'    {make}<&{struct}::{pin.member}>("{pin.port}", {pin.width}),')
    return _text([*lines, "};", "// clang-format on"])


def wiring(soc: SocMap) -> str:
    """model_pins.hpp"""
    inputs, outputs = _split(soc)
    about = f"Copies levels to and from the ports of a verilated {soc.name}. Model: a class that Verilator generates."
    lines = _start(soc, about, ["#include <cstdint>", "", '#include "cosim/logic/pins.hpp"'])
    lines += [
        "template <class Model>",
        "void drive_pins(Model& model, const SocInputs& in) {",
        *[f"  model.{pin.port} = in.{pin.member};" for pin in inputs],
        "}",
        "",
    ]
    lines += [
        "template <class Model>",
        "[[nodiscard]] SocOutputs sample_pins(const Model& model) {",
        "  SocOutputs out;",
    ]
    for pin in outputs:
        lines.append(f"  out.{pin.member} = model.{pin.port}{' != 0' if _type(pin) == 'bool' else ''};")
    lines += ["  return out;", "}", ""]
    lines += [
        "// All output pins in one word, so that one comparison per clock detects a change.",
        "template <class Model>",
        "[[nodiscard]] std::uint64_t output_word(const Model& model) {",
        "  std::uint64_t word = 0;",
    ]
    position = 0
    for pin in outputs:
        lines.append(f"  word |= std::uint64_t{{model.{pin.port}}} << {position};")
        position += pin.width
    return _text([*lines, "  return word;", "}"])
