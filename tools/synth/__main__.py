"""Synthesises arm_soc for the XC7Z020 with Yosys and compares the resources with limits.toml.

Both variants of the logic are synthesised. For each block the table lists look-up tables, flip-flops, block RAMs
(36 kbit) and DSP slices, then the longest combinational path between two flip-flops of the whole design. Synthesis
keeps the block boundaries, which are all flip-flops, so the rows add up to the total. README.md has the same tables.
Exit code: 0 within the limits; 1 above a limit, the netlist is not valid, or the README is stale; 2 usage.
"""

from __future__ import annotations

import argparse
import json
import math
import re
import subprocess
import sys
import tempfile
import tomllib
from collections import Counter
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from pathlib import Path

from netlist import RESOURCES, Graph, cell_counts, resources
from netlist import Path as LogicPath

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tools"))
from generated import section, write_section  # noqa: E402
from rtl_list import rtl_sources  # noqa: E402

LIMITS = Path(__file__).resolve().parent / "limits.toml"
README = Path(__file__).resolve().parent / "README.md"
TOP = "arm_soc"
DEVICE = {"lut": 53_200, "ff": 106_400, "bram": 140, "dsp": 220}  # XC7Z020
VARIANTS = {"counts": 0, "paper": 1}  # PaperFabric
CLOCK_NS = 20.0
HEADROOM = 1.05  # ratio of a new limit to the measured value
HEADROOM_LEVELS = 2  # the mapper depends on the names of signals: a pure renaming changes the longest path this much

SCRIPT = """
read_verilog -sv -I{rtl}/common {sources}
chparam -set PaperFabric {paper} {top}
hierarchy -check -top {top}
{keep}
synth_xilinx -family xc7 -flatten -noiopad -noclkbuf -top {top}
check -assert
write_json {folder}/blocks.json
setattr -mod -unset keep_hierarchy *
flatten
write_json {folder}/flat.json
"""


class Failure(Exception):
    pass


@dataclass
class Result:
    blocks: dict[str, dict[str, float]]  # resources by block in order of rtl.f; TOP: the wiring between blocks
    total: dict[str, float]
    path: LogicPath


def block_names() -> list[str]:
    """Modules that arm_soc instantiates."""
    modules = {Path(source).stem for source in rtl_sources(ROOT)} - {TOP}
    text = (ROOT / "rtl/soc/arm_soc.sv").read_text()
    return [name for name in dict.fromkeys(re.findall(r"^ +(\w+) (?:#\(|u_)", text, re.MULTILINE)) if name in modules]


def synthesise(variant: str, folder: Path) -> Result:
    folder.mkdir(parents=True, exist_ok=True)
    blocks = block_names()
    # Yosys names a module with parameters $paramod...\name or $paramod\name\parameters.
    keep = "\n".join(f"setattr -mod -set keep_hierarchy 1 {name} *\\{name} *\\{name}\\*" for name in blocks)
    script = folder / "synth.ys"
    sources = " ".join(f"{ROOT}/rtl/{source}" for source in rtl_sources(ROOT))
    script.write_text(
        SCRIPT.format(rtl=ROOT / "rtl", sources=sources, paper=VARIANTS[variant], keep=keep, top=TOP, folder=folder)
    )
    run = subprocess.run(
        ["yosys", "-q", "-e", "implicitly declared", "-l", str(folder / "yosys.log"), str(script)],
        capture_output=True,
        text=True,
        check=False,
    )
    if run.returncode:
        raise Failure(f"{variant}: yosys: exit code {run.returncode}\n{(run.stdout + run.stderr)[-2000:]}")

    # The netlist also contains the cell library as black boxes. Synthesised modules are not black boxes.
    modules = {
        name: module
        for name, module in json.loads((folder / "blocks.json").read_text())["modules"].items()
        if "blackbox" not in module["attributes"] and "whitebox" not in module["attributes"]
    }
    by_block = {}
    for name, module in modules.items():
        plain = re.sub(r"^\$paramod(?:\$[0-9a-f]+)?\\", "", name).split("\\")[0]
        if plain in by_block:
            raise Failure(f"{variant}: two variants of module {plain}")
        by_block[plain] = cell_counts(module, set(modules))
    order = [name for name in [*blocks, TOP] if name in by_block]
    if set(order) != set(by_block):
        raise Failure(f"{variant}: not blocks of {TOP}: {set(by_block) - set(order)}")
    flat = json.loads((folder / "flat.json").read_text())["modules"][TOP]
    total = sum(by_block.values(), Counter())
    of_flat = cell_counts(flat, set())
    if any(total[kind] != count for kind, count in of_flat.items() if kind != "INV"):
        raise Failure(f"{variant}: the sum of the blocks is not the total")
    return Result({name: resources(by_block[name]) for name in order}, resources(total), Graph(flat).longest())


def number(value: float) -> str:
    return f"{value:g}"


