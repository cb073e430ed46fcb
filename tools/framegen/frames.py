"""The content of controller/pendant/frames.toml: kinds, statuses, states, opcodes and pages, and the rules for them."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

from table import NAME, Table, check_duplicates, read

SOURCE = "controller/pendant/frames.toml"
PAYLOAD_BITS = 27  # without the sign
LARGEST = (1 << PAYLOAD_BITS) - 1  # of a payload: its highest byte is never 0xEE, the byte of the emergency stop
ANY = "any"


@dataclass(frozen=True)
class Kind:
    name: str
    nibble: int
    sender: str
    desc: str


@dataclass(frozen=True)
class Status:
    name: str
    code: int
    desc: str
    detail: str


@dataclass(frozen=True)
class State:
    name: str
    refusal: str
    desc: str


@dataclass(frozen=True)
class Range:
    low: int
    high: int
    unit: str
    desc: str


@dataclass(frozen=True)
class Value:
    """One of the numbers that a parameter may have."""

    name: str
    desc: str


@dataclass(frozen=True)
class Opcode:
    name: str
    code: int
    desc: str
    enumeration: str  # name of the values
    values: tuple[Value, ...]  # of the parameter, from 0 on; none: any number of the range
    parameter: Range
    payload: Range
    reply: str
    states: tuple[str, ...]
    extended: tuple[str, ...]
    reply_only: bool


@dataclass(frozen=True)
class Field:
    """Bits of the value of a page, from `shift` on."""

    name: str
    shift: int
    bits: int
    desc: str
    values: tuple[Value, ...]  # from 0 on; none: any number


@dataclass(frozen=True)
class Page:
    name: str
    first: int
    last: int
    group: int
    value: str
    desc: str
    fields: tuple[Field, ...]
    names: tuple[str, ...]


@dataclass(frozen=True)
class Frames:
    kinds: list[Kind]
    statuses: list[Status]
    states: list[State]
    opcodes: list[Opcode]
    pages: list[Page]


def load(root: Path) -> Frames:
    """Reads and checks the description. Raises MapError."""
    table = read(root, root / SOURCE)

    def entries(key: str, make):
        made = []
        for number, values in enumerate(table.pop_tables(key), 1):
            label = values.get("name", number)
            entry = Table(f"{table.where} [[{key}]] {label}", values)
            made.append(make(entry))
            entry.check_empty()
        check_duplicates(table, f"name in [[{key}]]", [item.name for item in made])
        return made

    kinds = entries("kind", _kind)
    statuses = entries("status", _status)
    names = [status.name for status in statuses]
    states = entries("state", lambda entry: _state(entry, names))
    state_names = [state.name for state in states]
    opcodes = entries("opcode", lambda entry: _opcode(entry, state_names))
    pages = entries("page", _page)
    table.check_empty()
    check_duplicates(table, "nibble", [f"0x{kind.nibble:X}" for kind in kinds])
    check_duplicates(table, "code of a status", [str(status.code) for status in statuses])
    check_duplicates(table, "code of an opcode", [f"0x{opcode.code:02X}" for opcode in opcodes])
    check_duplicates(table, "page", [str(number) for page in pages for number in range(page.first, page.last + 1)])
    check_duplicates(table, "`parameter_name`", [opcode.enumeration for opcode in opcodes if opcode.values])
    groups = 0
    for page in pages:
        groups |= page.group
    for opcode in opcodes:
        if opcode.name == "set_telemetry" and opcode.parameter.high != groups:
            table.fail(f"the parameter of set_telemetry has `max = {opcode.parameter.high}`, all groups are {groups}")
    return Frames(kinds, statuses, states, opcodes, pages)


def _number(entry: Table, key: str, low: int, high: int, default: int | None = None) -> int:
    value = entry.pop(key, int, default)
    if not low <= value <= high:
        entry.fail(f"`{key}` must be {low} .. {high}, is {value}")
    return value


def _kind(entry: Table) -> Kind:
    kind = Kind(entry.pop_name(), _number(entry, "nibble", 0, 15), entry.pop("from", str), entry.pop("desc", str))
    if kind.sender not in ("pendant", "controller"):
        entry.fail(f'`from` must be "pendant" or "controller", is "{kind.sender}"')
    # The emergency stop is a run of 0xEE, so no frame may begin with that byte.
    if kind.nibble == 0xE:
        entry.fail("`nibble` must not be 0xE: a frame could begin with the byte of the emergency stop")
    return kind


def _status(entry: Table) -> Status:
    name, code = entry.pop_name(), _number(entry, "code", 0, 127)
    return Status(name, code, entry.pop("desc", str), entry.pop("detail", str, ""))


def _state(entry: Table, statuses: list[str]) -> State:
    state = State(entry.pop_name(), entry.pop("refusal", str), entry.pop("desc", str))
    if state.refusal not in statuses:
        entry.fail(f"`refusal` names no status: {state.refusal}")
    return state


def _range(entry: Table, key: str, low: int, high: int) -> Range:
    values = entry.pop_optional(key, dict)
    if values is None:
        return Range(0, 0, "", "")
    inner = Table(f"{entry.where} {key}", values)
    least, most = _number(inner, "min", low, high, 0), _number(inner, "max", low, high)
    found = Range(least, most, inner.pop("unit", str, ""), inner.pop("desc", str))
    inner.check_empty()
    if least > most:
        inner.fail(f"`min` {least} is above `max` {most}")
    return found


def _values(entry: Table, key: str, what: str) -> tuple[Value, ...]:
    listed = entry.pop_optional(key, list) or []
    values = []
    for number, one in enumerate(listed):
        inner = Table(f"{entry.where} {what} {number}", one)
        values.append(Value(inner.pop_name(), inner.pop("desc", str)))
        inner.check_empty()
    check_duplicates(entry, f"name of a {what}", [value.name for value in values])
    return tuple(values)


def _listed(values: tuple[Value, ...]) -> str:
    return ", ".join(f"{number} {value.desc}" for number, value in enumerate(values))


def _enumeration(entry: Table) -> str:
    name = entry.pop("parameter_name", str)
    if not NAME.fullmatch(name):
        entry.fail(f"`parameter_name` `{name}` is not snake_case")
    return name


def _parameter(entry: Table, values: tuple[Value, ...]) -> Range:
    if not values:
        return _range(entry, "parameter", 0, 127)
    return Range(0, len(values) - 1, "", _listed(values))


def _states(entry: Table, key: str, names: list[str]) -> tuple[str, ...]:
    listed = entry.pop(key, list, [])
    if listed == [ANY]:
        return tuple(names)
    for name in listed:
        if name not in names:
            entry.fail(f"`{key}` names no state: {name}")
    return tuple(listed)


def _opcode(entry: Table, states: list[str]) -> Opcode:
    values = _values(entry, "parameter_values", "parameter")
    opcode = Opcode(
        enumeration=_enumeration(entry) if values else "",
        values=values,
        name=entry.pop_name(),
        code=_number(entry, "code", 1, 127),
        desc=entry.pop("desc", str),
        parameter=_parameter(entry, values),
        payload=_range(entry, "payload", -LARGEST, LARGEST),
        reply=entry.pop("reply", str, ""),
        states=_states(entry, "states", states),
        extended=_states(entry, "extended", states),
        reply_only=entry.pop("reply_only", bool, False),
    )
    if opcode.reply_only == bool(opcode.states or opcode.extended):
        entry.fail("a command has `states` or `extended`; what is `reply_only` has neither")
    for name in opcode.extended:
        if name in opcode.states:
            entry.fail(f"`extended` repeats a state: {name}")
    return opcode


def _field(entry: Table) -> Field:
    name, shift = entry.pop_name(), _number(entry, "shift", 0, PAYLOAD_BITS - 1)
    bits, desc = _number(entry, "bits", 1, PAYLOAD_BITS - shift, 1), entry.pop("desc", str)
    values = _values(entry, "values", "value")
    if len(values) > 1 << bits:
        entry.fail(f"`values` has {len(values)} values, `bits = {bits}` has room for {1 << bits}")
    entry.check_empty()
    return Field(name, shift, bits, f"{desc} ({_listed(values)})" if values else desc, values)


def _fields(entry: Table) -> tuple[Field, ...]:
    listed = entry.pop("fields", list, [])
    fields = tuple(_field(Table(f"{entry.where} field {number}", values)) for number, values in enumerate(listed, 1))
    check_duplicates(entry, "name of a field", [field.name for field in fields])
    check_duplicates(entry, "bit", [str(field.shift + i) for field in fields for i in range(field.bits)])
    return fields


def _page(entry: Table) -> Page:
    name, first = entry.pop_name(), _number(entry, "first", 0, 127)
    last, desc = _number(entry, "last", first, 127, first), entry.pop("desc", str)
    fields, names = _fields(entry), tuple(entry.pop("names", list, []))
    if fields:
        value = " + ".join(f"{1 << f.shift} * {f.desc}" if f.shift else f.desc for f in fields)
    elif names:
        value = ", ".join(f"{number} {text}" for number, text in enumerate(names))
    else:
        value = entry.pop("value", str)
    group = _number(entry, "group", 1, 127)
    if group & (group - 1):
        entry.fail(f"`group` must be a power of 2, is {group}")
    return Page(name, first, last, group, value, desc, fields, names)
