"""Lists of RTL sources: all of arm_soc (rtl/rtl.f), and the dependencies of one module for its tests and proofs.

As a program, `rtl_list.py FILE` writes FILE for CMake: rtl_closure_<module> lists the sources of each module of rtl/;
rtl_flat_<module> is the source of <module>_flat (flat_ports.py), written next to FILE, if <module> has struct ports.
"""

from __future__ import annotations

import re
import sys
from pathlib import Path

MODULE = re.compile(r"^(?:module|package)\s+(\w+)", re.MULTILINE)
COMMENT = re.compile(r"//[^\n]*")
# `name #(parameters) u_instance (`, and `name::` of a package.
_GROUP = r"\((?:[^()]|\((?:[^()]|\([^()]*\))*\))*\)"
_INSTANCE = re.compile(rf"^\s*(\w+)\s+(?:#\s*{_GROUP}\s*)?u_\w+\s*\(", re.MULTILINE)
_PACKAGE = re.compile(r"\b([a-zA-Z_]\w*)::")


class ListError(Exception):
    """A source uses a module that no source in rtl.f defines."""


def rtl_sources(root: Path) -> list[str]:
    """Every source in the order of rtl.f, packages first; paths are relative to `root`/rtl."""
    lines = (root / "rtl/rtl.f").read_text().splitlines()
    return [line for line in lines if line.endswith(".sv") and not line.startswith("//")]


def gated_clocks(root: Path) -> list[str]:
    """The gated clocks of arm_soc, in the order of the bits of its active_o."""
    return re.findall(r"^ *input +logic +(clk_\w+_i),", (root / "rtl/soc/arm_soc.sv").read_text(), re.MULTILINE)


class RtlTree:
    """The sources of rtl.f with the modules that each defines and uses."""

    def __init__(self, root: Path):
        self.paths = [root / "rtl" / source for source in rtl_sources(root)]
        self._text = {path: COMMENT.sub("", path.read_text()) for path in self.paths}
        self.owner = {name: path for path in self.paths for name in MODULE.findall(self._text[path])}
        self._uses = {path: set(re.findall(r"\w+", text)) & self.owner.keys() for path, text in self._text.items()}

    def closure(self, texts: list[str], skip: frozenset[str] = frozenset()) -> list[Path]:
        """The sources that `texts` use directly or indirectly, in the order of rtl.f, without the modules in `skip`."""
        used: set[Path] = set()
        pending = [name for text in texts for name in set(re.findall(r"\w+", COMMENT.sub("", text)))]
        while pending:
            name = pending.pop()
            if name in skip or name not in self.owner or self.owner[name] in used:
                continue
            used.add(self.owner[name])
            pending.extend(self._uses[self.owner[name]])
        return [path for path in self.paths if path in used]

    def closure_of(self, module: str) -> list[Path]:
        """The sources of one module of rtl/. ListError: one of them uses a module that rtl.f does not list."""
        sources = self.closure([module])
        for path in sources:
            text = self._text[path]
            missing = set(_INSTANCE.findall(text)) | set(_PACKAGE.findall(text))
            missing -= self.owner.keys()
            if missing:
                raise ListError(f"{path}: uses {', '.join(sorted(missing))}, which no source in rtl/rtl.f defines")
        return sources


def _write_cmake(tree: RtlTree, file: Path):
    from flat_ports import HEADERS, flat_module, has_struct_ports  # only CMake needs it

    lines = ["# Written by tools/rtl_list.py while configuring."]
    for module in tree.owner:
        sources = "\n  ".join(str(path) for path in tree.closure_of(module))
        lines.append(f"set(rtl_closure_{module}\n  {sources})")
        text = tree.owner[module].read_text()
        if tree.owner[module].name.endswith("_pkg.sv") or not has_struct_ports(text, [HEADERS]):
            continue
        flat = file.with_name(f"{module}_flat.sv")
        flat_text = flat_module(text, [HEADERS])
        if not flat.is_file() or flat.read_text() != flat_text:
            flat.write_text(flat_text)
        lines.append(f"set(rtl_flat_{module} {flat})")
    file.write_text("\n".join(lines) + "\n")


if __name__ == "__main__":
    try:
        _write_cmake(RtlTree(Path(__file__).resolve().parents[1]), Path(sys.argv[1]))
    except ListError as error:
        sys.exit(str(error))
