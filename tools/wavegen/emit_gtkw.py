"""A view of the waveforms of one variant of the logic for GTKWave, from the tables of signals, pins and registers."""

from __future__ import annotations

from dataclasses import dataclass, field

from model import Access, Block, Field, Pin, Register, SocMap
from signals import COLORS, Group
from table import MapError

# Flags of a trace.
RIGHT, HEX, DECIMAL, BINARY, SIGNED, TEXT, ANALOG = 0x20, 0x2, 0x4, 0x8, 0x400, 0x800, 0x8000
BLANK, GROUP, END_OF_GROUP, CLOSED, END_OF_CLOSED, HEIGHT = 0x200, 0x800000, 0x1000000, 0x400000, 0x400000, 0x20000
RADIX = {"bit": BINARY, "number": DECIMAL, "signed": SIGNED, "hex": HEX, "text": TEXT}
ANALOG_ROWS = 2  # below the row of an analog trace, for its height
NARROW = 8  # bits of a code that is shown in binary
WITH_PINS = "serial line and tool"  # signals of the software and pins in one group
AXIS_COLORS = ("red", "orange", "yellow", "green")  # the others are dark

TOP = "top"
CHIP = "top.arm_soc"
# The blocks that differ between the variants are in a generate block of arm_soc.
SCOPE_OF_VARIANT = {"counts": f"{CHIP}.g_rtl", "paper": f"{CHIP}.g_paper"}
OF_VARIANT = ("pulse_train", "pulse_width", "encoder", "encoder_switch", "ik_cordic", "policy_mlp")
BUS = (
    ("write", ("awvalid_i", "awready_o", "awaddr_i", "wvalid_i", "wready_o", "wdata_i", "bvalid_o", "bready_i")),
    ("read", ("arvalid_i", "arready_o", "araddr_i", "rvalid_o", "rready_i", "rdata_o")),
)


@dataclass
class View:
    """The lines of a view, and what is in it."""

    variant: str
    soc: SocMap
    blocks: dict[str, Block]
    lines: list[str] = field(default_factory=list)

    def group(self, name: str, traces: list[list[str]], closed: bool = False):
        begin, end = GROUP | BLANK, END_OF_GROUP | BLANK
        if closed:
            begin, end = begin | CLOSED, end | END_OF_CLOSED | 0x1000  # 0x1000: not drawn while the group is closed
        self.lines += [
            f"@{begin:x}",
            f"-{name}",
            *[line for trace in traces for line in trace],
            f"@{end:x}",
            f"-{name}",
        ]

    def pin(self, port: str) -> Pin:
        for pin in self.soc.pins:
            if pin.port == port:
                return pin
        raise MapError(f"{self.soc.source}: the views of tools/wavegen need the pin {port}")

    def pins(self, *ports: str) -> list[list[str]]:
        return [_pin(self.pin(port)) for port in ports]

    def axis_pins(self, *ports: str) -> list[list[str]]:
        """One trace an axis and pin, those of an axis side by side."""
        traces = []
        for axis in range(self.soc.num_axes):
            for port in ports:
                pin = self.pin(port)
                name = f"J{axis + 1} {pin.name.removeprefix('enc_')}"
                traces.append(
                    _trace(
                        BINARY, name, _bit(f"{TOP}.{pin.port}{_range(pin.width)}", pin.width, axis), _axis_color(axis)
                    )
                )
        return traces

    def interrupts(self) -> list[list[str]]:
        pin = self.pin("irq_o")
        net = f"{TOP}.{pin.port}{_range(pin.width)}"
        return [
            _trace(BINARY, f"interrupt of {mapping.name}", _bit(net, pin.width, mapping.irq))
            for mapping in self.soc.of(self.variant)
            if mapping.irq is not None
        ]

    def scope(self, block: str) -> str:
        parent = SCOPE_OF_VARIANT[self.variant] if block in OF_VARIANT else CHIP
        return f"{parent}.u_{block}"

    def field(self, block: str, register: str, name: str) -> tuple[Register, Field]:
        for reg in self.blocks[block].registers:
            for one in reg.fields:
                if (reg.name, one.name) == (register, name):
                    return reg, one
        raise MapError(f"{self.blocks[block].source}: the views of tools/wavegen need the field {register}.{name}")

    def fields(self, block: str, *names: str) -> list[list[str]]:
        """`register.field`, not of an array."""
        traces = []
        for name in names:
            reg, one = self.field(block, *name.split("."))
            traces.append(_trace(_radix(one), name, self.net(block, reg, one)))
        return traces

    def net(self, block: str, register: Register, one: Field) -> str:
        stored = one.access.writable and not register.external
        wide = one.width * register.count
        return f"{self.scope(block)}.u_regs.{register.name}_{one.name}{'_q' if stored else ''}{_range(wide)}"

    def array(self, block: str, register: str, name: str, text: str) -> list[list[str]]:
        """The elements of an array as analog traces."""
        reg, one = self.field(block, register, name)
        net, wide = self.net(block, reg, one), one.width * reg.count
        traces = []
        for i in range(reg.count):
            bits = [_bit(net, wide, i * one.width + bit) for bit in reversed(range(one.width))]
            traces.append(_trace(_radix(one) | ANALOG, f"J{i + 1} {text}", bits, _axis_color(i)))
        return traces


def _range(width: int) -> str:
    return f"[{width - 1}:0]" if width > 1 else ""


