"""How a register and its fields are called in the generated code. Used by the emitters and by the collision check."""

from model import Access, Field, Register


def camel(*parts: str) -> str:
    return "".join(word.capitalize() for part in parts for word in part.split("_"))


def port(reg: Register, field: Field) -> str:
    """The port that carries the value of a field; const fields have none."""
    return f"{reg.name}_{field.name}_{'i' if field.access is Access.RO else 'o'}"


def set_port(reg: Register, field: Field) -> str:
    return f"{reg.name}_{field.name}_set_i"


def external_port(reg: Register, role: str) -> str:
    """Role: we_o wdata_o wstrb_o re_o rdata_i."""
    return f"{reg.name}_{role}"


def strobe_port(reg: Register) -> str:
    return f"{reg.name}_we_o"


def ports(reg: Register) -> list[str]:
    if reg.external:
        roles = ("we_o", "wdata_o", "wstrb_o") if reg.writable else ()
        return [external_port(reg, role) for role in (*roles, "re_o", "rdata_i")]
    names = [strobe_port(reg)] if reg.strobe else []
    for field in reg.fields:
        if field.access is not Access.CONST:
            names.append(port(reg, field))
        if field.access is Access.W1C:
            names.append(set_port(reg, field))
    return names


def constants(reg: Register) -> list[str]:
    """Without the k of C++; the union of what both packages and headers define."""
    names = [camel(reg.name) + suffix for suffix in (("Offset", "Count", "Stride") if reg.is_array else ("Offset",))]
    for field in reg.fields:
        names += [camel(reg.name, field.name) + suffix for suffix in ("", "Lsb", "Width", "Mask", "Reset")]
    return names
