"""tools/mutants and tools/rtl_list.py: where a mutant is chosen, which entries are refused, what a module needs."""

import pathlib
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path[:0] = [str(ROOT / "tools"), str(ROOT / "tools/mutants")]
from catalogue import CatalogueError, Mutant, load  # noqa: E402
from rtl_list import ListError, RtlTree  # noqa: E402
from sites import sites  # noqa: E402
from weave import DECLARATION, weave  # noqa: E402

SOURCE = """module m (
  input  logic clk_i,
  output logic [3:0] a_o  // comment
);
  localparam logic [3:0] Limit = 4'd7;
  logic b;
  assign b = a_o == Limit && clk_i;
  child #(.W(4)) u_child (.clk_i, .d_i(a_o), .q_o());
  always_ff @(posedge clk_i) begin
    if (b) a_o <= 4'd1;
    else begin
      case (a_o)
        4'd1, 4'd2: a_o <= 4'd3;
        default: for (int i = 0; i < 4; i++) a_o[i] <= b;
      endcase
    end
  end
endmodule
"""


def mutant(old, new, name="broken"):
    return Mutant(name, "m.sv", old, new, {"m_test": "M.*"})


def woven(*mutants):
    """The woven text on one line, without the module's first lines."""
    text = weave(SOURCE, list(mutants))
    return " ".join(text[text.index("logic b;") :].split())


class Weave(unittest.TestCase):
    def chosen(self, one):
        return f"mutant_number == 32'd{one.number}"

    def test_smallest_statement_is_chosen(self):
        one = mutant("4'd3", "4'd4")
        self.assertIn(
            f"4'd1, 4'd2: if ({self.chosen(one)}) begin a_o <= 4'd4; end else begin a_o <= 4'd3; end default:",
            woven(one),
        )

    def test_statement_inside_a_chosen_one_is_chosen_too(self):
        inner, outer = mutant("4'd3", "4'd4", "inner"), mutant("if (b)", "if (!b)", "outer")
        text = woven(inner, outer)
        self.assertLess(text.index(self.chosen(outer)), text.index(self.chosen(inner)))
        self.assertIn("if (!b) a_o <= 4'd1; else begin case (a_o) 4'd1, 4'd2: a_o <= 4'd3;", text)

    def test_two_mutants_of_one_statement_exclude_each_other(self):
        text = woven(mutant("4'd3", "4'd4", "x"), mutant("a_o <= 4'd3;", "", "y"))
        self.assertIn("begin a_o <= 4'd4; end else if", text)
        self.assertIn("begin end else begin a_o <= 4'd3; end", text)

    def test_text_that_ends_what_stands_around_it_takes_the_whole(self):
        one = mutant("a_o <= 4'd1;", "a_o <= 4'd1;\n    else if (clk_i) a_o <= 4'd2;")
        self.assertIn(
            f"if ({self.chosen(one)}) begin if (b) a_o <= 4'd1; else if (clk_i) a_o <= 4'd2; else begin", woven(one)
        )

    def test_continuous_assignment_becomes_a_process(self):
        one = mutant("Limit &&", "Limit ||")
        self.assertIn(
            f"always_comb if ({self.chosen(one)}) begin b = a_o == Limit || clk_i; end else begin "
            "b = a_o == Limit && clk_i; end",
            woven(one),
        )

    def test_text_that_begins_before_the_assignment_is_chosen(self):
        one = mutant("\n  assign b = a_o == Limit", "\n  assign b = a_o != Limit")
        self.assertIn(f"always_comb if ({self.chosen(one)}) begin b = a_o != Limit && clk_i; end", woven(one))

    def test_connections_are_chosen_one_by_one(self):
        one = mutant(".d_i(a_o)", ".d_i(4'd0)")
        self.assertIn(f".W(4)) u_child (.clk_i, .d_i({self.chosen(one)} ? (4'd0) : (a_o)), .q_o())", woven(one))

    def test_every_module_has_the_number_after_its_ports(self):
        self.assertIn(f");\n{DECLARATION}\n  localparam", weave(SOURCE, [mutant("4'd3", "4'd4")]))

    def test_declaration_of_the_number_can_be_replaced(self):
        text = weave(SOURCE, [mutant("4'd3", "4'd4")], "  logic [31:0] mutant_number;")
        self.assertIn(");\n  logic [31:0] mutant_number;\n  localparam", text)

    def test_nothing_but_the_choice_changes(self):
        text = weave(SOURCE, [])
        self.assertEqual(text.replace(f"\n{DECLARATION}", ""), SOURCE)

    def test_constants_cannot_be_chosen(self):
        with self.assertRaisesRegex(CatalogueError, "broken changes a declaration"):
            woven(mutant("4'd7", "4'd6"))

    def test_parameters_of_an_instance_cannot_be_chosen(self):
        with self.assertRaisesRegex(CatalogueError, "broken changes more than"):
            woven(mutant(".W(4)", ".W(5)"))

    def test_second_assignment_is_refused(self):
        with self.assertRaisesRegex(CatalogueError, "broken makes more than one assignment"):
            woven(mutant("assign b =", "assign a_o[0] = 1'b0; assign b ="))

    def test_comments_cannot_be_chosen(self):
        with self.assertRaisesRegex(CatalogueError, "broken changes a comment"):
            woven(mutant("// comment", "// other"))

    def test_reads_all_of_rtl(self):
        for path in sorted((ROOT / "rtl").glob("*/*.sv")):
            with self.subTest(path=path.name):
                text = path.read_text()
                self.assertTrue(all(text[site.start : site.end].strip() for site in sites(text)))


