"""Random valid programs of G-code."""

import random

from gcode_programs import START


def random_program(seed):
    """A valid program. The same seed gives the same program."""
    return Draw(random.Random(seed)).program()


class Draw:
    """Draws lines of a valid program and follows the modes that decide what is valid."""

    def __init__(self, rng):
        self.rng = rng
        self.lines = []
        self.inverse = False
        self.labels = 0
        # Where a rotation changes while an offset of G92 is active, rs274 forgets where the machine is.
        self.turns = rng.random() < 0.5

    def number(self, low=-50.0, high=50.0):
        """A value as text: a number, or an expression."""
        value = self.rng.uniform(low, high)
        kind = self.rng.randrange(12)
        if kind == 0:
            return f"[{value / 2:.3f}+{value / 2:.3f}]"
        if kind == 1:
            return f"#{self.rng.randrange(1, 9)}" if low < 0 else f"[ABS[#{self.rng.randrange(1, 9)}]+1]"
        if kind == 2:
            return f"[{value:.2f}*COS[{self.rng.randrange(0, 60)}]]"
        if kind == 3:
            return f"{value:.0f}."
        return f"{value:.{self.rng.randrange(1, 5)}f}"

    def axes(self, letters="XYZABC", least=1):
        some = self.rng.sample(letters, self.rng.randrange(least, len(letters) + 1))
        return " ".join(f"{letter}{self.number()}" for letter in some)

    def label(self):
        self.labels += 1
        return f"o{self.labels}"

    def feed(self):
        if self.inverse or self.rng.random() < 0.2:
            return f" F{self.rng.uniform(0.5, 500):.2f}"
        return ""

    def program(self):
        add = self.lines.append
        add(START.strip())
        add("F100")
        for i in range(1, 9):
            add(f"#{i}={self.rng.uniform(-20, 20):.3f}")
        for _ in range(self.rng.randrange(10, 40)):
            self.statement(0)
        add(self.rng.choice(["M2", "M30"]))
        return "\n".join(self.lines) + "\n"

    def statement(self, depth):
        kinds = ["straight"] * 8 + ["arc"] * 5 + ["mode"] * 4 + ["offset"] * 3 + ["assign"] * 3 + ["machine"] * 3
        kinds += ["cycle"] * 2
        if depth < 2:
            kinds += ["if", "repeat", "while", "sub"]
        getattr(self, "draw_" + self.rng.choice(kinds))(depth)

    def draw_straight(self, _depth):
        code = self.rng.choice(["G0", "G1"])
        self.lines.append(f"{code} {self.axes()}{self.feed() if code == 'G1' else ''}")

    def draw_arc(self, _depth):
        """Relative, so that the radii agree whatever the place is."""
        plane, first, second, normal, i, j = self.rng.choice(
            [("G17", "X", "Y", "Z", "I", "J"), ("G18", "Z", "X", "Y", "K", "I"), ("G19", "Y", "Z", "X", "J", "K")]
        )
        code = self.rng.choice(["G2", "G3"])
        helix = f" {normal}{self.rng.uniform(-5, 5):.3f}" if self.rng.random() < 0.4 else ""
        turns = f" P{self.rng.randrange(1, 4)}" if self.rng.random() < 0.2 else ""
        a, b = self.rng.uniform(1, 20), self.rng.uniform(1, 20)
        kind = self.rng.randrange(3)
        if kind == 0:
            arc = f"{first}{2 * a:.3f} {second}{2 * b:.3f} {i}{a:.3f} {j}{b:.3f}"
        elif kind == 1:
            arc = f"{i}{a:.3f} {j}{-b:.3f}"
        else:
            sign = self.rng.choice(["", "-"])
            arc = f"{first}{a:.3f} {second}{-b:.3f} R{sign}{a + b:.3f}"
        self.lines.append(f"{plane} G91 {code} {arc}{helix}{turns}{self.feed()}")
        self.lines.append(self.rng.choice(["G90", "G91"]))

    def draw_mode(self, _depth):
        kind = self.rng.randrange(9)
        if kind == 0:
            self.inverse = not self.inverse
            self.lines.append("G93" if self.inverse else "G94 F250")
        elif kind == 1:
            # rs274 does not convert tolerance and tool offset to the new units.
            self.lines += ["G49", self.rng.choice(["G20", "G21"]), "G64"]
        else:
            self.lines.append(
                self.rng.choice(
                    [
                        "G90",
                        "G91",
                        "G61",
                        "G61.1",
                        "G64",
                        "G64 P0.1",
                        "G64 P0.2 Q0.05",
                        "G17",
                        "G18",
                        "G19",
                        "G98",
                        "G99",
                    ]
                )
            )

    def draw_offset(self, _depth):
        kind = self.rng.randrange(9)
        flat = "XYZABC"
        if kind == 0:
            turn = f" R{self.rng.randrange(-90, 91, 15)}" if self.turns else ""
            self.lines.append(f"G10 L2 P{self.rng.randrange(0, 10)} {self.axes(flat)}{turn}")
        elif kind == 1:
            self.lines.append(f"G10 L20 P{self.rng.randrange(0, 10)} {self.axes(flat)}")
        elif kind == 2:
            self.lines.append("G" + self.rng.choice(["54", "55", "56", "57", "58", "59", "59.1", "59.2", "59.3"]))
        elif kind in (3, 4) and self.turns:
            self.lines.append("G54")
        elif kind == 3:
            self.lines.append(f"{self.rng.choice(['G92', 'G52'])} {self.axes(flat)}")
        elif kind == 4:
            self.lines.append(self.rng.choice(["G92.1", "G92.2", "G92.3"]))
        elif kind == 5:
            self.lines.append(self.rng.choice([f"G43.1 Z{self.number()}", "G49"]))
        elif kind == 6:
            self.lines.append(self.rng.choice(["G28.1", "G30.1", "G28", "G30", f"G28 Z{self.number()}"]))
        else:
            self.lines.append(f"G90 G53 {self.rng.choice(['G0', 'G0'])} {self.axes('XYZ', least=2)}")

    def draw_assign(self, _depth):
        operator = self.rng.choice(["+", "-", "*", "/", " MOD ", " LT ", " EQ ", " AND ", " OR ", " XOR ", " GE "])
        divisor = f"{self.rng.uniform(1, 9):.2f}"
        left = self.rng.choice([f"#{self.rng.randrange(1, 9)}", f"{self.rng.uniform(-9, 9):.2f}"])
        target = self.rng.randrange(1, 9)
        function = self.rng.choice(["ABS", "FIX", "FUP", "ROUND", "SIN", "COS"])
        self.lines.append(f"#{target}={self.rng.choice(['', function])}[{left}{operator}{divisor}]")
        self.lines.append(f"#{target}=[#{target} MOD 50]")

    def draw_machine(self, _depth):
        self.lines.append(
            self.rng.choice(
                ["M3 S100", "M4 S200.5", "M5", "M7", "M8", "M9", "M48", "M49", "M50 P0", "M51 P1", "M52", "M53 P0"]
                + ["M62 P1", "M63 P2", "M64 P3", "M65 P0", "M67 E1 Q2.5", "M68 E0 Q-3", "G4 P0.25", "M0", "M1", "M60"]
                + ["T1 M6", "T2", "(MSG, text)", "(debug,#1 #5)", "G80"]
            )
        )

    def draw_cycle(self, _depth):
        if self.inverse:
            return
        self.lines.append(self.rng.choice(["G17", "G18", "G19"]) + " G90 G80")
        self.lines.append("G0 X20 Y20 Z20")
        code = self.rng.choice(["G81", "G82", "G83"])
        extra = {"G81": "", "G82": " P0.5", "G83": f" Q{self.rng.uniform(2, 9):.2f}"}[code]
        mode = self.rng.choice(["G90", "G91"])
        if mode == "G91":
            place, clearance = "X-3 Y-2 Z-4", "R-5"
        else:
            place, clearance = "X-3.5 Y-2.5 Z-4.5", f"R{self.rng.choice([5, 25])}"
        repeat = f" L{self.rng.randrange(1, 4)}" if self.rng.random() < 0.4 else ""
        self.lines.append(f"{mode} {self.rng.choice(['G98', 'G99'])} {code} {place} {clearance}{extra}{repeat}")
        for _ in range(self.rng.randrange(3)):
            self.lines.append(self.rng.choice(["X-1 Y-2", "G98", "G99 X-2", "G98 Y-3 Z-6", "Z-7"]))
        self.lines.append("G80 G90")

    def block(self, depth):
        for _ in range(self.rng.randrange(1, 4)):
            self.statement(depth + 1)

    def draw_if(self, depth):
        label = self.label()
        self.lines.append(f"{label} if [#{self.rng.randrange(1, 9)} GT {self.rng.uniform(-9, 9):.1f}]")
        inverse = self.inverse
        self.block(depth)
        self.lines.append(f"{label} else")
        self.block(depth)
        self.lines.append(f"{label} endif")
        self.inverse = inverse
        self.lines.append("G93" if inverse else "G94 F250")

    def draw_repeat(self, depth):
        label = self.label()
        inverse = self.inverse
        self.lines.append(f"{label} repeat [{self.rng.randrange(0, 4)}]")
        self.lines.append("G93" if inverse else "G94 F250")
        self.block(depth)
        self.lines.append(f"{label} endrepeat")
        self.inverse = inverse
        self.lines.append("G93" if inverse else "G94 F250")

    def draw_while(self, depth):
        label = self.label()
        counter = 10 + self.labels
        inverse = self.inverse
        self.lines.append(f"#{counter}=0")
        self.lines.append(f"{label} while [#{counter} LT {self.rng.randrange(1, 4)}]")
        self.lines.append("G93" if inverse else "G94 F250")
        self.lines.append(f"#{counter}=[#{counter}+1]")
        self.block(depth)
        self.lines.append(f"{label} endwhile")
        self.inverse = inverse
        self.lines.append("G93" if inverse else "G94 F250")

    def draw_sub(self, depth):
        if depth > 0:
            return
        label = self.label()
        inverse = self.inverse
        self.lines.append(f"{label} sub")
        self.lines.append("G93" if inverse else "G94 F250")
        self.block(1)
        self.lines.append(f"{label} endsub")
        arguments = " ".join(f"[{self.rng.uniform(-9, 9):.2f}]" for _ in range(self.rng.randrange(8, 10)))
        self.lines.append(f"{label} call {arguments}")
        self.inverse = inverse
        self.lines.append("G93" if inverse else "G94 F250")
