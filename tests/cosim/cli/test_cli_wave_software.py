"""The signals of the software in waveforms, compared with the pins of the logic and the results of the run."""

import json
import re
import subprocess

from cli_program import BRIEF, SCENARIOS, TINY, Program, main
from vcd import Vcd

CLOCK_NS = 20
TICK_NS = 50_000
ANSWER_NS = 10 * CLOCK_NS  # the way of an answer to the core takes 6 clocks, and the next access longer
WINDOW = ("--from", "0.0119", "--to", "0.0122")

PROGRAM = """description = "d"
robot = "abb_irb120"
duration_s = 0.2
program = "part.ngc"
program_at_s = 0.12
[[move]]
at_s = 0
type = "joint"
target_deg = [0, 0, 0, 0, 5, 0]
"""

PENDANT = """description = "d"
robot = "abb_irb120"
duration_s = 0.03
[pendant]
[[pendant.step]]
command = "heartbeat"
parameter = 1
payload = 7
[[pendant.step]]
command = "get_status"
[[pendant.step]]
command = "servo"
parameter = 1
[expect]
faults = ["drives_off"]
"""
CHARACTER_S = 10 / 115200  # of the pendant's line
PAUSE_S = 4 * CHARACTER_S
SERIAL_CHARACTERS = 32


def serial_texts(rows, direction):
    """What the signal of this direction must show, by serial.csv: [(time in ns, text)]."""
    texts, characters, last_s = [], [], None
    for row in rows:
        if row["direction"] != direction:
            continue
        at_s = float(row["time_s"])
        if last_s is not None and at_s - last_s - CHARACTER_S > PAUSE_S:
            characters = []
        last_s = at_s
        characters.append(row["char"])
        while len("".join(characters)) > SERIAL_CHARACTERS:
            characters.pop(0)
        texts.append((round(at_s * 1e9) + CLOCK_NS, "".join(characters)))
    return texts