class Catalogue(unittest.TestCase):
    GOOD = '[[mutant]]\nname = "one"\nfile = "b/m.sv"\nfrom = "4\'d3"\nto = "4\'d4"\nkilled_by.m_test = "M.*"\n'

    def load(self, text):
        with tempfile.TemporaryDirectory() as folder:
            folder = pathlib.Path(folder)
            (folder / "rtl/b").mkdir(parents=True)
            (folder / "rtl/b/m.sv").write_text(SOURCE)
            (folder / "m.toml").write_text(text)
            return load(folder, folder / "rtl")

    def refused(self, text, message):
        with self.assertRaisesRegex(CatalogueError, message):
            self.load(text)

    def test_entry(self):
        (one,) = self.load(self.GOOD)
        self.assertEqual((one.name, one.killed_by), ("one", {"m_test": "M.*"}))
        self.assertIn("a_o <= 4'd4", one.applied(SOURCE))

    def test_text_that_is_not_there_once_is_refused(self):
        self.refused(self.GOOD.replace('"4\'d3"', '"4\'d9"'), "one: `from` must occur exactly once .* 0 times")
        self.refused(self.GOOD.replace('"4\'d3"', '"a_o"'), "one: `from` must occur exactly once .* 7 times")

    def test_mutant_that_nobody_must_notice_is_refused(self):
        self.refused(self.GOOD.replace('killed_by.m_test = "M.*"', ""), "one: neither a test .* nor a proof")

    def test_second_mutant_of_a_name_is_refused(self):
        self.refused(self.GOOD * 2, "two mutants one")

    def test_unknown_and_missing_keys_are_refused(self):
        self.refused(self.GOOD + "model = 1\n", "one: unknown key `model`")
        self.refused(self.GOOD.replace("to = ", "killed_by.x = "), "one: no `to`")

    def test_file_that_is_not_there_is_refused(self):
        self.refused(self.GOOD.replace("b/m.sv", "b/n.sv"), "one: there is no rtl/b/n.sv")

    def test_proofs_are_named_or_matched(self):
        (one,) = self.load(self.GOOD + 'refuted_by.m = "A"\nrefuted_by."port.*" = "B"\n')
        self.assertEqual([one.assertion_of(name) for name in ("m", "port.x", "n")], ["A", "B", None])


class Tool(unittest.TestCase):
    def test_copy_of_a_file_that_has_no_mutant_any_more_is_removed(self):
        with tempfile.TemporaryDirectory() as scratch:
            old = pathlib.Path(scratch) / "axi_gpio" / "axi_gpio_of_yesterday.sv"
            old.parent.mkdir()
            old.write_text("module m; endmodule\n")
            subprocess.run([sys.executable, "-B", ROOT / "tools/mutants", scratch], check=True)
            self.assertFalse(old.exists())
            self.assertTrue((old.parent / "axi_gpio_core.sv").exists())
            self.assertTrue((pathlib.Path(scratch) / "mutants.cmake").exists())


class Closure(unittest.TestCase):
    FILES = {
        "b/b_pkg.sv": "package b_pkg;\nendpackage\n",
        "b/leaf.sv": "module leaf;\nendmodule\n",
        "b/other.sv": "module other;\n  absent #(.A(f(1))) u_absent (.clk_i);\nendmodule\n",
        "b/top.sv": "// other\nmodule top;\n  logic x = b_pkg::X;\n  leaf u_leaf (.clk_i);\nendmodule\n",
    }

    def setUp(self):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        root = pathlib.Path(scratch.name)
        (root / "rtl/b").mkdir(parents=True)
        for name, text in self.FILES.items():
            (root / "rtl" / name).write_text(text)
        (root / "rtl/rtl.f").write_text("\n".join(self.FILES))
        self.tree = RtlTree(root)

    def test_has_what_a_module_uses_in_the_order_of_the_list(self):
        self.assertEqual([path.stem for path in self.tree.closure_of("top")], ["b_pkg", "leaf", "top"])

    def test_module_that_no_source_defines_is_named(self):
        with self.assertRaisesRegex(ListError, "other.sv: uses absent, which no source in rtl/rtl.f defines"):
            self.tree.closure_of("other")


if __name__ == "__main__":
    unittest.main()
