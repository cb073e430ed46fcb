"""arm_soc connects the gated clock and active_o of each block to the same group.

The proofs gate.<block> show that no flop of the gated clock changes while active_o of the block is 0. arm_soc is wiring
only. This test checks that it connects both to the same group.
"""

import json
import pathlib
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tools"))
from rtl_list import gated_clocks, rtl_sources  # noqa: E402

CLOCKS = gated_clocks(ROOT)
ORS = ("$or", "$logic_or")
VARIANTS = {"counts": 0, "paper": 1}


def top(paper, edit=lambda text: text):
    """The module arm_soc with its instances, read by Yosys. Of the blocks it reads the ports only."""
    with tempfile.TemporaryDirectory() as scratch:
        folder = pathlib.Path(scratch)
        (folder / "arm_soc.sv").write_text(edit((ROOT / "rtl/soc/arm_soc.sv").read_text()))
        sources = [ROOT / "rtl" / source for source in rtl_sources(ROOT) if not source.endswith("arm_soc.sv")]
        script = (
            f"read_verilog -lib -sv -I{ROOT}/rtl/common {' '.join(map(str, sources))}; "
            f"read_verilog -sv -I{ROOT}/rtl/common {folder}/arm_soc.sv; "
            f"chparam -set PaperFabric {paper} arm_soc; hierarchy -check -top arm_soc; proc; opt_clean; "
            f"write_json {folder}/design.json"
        )
        subprocess.run(["yosys", "-q", "-p", script], check=True, capture_output=True)
        modules = json.loads((folder / "design.json").read_text())["modules"]
    return next(module for module in modules.values() if module["attributes"].get("top"))


def or_inputs(module, bit):
    """The nets of which `bit` is the OR."""
    for cell in module["cells"].values():
        if cell["type"] in ORS and cell["connections"]["Y"] == [bit]:
            return set().union(*(or_inputs(module, cell["connections"][pin][0]) for pin in "AB"))
    return {bit}


def wrong(module):
    """Pins on a gated clock other than the clock of a block whose active_o requests it."""
    ports = {name: port["bits"] for name, port in module["ports"].items()}
    requests = {ports[clock][0]: or_inputs(module, ports["active_o"][bit]) for bit, clock in enumerate(CLOCKS)}
    found = []
    for name, cell in module["cells"].items():
        for pin, bits in cell["connections"].items():
            for bit in bits:
                if bit not in requests:
                    continue
                if pin not in ("clk_gated_i", "clk_i") or cell["connections"]["active_o"][0] not in requests[bit]:
                    found.append(f"{name}.{pin}")
    return found


class GatedClocks(unittest.TestCase):
    def test_every_gated_block_requests_its_own_clock(self):
        for variant, paper in VARIANTS.items():
            with self.subTest(variant):
                module = top(paper)
                self.assertEqual(wrong(module), [])
                gated = [cell for cell in module["cells"].values() if "active_o" in cell["connections"]]
                self.assertGreaterEqual(len(gated), 6)

    def test_a_block_on_the_clock_of_another_is_found(self):
        text = ".clk_gated_i    (clk_encoder_i)"
        found = wrong(top(0, lambda source: source.replace(text, ".clk_gated_i    (clk_io_i)")))
        self.assertEqual(found, ["g_rtl.u_encoder.clk_gated_i"])

    def test_a_missing_clock_request_is_found(self):
        found = wrong(top(0, lambda source: source.replace("timer_active || pulses_active", "timer_active")))
        self.assertEqual(found, ["g_rtl.u_pulse_train.clk_gated_i"])


if __name__ == "__main__":
    unittest.main()
