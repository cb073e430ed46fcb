"""One table of a TOML file, key by key. Every message contains the file, the table and the key."""

from __future__ import annotations

import re
import tomllib
from pathlib import Path
from typing import NoReturn

NAME = re.compile(r"[a-z][a-z0-9]*(_[a-z0-9]+)*")


class MapError(Exception):
    """A register map or address map that breaks a rule."""


class Table:
    """One TOML table. It pops keys with a type check; check_empty() rejects keys that are left."""

    def __init__(self, where: str, values: dict):
        self.where = where
        self._values = dict(values)

    def fail(self, message: str) -> NoReturn:
        raise MapError(f"{self.where}: {message}")

    def pop(self, key: str, kind: type, default=None):
        """Without a default the key is required."""
        if key not in self._values:
            if default is None:
                self.fail(f"missing key `{key}`")
            return default
        return self._typed(key, kind)

    def pop_optional(self, key: str, kind: type):
        return self._typed(key, kind) if key in self._values else None

    def pop_tables(self, key: str) -> list[dict]:
        tables = self.pop(key, list)
        if not tables or not all(isinstance(values, dict) for values in tables):
            self.fail(f"`{key}` must be a list of tables with at least one element")
        return tables

    def pop_name(self) -> str:
        name = self.pop("name", str)
        if not NAME.fullmatch(name):
            self.fail(f"name `{name}` is not snake_case")
        return name

    def check_empty(self):
        if self._values:
            self.fail(f"unknown key `{next(iter(self._values))}`")

    def _typed(self, key: str, kind: type):
        value = self._values.pop(key)
        if type(value) is not kind:
            self.fail(f"`{key}` must be of type {kind.__name__}, is {value!r}")
        return value


def read(root: Path, path: Path) -> Table:
    where = path.relative_to(root).as_posix()
    try:
        return Table(where, tomllib.loads(path.read_text()))
    except FileNotFoundError:
        raise MapError(f"{where}: file not found") from None
    except tomllib.TOMLDecodeError as error:
        raise MapError(f"{where}: {error}") from None


def check_duplicates(table: Table, what: str, values: list[str]):
    seen = set()
    for value in values:
        if value in seen:
            table.fail(f"duplicate {what} `{value}`")
        seen.add(value)
