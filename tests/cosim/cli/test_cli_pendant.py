"""armature pendant: a person at a terminal, and this test at the other end of the line."""

import fcntl
import os
import pty
import select
import struct
import subprocess
import termios
import time

from cli_program import Program, main

FRAME = 8
SET_TELEMETRY, SERVO = 0x03, 0x05


def crc8(data):
    crc = 0xFF
    for byte in data:
        crc ^= byte
        for _ in range(8):
            crc = (crc << 1 ^ (0x2F if crc & 0x80 else 0)) & 0xFF
    return crc ^ 0xFF


def frame(kind, sequence, opcode, parameter, payload):
    body = bytes([kind << 4 | sequence, opcode, parameter]) + struct.pack("<i", payload)
    return body + bytes([crc8(body)])


class Terminal:
    """The program in a terminal of 24 x 80, and the controller's end of its line."""

    def __init__(self, *arguments):
        self.line, line = pty.openpty()
        self.screen, screen = pty.openpty()
        fcntl.ioctl(screen, termios.TIOCSWINSZ, struct.pack("HHHH", 24, 80, 0, 0))
        self.program = subprocess.Popen(
            [Program.path, "pendant", os.ttyname(line), *arguments],
            stdin=screen,
            stdout=screen,
            stderr=subprocess.PIPE,
            env={**os.environ, "TERM": "xterm"},
        )
        os.close(screen)
        self.keep = line  # else the line is closed until the program opens it
        self.received, self.shown = b"", b""
        self.commands = []

    def close(self):
        self.program.kill()
        self.program.communicate()
        for descriptor in (self.line, self.screen, self.keep):
            os.close(descriptor)

    def serve(self, until, timeout_s=60):
        """Answers commands with ok until the condition is true; fails after the time."""
        end = time.monotonic() + timeout_s
        while not until():
            assert time.monotonic() < end, (self.commands, self.shown[-2000:])
            for ready in select.select([self.line, self.screen], [], [], 0.1)[0]:
                try:
                    data = os.read(ready, 4096)
                except OSError:
                    return
                if ready == self.screen:
                    self.shown += data
                else:
                    self.received += data
            self.answer()

    def answer(self):
        while len(self.received) >= FRAME and not self.received.startswith(b"\xee"):
            command, self.received = self.received[:FRAME], self.received[FRAME:]
            assert crc8(command[:7]) == command[7], command.hex()
            sequence, opcode, parameter = command[0] & 15, command[1], command[2]
            self.commands.append((opcode, parameter))
            os.write(self.line, frame(5, sequence, opcode | 0x80, 0, 0))

    def telemetry(self, page, value):
        os.write(self.line, frame(6, 0, 0x02, page, value))

    def press(self, keys):
        os.write(self.screen, keys.encode())


class Pendant(Program):
    def terminal(self, *arguments):
        terminal = Terminal(*arguments)
        self.addCleanup(terminal.close)
        return terminal

    def test_it_connects_sends_what_is_pressed_and_shows_the_telemetry(self):
        terminal = self.terminal("--robot", "vo2021_6r")
        terminal.serve(lambda: any(opcode == SET_TELEMETRY for opcode, _ in terminal.commands))
        terminal.press("o")
        terminal.serve(lambda: (SERVO, 1) in terminal.commands)
        terminal.telemetry(0, 2 + 4096)
        terminal.telemetry(1, 13889)
        terminal.serve(lambda: b"READY" in terminal.shown and b"10.0001" in terminal.shown)
        terminal.press("Q")
        self.assertEqual(terminal.program.wait(60), 0)

    def test_the_emergency_stop_is_sent_without_a_connection(self):
        terminal = self.terminal()
        terminal.serve(lambda: b"no connection" in terminal.shown or terminal.commands)
        terminal.press("!")
        terminal.serve(lambda: b"\xee" * 16 in terminal.received)

    def test_a_closed_line_ends_it_and_gives_the_terminal_back(self):
        terminal = self.terminal()
        terminal.serve(lambda: terminal.commands)
        os.close(terminal.keep)
        os.close(terminal.line)
        _, errors = terminal.program.communicate(timeout=60)
        terminal.line, terminal.keep = os.open("/dev/null", os.O_RDWR), os.open("/dev/null", os.O_RDWR)
        self.assertIn("has closed the line", errors.decode())
        self.assertEqual(terminal.program.returncode, 2)

    def test_without_a_terminal_it_is_refused(self):
        line, other = pty.openpty()
        self.addCleanup(os.close, line)
        self.addCleanup(os.close, other)
        self.assertIn("needs a terminal", self.armature("pendant", os.ttyname(other), code=2).stderr)

    def test_wrong_lines_and_programs_are_refused(self):
        text = self.text("a.txt", "x")
        upper = self.text("a.GCODE", "(\u00e4)\n")
        odd = self.text("a.jbi", "/JOB\n//NAME \u00e4\n")
        for arguments, message in (
            (["no/such/line"], "no/such/line: cannot open this line"),
            (["/dev/null"], "/dev/null: is no serial device or pseudo-terminal"),
            (["tcp:0"], "expected tcp:PORT with a port from 1 to 65535"),
            (["tcp:x"], "expected tcp:PORT"),
            (["x", "--program", text], "expected a file that ends in .ngc, .nc, .gcode or .jbi"),
            (["x", "--program", odd], "a.jbi:2: holds a character that is not ASCII"),
            (["x", "--program", upper], "a.GCODE:1: holds a character that is not ASCII"),
            (["x", "--robot", "nobody"], "nobody"),
        ):
            with self.subTest(arguments=arguments):
                self.assertIn(message, self.armature("pendant", *arguments, code=2).stderr)


if __name__ == "__main__":
    main()
