"""Finds the module headers, statements, continuous assignments and instances of SystemVerilog text in the style of rtl/.

It reads the structure, not the meaning: enough to replace one of them by a choice between it and a mutated copy.
"""

from __future__ import annotations

import re
from dataclasses import dataclass, field

HEADER, STATEMENT, ASSIGN, INSTANCE = "module header", "statement", "continuous assignment", "instance"

# Compiler directives take the rest of their line; comments are no tokens.
_TOKEN = re.compile(
    r"""
    (?P<skip> \s+ | //[^\n]* | /\*.*?\*/ | `(?:include|ifdef|ifndef|elsif|else|endif|define|undef|default_nettype)\b[^\n]* )
  | (?P<token> "(?:\\.|[^"\\])*" | [`$]?\w+ | :: | . )""",
    re.VERBOSE | re.DOTALL,
)
_OPEN, _CLOSE = {"(": ")", "[": "]", "{": "}"}, {")", "]", "}"}
_WORD = re.compile(r"[A-Za-z_]\w*$")
_PROCESS = {"always_ff", "always_comb", "always_latch", "always", "initial", "final"}
_TYPES = {
    "logic",
    "bit",
    "reg",
    "int",
    "integer",
    "byte",
    "automatic",
    "static",
    "localparam",
    "genvar",
    "const",
    "var",
}
_NO_BEGIN = {"", "else", "end", "endcase", "endfunction", "endgenerate", "endmodule", "endpackage", "endtask"}


class SyntaxProblem(Exception):
    """Text that this reader does not understand."""


@dataclass
class Site:
    kind: str
    start: int  # offsets into the text
    end: int
    # Of an instance: where its connections begin, and the expression of each port.
    opening: int = 0
    connections: dict[str, tuple[int, int]] = field(default_factory=dict)


class _Reader:
    def __init__(self, text: str):
        self.text = text
        self.tokens = [
            (match["token"], match.start(), match.end()) for match in _TOKEN.finditer(text) if match["token"]
        ]
        self.at = 0
        self.sites: list[Site] = []

    def peek(self, ahead: int = 0) -> str:
        return self.tokens[self.at + ahead][0] if self.at + ahead < len(self.tokens) else ""

    def take(self, expected: str | None = None) -> str:
        token = self.peek()
        if not token or (expected and token != expected):
            line = self.text.count("\n", 0, self.tokens[min(self.at, len(self.tokens) - 1)][1]) + 1
            raise SyntaxProblem(f"line {line}: `{token}`" + (f" for `{expected}`" if expected else ""))
        self.at += 1
        return token

    def group(self):
        """Past the bracket that closes the one here."""
        depth = 0
        while True:
            token = self.take()
            depth += (token in _OPEN) - (token in _CLOSE)
            if depth == 0:
                return

    def until(self, stop: str):
        """Past `stop`, which is outside all brackets."""
        while self.peek() != stop:
            if self.peek() in _OPEN:
                self.group()
            else:
                self.take()
        self.take()

    def label(self):
        if self.peek() == ":":
            self.at += 2

    def site(self, kind: str, first: int, **values):
        self.sites.append(Site(kind, self.tokens[first][1], self.tokens[self.at - 1][2], **values))

    def items(self, end: str):
        """The items of a file, module or generate block, past `end`."""
        while self.peek() != end:
            self.item()
        if end:
            self.take()

    def item(self):
        first, token = self.at, self.peek()
        if token in _NO_BEGIN:
            self.take("an item")
        if token in ("module", "package"):
            self.until(";")
            if token == "module":
                self.site(HEADER, first)
            self.items(f"end{token}")
        elif token == "assign":
            self.until(";")
            self.site(ASSIGN, first)
        elif token in _PROCESS:
            self.take()
            if self.peek() == "@":
                self.take()
                self.group() if self.peek() == "(" else self.take()
            self.statement()
        elif token in ("function", "task"):
            self.until(";")
            while self.peek() != f"end{token}":
                self.statement()
            self.take()
        elif token == "generate":
            self.take()
            self.items("endgenerate")
        elif token == "begin":
            self.take()
            self.label()
            self.items("end")
            self.label()
        elif token in ("for", "if"):
            self.take()
            self.group()
            self.item()
            if token == "if" and self.peek() == "else":
                self.take()
                self.item()
        elif token.startswith("`"):
            self.macro()
        elif _WORD.match(token) and self.peek(1) == "#" or _WORD.match(self.peek(1)) and self.peek(2) == "(":
            self.instance()
        else:
            self.until(";")

    def macro(self):
        self.take()
        if self.peek() == "(":
            self.group()
        if self.peek() == ";":
            self.take()

    def instance(self):
        first = self.at
        self.take()
        if self.peek() == "#":
            self.take()
            self.group()
        self.take()
        opening = self.tokens[self.at][1]
        self.take("(")
        connections = {}
        while self.peek() != ")":
            self.take(".")
            _, start, end = self.tokens[self.at]
            name = self.take()
            if self.peek() == "(":
                start = self.tokens[self.at][2]
                self.group()
                end = self.tokens[self.at - 1][1]
            connections[name] = (start, end)
            if self.peek() == ",":
                self.take()
        self.take()
        self.take(";")
        self.site(INSTANCE, first, opening=opening, connections=connections)

    def statement(self):
        first, token = self.at, self.peek()
        if token in _NO_BEGIN:
            self.take("a statement")
        if token == ";":
            self.take()
            return
        if token.startswith("`"):
            self.macro()
            return
        if token in _TYPES or (
            _WORD.match(token)
            and _WORD.match(self.peek(1))
            and token not in ("unique", "unique0", "priority", "begin", "if", "case", "casez", "for")
        ):
            self.until(";")  # a declaration
            return
        if token in ("unique", "unique0", "priority"):
            self.take()
            token = self.peek()
        if token == "begin":
            self.take()
            self.label()
            while self.peek() != "end":
                self.statement()
            self.take()
            self.label()
        elif token == "if":
            self.take()
            self.group()
            self.statement()
            if self.peek() == "else":
                self.take()
                self.statement()
        elif token in ("case", "casez"):
            self.take()
            self.group()
            while self.peek() != "endcase":
                if self.peek() == "default":
                    self.take()
                    if self.peek() == ":":
                        self.take()
                else:
                    self.until(":")
                self.statement()
            self.take()
        elif token == "for":
            self.take()
            self.group()
            self.statement()
        else:
            self.until(";")
        self.site(STATEMENT, first)


def sites(text: str) -> list[Site]:
    """All of them, those inside others included. SyntaxProblem if the text is not in the style of rtl/."""
    reader = _Reader(text)
    reader.items("")
    return reader.sites


def tokens_within(text: str, start: int, end: int) -> tuple[int, int] | None:
    """The part of text[start:end] without comments and spaces at its ends; None: there is nothing else."""
    inside = [(first, last) for _, first, last in _Reader(text).tokens if first < end and last > start]
    return (max(start, inside[0][0]), min(end, inside[-1][1])) if inside else None
