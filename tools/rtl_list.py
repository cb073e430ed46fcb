"""Reads rtl/rtl.f for the tools that need the sources of arm_soc."""

from __future__ import annotations

from pathlib import Path


def rtl_sources(root: Path) -> list[str]:
    """Every source in its order, packages first; paths relative to `root`/rtl."""
    lines = (root / "rtl/rtl.f").read_text().splitlines()
    return [line for line in lines if line.endswith(".sv") and not line.startswith("//")]
