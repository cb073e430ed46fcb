"""The register file that tools/reggen writes for the example, simulated by Icarus; the testbench finds seeded faults."""

import pathlib
import sys
import tempfile
import unittest

from generator_tree import ROOT, run
from reggen_tree import EXAMPLE

sys.path.insert(0, str(ROOT / "tools"))
from flat_ports import flat_module  # noqa: E402

HEADERS = ROOT / "rtl/common"
TESTBENCH = pathlib.Path(__file__).resolve().parent / "reg_top_tb.sv"


# Faults of the example register file; the testbench must find each of them.
FAULTS = [
    ("reset value", "ctrl_limit_q   <= 16'hBEEF;", "ctrl_limit_q   <= 16'hBEEE;"),
    ("reset of an array", "{3{-12'd5}}", "{{2{-12'd5}}, 12'd5}"),
    ("byte strobe ignored", "if (wstrb[1]) ctrl_limit_q", "if (1'b1) ctrl_limit_q"),
    ("wrong byte strobe", "if (wstrb[2]) ctrl_limit_q", "if (wstrb[3]) ctrl_limit_q"),
    ("byte strobe of an array", "if (wstrb[1]) gain_value_q", "if (wstrb[0]) gain_value_q"),
    ("element index on write", "gain_value_q[12*i +: 8]", "gain_value_q[12*(i % 2) +: 8]"),
    ("element index on read", "level_value[32*i +: 32]", "level_value[0 +: 32]"),
    ("read of a wrong field", "16'b0, go_sequence_q}", "16'b0, ctrl_limit_q}"),
    ("write error missing", "default: werr_q <= 1'b1;", "default: werr_q <= 1'b0;"),
    ("write error sticks", "werr_q <= 1'b0;\n        case", "case"),
    ("write to ro accepted", "16'h0048: ;", "16'h0008, 16'h0048: ;"),
    ("write to const accepted", "16'h0048: ;", "16'h0000, 16'h0048: ;"),
    ("write to external ro accepted", "16'h0048: ;", "16'h004C, 16'h0048: ;"),
    (
        "write past an array accepted",
        "16'h0020, 16'h0024, 16'h0028: begin",
        "16'h0020, 16'h0024, 16'h0028, 16'h002C: begin",
    ),
    ("read error missing", "rerr_q  <= 1'b1;", "rerr_q  <= 1'b0;"),
    ("read error sticks", "rerr_q <= 1'b0;\n      case", "case"),
    ("unmapped data", "32'hBADACCE5", "32'h0"),
    ("upper address bits ignored on write", "{reg_i.waddr[15:2], 2'b00}", "{4'b0, reg_i.waddr[11:2], 2'b00}"),
    ("upper address bits ignored on read", "{reg_i.raddr[15:2], 2'b00}", "{4'b0, reg_i.raddr[11:2], 2'b00}"),
    (
        "byte address decoded on write",
        "assign waddr       = {reg_i.waddr[15:2], 2'b00}",
        "assign waddr       = reg_i.waddr",
    ),
    (
        "byte address decoded on read",
        "assign raddr       = {reg_i.raddr[15:2], 2'b00}",
        "assign raddr       = reg_i.raddr",
    ),
    ("read data not held", "end else if (re) begin", "end else begin"),
    ("write without strobe", "if (we) begin\n        werr_q", "begin\n        werr_q"),
    ("event lost while idle", "event_lost_q  <= event_lost_q | event_lost_set;", "event_lost_q  <= event_lost_q;"),
    ("event not sticky", "event_over_q  <= event_over_q | event_over_set;", "event_over_q  <= event_over_set;"),
    ("clear wins", "(event_over_q & ~wdata[0]) | event_over_set;", "(event_over_q & ~wdata[0]);"),
    (
        "clear wins in an array",
        "(alarm_lines_q[4*i + 1 +: 3] & ~wdata[10:8]) |",
        "(alarm_lines_q[4*i + 1 +: 3] & ~wdata[10:8]) &",
    ),
    ("clears all flags", "(event_lost_q[3:0] & ~wdata[7:4])", "4'b0"),
    ("write 0 clears", "(mixed_hit_q & ~wdata[16])", "(mixed_hit_q & wdata[16])"),
    ("clear ignores byte strobe", "if (wstrb[0]) event_over_q", "if (1'b1) event_over_q"),
    ("pulse stays", "kick_now_q    <= '0;\n      kick_axis_q", "kick_axis_q"),
    ("pulse ignores byte strobe", "if (wstrb[0]) kick_now_q", "if (1'b1) kick_now_q"),
    ("pulse reads back", "rdata_q <= 32'b0;  // KICK", "rdata_q <= 32'b1;  // KICK"),
    ("pulse of the wrong element", "fire_line_q[2*i +: 2]", "fire_line_q[0 +: 2]"),
    ("strobe stays", "go_we_q       <= '0;\n      slot_we_q", "slot_we_q"),
    ("strobe without a byte", "go_we_q <= |wstrb;", "go_we_q <= 1'b1;"),
    ("strobe of all elements", "slot_we_q[i] <= |wstrb;", "slot_we_q <= 2'b11;"),
    ("lock without effect", "locked = protect_i && !key_unlocked_q;", "locked = 1'b0;"),
    ("locked without protection", "locked = protect_i && !key_unlocked_q;", "locked = !key_unlocked_q;"),
    ("key without effect", "locked = protect_i && !key_unlocked_q;", "locked = protect_i;"),
    ("key by bytes", "wstrb == 4'hF && wdata", "wstrb[3] && wdata"),
    ("key without its last bit", "wdata == 32'h0BAD_C0DE", "wdata[31:1] == 31'h05D6_E06F"),
    ("key stays", "key_unlocked_q <= wstrb", "key_unlocked_q <= key_unlocked_q || wstrb"),
    ("key unlocked by reset", "key_unlocked_q <= '0;", "key_unlocked_q <= '1;"),
    (
        "locked write is okay",
        "MIXED, protected\n            if (locked) werr_q <= 1'b1;",
        "\n if (locked) werr_q <= 1'b0;",
    ),
    ("locked write to an array is okay", "SLOT[2], protected\n            if (locked) werr_q", "\n if (locked) rerr_q"),
    ("external write strobe without write", "if (we) begin\n      core_we", "begin\n      core_we"),
    ("external write strobe of any register", "core_we = waddr == 16'h0048", "core_we = 1'b1"),
    ("external read strobe without read", "if (re) begin\n      core_re", "begin\n      core_re"),
    ("external read strobe of another register", "core_re  = raddr == 16'h0048", "core_re  = 1'b1"),
    ("external byte strobes", "assign reg2hw_o.wstrb       = wstrb", "assign reg2hw_o.wstrb       = 4'hF"),
]