def _bit(net: str, width: int, bit: int) -> str:
    """GTKWave counts the bits of a vector from the left."""
    return f"({width - 1 - bit}){net}"


def _axis_color(axis: int) -> str:
    return AXIS_COLORS[axis % len(AXIS_COLORS)]


def _trace(radix: int, name: str, net: str | list[str], color: str = "normal") -> list[str]:
    lines = [f"@{radix | RIGHT:x}"]
    if color != "normal":
        lines.append(f"[color] {COLORS.index(color)}")
    lines.append(f"+{{{name}}} {net}" if isinstance(net, str) else f"#{{{name}}} {' '.join(net)}")
    if radix & ANALOG:
        lines += [f"@{HEIGHT:x}", *["-"] * ANALOG_ROWS]
    return lines


def _pin(pin: Pin) -> list[str]:
    return _trace(BINARY if pin.width <= NARROW else HEX, pin.port, f"{TOP}.{pin.port}{_range(pin.width)}")


def _radix(one: Field) -> int:
    if one.signed:
        return SIGNED
    if one.unit:
        return DECIMAL
    return BINARY if one.width <= NARROW else HEX


def _software(group: Group) -> list[list[str]]:
    return [
        _trace(RADIX[signal.kind], signal.name, f"{TOP}.software.{signal.name}{_range(signal.bits)}", signal.color)
        for signal in group.signals
    ]


def _registers(view: View, block: str) -> list[list[str]]:
    """What the register file of a block holds, except constants and arrays."""
    traces = []
    for reg in view.blocks[block].registers:
        if reg.external:
            continue
        for one in reg.fields:
            if one.access is not Access.CONST and one.access is not Access.KEY and not reg.is_array:
                traces.append(_trace(_radix(one), f"{reg.name}.{one.name}", view.net(block, reg, one)))
    return traces


def _clock(soc: SocMap) -> list[str]:
    return _trace(BINARY, f"clock {soc.clk_freq_hz // 1_000_000} MHz", f"{TOP}.clk_i")


def position_signals(view: View) -> list[str]:
    """The positions that the decoders have now; those of the paper have one for all axes."""
    count = view.soc.num_axes if view.variant == "counts" else 1
    return [f"{view.scope('encoder')}.u_core.gen_axis[{axis}].position_now" for axis in range(count)]


def _live_positions(view: View) -> list[list[str]]:
    signals = position_signals(view)
    names = [f"J{axis + 1}" for axis in range(len(signals))] if len(signals) > 1 else ["selected axis"]
    return [
        _trace(SIGNED | ANALOG, f"{name} position", f"{signal}[31:0]", _axis_color(axis))
        for axis, (name, signal) in enumerate(zip(names, signals))
    ]


def _bus(traces: tuple[str, ...]) -> list[list[str]]:
    wide = ("addr_i", "data_i", "data_o")
    return [
        _trace(
            HEX if name.endswith(wide) else BINARY, name, f"{TOP}.s_axi_{name}{'[31:0]' if name.endswith(wide) else ''}"
        )
        for name in traces
    ]


def _motion(view: View):
    view.group("step and direction", view.axis_pins("step_o", "dir_o"))
    view.group("positions [counts]", _live_positions(view))
    if view.variant == "counts":
        view.group("pulses for the next tick", view.array("pulse_train", "count", "value", "count"))
        view.group("pulses emitted", view.array("pulse_train", "emitted", "value", "emitted"), closed=True)
        state = ("status.sequence", "status.pending", "watchdog.in_a_row", "underruns.total")
        view.group("commits", view.fields("pulse_train", *state))
    else:
        view.group("half periods [cycles]", view.array("pulse_width", "width", "value", "half period"))
        view.group("encoder switch", view.fields("encoder_switch", "select.axis"))
    view.group("encoder lines", view.axis_pins("enc_a_i", "enc_b_i"), closed=True)


def view(name: str, variant: str, groups: list[Group], soc: SocMap, blocks: list[Block]) -> str:
    made = View(variant, soc, {block.name: block for block in blocks})
    for group in groups:
        if group.name != WITH_PINS:
            made.group(group.name, _software(group))
    made.group("trigger", [_clock(soc), *made.pins("trigger_o"), *made.interrupts()])
    _motion(made)
    made.group("safety", made.pins("estop_ni", "servo_on_o", "heartbeat_o", "drive_alarm_i", "in_position_i"))
    serial = [trace for group in groups if group.name == WITH_PINS for trace in _software(group)]
    made.group(WITH_PINS, [*serial, *made.pins("uart_rxd_i", "uart_txd_o", "gpio_i", "gpio_o", "pwm_o")])
    for direction, traces in BUS:
        made.group(f"AXI4-Lite {direction}", _bus(traces), closed=True)
    for group in soc.pin_groups:
        made.group(f"pins: {group.name}", [_pin(pin) for pin in group.pins], closed=True)
    for mapping in soc.of(variant):
        if traces := _registers(made, mapping.name):
            made.group(f"registers: {mapping.name}", traces, closed=True)
    head = [
        f"[*] Generated by tools/wavegen; do not edit. The logic of variant `{variant}`: gtkwave FILE {name}",
        "*-14.000000 -1" + " -1" * 27,
        "[size] 1500 1000",
        "[pos] -1 -1",
        "[sst_width] 230",
        "[signals_width] 300",
        "[sst_expanded] 1",
    ]
    return "".join(f"{line}\n" for line in head + made.lines)
