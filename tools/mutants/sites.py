"""Finds module headers, statements, continuous assignments and instances in SystemVerilog text in the style of rtl/.

It parses only the structure, which is enough to replace a site by a choice between the original and a mutated copy.
"""

from __future__ import annotations

import re
from dataclasses import dataclass, field

HEADER, STATEMENT, ASSIGN, INSTANCE = "module header", "statement", "continuous assignment", "instance"

# A compiler directive extends to the end of its line. Comments are not tokens.
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
    """The text is not in the supported subset of SystemVerilog."""


@dataclass
class Site:
    kind: str
    start: int  # offsets into the text
    end: int
    # Instances only: offset of the connections, and the range of the expression of each port.
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

    def accept(self, expected: str | None = None) -> str:
        token = self.peek()
        if not token or (expected and token != expected):
            line = self.text.count("\n", 0, self.tokens[min(self.at, len(self.tokens) - 1)][1]) + 1
            raise SyntaxProblem(f"line {line}: `{token}`" + (f" for `{expected}`" if expected else ""))
        self.at += 1
        return token

    def group(self):
        """Skips a bracketed group."""
        depth = 0
        while True:
            token = self.accept()
            depth += (token in _OPEN) - (token in _CLOSE)
            if depth == 0:
                return

    def until(self, stop: str):
        """Skips all tokens up to and including `stop`, ignoring `stop` inside brackets."""
        while self.peek() != stop:
            if self.peek() in _OPEN:
                self.group()
            else:
                self.accept()
        self.accept()

    def label(self):
        if self.peek() == ":":
            self.at += 2

    def site(self, kind: str, first: int, **values):
        self.sites.append(Site(kind, self.tokens[first][1], self.tokens[self.at - 1][2], **values))

    def items(self, end: str):
        """Parses the items of a file, module or generate block, up to and including `end`."""
        while self.peek() != end:
            self.item()
        if end:
            self.accept()

    def item(self):
        first, token = self.at, self.peek()
        if token in _NO_BEGIN:
            self.accept("an item")
        if token in ("module", "package"):
            self.until(";")
            if token == "module":
                self.site(HEADER, first)
            self.items(f"end{token}")
        elif token == "assign":
            self.until(";")
            self.site(ASSIGN, first)
        elif token in _PROCESS:
            self.accept()
            if self.peek() == "@":
                self.accept()
                self.group() if self.peek() == "(" else self.accept()
            self.statement()
        elif token in ("function", "task"):
            self.until(";")
            while self.peek() != f"end{token}":
                self.statement()
            self.accept()
        elif token == "generate":
            self.accept()
            self.items("endgenerate")
        elif token == "begin":
            self.accept()
            self.label()
            self.items("end")
            self.label()
        elif token in ("for", "if"):
            self.accept()
            self.group()
            self.item()
            if token == "if" and self.peek() == "else":
                self.accept()
                self.item()
        elif token.startswith("`"):
            self.macro()
        elif _WORD.match(token) and self.peek(1) == "#" or _WORD.match(self.peek(1)) and self.peek(2) == "(":
            self.instance()
        else:
            self.until(";")

    def macro(self):
        self.accept()
        if self.peek() == "(":
            self.group()
        if self.peek() == ";":
            self.accept()

    def instance(self):
        first = self.at
        self.accept()
        if self.peek() == "#":
            self.accept()
            self.group()
        self.accept()
        opening = self.tokens[self.at][1]
        self.accept("(")
        connections = {}
        while self.peek() != ")":
            self.accept(".")
            _, start, end = self.tokens[self.at]
            name = self.accept()
            if self.peek() == "(":
                start = self.tokens[self.at][2]
                self.group()
                end = self.tokens[self.at - 1][1]
            connections[name] = (start, end)
            if self.peek() == ",":
                self.accept()
        self.accept()
        self.accept(";")
        self.site(INSTANCE, first, opening=opening, connections=connections)

    def statement(self):
        first, token = self.at, self.peek()
        if token in _NO_BEGIN:
            self.accept("a statement")
        if token == ";":
            self.accept()
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
            self.accept()
            token = self.peek()
        if token == "begin":
            self.accept()
            self.label()
            while self.peek() != "end":
                self.statement()
            self.accept()
            self.label()
        elif token == "if":
            self.accept()
            self.group()
            self.statement()
            if self.peek() == "else":
                self.accept()
                self.statement()
        elif token in ("case", "casez"):
            self.accept()
            self.group()
            while self.peek() != "endcase":
                if self.peek() == "default":
                    self.accept()
                    if self.peek() == ":":
                        self.accept()
                else:
                    self.until(":")
                self.statement()
            self.accept()
        elif token == "for":
            self.accept()
            self.group()
            self.statement()
        else:
            self.until(";")
        self.site(STATEMENT, first)


def sites(text: str) -> list[Site]:
    """All sites, including those inside others. SyntaxProblem: the text is not in the style of rtl/."""
    reader = _Reader(text)
    reader.items("")
    return reader.sites


def tokens_within(text: str, start: int, end: int) -> tuple[int, int] | None:
    """text[start:end] without comments and spaces at its ends; None: it contains nothing else."""
    inside = [(first, last) for _, first, last in _Reader(text).tokens if first < end and last > start]
    return (max(start, inside[0][0]), min(end, inside[-1][1])) if inside else None
