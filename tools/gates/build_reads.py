"""The files of the project that the programs of a build were made of, as Ninja knows them after it has built them."""

from __future__ import annotations

import subprocess
from functools import cached_property
from pathlib import Path

from session import ROOT


class BuildReads:
    def __init__(self, build: Path, root: Path = ROOT):
        self.build, self.root = build, root.resolve()

    def files_of(self, targets: tuple[str, ...]) -> set[Path]:
        """Sources, headers that a compiler has read, and inputs of generators. Files of the build are not among them."""
        inputs = self._ninja("inputs", *targets)
        files = {self._path(name) for name in inputs}.union(*(self._headers.get(name, set()) for name in inputs))
        return {file for file in files if self._is_source(file)}

    def _ninja(self, tool: str, *arguments: str) -> list[str]:
        command = ["ninja", "-C", self.build, "--quiet", "-t", tool, *arguments]
        return subprocess.run(command, check=True, stdout=subprocess.PIPE, text=True).stdout.splitlines()

    def _path(self, name: str) -> Path:
        return (self.build / name).resolve()

    def _is_source(self, file: Path) -> bool:
        return file.is_relative_to(self.root) and not file.is_relative_to(self.build.resolve()) and file.is_file()

    @cached_property
    def _headers(self) -> dict[str, set[Path]]:
        """By object file. Ninja prints `OBJECT: #deps ...`, then a line for each file that begins with blanks."""
        headers: dict[str, set[Path]] = {}
        files: set[Path] = set()
        for line in self._ninja("deps"):
            if line.startswith(" "):
                files.add(self._path(line.strip()))
            elif line:
                files = headers.setdefault(line.partition(": #deps")[0], set())
        return headers
