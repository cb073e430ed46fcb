"""The gates of the RTL, whose passes are recorded by content.

tests/passes.txt has a line for each gate that has passed: its name, a SHA-256 of everything that it reads, and a
SHA-256 of the versions of its tools. While both are those of the checkout and the machine, the gate would give the
same result again, so tools/test leaves it out. It runs every other gate, and writes the line of each that passes.
tools/test --all runs every gate and writes nothing: it fails if a gate fails or if the line of a gate is not that of
its sources. A record that other versions of the tools made is not wrong, it only does not count.

CMake writes a description of each gate into the folder `gates` of the build (tests/recorded.cmake), with lines such as
  include PATH    a C++ source, with every file of this project that it includes
  input PATH      any other file
  package NAME    a Debian package: its version is a part of the second digest
  target NAME     a program that the gate needs
Those of the proofs come from tools/formal.
"""

from __future__ import annotations

import hashlib
import subprocess
import sys
from collections.abc import Callable, Iterable
from dataclasses import dataclass, field
from functools import cache
from pathlib import Path

from session import ROOT

sys.path.insert(0, str(ROOT / "tools"))
from cpp_includes import include_closure, included  # noqa: E402

RECORDS = ROOT / "tests" / "passes.txt"
HEAD = """\
# The gates that have passed, each with a digest of what it reads and one of the versions of its tools (tools/gates).
# tools/test writes this file. Commit it with the change that made it write.
"""
PROOF_PACKAGES = ("berkeley-abc", "python3.11", "yosys")


class GateError(Exception):
    """A description of a gate names a file or a package that does not exist."""


@dataclass(frozen=True)
class Gate:
    name: str
    sources: str  # digest
    tools: str  # digest
    targets: tuple[str, ...] = ()
    files: frozenset[Path] = field(default=frozenset(), compare=False)  # that it reads; of a proof, none are listed


def _digest(lines: list[str]) -> str:
    return hashlib.sha256("\n".join(lines).encode()).hexdigest()


@cache
def file_digest(path: Path) -> str:
    return hashlib.sha256(path.read_bytes()).hexdigest()


@cache
def _version(package: str) -> str:
    run = subprocess.run(["dpkg-query", "-W", "-f=${Version}", package], capture_output=True, text=True)
    if run.returncode:
        raise GateError(f"package {package}: {run.stderr.strip()}")
    return run.stdout


def _tools_digest(packages: Iterable[str]) -> str:
    return _digest([f"{package} {_version(package)}" for package in sorted(packages)])


def _relative(path: Path, root: Path) -> str:
    return str(path.relative_to(root)) if path.is_relative_to(root) else path.name


def read_gate(description: Path, root: Path = ROOT) -> Gate:
    """The gate of a description as its files are now."""
    words = [line.split(maxsplit=1) for line in description.read_text().splitlines() if line]
    of_kind = {kind: [Path(value) for key, value in words if key == kind] for kind in ("include", "input")}
    try:
        files = include_closure({path.resolve() for path in of_kind["include"]})
        files |= {path.resolve() for path in of_kind["input"]}
        digests = sorted(f"{_relative(path, root)} {file_digest(path)}" for path in files)
    except OSError as error:
        raise GateError(f"{description.name}: {error.filename}: {error.strerror}") from None
    packages = {value for key, value in words if key == "package"}
    if not files:
        raise GateError(f"{description}: reads nothing")
    return Gate(
        description.stem,
        _digest(digests),
        _tools_digest(packages),
        tuple(value for key, value in words if key == "target"),
        frozenset(files),
    )


def proofs() -> list[Gate]:
    listed = subprocess.run(
        [sys.executable, "-B", str(ROOT / "tools/formal"), "--digests"], check=True, stdout=subprocess.PIPE, text=True
    )
    tools = _tools_digest(PROOF_PACKAGES)
    return [Gate(f"formal.{name}", digest, tools) for name, digest in map(str.split, listed.stdout.splitlines())]


def _descriptions(build: Path) -> list[Path]:
    return sorted((build / "gates").glob("*.gate"))


