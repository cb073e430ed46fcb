"""Reads a VCD file, for tests that compare its signals."""

import bisect

TEXT_BITS = 8


class Vcd:
    """The changes of each signal: {"top.arm_soc.name": [(time in ns, bits as a string of 0 and 1)]}."""

    def __init__(self, text):
        head, _, body = text.partition("$enddefinitions $end")
        scope, names, self.changes, self.times = [], {}, {}, []
        for line in head.splitlines():
            words = line.split()
            if words[:1] == ["$scope"]:
                scope.append(words[2])
            elif words[:1] == ["$upscope"]:
                scope.pop()
            elif words[:1] == ["$var"]:
                name = ".".join([*scope, words[4]])
                names.setdefault(words[3], []).append(name)
                self.changes[name] = []
        now = None
        for line in body.splitlines():
            kind = line[:1]
            if kind == "#":
                now = int(line[1:])
                self.times.append(now)
                continue
            if kind == "b":
                value, code = line[1:].split()
                value = value.lstrip("0") or "0"  # the number of zeros in front is free
            elif kind and kind in "01xz":
                value, code = kind, line[1:]
            else:  # $dumpvars and its $end
                continue
            for name in names[code]:
                changes = self.changes[name]
                if not changes or changes[-1][1] != value:
                    changes.append((now, value))

    def at(self, name, time):
        """The number at this time, changes at the time included."""
        changes = self.changes[name]
        return int(changes[bisect.bisect_right(changes, (time, "~")) - 1][1], 2)

    def text_at(self, name, time):
        value = self.at(name, time)
        return value.to_bytes((value.bit_length() + TEXT_BITS - 1) // TEXT_BITS, "big").decode("ascii")

    def texts(self, name):
        """Every text that the signal has, with its time."""
        return [(time, self.text_at(name, time)) for time, _ in self.changes[name]]

    def rises(self, name):
        """The times at which a level rises, those of the first values excepted."""
        return [time for time, value in self.changes[name][1:] if value == "1"]

    def falls(self, name):
        return [time for time, value in self.changes[name][1:] if value == "0"]
