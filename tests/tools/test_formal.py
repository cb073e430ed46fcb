"""tools/formal: what a proof of a small counter finds, and what makes it fail. Each break must really be selected."""

import importlib.util
import pathlib
import sys
import tempfile
import unittest
from dataclasses import replace

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tools/formal"))
import broken  # noqa: E402
import gates  # noqa: E402
from digest import digest  # noqa: E402
from engine import Question, counterexample, counterexamples  # noqa: E402
from proofs import Break, Proof, all_proofs  # noqa: E402
from synthesis import PROVED, REACHED, Failure  # noqa: E402

spec = importlib.util.spec_from_file_location("formal", ROOT / "tools/formal/__main__.py")
formal = importlib.util.module_from_spec(spec)
sys.modules["formal"] = formal
spec.loader.exec_module(formal)

COUNTER = """module counter (
  input  logic       clk_i,
  input  logic       rst_ni,
  input  logic       run_i,
  output logic [3:0] count_o
);
  localparam logic [3:0] Last = 4'd9;
  logic wraps;
  assign wraps = count_o >= Last;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) count_o <= '0;
    else if (run_i) count_o <= wraps ? '0 : count_o + 4'd1;
  end
endmodule
"""
# Two counters: a break is in both.
PROOF = """`include "assert.svh"
module counter_proof (
  input wire clk_i,
  input wire rst_ni,
  input wire run_i
);
  logic [3:0] count, other, count_q;
  counter u_count (.clk_i, .rst_ni, .run_i, .count_o(count));
  counter u_other (.clk_i, .rst_ni, .run_i, .count_o(other));
  always_ff @(posedge clk_i) count_q <= rst_ni && run_i ? count : '0;
  `RESET_FIRST
  `ASSERT(InRange, count <= 4'd9)
  `ASSERT(BothAreEqual, count == other)
  `ASSERT(CountsUp, count_q == '0 || count == count_q + 4'd1 || count == '0)
  `REACH(Four, count == 4'd4)
  `REACH(Last, count == 4'd9)
endmodule
"""
WRAPS_LATE = ("wraps_late", "count_o >= Last", "count_o > Last", "InRange")
SKIPS = ("skips", "count_o + 4'd1", "count_o + 4'd3", "CountsUp")
CONSTANT = ("last_is_12", "4'd9;", "4'd12;", "InRange")


