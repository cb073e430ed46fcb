"""One copy of an RTL file with many mutants in it: `mutant_number` selects one at run time, 0 is the original.

The smallest statement, continuous assignment or instance that contains the text of a mutant becomes a choice:

    statement    if (mutant_number == N) begin <mutated> end else begin <original> end
    assignment   always_comb if (mutant_number == N) begin <mutated> end else begin <original> end
    instance     .port_i(mutant_number == N ? (<mutated>) : (<original>)) for each connection that differs
"""

from __future__ import annotations

from dataclasses import dataclass, field

from catalogue import CatalogueError, Mutant
from sites import ASSIGN, HEADER, INSTANCE, STATEMENT, Site, SyntaxProblem, sites, tokens_within

# MUTANT is an environment variable; $c32 evaluates C++ in Verilator. Each module has its own variable, because one in a
# package would change the class of the model.
NUMBER = "mutant_number"
DECLARATION = (
    f"  logic [31:0] {NUMBER} = "
    '$c32("(std::getenv(\\"MUTANT\\") ? std::strtoul(std::getenv(\\"MUTANT\\"), nullptr, 10) : 0)");'
)


@dataclass
class _Choice:
    site: Site
    mutants: list[Mutant] = field(default_factory=list)
    inner: list[_Choice] = field(default_factory=list)


def _is(mutant: Mutant) -> str:
    return f"{NUMBER} == 32'd{mutant.number}"


def _are_statements(text: str) -> bool:
    """Whether the text is complete statements: no `end` or `else` in it belongs to a statement around it."""
    block = f"initial begin {text}\nend"
    try:
        return any(site.kind == STATEMENT and site.end == len(block) for site in sites(block))
    except SyntaxProblem:
        return False


def _assignment(text: str) -> str:
    return text.strip().removeprefix("assign").strip()


class _Weaver:
    def __init__(self, text: str, declaration: str):
        self.text = text
        self.declaration = declaration
        self.sites = sorted(sites(text), key=lambda site: site.end - site.start)

    def site_of(self, mutant: Mutant) -> Site:
        start = self.text.index(mutant.old)
        changed = tokens_within(self.text, start, start + len(mutant.old))
        if not changed:
            raise CatalogueError(f"mutant {mutant.name} changes a comment")
        for site in self.sites:
            if site.kind == HEADER or changed[0] < site.start or site.end < changed[1]:
                continue
            if site.kind != STATEMENT or _are_statements(self.mutated(site, mutant)):
                return site
        raise CatalogueError(
            f"mutant {mutant.name} changes a declaration, which cannot be chosen at run time: change "
            "a statement, an assignment or a connection that uses it instead"
        )

    def mutated(self, site: Site, mutant: Mutant) -> str:
        start = self.text.index(mutant.old)
        end = start + len(mutant.old)
        return self.text[site.start : max(start, site.start)] + mutant.new + self.text[min(end, site.end) : site.end]

    def render(self, start: int, end: int, choices: list[_Choice]) -> str:
        parts = []
        for choice in sorted(choices, key=lambda one: one.site.start):
            parts += [self.text[start : choice.site.start], self.choice(choice)]
            start = choice.site.end
        return "".join([*parts, self.text[start:end]])

    def choice(self, choice: _Choice) -> str:
        site = choice.site
        if site.kind == HEADER:
            return f"{self.text[site.start:site.end]}\n{self.declaration}"
        if site.kind == INSTANCE:
            return self.instance(choice)
        original = self.render(site.start, site.end, choice.inner)
        copies = [(mutant, self.mutated(site, mutant)) for mutant in choice.mutants]
        if site.kind == ASSIGN:
            for mutant, copy in copies:
                if [one.kind for one in sites(copy)] != [ASSIGN]:
                    raise CatalogueError(f"mutant {mutant.name} makes more than one assignment of a continuous one")
            original = _assignment(original)
            copies = [(mutant, _assignment(copy)) for mutant, copy in copies]
        chosen = "".join(f"if ({_is(mutant)}) begin\n{copy}\nend else " for mutant, copy in copies)
        return f"{'always_comb ' if site.kind == ASSIGN else ''}{chosen}begin\n{original}\nend"

    def instance(self, choice: _Choice) -> str:
        original = self.text[choice.site.start : choice.site.end]
        instance = sites(original)[0]
        plain = instance.connections
        expressions = {port: original[start:end] for port, (start, end) in plain.items()}
        for mutant in choice.mutants:
            copy = self.mutated(choice.site, mutant)
            other = sites(copy)[0]
            changed = {port: copy[start:end] for port, (start, end) in other.connections.items()}
            if changed.keys() != plain.keys() or copy[: other.opening] != original[: instance.opening]:
                raise CatalogueError(f"mutant {mutant.name} changes more than the expressions of connections")
            for port, (start, end) in plain.items():
                if changed[port] != original[start:end]:
                    expressions[port] = f"{_is(mutant)} ? ({changed[port]}) : ({expressions[port]})"
        for port, (start, end) in sorted(plain.items(), key=lambda one: -one[1][0]):
            expression = expressions[port]
            if start != end and original[start - 1] != "(" and expression != port:  # `.clk_i` connects clk_i
                expression = f"{port}({expression})"
            original = original[:start] + expression + original[end:]
        return original


def weave(text: str, mutants: list[Mutant], declaration: str = DECLARATION) -> str:
    """`text` with all `mutants`, which are all of this file. CatalogueError: one cannot be selected at run time.

    `declaration` declares `mutant_number` in each module. By default Verilator sets it to the environment variable.
    """
    try:
        weaver = _Weaver(text, declaration)
        choices: dict[tuple[int, int], _Choice] = {}
        for mutant in mutants:
            site = weaver.site_of(mutant)
            choices.setdefault((site.start, site.end), _Choice(site)).mutants.append(mutant)
        outermost = [_Choice(site) for site in weaver.sites if site.kind == HEADER]
        for choice in choices.values():
            around = [
                other
                for other in choices.values()
                if other is not choice and other.site.start <= choice.site.start and choice.site.end <= other.site.end
            ]
            smallest = min(around, key=lambda other: other.site.end - other.site.start, default=None)
            (smallest.inner if smallest else outermost).append(choice)
        return weaver.render(0, len(text), outermost)
    except SyntaxProblem as problem:
        raise CatalogueError(
            f"rtl/{mutants[0].file}: {problem}, where tools/mutants/sites.py reads no SystemVerilog"
        ) from None
