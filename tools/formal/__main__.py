"""Proves the properties of tests/formal without a bound on time, and shows that each proof can fail.

A proof passes if every assertion is true in every reachable state, every REACH has a run that the solver found and the
AIGER replay confirmed, and each broken copy refutes the assertion that it names.
The time of a proof is processor time, with all programs that it starts. It does not depend on -j.
Exit code: 0 all proofs pass, 1 a proof fails, 2 usage.
"""

from __future__ import annotations

import argparse
import os
import sys
import tempfile
from collections import Counter
from concurrent.futures import ProcessPoolExecutor
from functools import partial
from pathlib import Path

from broken import refute
from digest import digest
from engine import Question, counterexample, counterexamples, decide
from proofs import FORMAL, ROOT, Proof, all_proofs
from synthesis import PROVED, REACHED, Design, Failure, synthesise
from trace import write_vcd

sys.path.insert(0, str(ROOT / "tools"))
from generated import write_section  # noqa: E402
from processor_time import processor_s  # noqa: E402

SYNTHESIS_S = 120
SOLVER_S = 60


def _design(proof: Proof, folder: Path, copies: dict[Path, Path] | None = None, only: set[str] | None = None) -> Design:
    """`copies`: files that replace sources. `only`: the assertions to keep; default: all."""
    folder.mkdir(parents=True, exist_ok=True)
    generated = []
    for name, text in proof.generated.items():
        (folder / name).write_text(text)
        generated.append(folder / name)
    cells = FORMAL / "formal_cells.sv"
    sources = [(copies or {}).get(path, path) for path in proof.sources]
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
        only,
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
        run = counterexample(design, Question(assertions), SOLVER_S)
        if not run:
            raise Failure("two methods disagree whether the assertions are true")
        name = design.properties[next(number for number in assertions if design.aiger.fails(run[-1], number))]
        vcd = folder / f"{name}.vcd"
        write_vcd(design, run, vcd)
        raise Failure(f"{name} fails in clock {len(run) - 1}, see {vcd}")
    runs = counterexamples(design, [Question([number]) for number in reaches], SOLVER_S)
    for number, run in zip(reaches, runs):
        if not run:
            raise Failure(f"{design.properties[number]}: not reachable, so the proof may be vacuous")
    alone = refute(proof, folder, partial(_design, proof), SOLVER_S)
    own = f" ({alone} in a design of its own)" if alone else ""
    return f"{len(assertions)} proved, {len(reaches)} reached, {len(proof.breaks)} broken copies refuted{own}"


def _report(folder: Path, proof: Proof) -> tuple[bool, float]:
    """Proves and prints. Runs in a process of its own, so that its processor time is that of the proof."""
    start = processor_s()
    try:
        text, good = _prove(proof, folder / proof.name), True
    except Failure as failure:
        text, good = str(failure), False
    seconds = processor_s() - start
    print(f"{'ok    ' if good else 'FAILED'}  {proof.name}: {text} ({seconds:.1f} s)", flush=True)
    return good, seconds


def _times_text(seconds: dict[str, float]) -> str:
    """The sentence of PROOFS.md: processor time by group of proofs, rounded to two digits."""
    groups = Counter()
    for name, time_s in seconds.items():
        groups[f"`{name.partition('.')[0]}.*`" if "." in name else "the others"] += time_s

    def rounded(time_s: float) -> str:
        return f"{float(f'{time_s:.2g}'):.0f} s"

    parts = ", ".join(f"{name} {rounded(time_s)}" for name, time_s in groups.items())
    return f"Processor time of all proofs on a PC: {rounded(sum(seconds.values()))} ({parts}).\n"


def main() -> int:
    parser = argparse.ArgumentParser(
        prog="formal", description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("names", nargs="*", help="proofs; default: all")
    parser.add_argument("--list", action="store_true", help="print the names of the proofs")
    parser.add_argument("--digests", action="store_true", help="print each proof with a digest of what it reads")
    parser.add_argument("--keep", type=Path, help="folder for designs and traces; by default they are deleted")
    parser.add_argument("-j", type=int, default=os.cpu_count(), help="number of proofs in parallel")
    parser.add_argument("--write", action="store_true", help="write the processor times in tests/formal/PROOFS.md")
    args = parser.parse_args()
    if args.write and args.names:
        parser.error("--write is for all proofs")

    proofs = all_proofs()
    if args.list:
        print("\n".join(proof.name for proof in proofs))
        return 0
    if args.digests:
        print("\n".join(f"{proof.name} {digest(proof)}" for proof in proofs))
        return 0
    unknown = set(args.names) - {proof.name for proof in proofs}
    if unknown:
        print(f"formal: unknown proof {', '.join(sorted(unknown))} (see --list)", file=sys.stderr)
        return 2
    chosen = [proof for proof in proofs if not args.names or proof.name in args.names]
    with tempfile.TemporaryDirectory(prefix="formal.") as folder:
        keep = args.keep.resolve() if args.keep else Path(folder)
        with ProcessPoolExecutor(max_workers=args.j) as pool:
            results = list(pool.map(partial(_report, keep), chosen))
    seconds = {proof.name: time_s for proof, (_, time_s) in zip(chosen, results)}
    print(f"{sum(seconds.values()):.0f} s of processor time")
    passed = all(good for good, _ in results)
    if args.write and passed:
        write_section(FORMAL / "PROOFS.md", "times", _times_text(seconds))
    return 0 if passed else 1


if __name__ == "__main__":
    sys.exit(main())
