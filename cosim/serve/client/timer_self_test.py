#!/usr/bin/env python3
"""The self-test of the vendor's AXI Timer driver, rewritten for the served RTL; then one period of 50 us.

usage: timer_self_test.py tcp:PORT | PATH
The environment variable ARMATURE_TOKEN contains the token that the server printed; a path needs none.
"""

import sys

from armature_client import Soc

BASE, STRIDE = 0x4280_0000, 0x10
TCSR, TLR, TCR = 0x0, 0x4, 0x8
UDT, ARHT, LOAD, ENIT, ENT, TINT = 0x002, 0x010, 0x020, 0x040, 0x080, 0x100
POLLS = 65535
TICK_CYCLES = 2500


class Timer:
    def __init__(self, soc, number):
        self.soc, self.base = soc, BASE + number * STRIDE

    def write(self, offset, value):
        self.soc.write(self.base + offset, value)

    def read(self, offset):
        return self.soc.read(self.base + offset)

    def initialise(self):
        """Initialisation as in the driver: counter at 0, flag acknowledged, stopped."""
        self.write(TLR, 0)
        self.write(TCSR, TINT | LOAD)
        self.write(TCSR, 0)

    def self_test(self):
        """The counter must leave 0 within the number of polls that the driver makes."""
        self.initialise()
        self.write(TCSR, ENT)
        first = self.read(TCR)
        if all(self.read(TCR) == first for _ in range(POLLS)):
            sys.exit("the counter does not count")
        self.write(TCSR, TINT | LOAD)
        self.write(TCSR, 0)
        if self.read(TCR) != 0:
            sys.exit("the counter was not loaded with 0")

    def period(self):
        """As the trigger of the tick: cycles between two interrupts."""
        self.write(TLR, TICK_CYCLES - 2)
        self.write(TCSR, LOAD)
        self.write(TCSR, ENT | ENIT | ARHT | UDT)
        first = self.soc.run_until_irq(2 * TICK_CYCLES)
        self.write(TCSR, TINT | ENT | ENIT | ARHT | UDT)
        second = self.soc.run_until_irq(2 * TICK_CYCLES)
        self.initialise()
        return second - first


def main(where):
    with Soc(where) as soc:
        timers = [Timer(soc, number) for number in range(2)]
        for timer in timers:
            timer.initialise()
        for number, timer in enumerate(timers):
            timer.self_test()
            print(f"timer {number} counts")
        cycles = timers[0].period()
        print(f"period {cycles} cycles")
        if cycles != TICK_CYCLES:
            sys.exit("the period is wrong")


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    try:
        main(sys.argv[1])
    except (OSError, ValueError) as error:
        sys.exit(f"{sys.argv[1]}: {error}")
