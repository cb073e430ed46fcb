"""What a register map says: plain values, already validated by load.py."""

from __future__ import annotations

from dataclasses import dataclass
from enum import Enum

WORD_BITS = 32
STRIDE = 4  # bytes from one element of an array to the next
ADDR_BITS = 16  # address bits that a register file decodes
VARIANTS = ("counts", "paper")  # variants of the logic, parameter PaperFabric of arm_soc


class Access(Enum):
    """How software sees a field."""

    RW = "rw"  # flop in the register file, byte strobes honoured
    RO = "ro"  # sampled from the hardware when read
    CONST = "const"  # reads its reset value
    W1C = "w1c"  # flag: set by a hardware event, cleared by writing 1; the event wins
    PULSE = "pulse"  # writing 1 gives one cycle of 1; reads 0

    @property
    def writable(self) -> bool:
        return self in (Access.RW, Access.W1C, Access.PULSE)


@dataclass(frozen=True)
class Field:
    name: str
    msb: int
    lsb: int
    access: Access
    reset: int | None  # two's complement in `width` bits; None: not stated (ro, or owned by an external core)
    signed: bool
    unit: str
    desc: str

    @property
    def width(self) -> int:
        return self.msb - self.lsb + 1

    @property
    def mask(self) -> int:
        return ((1 << self.width) - 1) << self.lsb

    @property
    def bits(self) -> str:
        return f"{self.msb}:{self.lsb}" if self.width > 1 else f"{self.lsb}"

    @property
    def is_quantity(self) -> bool:
        """Its reset reads best in decimal; otherwise it is a code or a mask."""
        return bool(self.unit) or self.signed or self.reset < 10

    @property
    def reset_value(self) -> int | None:
        """The reset as software reads it: negative where a signed field has its top bit set."""
        if self.reset is not None and self.signed and self.reset >> (self.width - 1):
            return self.reset - (1 << self.width)
        return self.reset


@dataclass(frozen=True)
class Register:
    name: str
    offset: int  # bytes from the base of the block; of element 0 of an array
    count: int  # elements; 1: not an array
    strobe: bool  # tells the hardware of each write
    external: bool  # the core owns storage and side effects
    desc: str
    fields: tuple[Field, ...]  # ascending bits

    @property
    def is_array(self) -> bool:
        return self.count > 1

    @property
    def writable(self) -> bool:
        return any(field.access.writable for field in self.fields)

    @property
    def is_const(self) -> bool:
        return all(field.access is Access.CONST for field in self.fields)

    @property
    def offsets(self) -> range:
        return range(self.offset, self.offset + STRIDE * self.count, STRIDE)

    @property
    def index_msb(self) -> int:
        """The element index of an array is address bits index_msb:2 (load.py demands the alignment)."""
        return 1 + (self.count - 1).bit_length()

    @property
    def label(self) -> str:
        return f"{self.name.upper()}[{self.count}]" if self.is_array else self.name.upper()


@dataclass(frozen=True)
class Block:
    name: str
    desc: str
    source: str  # the TOML file, relative to the root
    registers: tuple[Register, ...]  # ascending offset
    # A power of two, or 0. Words below it without a register read 0, and no write to a word below it is an error.
    no_error_below: int = 0


@dataclass(frozen=True)
class Mapping:
    """A block at its place in the address map."""

    name: str
    regs: str  # name of the Block
    base: int
    size: int  # bytes
    irq: int | None
    variant: str | None  # of VARIANTS, the variant of the logic that has it; None: all have
    desc: str


@dataclass(frozen=True)
class Pin:
    """A port of the logic that is neither clock, reset nor bus."""

    name: str  # without the suffix of the port
    is_input: bool
    width: int
    per: str | None  # "axis": one bit per axis, axis 1 is bit 0; "irq": one bit per interrupt line
    active_low: bool
    idle: int  # 0 or 1: the level of each bit while nothing happens
    pull: str | None  # "up" or "down": where a resistor at the pad holds an open input
    desc: str

    @property
    def member(self) -> str:
        """Its name in C++ and as a pad of the chip."""
        return self.name + ("_n" if self.active_low else "")

    @property
    def port(self) -> str:
        return self.name + ("_n" if self.active_low else "_") + ("i" if self.is_input else "o")

    @property
    def has_pad(self) -> bool:
        """It leaves the chip; interrupts go to the processor, which is on the same chip."""
        return self.per != "irq"


@dataclass(frozen=True)
class PinGroup:
    name: str
    pins: tuple[Pin, ...]


@dataclass(frozen=True)
class SocMap:
    name: str
    desc: str
    source: str
    clk_freq_hz: int
    tick_cycles: int
    num_axes: int
    num_irqs: int
    mappings: tuple[Mapping, ...]  # ascending base
    pin_groups: tuple[PinGroup, ...]  # in the order of the ports

    @property
    def pins(self) -> list[Pin]:
        return [pin for group in self.pin_groups for pin in group.pins]

    @property
    def crossbar(self) -> list[Mapping]:
        """Every block in the order of the crossbar's ports, ascending base, those of one variant last.

        So a block has the same port in each variant that has it.
        """
        return sorted(self.mappings, key=lambda m: m.variant is not None)

    def crossbar_of(self, variant: str) -> list[Mapping]:
        """The blocks of one variant of the logic in the order of its crossbar's ports."""
        return [m for m in self.crossbar if m.variant in (None, variant)]

    def of(self, variant: str) -> list[Mapping]:
        """The blocks of one variant of the logic."""
        return [m for m in self.mappings if m.variant in (None, variant)]
