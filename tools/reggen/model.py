"""The content of a register map as plain values, validated by load.py."""

from __future__ import annotations

from dataclasses import dataclass
from enum import Enum

WORD_BITS = 32
STRIDE = 4  # bytes from one element of an array to the next
ADDR_BITS = 16  # address bits that a register file decodes
VARIANTS = ("counts", "paper")  # variants of the logic, parameter PaperFabric of arm_soc


class Access(Enum):
    """Access of software to a field."""

    RW = "rw"  # flop in the register file, written with byte strobes
    RO = "ro"  # sampled from the hardware when read
    CONST = "const"  # reads its reset value
    W1C = "w1c"  # sticky flag: set by a hardware event, cleared by writing 1; the event wins
    PULSE = "pulse"  # writing 1 gives one cycle of 1; reads 0
    KEY = "key"  # 1 while the protected registers are unlocked; only the register KEY has it

    @property
    def writable(self) -> bool:
        return self not in (Access.RO, Access.CONST)


@dataclass(frozen=True)
class Field:
    name: str
    msb: int
    lsb: int
    access: Access
    reset: int | None  # two's complement in `width` bits; None: not given (ro, or stored in the core)
    signed: bool
    unit: str
    desc: str
    protected: bool = False  # one bit, rw: cannot be cleared while the block is protected and locked

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
        """True: a number, whose reset is written in decimal. False: a code or a mask."""
        return bool(self.unit) or self.signed or self.reset < 10

    @property
    def reset_value(self) -> int | None:
        """The reset as a number: negative if the field is signed and its top bit is 1."""
        if self.reset is not None and self.signed and self.reset >> (self.width - 1):
            return self.reset - (1 << self.width)
        return self.reset


@dataclass(frozen=True)
class Register:
    name: str
    offset: int  # bytes from the base of the block; of element 0 of an array
    count: int  # elements; 1: not an array
    strobe: bool  # a write gives a strobe to the core
    external: bool  # the core has the storage and the side effects
    protected: bool  # read only while the block is protected and locked
    key: int | None  # the word that unlocks the protected registers; None: not the register KEY
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
        """The element index of an array is address bits index_msb:2 (load.py requires the alignment)."""
        return 1 + (self.count - 1).bit_length()

    @property
    def protected_field(self) -> Field | None:
        return next((field for field in self.fields if field.protected), None)

    @property
    def label(self) -> str:
        return f"{self.name.upper()}[{self.count}]" if self.is_array else self.name.upper()


@dataclass(frozen=True)
class Block:
    name: str
    desc: str
    source: str  # the TOML file, relative to the root
    registers: tuple[Register, ...]  # ascending offset
    # Size in bytes of the range in which no access is an error, a power of two; 0: there is no such range.
    no_error_below: int = 0
    protected_while: str = ""  # when the input protect_i is 1, in words; empty: the block has no lock

    @property
    def key(self) -> Register | None:
        """The register KEY; None: the block has no lock."""
        return next((reg for reg in self.registers if reg.key is not None), None)

    @property
    def lock_rule(self) -> str:
        """The meaning of the lock in words, or an empty text."""
        if not self.key:
            return ""
        protected = ", ".join(reg.label for reg in self.registers if reg.protected)
        fields = [f"{reg.label}.{reg.protected_field.name}" for reg in self.registers if reg.protected_field]
        kept = (
            f" A write cannot clear {', '.join(fields)} either: it writes the other fields of the register and is answered "
            "in the same way."
            if fields
            else ""
        )
        return (
            f"While {self.protected_while}, these registers are protected: {protected}. A write to one of them changes "
            f"nothing and is answered like a write to a read-only register, unless 0x{self.key.key:08X} was written to KEY."
            f"{kept}"
        )

    @property
    def error_rule(self) -> str:
        """The meaning of no_error_below in words, or an empty text."""
        if not self.no_error_below:
            return ""
        limit = f"0x{self.no_error_below:X}"
        return (
            f"Below {limit} every access answers OKAY, as in the vendor's block: words without a register read 0, and "
            f"writes to them and to read-only words are ignored. From {limit} on every access answers SLVERR."
        )


@dataclass(frozen=True)
class Mapping:
    """The entry of a block in the address map."""

    name: str
    regs: str  # name of the Block
    base: int
    size: int  # bytes
    irq: int | None
    variant: str | None  # one of VARIANTS: the variant of the logic that has the block; None: all variants
    desc: str


@dataclass(frozen=True)
class Pin:
    """A port of the logic, except clocks, reset and bus."""

    name: str  # without the suffix of the port
    is_input: bool
    width: int
    per: str | None  # "axis": one bit per axis, axis 1 is bit 0; "irq": one bit per interrupt line
    active_low: bool
    idle: int  # 0 or 1: level of each bit in the idle state
    pull: str | None  # "up" or "down": pull resistor at the pad of an input
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
        """False for interrupts: they go to the processor, which is on the same chip."""
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
        """Every block in the order of the crossbar ports: ascending base, blocks of only one variant last.

        A block therefore has the same port in every variant that has it.
        """
        return sorted(self.mappings, key=lambda m: m.variant is not None)

    def crossbar_of(self, variant: str) -> list[Mapping]:
        """The blocks of one variant of the logic in the order of the crossbar ports."""
        return [m for m in self.crossbar if m.variant in (None, variant)]

    def of(self, variant: str) -> list[Mapping]:
        """The blocks of one variant of the logic."""
        return [m for m in self.mappings if m.variant in (None, variant)]
