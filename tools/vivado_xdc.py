"""The constraints of tools/vivado: package pins of the carrier card, and timing of pins and synchronisers."""

from __future__ import annotations

import csv
import re
import textwrap
import tomllib
from dataclasses import dataclass
from pathlib import Path

CARRIER = Path("rtl/vivado/carrier.toml")
NETS = Path("rtl/vivado/microzed_pins.csv")

CLOCK = "clk_fpga_0"  # FCLK_CLK0; the IP of the processing system defines it
# From an input pad to its first flop [ns]. It limits the skew between the lines of one encoder to half a clock of 20 ns.
INPUT_NS = 10
# From the first to the second flop of a synchroniser [ns], clock to output and set-up included. The rest of the clock
# period is the time in which the first flop settles: 18 ns, see the mean time between failures in rtl/pulse_train.
SETTLED_NS = 2
# Time from the valid level at an output pad to the next clock edge [ns]: outputs change within 15 ns of their edge.
OUTPUT_NS = 5
FIRST_FLOPS, SECOND_FLOPS = "*first_q_reg*", "*second_q_reg*"  # of sync_2ff and of the emergency stop
IOB = ("step", "dir")  # ports with their flop in the pad


class CarrierError(Exception):
    pass


@dataclass(frozen=True)
class Net:
    name: str
    package_pin: str
    bank: int
    connector: str


def _expanded(text: str) -> list[str]:
    """`X_0..1 Y` is X_0_P, X_0_N, X_1_P, X_1_N, Y."""
    names = []
    for word in text.split():
        pairs = re.fullmatch(r"(\w+_)(\d+)\.\.(\d+)", word)
        if pairs:
            numbers = range(int(pairs[2]), int(pairs[3]) + 1)
            names += [f"{pairs[1]}{number}_{side}" for number in numbers for side in "PN"]
        else:
            names.append(word)
    return names


class Carrier:
    def __init__(self, root: Path):
        carrier = tomllib.loads((root / CARRIER).read_text())
        with (root / NETS).open(newline="") as file:
            rows = [
                Net(row["net"], row["package_pin"], int(row["bank"]), row["connector"]) for row in csv.DictReader(file)
            ]
        self._nets = {net.name: net for net in rows}
        self._of_port = {port: _expanded(text) for port, text in carrier["nets"].items()}
        self.iostandard = carrier["iostandard"]

    def place(self, ports: list) -> dict[str, Net]:
        """The net of each bit of `ports`, by name of the bit. CarrierError: a bit has none, or a net has two."""
        placed: dict[str, Net] = {}
        for port in ports:
            names = self._of_port.pop(port.outer, [])
            if len(names) != port.width:
                raise CarrierError(f"{CARRIER}: {port.outer} has {port.width} bits and {len(names)} nets")
            for bit, name in zip(port.bits, names):
                if name not in self._nets:
                    raise CarrierError(f"{CARRIER}: {bit}: {NETS.name} has no free net {name}")
                placed[bit] = self._nets.pop(name)
        if self._of_port:
            raise CarrierError(f"{CARRIER}: arm_soc has no pin {next(iter(self._of_port))}")
        return placed


def wrapped(words: str) -> str:
    """Words of a Tcl list on continued lines."""
    return " \\\n".join(textwrap.wrap(words, 110, initial_indent="  ", subsequent_indent="  "))


def _all_bits(port) -> str:
    return port.outer if port.width == 1 else f"{{{port.outer}[*]}}"


def _list(ports: list) -> str:
    return f"[get_ports [list \\\n{wrapped(' '.join(_all_bits(port) for port in ports))}]]"


def _cells(pattern: str) -> str:
    return f"[get_cells -hierarchical -filter {{NAME =~ {pattern}}}]"


def xdc(root: Path, generated: str, mhz: float, pads: list) -> str:
    """`pads`: the ports with a pad of the chip."""
    carrier = Carrier(root)
    placed = carrier.place(pads)
    inputs = [port for port in pads if port.direction == "input"]
    outputs = [port for port in pads if port.direction == "output"]
    lines = [
        f"# {generated}",
        "# An example for a carrier card of the MicroZed 7020. Change rtl/vivado/carrier.toml for your own card.",
        "# These constraints have not been run in Vivado, and Debian has no place and route for this device.",
        "",
        f"# The clock of {mhz:g} MHz is {CLOCK}. The IP of the processing system defines it, and arm_soc_ip ties the gated",
        "# clock pins of arm_soc to it. There is no other clock.",
        "",
        "# Package pins, and contact and net of the connector.",
    ]
    width = max(len(bit) for bit in placed)
    for bit, net in placed.items():
        pin = f"{{PACKAGE_PIN {net.package_pin:3} IOSTANDARD {carrier.iostandard}}}"
        port = f"[get_ports {{{bit}}}]".ljust(width + 14)
        lines.append(f"set_property -dict {pin} {port};  # {net.connector} {net.name}, bank {net.bank}")
    lines += [
        "",
        "# No input is synchronous to the clock. Each has a synchroniser, and its delay to the first flop is limited.",
        f"set_max_delay -datapath_only {INPUT_NS} -from {_list(inputs)}",
        "# The second flop of each synchroniser samples a level that has settled: the flops are close to each other.",
        f"set_max_delay {SETTLED_NS} -from {_cells(FIRST_FLOPS)} \\",
        f"  -to {_cells(SECOND_FLOPS)}",
        "",
        f"# Every output is a flop. Its new level is at the pad {OUTPUT_NS} ns before the next clock edge.",
        f"set_output_delay -clock {CLOCK} -max {OUTPUT_NS} {_list(outputs)}",
        f"set_output_delay -clock {CLOCK} -min 0 {_list(outputs)}",
        "# The flops of step and dir are in the pads. They feed logic too: synthesis copies them because of the attribute",
        "# IOB in the RTL. If Vivado reports Shape Builder 18-132, a flop is outside of its pad.",
        f"set_property IOB TRUE {_list([port for port in outputs if port.outer in IOB])}",
        "",
    ]
    for port in pads:
        if port.pin.pull:
            lines += [
                f"# {port.pin.desc}.",
                f"set_property PULLTYPE PULL{port.pin.pull.upper()} [get_ports {_all_bits(port)}]",
            ]
    return "\n".join(lines) + "\n"
