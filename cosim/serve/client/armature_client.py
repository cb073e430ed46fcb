"""Client of `armature serve`: registers, pins and simulated time of the logic. Standard library only.

    with Soc("tcp:5025") as soc:            # or the path of a Unix socket, as after --listen
        soc.write(0x42800004, 2498)
        print(hex(soc.read(0x42800004)), soc.pin("irq_o"), soc.time())

Over TCP the server requires the token that it printed when it started: Soc(where, token), or the environment variable
ARMATURE_TOKEN. The protocol is described in cosim/serve/README.md.
"""

import os
import re
import socket

MAX_IN_FLIGHT = 4096  # commands that may be sent before an answer is read
MAX_OPERATIONS = 4096  # of one batch


class Refused(Exception):
    """The server answered `error ...`; the connection stays open."""


class BatchRefused(Refused):
    """An operation of a batch failed. Those after it were not executed.

    index: of the operation in the list that was given, from 0; results: of the operations before it.
    """

    def __init__(self, text, index, results):
        super().__init__(text)
        self.index, self.results = index, results


class Soc:
    def __init__(self, where, token=None):
        """Raises ConnectionError with the server's reason when it serves another client or the token is wrong."""
        if where.startswith("tcp:"):
            self._socket = socket.create_connection(("127.0.0.1", int(where.removeprefix("tcp:"))))
            self._socket.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
        else:
            self._socket = socket.socket(socket.AF_UNIX)
            self._socket.connect(where)
        self._answers = self._socket.makefile("r", encoding="ascii", newline="\n")
        try:
            self._send_token(os.environ.get("ARMATURE_TOKEN", "") if token is None else token)
        except BaseException:
            self.close()
            raise

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.close()

    def close(self):
        self._answers.close()
        self._socket.close()

    def read(self, addr):
        return self._number(f"r {addr:#x}")

    def write(self, addr, data, strobes=0xF):
        """Bit i of strobes: byte i is written."""
        self.command(f"w {addr:#x} {data:#x} {strobes}")

    def run(self, cycles):
        """Runs clocks of 20 ns; returns the cycle after them."""
        return self._number(f"run {cycles}")

    def run_until_irq(self, max_cycles):
        """Returns the cycle in which a bit of irq_o is high; raises Refused when none is within `max_cycles` clocks."""
        return self._number(f"run-until-irq {max_cycles}")

    def time(self):
        """Clocks since reset."""
        return self._number("time")

    def pin(self, name, level=None):
        """The level of a pin of arm_soc; with a level: drives an input from the next clock on."""
        if level is None:
            return self._number(f"pin {name}")
        self.command(f"pin {name} {level}")
        return level

    def vcd(self, file=""):
        """Waveform of every signal from now on, in a file below the folder of the server's --out; without a name: closes it."""
        self.command(f"vcd {file}")

    def command(self, line):
        """Sends a command; returns the text after `ok`."""
        self._send([line])
        return self._answer()

    def pipeline(self, lines):
        """Sends many commands at full speed. Returns the text after each `ok`, or a Refused, in order."""
        lines, results = list(lines), []
        for begin in range(0, len(lines), MAX_IN_FLIGHT):
            some = lines[begin : begin + MAX_IN_FLIGHT]
            self._send(some)
            for _ in some:
                try:
                    results.append(self._answer())
                except Refused as refused:
                    results.append(refused)
        return results

    def batch(self, operations):
        """Carries out commands (r, w, run, run-until-irq, pin, time) one after the other, thousands in one request.

        Returns a number for each, None for those that have none. Raises BatchRefused at the first one that fails.
        """
        operations, results = list(operations), []
        for begin in range(0, len(operations), MAX_OPERATIONS):
            some = operations[begin : begin + MAX_OPERATIONS]
            text = ";".join(some)
            if text.count(";") != len(some) - 1:
                raise ValueError("an operation is one command without ';'")
            try:
                results += self._values(self.command("batch " + text))
            except Refused as refused:
                failed = re.match(r"operation (\d+) of \d+: (.*); executed (?:none|0\.\.\d+: (.*))$", str(refused))
                if not failed:
                    raise
                index, what, executed = failed.groups(default="")
                raise BatchRefused(what, begin + int(index), results + self._values(executed)) from None
        return results

    @staticmethod
    def _values(words):
        return [None if word == "-" else int(word, 0) for word in words.split()]

    def _send_token(self, token):
        try:
            self._send([f"token {token}"])
        except (BrokenPipeError, ConnectionResetError):
            pass  # the server has closed; its last line can still be read
        try:
            self._answer()
        except Refused as refused:
            raise ConnectionError(str(refused)) from None

    def _send(self, lines):
        if any("\n" in line for line in lines):
            raise ValueError("a command is one line")
        self._socket.sendall("".join(line + "\n" for line in lines).encode())

    def _answer(self):
        answer = self._answers.readline()
        if not answer.endswith("\n"):
            raise ConnectionError("the server has closed the connection")
        word, _, rest = answer.rstrip("\n").partition(" ")
        if word != "ok":
            raise Refused(rest)
        return rest

    def _number(self, line):
        return int(self.command(line), 0)
