"""AIGER files: copies with selected properties, and the replay of a counterexample without the solver that found it."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from pathlib import Path


def _encoded(gates: list[tuple[int, int]], first: int) -> bytearray:
    """The gates in the encoding of the file. `first`: variable of the first gate."""
    encoded = bytearray()
    for gate, (left, right) in enumerate(gates, first):
        for delta in (2 * gate - left, left - right):
            while delta >= 128:
                encoded.append(delta & 127 | 128)
                delta >>= 7
            encoded.append(delta)
    return encoded


@dataclass
class Aiger:
    """A binary AIGER 1.9 file whose properties are its bad-state literals."""

    inputs: int
    latches: list[int]  # next-state literal of each latch; all start at 0
    bad: list[int]
    constraints: list[int]
    first_and: int  # variable of the first gate
    ands: int
    gates: bytes  # the gates in the encoding of the file

    @staticmethod
    def read(path: Path) -> Aiger:
        data = path.read_bytes()
        position = data.index(b"\n")
        header = [int(word) for word in data[:position].split()[1:]] + [0] * 4
        _, inputs, latches, outputs, ands, bad, constraints = header[:7]
        position += 1

        def lines(count: int) -> list[bytes]:
            nonlocal position
            found = []
            for _ in range(count):
                end = data.index(b"\n", position)
                found.append(data[position:end])
                position = end + 1
            return found

        next_states = [int(line) for line in lines(latches)]
        lines(outputs)
        bad_literals = [int(line) for line in lines(bad)]
        constraint_literals = [int(line) for line in lines(constraints)]
        gates = data[position:]
        return Aiger(
            inputs,
            next_states,
            bad_literals,
            constraint_literals,
            1 + inputs + latches,
            ands,
            gates,
        )

    def write(self, path: Path, properties: list[int]):
        """Writes a copy with only `properties`, given by number."""
        bad = [self.bad[number] for number in properties]
        size = self.first_and - 1 + self.ands
        header = f"aig {size} {self.inputs} {len(self.latches)} 0 {self.ands} {len(bad)} {len(self.constraints)} 0 0"
        literals = [str(literal).encode() for literal in self.latches + bad + self.constraints]
        path.write_bytes(b"\n".join([header.encode(), *literals, b""]) + self.gates)

    def write_step(self, path: Path, number: int, proved: list[int], every: list[int]):
        """Writes a copy with property `number`, which fails only if none of `every` failed in an earlier clock and none
        of `proved` fails in this one."""
        state = 1 + self.inputs + len(self.latches)  # variable of a new latch: a property failed
        gates: list[tuple[int, int]] = []

        def moved(literal: int) -> int:
            return literal + 2 if literal >> 1 >= state else literal

        def both(one: int, other: int) -> int:
            gates.append((max(one, other), min(one, other)))
            return 2 * (state + len(gates))

        def none_of(numbers: list[int], literal: int) -> int:
            for each in numbers:
                literal = both(literal, moved(self.bad[each]) ^ 1)
            return literal

        gates += [(moved(left), moved(right)) for left, right in self.fanins]
        healthy = 2 * state ^ 1
        failed = none_of(every, healthy) ^ 1
        bad = none_of(proved, both(healthy, moved(self.bad[number])))
        size = state + len(gates)
        header = f"aig {size} {self.inputs} {len(self.latches) + 1} 0 {len(gates)} 1 {len(self.constraints)} 0 0"
        literals = [*map(moved, self.latches), failed, bad, *map(moved, self.constraints)]
        encoded = _encoded(gates, state + 1)
        path.write_bytes(b"\n".join([header.encode(), *(str(each).encode() for each in literals), b""]) + encoded)

    def with_constants(self, constants: dict[int, int]) -> Aiger:
        """A copy in which input variables have these values in every clock. Its inputs, latches and properties are the
        same. It lacks the gates that become constant or equal to another literal."""
        if not constants:
            return self
        literals = list(range(0, 2 * self.first_and, 2))  # the literal of each variable in the copy
        for variable, value in constants.items():
            literals[variable] = value
        gates: list[tuple[int, int]] = []
        gate = 2 * self.first_and
        for left, right in self.fanins:
            one, other = literals[left >> 1] ^ (left & 1), literals[right >> 1] ^ (right & 1)
            if one < other:
                one, other = other, one
            if other == 0 or one == other ^ 1:
                literals.append(0)
            elif other == 1 or one == other:
                literals.append(one)
            else:
                gates.append((one, other))
                literals.append(gate)
                gate += 2

        def moved(old: list[int]) -> list[int]:
            return [literals[literal >> 1] ^ (literal & 1) for literal in old]

        return Aiger(
            self.inputs,
            moved(self.latches),
            moved(self.bad),
            moved(self.constraints),
            self.first_and,
            len(gates),
            bytes(_encoded(gates, self.first_and)),
        )

    @cached_property
    def fanins(self) -> list[tuple[int, int]]:
        """The two inputs of every gate, in order."""
        position = 0
        gates = []

        def delta() -> int:
            nonlocal position
            value = shift = 0
            while True:
                byte = self.gates[position]
                position += 1
                value |= (byte & 0x7F) << shift
                shift += 7
                if not byte & 0x80:
                    return value

        for number in range(self.ands):
            left = 2 * (self.first_and + number) - delta()
            gates.append((left, left - delta()))
        return gates

    def replay(
        self, stimulus: list[list[int]], numbers: list[int], constants: dict[int, int]
    ) -> list[list[int]] | None:
        """All variables in each clock of `stimulus` (inputs by clock) if the run is a counterexample of one of the
        properties `numbers`, else None. In a counterexample all constraints are true and the property fails at the
        end. `constants`: values of input variables, instead of those of `stimulus`."""
        state = [0] * len(self.latches)
        clocks = []
        for inputs in stimulus:
            values = [0, *inputs, *state]
            for variable, constant in constants.items():
                values[variable] = constant
            for left, right in self.fanins:
                values.append((values[left >> 1] ^ (left & 1)) & (values[right >> 1] ^ (right & 1)))

            def value(literal: int) -> int:
                return values[literal >> 1] ^ (literal & 1)

            if not all(value(literal) for literal in self.constraints):
                return None
            clocks.append(values)
            state = [value(literal) for literal in self.latches]
        return clocks if any(self.fails(clocks[-1], number) for number in numbers) else None

    def fails(self, values: list[int], number: int) -> bool:
        """Whether property `number` fails in a clock with these values of all variables."""
        literal = self.bad[number]
        return bool(values[literal >> 1] ^ (literal & 1))
