"""Device resources and the longest combinational path of a netlist of 7-series cells."""

from __future__ import annotations

from collections import Counter, defaultdict
from dataclasses import dataclass
from functools import cached_property

RESOURCES = ("lut", "ff", "bram", "dsp")

# Cells without a combinational path from an input to an output.
FLOPS = {"FDRE", "FDSE", "FDCE", "FDPE"}
# Sites per cell: look-up tables (a RAM32M is four), half block RAMs. Two estimates are too high on purpose: an inverter
# counts as a LUT (Vivado mostly absorbs it), and two small LUTs that could share a site count as two.
LUTS = {
    **{f"LUT{n}": 1 for n in range(1, 7)},
    "INV": 1,
    "SRL16E": 1,
    "SRLC32E": 1,
    "RAM32M": 4,
    "RAM64M": 4,
    "RAM32X1D": 2,
    "RAM64X1D": 2,
}
HALF_BRAMS = {"RAMB18E1": 1, "RAMB36E1": 2}
DSPS = {"DSP48E1": 1}
FREE = {"MUXF7": 0, "MUXF8": 0, "CARRY4": 0, "BUFG": 0}  # part of a slice beside its LUTs
# Memories with asynchronous read: the inputs that the output depends on combinationally.
READ_ADDRESS = ("ADDR", "A", "DPRA")
# Delay estimate per cell with the wire in front of it, in ns: rounded up from typical values of 7-series designs of
# speed grade -1. The estimate gives the order of magnitude; Vivado gives the exact value.
DELAY_NS = {"MUXF7": 0.3, "MUXF8": 0.3, "CARRY4": 0.6}
CHAINED_CARRY_NS = 0.12
LUT_NS = 1.1
FLOP_NS = 0.6  # clock to output and set-up together


def resources(cells: Counter[str]) -> dict[str, float]:
    unknown = set(cells) - FLOPS - set(LUTS) - set(HALF_BRAMS) - set(DSPS) - set(FREE)
    if unknown:
        raise ValueError(f"cells that netlist.py does not know: {', '.join(sorted(unknown))}")

    def total(sites: dict[str, int]) -> int:
        return sum(sites.get(kind, 0) * count for kind, count in cells.items())

    return {
        "lut": total(LUTS),
        "ff": sum(cells[kind] for kind in FLOPS),
        "bram": total(HALF_BRAMS) / 2,
        "dsp": total(DSPS),
    }


@dataclass
class Path:
    levels: int  # levels of logic between two flops as in Vivado: each LUT, MUXF7, MUXF8 and CARRY4 is one level
    delay_ns: float
    cells: list[tuple[str, str]]  # (kind, net that it drives), from the first flop to the last


class Graph:
    """The bits of a flat module and the cells between them. A path begins and ends at a clocked cell or a port."""

    def __init__(self, module: dict):
        self._cells = module["cells"]
        self._names = {}
        for name, net in module["netnames"].items():
            for index, bit in enumerate(net["bits"]):
                # The shortest name is the name in the source.
                text = name if len(net["bits"]) == 1 else f"{name}[{index}]"
                if bit not in self._names or len(text) < len(self._names[bit]):
                    self._names[bit] = text

    @cached_property
    def _arcs(self) -> dict[int, list[tuple[str, str, list]]]:
        """For each driven bit: (kind, cell, input bits)."""
        arcs = {}
        for name, cell in self._cells.items():
            kind = cell["type"]
            inputs = {pin: bits for pin, bits in cell["connections"].items() if cell["port_directions"][pin] == "input"}
            for pin, bits in cell["connections"].items():
                if cell["port_directions"][pin] != "output":
                    continue
                for index, bit in enumerate(bits):
                    arcs[bit] = (kind, name, self._sources(kind, inputs, index))
        return arcs

    @staticmethod
    def _sources(kind: str, inputs: dict[str, list], index: int) -> list:
        if kind in FLOPS or kind in HALF_BRAMS or kind in DSPS:
            return []
        if kind == "CARRY4":  # bit i depends on the carry of the bits below it
            return [bit for pin, bits in inputs.items() for bit in (bits[: index + 1] if len(bits) > 1 else bits)]
        if kind.startswith(("RAM", "SRL")):
            return [bit for pin, bits in inputs.items() if pin.startswith(READ_ADDRESS) for bit in bits]
        return [bit for bits in inputs.values() for bit in bits]

    def _order(self) -> list[int]:
        """The driven bits in topological order: each after all bits that it depends on."""
        order, state = [], defaultdict(int)
        for root in self._arcs:
            stack = [(root, False)]
            while stack:
                bit, done = stack.pop()
                if done:
                    state[bit] = 2
                    order.append(bit)
                elif state[bit] == 0:
                    state[bit] = 1
                    stack.append((bit, True))
                    for source in self._arcs[bit][2]:
                        if source in self._arcs:
                            if state[source] == 1:
                                raise ValueError(f"combinational loop through {self._names[source]}")
                            if state[source] == 0:
                                stack.append((source, False))
        return order

    def longest(self) -> Path:
        """The slowest of the paths with the most levels."""
        worst: dict[int, tuple[int, float]] = {}
        before: dict[int, int] = {}
        for bit in self._order():
            kind, cell, sources = self._arcs[bit]
            best = (0, 0.0)
            if sources:
                for source in sources:
                    levels, delay = worst.get(source, (0, 0.0))
                    if (levels, delay) >= best:
                        best, before[bit] = (levels, delay), source
                step = DELAY_NS.get(kind, LUT_NS)
                if kind == "CARRY4" and self._arcs.get(before[bit], ("",))[0] == "CARRY4":
                    step = CHAINED_CARRY_NS
                # All bits of one carry chain cell are one level.
                best = (best[0] + 1, best[1] + step)
            worst[bit] = best
        end = max(worst, key=worst.get)
        levels, delay = worst[end]
        cells, bit = [], end
        while bit in before:
            cells.append((self._arcs[bit][0], self._names.get(bit, "?")))
            bit = before[bit]
        cells.append((self._arcs[bit][0] if bit in self._arcs else "port", self._names.get(bit, "?")))
        return Path(levels, delay + FLOP_NS, cells[::-1] + self._taken_by(end))

    def _taken_by(self, end: int) -> list[tuple[str, str]]:
        """The flop at the end of a path, if there is one."""
        for cell in self._cells.values():
            if cell["type"] in FLOPS and end in (bits[0] for pin, bits in cell["connections"].items() if pin != "Q"):
                return [(cell["type"], self._names.get(cell["connections"]["Q"][0], "?"))]
        return []


def cell_counts(module: dict, kept: set[str]) -> Counter[str]:
    """Number of cells of one module by kind, without its kept submodules. Yosys adds an inverter of the reset to each
    flop, so inverters with the same input count as one."""
    counts = Counter(cell["type"] for cell in module["cells"].values() if cell["type"] not in kept)
    counts["INV"] = len({cell["connections"]["I"][0] for cell in module["cells"].values() if cell["type"] == "INV"})
    return counts