def table(variant: str, result: Result) -> list[str]:
    """The table in Markdown."""
    rows = [("", "LUT", "FF", "BRAM", "DSP")]
    for name, used in [*result.blocks.items(), ("total", result.total)]:
        if not any(used.values()):
            continue  # wiring
        rows.append((f"{variant}: {name}" if name == "total" else name, *(number(used[kind]) for kind in RESOURCES)))
    rows.append(("of the XC7Z020", *(f"{100 * result.total[kind] / DEVICE[kind]:.1f} %" for kind in RESOURCES)))
    widths = [max(len(row[column]) for row in rows) for column in range(len(rows[0]))]
    lines = []
    for name, *cells in rows:
        numbers = [cell.rjust(width) for cell, width in zip(cells, widths[1:])]
        lines.append(f"| {name.ljust(widths[0])} | {' | '.join(numbers)} |")
    lines.insert(1, f"|{'-' * (widths[0] + 2)}|{'|'.join('-' * (width + 1) + ':' for width in widths[1:])}|")
    path = result.path
    return [
        *lines,
        "",
        f"Longest path: {path.levels} levels of logic, about {path.delay_ns:.0f} ns of the "
        f"{CLOCK_NS:g} ns of a clock, from `{path.cells[0][1]}` to `{path.cells[-1][1]}`.",
    ]


def readme_text(variant: str, result: Result) -> str:
    """The section of README.md."""
    return "\n".join(table(variant, result)) + "\n"


def stale(variant: str, result: Result, readme: Path = README) -> list[str]:
    if section(readme, variant) == readme_text(variant, result):
        return []
    return [f"{variant}: the table in tools/synth/README.md is stale (run `python3 tools/synth --write`)"]


def measured(result: Result) -> dict[str, dict[str, float]]:
    """The result in the format of the limits."""
    return {**result.blocks, "total": {**result.total, "levels": result.path.levels}}


def above(variant: str, result: Result, limits: dict) -> list[str]:
    """Values above their limit, values without a limit, and limits without a value."""
    found = []
    values = measured(result)
    for name in values.keys() | limits.keys():
        if name not in values or name not in limits:
            found.append(f"{variant}.{name}: {'unknown block' if name in limits else 'no limits'}")
            continue
        for kind in values[name].keys() | limits[name].keys():
            value, limit = values[name].get(kind), limits[name].get(kind)
            if value is None or limit is None or value > limit:
                found.append(f"{variant}.{name}.{kind}: {value} above the limit {limit}")
    found += [
        f"{variant}: {value:g} {kind} do not fit the XC7Z020"
        for kind, value in result.total.items()
        if value > DEVICE[kind]
    ]
    return sorted(found)


def limit_of(kind: str, value: float) -> float:
    """The limit that is set for a measured value."""
    if kind == "levels":
        return value + HEADROOM_LEVELS
    return value if kind in ("bram", "dsp") else math.ceil(value * HEADROOM)


def limits_text(results: dict[str, Result]) -> str:
    lines = [
        "# Limits of tools/synth per variant and block: 5 % above the values measured when they were last set, 2 levels above.",
        "# `python3 tools/synth --set-limits` writes this file. The commit of a higher limit must give the reason.",
    ]
    for variant, result in results.items():
        lines += ["", f"[{variant}]"]
        for name, values in measured(result).items():
            cells = [f"{kind} = {limit_of(kind, value):g}" for kind, value in values.items()]
            lines.append(f"{name} = {{ {', '.join(cells)} }}")
    return "\n".join(lines) + "\n"


def main() -> int:
    parser = argparse.ArgumentParser(
        prog="synth", description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("variants", nargs="*", metavar="VARIANT", help=f"one of {', '.join(VARIANTS)}; default: all")
    parser.add_argument("--set-limits", action="store_true", help="write limits.toml from the measured values")
    parser.add_argument("--write", action="store_true", help="write the tables in README.md")
    parser.add_argument("--check", action="store_true", help="fail if a table in README.md is stale")
    parser.add_argument("--path", action="store_true", help="print every cell of the longest path")
    parser.add_argument("--keep", type=Path, help="folder for netlists and logs; by default they are deleted")
    args = parser.parse_args()
    if set(args.variants) - set(VARIANTS) or (args.set_limits and args.variants):
        parser.error(f"variants are {' and '.join(VARIANTS)}; --set-limits is for all of them")
    variants = args.variants or list(VARIANTS)
    with tempfile.TemporaryDirectory(prefix="synth.") as folder:
        keep = args.keep.resolve() if args.keep else Path(folder)
        try:
            with ThreadPoolExecutor() as pool:
                results = dict(zip(variants, pool.map(lambda name: synthesise(name, keep / name), variants)))
        except (Failure, ValueError) as failure:
            print(f"synth: {failure}", file=sys.stderr)
            return 1
    if args.set_limits:
        LIMITS.write_text(limits_text(results))
    limits = tomllib.loads(LIMITS.read_text())
    found = []
    for variant, result in results.items():
        print("\n".join(table(variant, result)), end="\n\n")
        if args.write:
            write_section(README, variant, readme_text(variant, result))
        if args.check:
            found += stale(variant, result)
        if args.path:
            print("\n".join(f"  {kind:7} {net}" for kind, net in result.path.cells), end="\n\n")
        found += above(variant, result, limits.get(variant, {}))
    for line in found:
        print(f"synth: {line}", file=sys.stderr)
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
