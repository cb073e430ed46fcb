"""The table of the tracking errors of an arm, as Markdown."""

import math

from runs import WAYS

HEAD = (
    "| controller | mean rms mm | largest rms mm | worst mm | rms is larger | worst is larger | switched off | lost | as on ARM |\n"
    "|---|---:|---:|---:|---:|---:|---:|---:|---:|\n"
)


def compared_targets(results):
    """Those whose part all controllers have followed to its end."""
    return [
        number
        for number, followed in enumerate(zip(*results.values()))
        if all(run.end == "released" and run.rms_mm is not None for run in followed)
    ]


def larger(own, base, value):
    """The share of the targets for which a value is larger than that of the baseline."""
    count = sum(getattr(a, value) > getattr(b, value) for a, b in zip(own, base))
    return f"{100 * count / len(own):.1f} %"


def row(way, results, compared):
    own, base = ([results[name][number] for number in compared] for name in (way, "baseline"))
    lost = sum(run.end != "released" for run in results[way])
    same = sum(a.sha256 == b.sha256 for a, b in zip(results["arm"], results["logic"])) if way == "logic" else ""
    if not compared:
        return [WAYS[way].title, *["-"] * 6, lost, same]
    figures = [
        f"{math.fsum(run.rms_mm for run in own) / len(own):.4f}",
        f"{max(run.rms_mm for run in own):.3f}",
        f"{max(run.worst_mm for run in own):.3f}",
    ]
    if way == "baseline":
        return [WAYS[way].title, *figures, "", "", "", lost, same]
    ticks = sum(run.corrected + run.uncorrected for run in own)
    off = 100 * sum(run.uncorrected for run in own) / max(ticks, 1)
    shares = [larger(own, base, "rms_mm"), larger(own, base, "worst_mm"), f"{off:.2f} %"]
    return [WAYS[way].title, *figures, *shares, lost, same]


def line(cells):
    return "| " + " | ".join(map(str, cells)) + " |\n"


def figures_text(arm, results, seed):
    """What depends on the seed only."""
    targets = len(results["baseline"])
    compared = compared_targets(results)
    return (
        f"**{arm.title}**, {targets} targets of seed {seed}, of which {len(compared)} are compared:\n\n"
        + HEAD
        + "".join(line(row(way, results, compared)) for way in WAYS)
    )


def speed_text(speed):
    per_core = speed.runs * speed.simulated_s / 3600 / (speed.processor_s / 60)
    return (
        f"{speed.runs} runs of {speed.simulated_s} s took {speed.processor_s / 60:.1f} min of processor time: "
        f"a minute of a core gives {per_core:.2f} simulated hours.\n"
    )
