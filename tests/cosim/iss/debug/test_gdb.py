"""`armature-iss debug` with gdb-multiarch, and with clients that are no gdb."""

import contextlib
import pathlib
import re
import shutil
import signal
import socket
import subprocess
import sys
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).parents[2] / "cli"))
from cli_program import BRIEF, MOMENT, ROOT, SCENARIOS, TINY, Program, main

GDB = shutil.which("gdb-multiarch")
TUTORIAL = ROOT / "cosim/iss/debug/README.md"


class Debugged:
    """A run that waits for gdb."""

    def __init__(self, test, *arguments):
        command = [test.path, "debug", *map(str, arguments or (TINY, *BRIEF)), "--engine", "model"]
        self.process = subprocess.Popen(
            command, cwd=test.folder, text=True, stdout=subprocess.PIPE, stderr=subprocess.PIPE
        )
        first = self.process.stdout.readline()
        self.port = int(re.fullmatch(r"listening on tcp:(\d+)\n", first)[1])

    def __enter__(self):
        return self

    def __exit__(self, *_):
        if self.process.poll() is None:
            self.process.kill()
        self.process.communicate()

    def end(self):
        """Its exit code, and what it printed."""
        out, errors = self.process.communicate(timeout=Program.longest_s)
        return self.process.returncode, out + errors


class Client:
    """A program that speaks the protocol, in its own way."""

    def __init__(self, port):
        self.socket = socket.create_connection(("127.0.0.1", port), timeout=60)

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.socket.close()

    def send(self, payload):
        self.socket.sendall(f"${payload}#{sum(payload.encode()) % 256:02x}".encode())

    def receive(self):
        """The next packet, without what acknowledges one."""
        text = b""
        while not re.search(rb"#..$", text):
            byte = self.socket.recv(1)
            if not byte:
                raise ConnectionError(text)
            text += byte
        return re.search(rb"\$(.*)#..$", text)[1].decode()

    def ask(self, payload):
        self.send(payload)
        return self.receive()