def all_gates(build: Path) -> list[Gate]:
    return sorted([*map(read_gate, _descriptions(build)), *proofs()], key=lambda gate: gate.name)


def targets(build: Path) -> list[str]:
    """The programs of all gates."""
    lines = [line for path in _descriptions(build) for line in path.read_text().splitlines()]
    return sorted({line.removeprefix("target ") for line in lines if line.startswith("target ")})


def read_records(path: Path = RECORDS) -> dict[str, tuple[str, str]]:
    """Digests of sources and of tools, by gate. A line that is not a record counts as no record."""
    if not path.is_file():
        return {}
    rows = [line.split() for line in path.read_text().splitlines() if not line.startswith("#")]
    return {row[0]: (row[1], row[2]) for row in rows if len(row) == 3}


def write_records(records: dict[str, tuple[str, str]], path: Path = RECORDS):
    lines = [f"{name} {sources} {tools}\n" for name, (sources, tools) in sorted(records.items())]
    path.write_text(HEAD + "".join(lines))


def not_recorded(gates: list[Gate], records: dict[str, tuple[str, str]]) -> list[Gate]:
    """The gates that have to run."""
    return [gate for gate in gates if records.get(gate.name) != (gate.sources, gate.tools)]


def unmatched(gates: list[Gate], run: list[Gate], tests: dict[str, set[str]]) -> list[str]:
    """A line for each gate of `run` without a test, and for each label of a test that names no gate. A program that is
    not built has no tests yet."""
    without = sorted({gate.name for gate in run} - tests.keys())
    unknown = sorted(tests.keys() - {gate.name for gate in gates})
    lines = [f"{name}: is described as a recorded gate, but has no test" for name in without]
    return lines + [f"{name}: is the label of a test, but is not described" for name in unknown]


def undescribed(gates: list[Gate], files_of: Callable[[tuple[str, ...]], set[Path]]) -> dict[str, str]:
    """By gate, a line with the files that its programs were made of and that its description does not name: a change of
    one would not make the gate run. `files_of`: of programs that are built."""
    missing = {gate.name: sorted(map(str, files_of(gate.targets) - gate.files)) for gate in gates if gate.targets}
    return {
        name: f"{name}: its description does not name {', '.join(files)}" for name, files in missing.items() if files
    }


def changed_since(gates: list[Gate], build: Path) -> set[str]:
    """The names of the gates whose files are no longer those of `gates`: somebody edited them during the run."""
    file_digest.cache_clear()
    included.cache_clear()
    return {gate.name for gate in {*gates} - {*all_gates(build)}}


def passed(gates: list[Gate], tests: dict[str, set[str]], run: set[str], failed: set[str]) -> list[Gate]:
    """The gates that have tests, all of which ran and passed."""
    return [gate for gate in gates if (own := tests.get(gate.name)) and own <= run and not own & failed]


def renewed(
    records: dict[str, tuple[str, str]], gates: list[Gate], run: list[Gate], passes: list[Gate]
) -> dict[str, tuple[str, str]]:
    """The records after `run`, of which `passes` passed. Gates that no longer exist, and that failed, have none."""
    names = {gate.name for gate in gates} - {gate.name for gate in run}
    kept = {name: digests for name, digests in records.items() if name in names}
    return kept | {gate.name: (gate.sources, gate.tools) for gate in passes}


def wrong_records(records: dict[str, tuple[str, str]], gates: list[Gate], passes: list[Gate]) -> list[str]:
    """A line for each record that does not agree with a run of every gate."""
    passing = {gate.name for gate in passes}
    lines = [f"{name}: has a record, but is no gate" for name in sorted(records.keys() - {gate.name for gate in gates})]
    for gate in gates:
        if gate.name not in records:
            lines.append(f"{gate.name}: has no record")
        elif records[gate.name][0] != gate.sources:
            lines.append(f"{gate.name}: the record is not that of its sources")
        elif gate.name not in passing:
            lines.append(f"{gate.name}: has a record of a pass, but does not pass")
    return lines