class Formal(unittest.TestCase):
    def setUp(self):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.folder = pathlib.Path(scratch.name)
        self.counter = self.folder / "counter.sv"

    def proof(self, *breaks, counter=COUNTER, proof=PROOF):
        self.counter.write_text(counter)
        source = self.folder / "counter_proof.sv"
        source.write_text(proof)
        found = [Break(name, self.counter, old, new, rule) for name, old, new, rule in breaks]
        return Proof("counter", "counter_proof", [self.counter, source], breaks=found)

    def prove(self, *breaks, **texts):
        return formal._prove(self.proof(*breaks, **texts), self.folder / "work")

    def fails(self, message, *breaks, **texts):
        with self.assertRaisesRegex(Failure, message):
            self.prove(*breaks, **texts)

    def woven(self, *breaks):
        """The woven design, and the inputs that select each number: 0 and the breaks in order."""
        proof = self.proof(*breaks)
        folder = self.folder / "woven"
        folder.mkdir()
        design = formal._design(proof, folder, broken.woven_sources(proof.breaks, folder))
        numbers = [0, *(broken.as_mutant(one).number for one in proof.breaks)]
        return design, [broken.selection(design, number) for number in numbers]

    def test_proof_that_passes(self):
        self.assertEqual(self.prove(WRAPS_LATE, SKIPS), "3 proved, 2 reached, 2 broken copies refuted")

    def test_break_of_a_constant_has_its_own_design(self):
        text = "3 proved, 2 reached, 2 broken copies refuted (1 in a design of its own)"
        self.assertEqual(self.prove(WRAPS_LATE, CONSTANT), text)

    def test_number_0_selects_no_break(self):
        design, (nothing, *_) = self.woven(WRAPS_LATE, SKIPS)
        for number in design.numbers(PROVED):
            self.assertIsNone(counterexample(design, Question([number], nothing), 10))

    def test_number_selects_its_break_only_and_in_every_instance(self):
        design, (_, late, skips) = self.woven(WRAPS_LATE, SKIPS)
        self.assertEqual(len(late), 2 * broken.BITS)

        def refuted(selected):
            names = ("InRange", "BothAreEqual", "CountsUp")
            return [name for name in names if counterexample(design, Question(design.matching(name), selected), 10)]

        self.assertEqual(refuted(late), ["InRange"])
        self.assertEqual(refuted(skips), ["CountsUp"])

    def test_replay_uses_the_selected_break(self):
        design, (nothing, late, _) = self.woven(WRAPS_LATE, SKIPS)
        numbers = design.matching("InRange")
        run = counterexample(design, Question(numbers, late), 10)
        stimulus = [values[1 : 1 + design.aiger.inputs] for values in run]
        self.assertIsNotNone(design.aiger.replay(stimulus, numbers, late))
        self.assertIsNone(design.aiger.replay(stimulus, numbers, nothing))

    def test_short_and_long_runs_are_found_together(self):
        design = formal._design(self.proof(), self.folder / "healthy")
        four, last = design.numbers(REACHED)
        runs = counterexamples(design, [Question([last]), Question([four]), Question(design.matching("InRange"))], 10)
        self.assertEqual([run and len(run) for run in runs], [11, 6, None])

    def test_assertion_that_fails_is_named(self):
        self.fails("InRange.proved fails in clock 11", SKIPS, counter=COUNTER.replace(">=", ">"))

    def test_reach_that_cannot_be_reached_is_named(self):
        proof = PROOF.replace("`REACH(Last, count == 4'd9)", "`REACH(Last, count == 4'd10)")
        self.fails("Last.reached: not reachable", SKIPS, proof=proof)

    def test_break_that_is_harmless_fails(self):
        harmless = ("harmless", "count_o >= Last", "count_o == Last", "InRange")
        self.fails("broken copy harmless: InRange is true, expected to be refuted", SKIPS, harmless)

    def test_break_that_another_assertion_refutes_fails(self):
        self.fails("broken copy wraps_late: CountsUp is true", (*WRAPS_LATE[:3], "CountsUp"))

    def test_break_in_a_module_that_the_design_does_not_use_fails(self):
        unused = COUNTER + COUNTER.replace("module counter", "module unused").replace("4'd1;", "4'd2;")
        self.fails("broken copy skips: CountsUp is true", ("skips", "4'd2;", "4'd3;", "CountsUp"), counter=unused)

    def test_weaving_that_breaks_number_0_fails(self):
        weave = broken.weave
        self.addCleanup(setattr, broken, "weave", weave)
        broken.weave = lambda *arguments: weave(*arguments).replace(
            "begin\nwraps = count_o >=", "begin\nwraps = count_o >"
        )
        self.fails("broken copy wraps_late: InRange fails without the break too", WRAPS_LATE)

    def test_text_that_is_not_there_once_fails(self):
        self.fails("broken copy x: 0 matches in counter.sv: count_o - 1", ("x", "count_o - 1", "0", "InRange"))
        self.fails("broken copy x: 2 matches in counter.sv:  Last", ("x", " Last", " 4'd8", "InRange"))

    def test_breaks_with_the_same_number_fail(self):
        self.fails("broken copy skips: rename it, its number is that of skips", SKIPS, ("skips", *WRAPS_LATE[1:]))

    def test_unknown_assertion_fails(self):
        self.fails("broken copy skips: there is no assertion Absent", (*SKIPS[:3], "Absent"))

    def test_file_that_the_proof_does_not_read_fails(self):
        proof = self.proof(SKIPS)
        proof.sources.remove(self.counter)
        with self.assertRaisesRegex(Failure, "broken copy skips: the proof does not read counter.sv"):
            broken.refute(proof, self.folder, None, 10)

    def test_proof_without_a_break_fails(self):
        self.fails("0 broken copies: a proof needs at least one of each")


class Digests(unittest.TestCase):
    def test_changes_with_all_that_a_proof_reads(self):
        proof = next(each for each in all_proofs() if each.generated and each.breaks and each.rewrite is None)
        before = digest(proof)
        self.assertEqual(digest(replace(proof)), before)
        broken_otherwise = [replace(proof.breaks[0], new=proof.breaks[0].new + " "), *proof.breaks[1:]]
        generated = {name: text + "// a comment\n" for name, text in proof.generated.items()}
        for change in (
            {"sources": [*proof.sources, ROOT / "rtl/soc/arm_soc.sv"]},
            {"generated": generated},
            {"breaks": broken_otherwise},
            {"breaks": proof.breaks[1:]},
            {"headers": ()},
            {"assertions": not proof.assertions},
            {"rewrite": gates.with_guards},
        ):
            with self.subTest(list(change)):
                self.assertNotEqual(digest(replace(proof, **change)), before)


if __name__ == "__main__":
    unittest.main()
