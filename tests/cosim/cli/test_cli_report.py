"""armature report, and the options that write one. tests/cosim/page looks at reports in a browser."""

import json
import re
import signal

from cli_program import BRIEF, SCENARIOS, TINY, Program, main


def data_of(page):
    """What the page shows, as the program gave it."""
    return json.loads(re.search(r'(?s)<script type="application/json" id="run">(.*?)</script>', page).group(1))


class Report(Program):
    def page(self, name):
        return (self.folder / name).read_text()

    def test_the_report_has_summary_and_golden_of_the_run(self):
        out, _ = self.run_once(TINY, "--report")
        page = (out / "report.html").read_text()
        data = data_of(page)
        summary = json.loads((out / "summary.json").read_text())
        del summary["host"]  # differs between machines
        self.assertEqual(data["summary"], summary)
        self.assertEqual(data["other"]["name"], "golden")
        self.assertEqual(self.armature("report", out, "-o", "y.html").stdout, "y.html\n")
        self.assertTrue(self.page("y.html") == page)

    def test_the_report_loads_nothing(self):
        out, _ = self.run_once(TINY, "--report")
        page = (out / "report.html").read_text()
        self.assertIn("default-src 'none'", page.partition('id="run"')[0])
        self.assertEqual(re.findall(r"<(?:link|script|img|iframe)[^>]*\b(?:src|href)=", page), [])
        self.assertFalse("sourceMappingURL" in page)

    def test_expectations_are_told_with_margins(self):
        options = ("--set", "expect.max_correction_pulses=5", "--set", "expect.underruns=3")
        self.armature("run", TINY, *BRIEF, "--out", "x", *options, code=1)
        result = json.loads(self.page("x/summary.json"))["result"]
        expectations = {one["key"]: one for one in result["expectations"]}
        underruns, correction = expectations["underruns"], expectations["max_correction_pulses"]
        self.assertEqual((underruns["met"], underruns["got"], underruns["margin"]), (False, "0", None))
        self.assertEqual((correction["met"], correction["margin"]), (True, 5 - result["max_correction_pulses"]))

    def test_compare_writes_a_page_of_both_runs(self):
        for name in ("a", "b"):
            self.armature("run", TINY, *BRIEF, "--out", name)
        self.armature("compare", "a/trace.csv", "b/trace.csv", "--report", "both.html")
        data = data_of(self.page("both.html"))
        self.assertEqual((data["other"]["name"], data["other"]["shown"]), ("a/trace.csv", "b/trace.csv"))
        self.assertEqual(data["other"]["trace"], data["trace"])
        done = self.armature("compare", "a/trace.csv", "b/trace.csv", "--report", "b/summary.json", code=2)
        self.assertIn("summary.json", done.stderr)

    def test_a_report_follows_a_run_to_its_end(self):
        run = self.beside("run", SCENARIOS / "fig9_joint_move", "--out", "x", "--set", "duration_s=1000")
        self.wait_for("x/trace.csv")
        report = self.beside("report", "x", "--follow")

        def rows():
            file = self.folder / "x/report.html"
            return data_of(file.read_text())["trace"]["columns"][0]["rows"] if file.exists() else 0

        self.wait_until(lambda: rows() > 0)
        self.wait_for("x/reload.js")  # written after the page
        before, digest = rows(), self.page("x/reload.js")
        self.wait_until(lambda: rows() > before)
        self.assertIsNone(report.poll())
        run.kill()
        self.assertEqual(report.wait(timeout=60), 0)
        self.assertNotEqual(self.page("x/reload.js"), digest)
        self.assertEqual(rows(), len(self.page("x/trace.csv").splitlines()) - 1)
        self.assertIsNone(data_of(self.page("x/report.html"))["page"]["shown"])

    def test_a_report_of_a_run_that_is_over_does_not_wait(self):
        self.armature("run", TINY, *BRIEF, "--out", "x")
        self.armature("report", "x", "--follow")
        self.assertEqual(data_of(self.page("x/report.html"))["summary"]["result"]["passed"], True)

    def test_ctrl_c_ends_a_report_that_follows(self):
        self.beside("run", SCENARIOS / "fig9_joint_move", "--out", "x", "--set", "duration_s=1000")
        self.wait_for("x/trace.csv")
        report = self.beside("report", "x", "--follow")
        self.wait_for("x/reload.js")
        report.send_signal(signal.SIGINT)
        self.assertEqual(report.wait(timeout=60), 130)

    def test_bad_input_is_told(self):
        self.assertIn("y: is no folder", self.armature("report", "y", code=2).stderr)
        self.armature("run", TINY, *BRIEF, "--out", "x")
        self.assertIn("trace.csv", self.armature("report", "x", "-o", "x/trace.csv", code=2).stderr)
        (self.folder / "x/trace.csv").write_text("tick,time_s\n0,0.1\n0,0.2\n")
        self.assertIn("x/trace.csv:3", self.armature("report", "x", code=2).stderr)


if __name__ == "__main__":
    main()
