"""Names of registers and fields in the generated code, for the emitters and for the collision check."""

from model import Access, Field, Register


def camel(*parts: str) -> str:
    return "".join(word.capitalize() for part in parts for word in part.split("_"))


# Members of the structs. A net of the register file has the name of its member; a flop has the suffix `_q`.


def member(reg: Register, field: Field) -> str:
    """The value of a field; const fields have none."""
    return f"{reg.name}_{field.name}"


def event(reg: Register, field: Field) -> str:
    """The event that sets a w1c field."""
    return f"{member(reg, field)}_set"


def external(reg: Register, role: str) -> str:
    """`role`: we, re or rdata."""
    return f"{reg.name}_{role}"


def strobe(reg: Register) -> str:
    return f"{reg.name}_we"


def net(reg: Register, field: Field) -> str:
    """The net of the register file with the value."""
    return member(reg, field) + ("_q" if field.access.writable else "")


def members(reg: Register) -> list[str]:
    if reg.external:
        return [external(reg, role) for role in (*(("we",) if reg.writable else ()), "re", "rdata")]
    names = [strobe(reg)] if reg.strobe else []
    for field in reg.fields:
        if field.access is not Access.CONST:
            names.append(member(reg, field))
        if field.access is Access.W1C:
            names.append(event(reg, field))
    return names


def constants(reg: Register) -> list[str]:
    """Names without the k of C++: all constants of the package and of the header."""
    names = [camel(reg.name) + suffix for suffix in (("Offset", "Count", "Stride") if reg.is_array else ("Offset",))]
    for field in reg.fields:
        names += [camel(reg.name, field.name) + suffix for suffix in ("", "Lsb", "Width", "Mask", "Reset")]
    if reg.key is not None:
        names.append(camel(reg.name) + "Word")
    return names
