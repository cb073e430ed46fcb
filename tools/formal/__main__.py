"""Proves the properties of tests/formal without a bound on time, and shows that each proof can fail.

A proof passes if every assertion is true in every reachable state, every REACH has a run that the solver found and the
AIGER replay confirmed, and each broken copy refutes the assertion that it names.
Exit code: 0 all proofs pass, 1 a proof fails, 2 usage.
"""

from __future__ import annotations

import argparse
import os
import sys
import tempfile
import time
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

from engine import PROVED, REACHED, Design, Failure, counterexample, decide, synthesise
from proofs import FORMAL, RTL, Break, Proof, all_proofs
from trace import write_vcd

SYNTHESIS_S = 120
SOLVER_S = 60


def _design(proof: Proof, folder: Path, broken: Break | None = None) -> Design:
    folder.mkdir(parents=True, exist_ok=True)
    generated = []
    for name, text in proof.generated.items():
        (folder / name).write_text(text)
        generated.append(folder / name)
    cells = FORMAL / "formal_cells.sv"
    sources = [*proof.sources]
    if broken:
        if broken.file not in sources:
            raise Failure(f"broken copy {broken.name}: the proof does not read {broken.file.name}")
        text = broken.file.read_text()
        if text.count(broken.old) != 1:
            raise Failure(
                f"broken copy {broken.name}: {text.count(broken.old)} matches in {broken.file.name}: {broken.old}"
            )
        copy = folder / broken.file.name
        copy.write_text(text.replace(broken.old, broken.new))
        sources[sources.index(broken.file)] = copy
    stubs = [path for path in generated if path.name.endswith("_stub.sv")]
    packages = [path for path in sources if path.name.endswith("_pkg.sv")]
    rest = [path for path in sources if path not in packages]
    tops = [path for path in generated if path not in stubs]
    return synthesise(
        folder,
        [*([FORMAL] if proof.assertions else []), *proof.headers],
        # The file that is read first decides which assert.svh all see.
        [cells, *packages, *stubs, *rest, *tops] if proof.assertions else [*packages, *stubs, *rest, *tops, cells],
        proof.top,
        SYNTHESIS_S,
        broken.refuted_by if broken else None,
        proof.rewrite,
    )


def _prove(proof: Proof, folder: Path) -> str:
    """Returns one line with the results. Failure: the proof does not pass."""
    design = _design(proof, folder / "healthy")
    assertions = design.numbers(PROVED)
    reaches = design.numbers(REACHED)
    if not assertions or not reaches or not proof.breaks:
        raise Failure(
            f"{len(assertions)} assertions, {len(reaches)} reaches, {len(proof.breaks)} broken copies: "
            "a proof needs at least one of each"
        )
    if not decide(design, assertions, SOLVER_S):
        for number in assertions:
            run = counterexample(design, [number], SOLVER_S)
            if run:
                vcd = folder / f"{design.properties[number]}.vcd"
                write_vcd(design, run, vcd)
                raise Failure(f"{design.properties[number]} fails in clock {len(run) - 1}, see {vcd}")
        raise Failure("the assertions fail together, but each of them passes alone")
    for number in reaches:
        if not counterexample(design, [number], SOLVER_S):
            raise Failure(f"{design.properties[number]}: not reachable, so the proof may be vacuous")
    for broken in proof.breaks:
        copy = _design(proof, folder / broken.name, broken)
        numbers = copy.matching(broken.refuted_by)
        if not numbers:
            raise Failure(f"broken copy {broken.name}: there is no assertion {broken.refuted_by}")
        if not counterexample(copy, numbers, SOLVER_S):
            raise Failure(f"broken copy {broken.name}: {broken.refuted_by} is true, expected to be refuted")
    return f"{len(assertions)} proved, {len(reaches)} reached, {len(proof.breaks)} broken copies refuted"


def _report(proof: Proof, folder: Path) -> bool:
    start = time.monotonic()
    try:
        text, good = _prove(proof, folder / proof.name), True
    except Failure as failure:
        text, good = str(failure), False
    print(f"{'ok    ' if good else 'FAILED'}  {proof.name}: {text} ({time.monotonic() - start:.1f} s)", flush=True)
    return good


def main() -> int:
    parser = argparse.ArgumentParser(
        prog="formal", description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("names", nargs="*", help="proofs; default: all")
    parser.add_argument("--list", action="store_true", help="print the names of the proofs")
    parser.add_argument("--keep", type=Path, help="folder for designs and traces; by default they are deleted")
    parser.add_argument("-j", type=int, default=os.cpu_count(), help="number of proofs in parallel")
    args = parser.parse_args()

    proofs = all_proofs()
    if args.list:
        print("\n".join(proof.name for proof in proofs))
        return 0
    unknown = set(args.names) - {proof.name for proof in proofs}
    if unknown:
        print(f"formal: unknown proof {', '.join(sorted(unknown))} (see --list)", file=sys.stderr)
        return 2
    chosen = [proof for proof in proofs if not args.names or proof.name in args.names]
    with tempfile.TemporaryDirectory(prefix="formal.") as folder:
        keep = args.keep.resolve() if args.keep else Path(folder)
        with ThreadPoolExecutor(max_workers=args.j) as pool:
            results = list(pool.map(lambda proof: _report(proof, keep), chosen))
    return 0 if all(results) else 1


if __name__ == "__main__":
    sys.exit(main())