class Debugger(Program):
    def elf(self):
        return pathlib.Path(self.path).parent / "board/controller.elf"

    def gdb(self, port, *commands):
        words = [word for command in ("set pagination off", "set width 0", *commands) for word in ("-ex", command)]
        command = [GDB, "-nx", "-batch", "-ex", f"target remote :{port}", *words, self.elf()]
        done = subprocess.run(command, text=True, capture_output=True, timeout=self.longest_s, cwd=self.folder)
        return done.stdout, done.stderr  # that of monitor and errors

    def digest(self, text):
        return re.search(r"sha256 +(\w+)", text)[1]

    def expect(self, text, *patterns):
        """The patterns, in this order."""
        at = 0
        for pattern in patterns:
            found = re.compile(pattern.replace(".*", ".*?"), re.S).search(text, at)
            self.assertIsNotNone(found, f"{pattern}\nin\n{text[at:]}")
            at = found.end()

    def symbol(self, name):
        listing = subprocess.run(["arm-none-eabi-nm", "-C", self.elf()], text=True, capture_output=True, check=True)
        return re.search(rf"(\w+) . {re.escape(name)}\n", listing.stdout)[1]

    def plain(self):
        """What the run prints without a debugger."""
        return self.run_once(TINY, "--cpu", "a9", *BRIEF)[1]

    def test_the_session_of_the_tutorial(self):
        text = TUTORIAL.read_text()
        commands = re.findall(r"^\(gdb\) (.*)$", text, re.M)
        arguments = re.search(r"armature-iss debug (.*) --port", text)[1].split()
        self.assertEqual(commands.pop(), "detach")  # the rest of this run takes seconds
        with Debugged(self, SCENARIOS / arguments[0]) as run:
            said = "".join(self.gdb(run.port, *commands, "kill"))
            self.assertEqual(run.end()[0], 130)
        block = text[text.index("(gdb)") :].split("```")[0]
        for line in [line for line in block.splitlines() if line and not line.startswith("(gdb)")]:
            self.assertIn(" ".join(line.split()), " ".join(said.split()))

    def test_a_session_of_gdb(self):
        scenario = self.brief()
        with Debugged(self, scenario) as run:
            said, shown = self.gdb(
                run.port,
                "info threads",
                "monitor cycle",
                "break armature::MotionLoop::follow_source",
                "continue",
                "backtrace 3",
                "info threads",
                "monitor tick",
                "monitor pins",
                "x/1xw 0x43C10000",
                "x/1xw 0x43C01014",
                "x/1xw 0x43C01014",
                "print *(int*)0x43D00000",
                "set $counted = &this->telemetry_.tick",
                "delete",
                "watch *$counted",
                "continue",
                "x/2i $pc - 4",
                "delete",
                "stepi",
                "next",
                "print $d0",
                "thread 2",
                "backtrace 2",
                "delete",
                "continue",
            )
            code, printed = run.end()
        self.expect(
            said,
            r"\* 1 .*core 0: executes.*core0_is_prepared",
            r"2 .*core 1: waits for an interrupt",
            r"Thread 1 hit Breakpoint 1, armature::MotionLoop::follow_source .*motion_loop\.cpp:\d+",
            r"#1 .*MotionLoop::tick .*motion_loop\.cpp:\d+\n#2 .*MotionLoop::run",
            r"\* 1 .*follow_source.* 2 .*core 1: waits for an interrupt\) .*pending",
            r"0x43c10000:\t0x\w+",
            r"0x43c01014:\t0x00000060\n0x43c01014:\t0x00000060\n",  # the line status, twice the same
            r"Thread 1 hit Hardware watchpoint 2.*value_ = 0.*value_ = 1",
            r"\tstr\t.*=> 0x",  # the store has just been executed, of an inlined addition
            r"armature::MotionLoop::tick .*motion_loop\.cpp:\d+",
            r"armature::board.*pending.*#1 .*wait_for_interrupt",
            r"exited normally",
        )
        self.expect(
            shown,
            r"cycle 0, 0\.0",
            r"tick 0\n",
            r"servo_on_o +output 0x3f\n.*in_position_i +input  0x3f\n",
            r"Cannot access memory at address 0x43d00000",
        )
        self.assertEqual(code, 0, printed)
        self.assertEqual(self.digest(printed), self.digest(self.plain()))
        self.assertIn("golden                equal", printed)

    def test_without_stops_and_with_many_the_run_has_the_same_digest(self):
        """gdb counts: each stop has a cost in host time and none in the run."""
        with Debugged(self) as run, Client(run.port) as client:
            self.assertEqual(client.ask("?"), "T05thread:1;")
            self.assertEqual(client.ask("vCont;c"), "W00")
            self.assertEqual(self.digest(run.end()[1]), self.digest(self.plain()))
        tick = self.symbol("armature::MotionLoop::tick()")
        with Debugged(self) as run, Client(run.port) as client:
            client.ask("QStartNoAckMode")
            client.ask(f"Z0,{tick},4")
            stops = 0
            while client.ask("vCont;c").startswith("T05"):
                stops += 1
                client.ask("g")
                if stops % 100 == 0:
                    client.ask("vCont;s:1;c")
                    client.ask("m43c10000,4")
                    client.ask(f"qRcmd,{b'pins'.hex()}")
            code, printed = run.end()
        self.assertEqual(code, 0, printed)
        self.assertEqual(stops, 599)
        self.assertEqual(self.digest(printed), self.digest(self.plain()))

    def test_reading_a_register_takes_nothing_from_the_run(self):
        """RBR gives a character away, and LSR its errors."""
        with Debugged(self) as run, Client(run.port) as client:
            self.assertEqual(client.ask("m43c00000,2"), "E02")  # UART registers begin at 0x1000
            first = client.ask("m43c01014,4")
            self.assertEqual(first, client.ask("m43c01014,4"))
            self.assertEqual(client.ask("m43c01014,1"), first[:2])
            self.assertEqual(client.ask("M43c10000,4:00000000"), "E02")
            self.assertEqual(client.ask("M100080,4:00000000"), "E02")  # code
            self.assertEqual(client.ask("m0,4"), "E02")

    def test_the_memory_and_registers_of_the_firmware_can_be_written(self):
        with Debugged(self) as run, Client(run.port) as client:
            self.assertEqual(client.ask("M200000,4:78563412"), "OK")
            self.assertEqual(client.ask("m200000,4"), "78563412")
            self.assertEqual(client.ask("P3=78563412"), "OK")
            self.assertEqual(client.ask("p3"), "78563412")
            start = client.ask("pf")
            self.assertEqual(client.ask("vCont;s:1"), "T05thread:1;")
            self.assertNotEqual(client.ask("pf"), start)
            self.assertEqual(client.ask(f"Pf={start}"), "OK")  # once more from there
            self.assertEqual(client.ask("pf"), start)
            self.assertEqual(client.ask("vCont;s:1"), "T05thread:1;")
            self.assertNotEqual(client.ask("pf"), start)

    def monitor(self, client, command):
        return bytes.fromhex(client.ask("qRcmd," + command.encode().hex())).decode()

    def seen(self, client):
        """What is seen of the run where it stands."""
        threads = [(client.ask(f"Hg{thread}"), client.ask("g")) for thread in (2, 1)]
        memory = client.ask(f"m{self.symbol('(anonymous namespace)::storage')},1000")
        return threads, memory, self.monitor(client, "cycle"), self.monitor(client, "pins"), client.ask("m43c10010,4")

    def test_a_run_goes_back_to_the_same_states(self):
        tick = self.symbol("armature::MotionLoop::tick()")
        with Debugged(self) as run, Client(run.port) as client:
            self.assertEqual(client.ask("bs"), "T05thread:1;replaylog:begin;")
            client.ask(f"Z0,{tick},4")
            ticks = []
            for _ in range(50):
                self.assertEqual(client.ask("vCont;c"), "T05thread:1;swbreak:;")
                ticks.append(self.monitor(client, "cycle"))
            steps = []
            for _ in range(4):
                steps.append(self.seen(client))
                self.assertEqual(client.ask("vCont;s:1;c"), "T05thread:1;")
            for expected in reversed(steps):
                self.assertEqual(client.ask("bs"), "T05thread:1;")
                self.assertEqual(self.seen(client), expected)
            for expected in reversed(ticks[-5:-1]):
                self.assertEqual(client.ask("bc"), "T05thread:1;swbreak:;")
                self.assertEqual(self.monitor(client, "cycle"), expected)
            client.ask(f"z0,{tick},4")
            self.assertEqual(client.ask("bc"), "T05thread:1;replaylog:begin;")
            self.assertEqual(self.monitor(client, "cycle"), "cycle 0, 0.00000000 s\n")
            self.assertEqual(client.ask("vCont;c"), "W00")
            self.assertEqual(self.digest(run.end()[1]), self.digest(self.plain()))

    def test_what_gdb_wrote_is_taken_back(self):
        with Debugged(self) as run, Client(run.port) as client:
            client.ask("vCont;s:1;c")
            client.ask("M200000,4:78563412")
            client.ask("P3=78563412")
            client.ask("vCont;s:1;c")
            client.ask("vCont;s:1;c")
            self.assertEqual(client.ask("bs"), "T05thread:1;")  # not behind the writing
            self.assertEqual(client.ask("m200000,4"), "78563412")
            self.assertEqual(client.ask("p3"), "78563412")
            self.assertEqual(client.ask("bc"), "T05thread:1;replaylog:begin;")
            self.assertEqual(client.ask("m200000,4"), "00000000")

    def test_ctrl_c_of_gdb_stops_a_run(self):
        with Debugged(self) as run, Client(run.port) as client:
            client.send("vCont;c")
            client.socket.sendall(b"\x03")
            self.assertRegex(client.receive(), "^T02thread:[12];$")
            self.assertEqual(client.ask("D"), "OK")
            self.assertEqual(self.digest(run.end()[1]), self.digest(self.plain()))

    def test_a_client_that_goes_away_leaves_the_run_for_the_next_one(self):
        with Debugged(self) as run:
            with Client(run.port) as client:
                client.ask(f"Z0,{self.symbol('armature::MotionLoop::tick()')},4")
                self.assertEqual(client.ask("vCont;c"), "T05thread:1;swbreak:;")
                at = client.ask("pf")
            with Client(run.port) as client:
                self.assertEqual(client.ask("pf"), at)
                client.send("vCont;c")  # the stop points of the session before are gone
            with Client(run.port) as client:
                self.assertRegex(client.ask("?"), "^(T02thread:[12];|W00)$")
                with contextlib.suppress(ConnectionError):
                    client.ask("vKill;1")

    def test_one_client_is_served_at_a_time(self):
        with Debugged(self) as run, Client(run.port) as client:
            client.ask("?")
            with Client(run.port) as other:
                self.assertEqual(other.socket.recv(1), b"")
            self.assertEqual(client.ask("qC"), "QC1")
            self.assertEqual(client.ask("vKill;1"), "OK")
            code, printed = run.end()
        self.assertEqual((code, printed), (130, "gdb has ended the run\n"))

    def test_what_is_no_gdb_is_closed_or_asked_again(self):
        with Debugged(self) as run:
            with Client(run.port) as page:
                page.socket.sendall(b"POST / HTTP/1.1\r\n\r\n$vKill;1#6e")
                with contextlib.suppress(ConnectionResetError):
                    self.assertEqual(page.socket.recv(1), b"")
            with Client(run.port) as client:
                client.socket.sendall(b"$qC#00")
                self.assertEqual(client.socket.recv(1), b"-")
                for wrong in ("m", "Z0", "vCont;x", "G00", "qRcmd,0", "p99"):
                    self.assertEqual(client.ask(wrong), "E01", wrong)
                self.assertEqual(client.ask("?"), "T05thread:1;")

    def test_a_waveform_is_written_between_on_and_off(self):
        with Debugged(self, TINY, *MOMENT, "--vcd", "some.vcd") as run, Client(run.port) as client:
            self.assertIn("no waveform is on", self.monitor(client, "wave off"))
            self.assertIn("some.vcd is written", self.monitor(client, "wave on"))
            client.ask(f"Z0,{self.symbol('armature::MotionLoop::tick()')},4")
            for _ in range(3):
                client.ask("vCont;c")
            self.assertIn("some.vcd is complete", self.monitor(client, "wave off"))
            times = re.findall(r"^#(\d+)", (self.folder / "some.vcd").read_text(), re.M)
            self.assertGreater(len(times), 10)
        with Debugged(self, TINY, *MOMENT) as run, Client(run.port) as client:
            self.assertIn("--vcd", self.monitor(client, "wave on"))
            self.assertIn("expected tick", self.monitor(client, "ticks"))
            self.assertIn("wave off", self.monitor(client, "help"))
            self.assertEqual(self.monitor(client, "fault"), "no fault so far\n")

    def test_ctrl_c_of_the_terminal_ends_the_program(self):
        with Debugged(self) as run:
            run.process.send_signal(signal.SIGINT)
            self.assertEqual(run.end()[0], 130)

    def test_wrong_input_is_refused(self):
        with Debugged(self) as run:
            done = self.armature("debug", TINY, "--port", run.port, code=2)
            self.assertRegex(done.stderr, rf"--port {run.port}: .*in use")
        self.assertIn("no_such_scenario", self.armature("debug", "no_such_scenario", code=2).stderr)
        self.assertIn("--port", self.armature("debug", TINY, "--port", "70000", code=2).stderr)


if __name__ == "__main__":
    if GDB is None:
        print("gdb-multiarch is not installed (tools/packages-iss.txt)")
        sys.exit(77)
    main()
