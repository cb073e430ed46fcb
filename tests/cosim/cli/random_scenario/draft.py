"""A scenario file that is being written, and draws of values."""

import contextlib
import json


def text_of(value):
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, str):
        return json.dumps(value, ensure_ascii=False)  # TOML's basic strings know the same escapes
    if isinstance(value, list):
        return "[" + ", ".join(text_of(element) for element in value) + "]"
    return repr(value)


class Draft:
    """`keys` collects the keys that were written as `table.key`, `files` the other files by name."""

    def __init__(self, rng, robots):
        self.rng = rng
        self.robot = rng.choice(robots)
        self.lines = []
        self.open_table = ""
        self.keys = set()
        self.files = {}
        # What tables have drawn, for those behind them.
        self.duration_s = 0.0
        self.paper = False
        self.may_time_out = False  # accesses of the bus
        self.has_serial = False
        self.has_pendant = False
        self.has_job = False  # the pendant has sent one
        self.frames = []
        self.has_conveyor = False
        self.program = None  # the end of the name of its file
        self.analog = []  # outputs of G-code

    def text(self):
        return "\n".join(self.lines) + "\n"

    def put(self, key, value):
        self.keys.add(f"{self.open_table}.{key}" if self.open_table else key)
        self.lines.append(f"{key} = {text_of(value)}")

    def maybe(self, key, make, chance=0.4):
        if self.rng.random() < chance:
            self.put(key, make())

    @contextlib.contextmanager
    def aside(self):
        """Draws in it change nothing of what is drawn behind it: for new keys within a table."""
        state = self.rng.getstate()
        yield
        self.rng.setstate(state)

    def table(self, name, header=None):
        self.open_table = name
        self.keys.add(name)
        self.lines.append(header or f"[{name}]")

    def number(self, low, high, digits=3):
        """Now and then an end of the range."""
        return self.rng.choice([low, high]) if self.rng.random() < 0.1 else round(self.rng.uniform(low, high), digits)

    def integer(self, low, high):
        return self.rng.choice([low, high]) if self.rng.random() < 0.1 else self.rng.randint(low, high)

    def count(self):
        return self.integer(0, 1000)

    def per_axis(self, make):
        return [make() for _ in range(self.robot.axes)]

    def place(self, size=50):
        return [self.number(-size, size) for _ in range(3)]

    def angles(self, size=180):
        return [self.number(-size, size) for _ in range(3)]

    def at(self):
        return round(self.rng.uniform(0, self.duration_s) * 0.999, 7)