class Simulation(unittest.TestCase):
    def simulate(self, design):
        """The last line of the testbench."""
        with tempfile.TemporaryDirectory() as scratch:
            source = pathlib.Path(scratch) / "example_reg_top.sv"
            program = pathlib.Path(scratch) / "tb.vvp"
            source.write_text(design)
            flat = source.with_name("example_reg_top_flat.sv")
            headers = [EXAMPLE / "rtl/common", HEADERS]
            flat.write_text(flat_module(design, headers))
            compiled = run(
                "iverilog",
                "-g2012",
                "-s",
                "reg_top_tb",
                "-o",
                program,
                *(f"-I{path}" for path in headers),
                source,
                flat,
                TESTBENCH,
            )
            self.assertEqual(compiled.returncode, 0, compiled.stderr)
            return run("vvp", "-n", program).stdout

    def setUp(self):
        self.design = (EXAMPLE / "rtl/example/example_reg_top.sv").read_text()

    def test_the_register_file_behaves(self):
        log = self.simulate(self.design)
        self.assertRegex(log, r"\Areg_top_tb: [1-9]\d+ checks, 0 failed\n\Z")

    def test_the_testbench_finds_every_seeded_fault(self):
        for what, old, new in FAULTS:
            with self.subTest(what):
                before, found, after = self.design.partition(old)
                self.assertTrue(found, f"`{old}` is not in the design")
                self.assertRegex(self.simulate(before + new + after), r"checks, [1-9]\d* failed\n\Z")


if __name__ == "__main__":
    unittest.main()