class SoftwareSignals(Program):
    def run_tiny(self, *options, scenario=TINY, code=0):
        self.armature("run", scenario, "--vcd", "w.vcd", "--out", "out", *options, *BRIEF, code=code)
        self.result = json.loads((self.folder / "out/summary.json").read_text())["result"]
        return Vcd((self.folder / "w.vcd").read_text())

    def window(self):
        """The waveform of six ticks, and the trace of their run with every tick."""
        every_tick = ("--set", "trace.every_ticks=1")
        return self.once("window", lambda: (self.run_tiny(*WINDOW, *every_tick), self.rows("out/trace.csv")))

    def test_every_access_is_that_of_the_bus_at_the_same_time(self):
        vcd, _ = self.window()
        writes, reads = vcd.rises("top.s_axi_awvalid_i"), vcd.rises("top.s_axi_arvalid_i")
        self.assertGreater(len(writes), 30)
        self.assertGreater(len(reads), 50)
        for times, is_write, pin in ((writes, 1, "top.s_axi_awaddr_i"), (reads, 0, "top.s_axi_araddr_i")):
            for time in times:
                self.assertEqual(vcd.at("top.software.bus_busy", time), 1, time)
                self.assertEqual(vcd.at("top.software.bus_write", time), is_write, time)
                self.assertEqual(vcd.at("top.software.bus_address", time), vcd.at(pin, time), time)
                core = vcd.at("top.software.bus_core", time)
                self.assertEqual(vcd.text_at(f"top.software.core{core}", time), "bus", time)
        for time in writes:
            self.assertEqual(vcd.at("top.software.bus_write_data", time), vcd.at("top.s_axi_wdata_i", time), time)

    def test_a_read_gives_what_the_logic_answered(self):
        vcd, _ = self.window()
        answers = [time for time in vcd.rises("top.s_axi_rvalid_o") if time + ANSWER_NS < vcd.times[-1]]
        self.assertGreater(len(answers), 50)
        for time in answers:
            read = vcd.at("top.software.bus_read_data", time + ANSWER_NS)
            self.assertEqual(read, vcd.at("top.s_axi_rdata_o", time), time)

    def test_registers_have_the_names_of_their_addresses(self):
        vcd, _ = self.window()
        starts = vcd.rises("top.s_axi_awvalid_i") + vcd.rises("top.s_axi_arvalid_i")
        names = {
            vcd.at("top.software.bus_address", time): vcd.text_at("top.software.bus_register", time) for time in starts
        }
        self.assertEqual(names[0x4280_0000], "axi_timer.tcsr0")
        self.assertIn("pulse_train.commit", names.values())
        for axis in range(6):
            base = next(address for address, name in names.items() if name == "encoder.position[0]")
            self.assertEqual(names[base + 4 * axis], f"encoder.position[{axis}]")
        self.assertNotIn("", names.values())

    def test_the_tick_is_that_of_the_trigger_and_of_the_trace(self):
        vcd, rows = self.window()
        triggers = vcd.rises("top.trigger_o")
        self.assertGreater(len(triggers), 4)
        ticks = {round(float(row["time_s"]) * 1e9): int(row["tick"]) for row in rows}
        for time in triggers:
            self.assertEqual(vcd.at("top.software.tick", time + CLOCK_NS), ticks[time])
            self.assertEqual(vcd.at("top.software.tick", time), ticks[time] - 1)
        self.assertEqual([time - CLOCK_NS for time, _ in vcd.changes["top.software.tick"][1:]], triggers)

    def test_a_core_computes_after_its_interrupt_and_then_waits(self):
        vcd, _ = self.window()
        states = dict(vcd.texts("top.software.core0"))
        self.assertEqual(set(states.values()), {"waiting", "computing", "bus"})
        for time in vcd.rises("top.trigger_o")[:-1]:
            begins = min(at for at, state in states.items() if at > time and state == "computing")
            self.assertLessEqual(begins - time, 10 * CLOCK_NS)
            sleeps = min(at for at, state in states.items() if at > time and state == "waiting")
            self.assertLess(sleeps - time, TICK_NS)
        self.assertLessEqual({state for _, state in vcd.texts("top.software.core1")}, {"waiting", "computing", "bus"})

    def test_move_and_motion_are_those_of_the_results(self):
        self.armature("run", TINY, "--out", "out", *BRIEF)
        move = json.loads((self.folder / "out/summary.json").read_text())["result"]["moves"][-1]
        at_s = move["start_tick"] * 50e-6
        vcd = self.run_tiny("--from", f"{at_s - 60e-6}", "--to", f"{at_s + 110e-6}")
        seen = [
            (vcd.text_at("top.software.move", time), vcd.text_at("top.software.move_type", time)) for time in vcd.times
        ]
        self.assertEqual(list(dict.fromkeys(seen)), [("", ""), (f"move[{move['move']}]", move["kind"])])
        begins = vcd.changes["top.software.move"][1][0]
        self.assertEqual(vcd.at("top.software.tick", begins), move["start_tick"])
        self.assertEqual([state for _, state in vcd.texts("top.software.motion")], ["idle", "moving"])

    def test_the_program_is_at_the_line_that_the_log_has(self):
        (self.folder / "s").mkdir()
        (self.folder / "s/part.ngc").write_text("G21 G91 F6000\nG1 Z-1\nG1 Z-1\nG4 P0.01\nM2\n")
        (self.folder / "s/scenario.toml").write_text(PROGRAM)
        run = ("run", "s", "--path", SCENARIOS, "--out", "out")
        self.armature(*run)
        seen = r"^info: \[(\S+) s\] (line \d+ of part\.ngc) interpreted$"
        lines = {
            (round(float(at_s) * 1e6), line)
            for at_s, line in re.findall(seen, (self.folder / "out/log.txt").read_text(), re.M)
        }
        first_us = min(at_us for at_us, _ in lines)
        window = ("--from", f"{(first_us - 20) / 1e6}", "--to", f"{(first_us + 300) / 1e6}")
        self.armature(*run, "--vcd", "w.vcd", *window)
        (_, before), *changes = Vcd((self.folder / "w.vcd").read_text()).texts("top.software.program")
        self.assertEqual(before, "")
        self.assertGreater(len(changes), 1)
        self.assertLessEqual({(round((at - CLOCK_NS) / 1e3), line) for at, line in changes}, lines)

    def test_the_first_fault_is_that_of_the_summary(self):
        scenario = self.copy_of(TINY)
        with (scenario / "scenario.toml").open("a") as file:
            file.write('\n[[fault]]\nat_s = 0.012\nkind = "estop"\nduration_s = 0.001\n')
        vcd = self.run_tiny("--from", "0.0119", "--to", "0.0121", scenario=scenario, code=1)
        first = self.result["faults"][0]
        at = (first["cycle"] + 1) * CLOCK_NS
        self.assertEqual(vcd.texts("top.software.fault"), [(vcd.times[0], ""), (at, first["cause"])])
        self.assertEqual(vcd.at("top.software.fault_axis", at), first["axis"])
        self.assertEqual(vcd.at("top.software.tick", at) + 1, first["tick"], "the next row of the trace shows it")
        self.assertEqual(vcd.text_at("top.software.motion", at + TICK_NS), "fault")

    def test_a_window_that_begins_later_knows_the_fault(self):
        scenario = self.copy_of(TINY)
        with (scenario / "scenario.toml").open("a") as file:
            file.write('\n[[fault]]\nat_s = 0.012\nkind = "estop"\nduration_s = 0.001\n')
        vcd = self.run_tiny("--from", "0.0125", "--to", "0.0126", scenario=scenario, code=1)
        self.assertEqual(vcd.text_at("top.software.fault", vcd.times[0]), self.result["faults"][0]["cause"])

    def run_pendant(self, engine, *window):
        """The waveform of a pendant's run, and the rows of its serial.csv."""
        (self.folder / "s").mkdir(exist_ok=True)
        (self.folder / "s/scenario.toml").write_text(PENDANT)
        options = ("--path", SCENARIOS, "--out", "out", "--engine", engine, "--vcd", "w.vcd", *window)
        self.armature("run", "s", *options)
        return Vcd((self.folder / "w.vcd").read_text()), self.rows("out/serial.csv")

    def test_the_serial_texts_are_the_characters_of_serial_csv(self):
        vcd, rows = self.run_pendant("model")
        for direction, name in (("rx", "serial_in"), ("tx", "serial_out")):
            wanted = serial_texts(rows, direction)
            self.assertGreater(len(wanted), 20)
            self.assertGreater(len([text for _, text in wanted if len(text) == 1 or text.count("\\x") == 1]), 2)
            self.assertEqual(vcd.texts(f"top.software.{name}"), [(vcd.times[0], ""), *wanted])

    def test_the_serial_texts_of_both_engines_are_equal_also_in_a_window_that_begins_later(self):
        _, rows = self.run_pendant("model")
        third_s = [float(row["time_s"]) for row in rows if row["direction"] == "tx"][2]
        window = ("--from", f"{third_s - 0.5 * CHARACTER_S}", "--to", f"{third_s + 1.5 * CHARACTER_S}")
        rtl, model = (self.run_pendant(engine, *window)[0] for engine in ("rtl", "model"))
        for name in ("top.software.serial_in", "top.software.serial_out"):
            self.assertEqual(rtl.texts(name), model.texts(name))
        shown = [text for _, text in model.texts("top.software.serial_out")]
        self.assertEqual(shown, [text for _, text in serial_texts(rows, "tx")[1:4]])

    def test_the_paper_variant_has_the_registers_of_its_own_blocks(self):
        vcd = self.run_tiny("--from", "0.0202", "--to", "0.0204", "--variant", "paper")
        names = {name for _, name in vcd.texts("top.software.bus_register")}
        self.assertIn("pulse_width.width[5]", names)
        self.assertEqual([name for name in names if name.startswith("pulse_train")], [])

    def test_vcd_and_fst_have_the_same_changes(self):
        window = ("--from", "0.012", "--to", "0.01205")
        self.run_tiny(*window)
        self.armature("run", TINY, "--fst", "w.fst", *window, *BRIEF)
        back = subprocess.run(["fst2vcd", "w.fst"], cwd=self.folder, text=True, capture_output=True, check=True).stdout
        vcd, fst = Vcd((self.folder / "w.vcd").read_text()), Vcd(back)
        self.assertEqual(vcd.times, fst.times)
        self.assertTrue("top.software.bus_register" in vcd.changes)
        self.assertEqual(vcd.changes.keys() ^ fst.changes.keys(), set())
        self.assertEqual([name for name, changes in vcd.changes.items() if fst.changes[name] != changes], [])

    def test_two_runs_write_the_same_bytes(self):
        for option, name in (("--vcd", "w.vcd"), ("--fst", "w.fst")):
            written = []
            for _ in range(2):
                self.armature("run", TINY, option, name, *WINDOW, *BRIEF)
                written.append((self.folder / name).read_bytes())
            self.assertEqual(written[0], written[1], name)

    def test_a_waveform_changes_no_result(self):
        results = []
        for options in ((), ("--vcd", "w.vcd", *WINDOW)):
            self.armature("run", TINY, "--out", "out", *options, *BRIEF)
            summary = json.loads((self.folder / "out/summary.json").read_text())
            results.append(
                (summary["result"], *((self.folder / "out" / name).read_bytes() for name in ("trace.csv", "log.txt")))
            )
        self.assertEqual(results[0], results[1])


if __name__ == "__main__":
    main()
