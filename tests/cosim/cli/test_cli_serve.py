"""armature serve, its clients and what its README shows."""

import os
import pathlib
import random
import re
import signal
import socket
import subprocess
import sys

from cli_program import ROOT, Program, main

CLIENT = ROOT / "cosim" / "serve" / "client"
README = (ROOT / "cosim" / "serve" / "README.md").read_text()
sys.path.insert(0, str(CLIENT))
from armature_client import MAX_IN_FLIGHT, MAX_OPERATIONS, BatchRefused, Refused, Soc  # noqa: E402

SELF_TEST = "timer 0 counts\ntimer 1 counts\nperiod 2500 cycles\n"


class Serve(Program):
    c_example = ""  # path

    def server(self, where, *more):
        """The process, with its token, and the address that it printed."""
        process, found = self.listening(r"listening on (\S+)\n$", "serve", "--listen", where, *more)
        address = found.group(1)
        process.token = None
        if not address.startswith("tcp:"):
            return process, str(self.folder / address)
        found = re.fullmatch(r"token ([0-9a-f]{32})\n", process.stdout.readline())
        self.assertTrue(found)
        process.token = found.group(1)
        return process, address

    def end(self, process, how=signal.SIGINT):
        process.send_signal(how)
        out, err = process.communicate(timeout=60)
        self.assertEqual((process.returncode, err), (130, ""))
        return out

    def connected(self, address):
        """A socket that has said nothing."""
        s = socket.socket(socket.AF_INET if address.startswith("tcp:") else socket.AF_UNIX)
        self.addCleanup(s.close)
        s.settimeout(60)
        s.connect(("127.0.0.1", int(address[4:])) if address.startswith("tcp:") else address)
        return s

    def everything(self, s):
        """What comes until the server closes the connection."""
        return b"".join(iter(lambda: s.recv(65536), b""))

    def raw(self, process, address, pieces):
        """The answers to bytes that are sent in pieces; then the sending side is closed."""
        with self.connected(address) as s:
            s.sendall(f"token {process.token}\n".encode())
            for piece in pieces:
                s.sendall(piece)
            s.shutdown(socket.SHUT_WR)
            answers = self.everything(s)
            self.assertEqual(answers[:3], b"ok\n")
            return answers[3:]

    def example(self, command, process, *more):
        """One of the examples, with the token in its environment."""
        return subprocess.run(
            [*command, *more],
            cwd=self.folder,
            text=True,
            capture_output=True,
            timeout=120,
            env=os.environ | {"ARMATURE_TOKEN": process.token or ""},
        )

    def test_both_examples_pass_the_vendors_timer_self_test_on_both_variants(self):
        for where, variant in (("tcp:0", "counts"), ("a.sock", "paper")):
            process, address = self.server(where, "--variant", variant)
            for example in ([self.c_example], [sys.executable, "-B", str(CLIENT / "timer_self_test.py")]):
                with self.subTest(example=example, variant=variant):
                    done = self.example(example, process, address)
                    self.assertEqual((done.stdout, done.stderr, done.returncode), (SELF_TEST, "", 0))
            self.end(process)

    def test_the_examples_say_when_there_is_no_server_or_no_address(self):
        for example in ([self.c_example], [sys.executable, "-B", str(CLIENT / "timer_self_test.py")]):
            self.assertNotEqual(
                subprocess.run([*example, "none.sock"], cwd=self.folder, capture_output=True).returncode, 0
            )
            done = subprocess.run(example, text=True, capture_output=True)
            self.assertNotEqual(done.returncode, 0)
            self.assertIn("usage: timer_self_test", done.stderr)

    def test_the_session_of_the_readme_is_what_the_server_answers(self):
        session = re.findall(r"^> (.*)\n< (.*)$", README, re.M)
        self.assertGreater(len(session), 8)
        process, address = self.server("tcp:0")
        commands = "".join(command + "\n" for command, _ in session)
        self.assertEqual(
            self.raw(process, address, [commands.encode()]).decode().splitlines(), [answer for _, answer in session]
        )
        self.end(process)

    def test_the_readme_has_a_row_for_every_command(self):
        rows = re.findall(r"^\| `([a-z-]+)[ `]", README, re.M)
        process, address = self.server("tcp:0")
        with Soc(address, process.token) as soc:
            commands = [usage.split()[0] for usage in soc.command("help").split(" | ")]
        self.end(process)
        self.assertEqual(list(dict.fromkeys(row for row in rows if row in commands)), commands)

    def test_the_commands_of_the_help_text_are_understood(self):
        text = self.armature("serve", "--help").stdout
        commands = re.search(r"printf '([^']+)'", text).group(1).replace("\\n", "\n")
        process, address = self.server("tcp:0", "--variant", "paper")
        answers = self.raw(process, address, [commands.encode()]).decode().splitlines()
        self.end(process)
        self.assertEqual(answers, ["ok", "ok", "ok", "ok 2548", "ok 0x1"])

    def test_the_example_with_a_token_of_the_help_text_runs_as_printed(self):
        text = self.armature("serve", "--help").stdout
        lines = re.search(r"^Over TCP .*\n((?:  .*\n)+)\n", text, re.M).group(1).splitlines()
        self.assertEqual(len(lines), 4)
        self.assertIn("nc -N 127.0.0.1 5025", lines.pop())  # not everybody has it
        with socket.create_server(("127.0.0.1", 0)) as free:
            port = str(free.getsockname()[1])
        # A slow machine needs longer than the example waits.
        script = (
            "\n".join(lines)
            .replace("5025", port)
            .replace("sleep 1;", "until grep -qs ^token serve.txt; do sleep 0.1; done;")
        )
        (self.folder / "cosim").symlink_to(ROOT / "cosim")
        (self.folder / "bin").mkdir()
        (self.folder / "bin" / "armature").symlink_to(self.path)
        script += "\nkill $!\nwait\n"
        env = os.environ | {"PATH": f"{self.folder}/bin:{os.environ['PATH']}", "PYTHONDONTWRITEBYTECODE": "1"}
        done = subprocess.run(
            ["bash", "-c", script], cwd=self.folder, env=env, text=True, capture_output=True, timeout=120
        )
        self.assertEqual((done.stdout, done.stderr), (SELF_TEST, ""))
        self.assertEqual((self.folder / "serve.txt").stat().st_mode & 0o777, 0o600)

    def test_the_same_lines_give_the_same_bytes_over_both_kinds_of_socket_in_any_pieces(self):
        seed = 7
        rng = random.Random(seed)
        lines = []
        for _ in range(3000):
            addr = rng.choice((0x42800000, 0x43C10000, 0x43C20000)) + 4 * rng.randrange(24)
            lines.append(
                rng.choice(
                    (
                        f"r {addr:#x}",
                        f"w {addr} {rng.randrange(400)}",
                        f"run {rng.randrange(50)}",
                        f"pin enc_a_i {rng.randrange(64)}",
                        "pin step_o",
                        "run-until-irq 20",
                        "time",
                    )
                )
            )
        data = "".join(line + "\n" for line in lines).encode()
        answers = []
        for where, most in (("tcp:0", len(data)), ("b.sock", len(data)), ("tcp:0", 5000), ("b.sock", 300)):
            pieces, at = [], 0
            while at < len(data):
                size = rng.randint(1, most)
                pieces.append(data[at : at + size])
                at += size
            process, address = self.server(where)
            answers.append(self.raw(process, address, pieces))
            self.end(process)
        self.assertEqual(answers[0].count(b"\n"), len(lines))
        for other in answers[1:]:
            self.assertEqual(other, answers[0], f"seed {seed}")

    def test_the_python_client_pipelines_and_reports_refusals(self):
        process, address = self.server("c.sock")
        with Soc(address, process.token) as soc:
            results = soc.pipeline(["run 1"] * (2 * MAX_IN_FLIGHT + 5) + ["r 0", "time"])
            self.assertEqual(results[:3] + results[-3:-2], ["1", "2", "3", str(2 * MAX_IN_FLIGHT + 5)])
            self.assertIsInstance(results[-2], Refused)
            self.assertRegex(str(results[-2]), "^DECERR")
            soc.write(0x43C2_0080, 0x00FF_FFFF, strobes=1)
            self.assertEqual(soc.read(0x43C2_0080), 0x27FF)
            self.assertEqual(soc.pin("home_i", 3), 3)
            self.assertEqual(soc.pin("home_i"), 3)
            with self.assertRaisesRegex(Refused, "^no interrupt within 5 cycles"):
                soc.run_until_irq(5)
            with self.assertRaises(ValueError):
                soc.command("time\ntime")
            self.assertEqual(soc.run(0), soc.time())
            self.end(process)
            with self.assertRaises(OSError):
                soc.time()

    def test_the_python_client_sends_batches_and_says_which_operations_were_executed(self):
        for engine in ("rtl", "model"):
            with self.subTest(engine):
                process, address = self.server("k.sock", "--engine", engine)
                with Soc(address) as soc:
                    self.assertEqual(soc.batch([]), [])
                    count = MAX_OPERATIONS + 10
                    self.assertEqual(soc.batch(["run 1"] * count), list(range(1, count + 1)))
                    operations = ["w 0x42800004 7", "r 0x42800004", "pin step_o", "run-until-irq 5", "time"]
                    with self.assertRaisesRegex(BatchRefused, "^no interrupt within 5 cycles$") as refused:
                        soc.batch(["time"] * MAX_OPERATIONS + operations)
                    self.assertEqual(refused.exception.index, MAX_OPERATIONS + 3)
                    self.assertEqual(refused.exception.results[MAX_OPERATIONS:], [None, 7, 0])
                    self.assertEqual(soc.time(), count + 19 + 18 + 5)
                    with self.assertRaises(ValueError):
                        soc.batch(["time;time"])
                self.end(process)

    def test_an_interrupt_closes_the_waveform_and_removes_the_socket(self):
        for how in (signal.SIGINT, signal.SIGTERM):
            process, address = self.server("d.sock", "--out", "waves")
            with Soc(address, process.token) as soc:
                soc.vcd("w.vcd")
                soc.run(1000)
                self.assertTrue(pathlib.Path(address).is_socket())
                out = self.end(process, how)
            self.assertRegex(out, r"^2 lines of 1 clients answered, cycle 1000\n$")
            self.assertFalse(pathlib.Path(address).exists())
            text = (self.folder / "waves" / "w.vcd").read_text()
            self.assertEqual(re.findall(r"^#(\d+)", text, re.M)[-1], "20010")
            self.assertTrue(text.endswith("\n"))

    def test_an_interrupt_ends_a_long_run(self):
        process, address = self.server("tcp:0")
        with socket.create_connection(("127.0.0.1", int(address[4:]))) as s:
            s.sendall(f"token {process.token}\nrun 1\n".encode())
            answers = b""
            while not answers.endswith(b"ok 1\n"):
                answers += s.recv(100)
            s.sendall(b"run 1000000000\n")
            self.assertRegex(self.end(process), "answered, cycle ")
            try:
                self.assertRegex(s.recv(100), rb"^(error interrupted at cycle \d+\n)?$")
            except ConnectionResetError:
                pass  # the signal was there before the line

    def test_bad_input_is_refused_with_its_reason(self):
        precious = self.text("precious", "keep")
        process, address = self.server("e.sock")
        tcp, port = self.server("tcp:0")
        for arguments, reason in (
            ([], "--listen is required"),
            (["--listen", "tcp:70000"], "--listen tcp:70000: expected a port 0..65535"),
            (["--listen", "tcp:abc"], "--listen tcp:abc: expected a port 0..65535"),
            (["--listen", "udp:5"], "--listen udp:5: expected tcp:PORT or the path of a Unix socket"),
            (["--listen", "g.sock", "--out", precious], "--out precious: cannot use the folder: Not a directory"),
            (["--listen", precious], "--listen precious: exists and is not a socket; it stays unchanged"),
            (["--listen", "e.sock"], "--listen e.sock: another server listens there"),
            (["--listen", port], f"--listen {port}: cannot listen: Address already in use"),
            (["--listen", "no/folder.sock"], "--listen no/folder.sock: cannot create the socket: No such file"),
            (["--listen", "f.sock", "--variant", "fpga"], "fpga not in {counts,paper}"),
            (["--listen", "f.sock", "--fabric", "paper"], "--fabric: write --variant paper"),
        ):
            with self.subTest(arguments):
                done = self.armature("serve", *arguments, code=2)
                self.assertIn(reason, done.stderr)
                self.assertEqual(done.stdout, "")
        self.assertEqual((self.folder / precious).read_text(), "keep")
        self.assertEqual(sorted(path.name for path in self.folder.iterdir()), ["e.sock", precious])
        self.end(process)
        self.end(tcp)

    def test_a_path_with_a_colon_is_one_after_a_slash(self):
        process, address = self.server("./udp:5")
        with Soc(address) as soc:
            self.assertEqual(soc.time(), 0)
        self.end(process)

    def test_nothing_of_an_http_request_is_carried_out(self):
        process, address = self.server("tcp:0", "--out", "waves")
        body = b"vcd x.vcd\nrun 100\nvcd\n"
        for request in (
            b"POST / HTTP/1.1\r\nHost: 127.0.0.1:%s\r\nUser-Agent: curl/7.88.1\r\nAccept: */*\r\n"
            b"Content-Length: %d\r\nContent-Type: application/x-www-form-urlencoded\r\n\r\n%s"
            % (address[4:].encode(), len(body), body),
            body,
        ):
            with self.connected(address) as s:
                s.sendall(request)
                self.assertRegex(self.everything(s), rb"^error the first line must be 'token TOKEN'[^\n]*\n$")
        with Soc(address, process.token) as soc:
            self.assertEqual(soc.time(), 0)
        self.assertEqual(list((self.folder / "waves").iterdir()), [])
        self.assertIn("1 lines of 1 clients", self.end(process))

    def test_each_start_has_another_token_and_only_that_is_taken(self):
        first, address = self.server("tcp:0")
        second, _ = self.server("tcp:0")
        self.assertNotEqual(first.token, second.token)
        for command in ([self.c_example], [sys.executable, "-B", str(CLIENT / "timer_self_test.py")]):
            done = self.example(command, second, address)
            self.assertNotEqual(done.returncode, 0)
            self.assertIn("wrong token", done.stderr)
        self.end(first)
        self.end(second)

    def test_the_second_client_is_told_that_the_server_is_busy(self):
        for where in ("tcp:0", "h.sock"):
            process, address = self.server(where)
            with self.subTest(where), Soc(address, process.token) as idle:
                self.assertEqual(
                    self.everything(self.connected(address)),
                    b"error busy: another client is served, one at a time; closed\n",
                )
                for command in ([self.c_example], [sys.executable, "-B", str(CLIENT / "timer_self_test.py")]):
                    done = self.example(command, process, address)
                    self.assertNotEqual(done.returncode, 0)
                    self.assertIn("busy: another client is served", done.stderr)
                self.assertEqual(idle.time(), 0)
            self.end(process)

    def test_a_client_that_is_killed_during_a_long_run_frees_the_server(self):
        # The answer to the first run comes when the server begins with the second.
        script = (
            "import socket, sys\n"
            "s = socket.socket(socket.AF_INET if sys.argv[1] == '127.0.0.1' else socket.AF_UNIX)\n"
            "s.connect((sys.argv[1], int(sys.argv[2])) if len(sys.argv) > 2 else sys.argv[1])\n"
            "s.sendall(sys.stdin.readline().encode() + b'run 60000\\nrun 1000000000\\n')\n"
            "for line in s.makefile(): print(line, end='', flush=True)\n"
        )
        for where in ("tcp:0", "i.sock"):
            process, address = self.server(where)
            place = ["127.0.0.1", address[4:]] if where == "tcp:0" else [address]
            client = subprocess.Popen(
                [sys.executable, "-c", script, *place], text=True, stdin=subprocess.PIPE, stdout=subprocess.PIPE
            )
            with self.subTest(where), client:
                client.stdin.write(f"token {process.token}\n")
                client.stdin.flush()
                self.assertEqual([client.stdout.readline() for _ in range(2)], ["ok\n", "ok 60000\n"])
                client.kill()
                client.wait()
                with Soc(address, process.token) as soc:
                    self.assertLess(soc.time(), 500_000_000)
            self.end(process)

    def test_a_waveform_is_written_below_the_folder_of_out_only(self):
        outside = self.text("outside.vcd", "keep")
        process, address = self.server("j.sock", "--out", "waves")
        with Soc(address) as soc:
            for name in ("../outside.vcd", str(self.folder / outside), "../new.vcd"):
                with self.assertRaisesRegex(Refused, "below the folder of --out"):
                    soc.vcd(name)
            soc.vcd("w.vcd")
            soc.run(10)
            soc.vcd()
        self.end(process)
        self.assertEqual((self.folder / outside).read_text(), "keep")
        self.assertIn("$enddefinitions", (self.folder / "waves" / "w.vcd").read_text())
        process, address = self.server("j.sock")
        with Soc(address) as soc, self.assertRaisesRegex(Refused, "--out DIR"):
            soc.vcd("w.vcd")
        self.end(process)


if __name__ == "__main__":
    Serve.c_example = os.path.abspath(sys.argv.pop(2))
    main()
