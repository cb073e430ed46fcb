"""armature plot: pictures of a run."""

import json
import re
import xml.etree.ElementTree

from cli_program import BRIEF, SCENARIOS, TINY, Program, main

MOVE = """description = "d"
robot = "vo2021_6r"
duration_s = 0.18
[[move]]
at_s = 0.01
type = "joint"
target_deg = [3, -2.5, 2, 1, -1, 2]
"""
CUT = """description = "d"
robot = "abb_irb120"
duration_s = 1.9
program = "part.ngc"
program_at_s = 0.8
[trace]
tcp = true
[tool]
xyz_mm = [0, 0, 100]
[[frame]]
name = "table"
xyz_mm = [380, 0, 300]
rpy_deg = [0, -40, 90]
[gcode]
frame = "table"
[[move]]
at_s = 0.01
type = "joint"
xyz_mm = [0, 0, 5]
rpy_deg = [180, 0, 0]
frame = "table"
"""
SVG = "{http://www.w3.org/2000/svg}"


def polylines(document):
    """Points in pixels of each curve that is no dashed line, in the order of drawing."""
    curves = []
    for curve in xml.etree.ElementTree.fromstring(document).iter(SVG + "polyline"):
        if "stroke-dasharray" not in curve.attrib:
            curves.append([tuple(map(float, point.split(","))) for point in curve.get("points").split()])
    return curves


class Plot(Program):
    def picture(self, folder, figure):
        self.armature("plot", folder, "--figure", figure, "-o", "picture.svg")
        return (self.folder / "picture.svg").read_text()

    def test_the_curves_are_those_of_the_trace(self):
        """The scale is read from the picture's own numbers, and the angles at the ends of the curves from the file."""
        self.armature("run", self.text("move.toml", MOVE), "--path", SCENARIOS, "--out", "x")
        document = self.picture("x", "joints")
        marks = [
            (float(y), float(number.replace("\u2212", "-")))
            for y, number in re.findall(r'y="([-\d.]+)" [^>]*text-anchor="end">([^<]+)<', document)
        ]
        (y0, v0), (y1, v1) = marks[0], marks[1]  # of the upper diagram
        rows = self.rows("x/trace.csv")
        curves = polylines(document)
        self.assertEqual(len(curves), 12)
        for joint in range(6):
            points = curves[2 * joint]
            for row, (_, y) in ((rows[0], points[0]), (rows[-1], points[-1])):
                value = v0 + (y - y0) * (v1 - v0) / (y1 - y0)
                # A number stands 4 px below its line.
                value += 4 * (v1 - v0) / (y1 - y0)
                self.assertAlmostEqual(value, float(row[f"j{joint + 1}_ref_deg"]), delta=0.02)

    def test_the_same_run_gives_the_same_bytes_at_the_default_place(self):
        self.armature("run", TINY, *BRIEF, "--out", "x", "--set", "trace.tcp=true")
        for figure in ("joints", "path"):
            first = self.picture("x", figure)
            self.armature("plot", "x", "--figure", figure)
            self.assertEqual((self.folder / f"x/{figure}.svg").read_text(), first)
            xml.etree.ElementTree.fromstring(first)

    def test_the_path_of_a_program_is_drawn_in_its_frame_with_dashed_rapids(self):
        """On a table that leans by 40 degrees, cut one millimetre deep: a square from (0, 0) to (6, 6)."""
        (self.folder / "robots").symlink_to(SCENARIOS / "robots")
        (self.folder / "part.ngc").write_text("G21 G90 G61 F6000\nG0 X0 Y0 Z2\nG1 Z1\nX6\nY6\nX0\nY0\nG0 Z2\nX9\nM2\n")
        self.text("cut.toml", CUT)
        self.armature("run", "cut.toml", "--path", SCENARIOS, "--out", "x")
        moves = json.loads((self.folder / "x/summary.json").read_text())["result"]["moves"]
        rapid = {
            int(move["command"].split()[1]): move.get("rapid", False) for move in moves if "line" in move["command"]
        }
        self.assertEqual(rapid, {2: True, 3: False, 4: False, 5: False, 6: False, 7: False, 8: True, 9: True})
        document = self.picture("x", "path")
        for text in ("x in table [mm]", "y in table [mm]", "seen along z of the frame table", ">rapids<"):
            self.assertIn(text, document)
        x, y = self.scales_of(document)
        for curve in polylines(document):  # set-points and encoders of the cut
            for axis in range(2):
                shown = [(x, y)[axis](point[axis]) for point in curve]
                self.assertAlmostEqual(min(shown), 0, delta=0.03)
                self.assertAlmostEqual(max(shown), 6, delta=0.03)
        dashed = [
            curve.get("points").split()
            for curve in xml.etree.ElementTree.fromstring(document).iter(SVG + "polyline")
            if curve.get("stroke-dasharray") == "3 4"
        ]
        last = tuple(map(float, dashed[-1][-1].split(",")))
        self.assertAlmostEqual(x(last[0]), 9, delta=0.1)  # the encoders lag
        self.assertAlmostEqual(y(last[1]), 0, delta=0.03)

    def scales_of(self, document):
        """From pixels to millimetres, by the numbers of the picture."""

        def scale(marks):
            marks = [(float(at), float(number.replace("\u2212", "-"))) for at, number in marks]
            (p0, v0), (p1, v1) = marks[0], marks[-1]
            return lambda pixel: v0 + (pixel - p0) * (v1 - v0) / (p1 - p0)

        number = r">([\u2212\d.]+)<"
        x = scale(re.findall(r'<text x="([-\d.]+)" [^>]*text-anchor="middle"' + number, document))
        y = scale(re.findall(r'y="([-\d.]+)" [^>]*text-anchor="end"' + number, document))
        return x, lambda pixel: y(pixel + 4)  # a number stands 4 px below its line

    def test_a_description_with_markup_stays_text(self):
        scenario = self.copy_of(TINY)
        text = (scenario / "scenario.toml").read_text()
        evil = "</title><script>alert(1)</script>"
        text = re.sub(r"(?m)^description = .*$", f"description = '{evil}'", text)
        (scenario / "scenario.toml").write_text(text)
        self.armature("run", scenario, *BRIEF, "--out", "x")
        document = self.picture("x", "joints")
        self.assertEqual(xml.etree.ElementTree.fromstring(document).find(SVG + "title").text, evil)
        self.assertNotIn("<script", document)

    def test_bad_input_is_told(self):
        self.armature("run", TINY, *BRIEF, "--out", "x")
        self.assertRegex(
            self.armature("plot", "x", "--figure", "path", code=2).stderr,
            r"x/trace.csv: has no column 'tcp_ref_x_mm'; run the scenario with --set trace.tcp=true",
        )
        self.assertIn("circle", self.armature("plot", "x", "--figure", "circle", code=2).stderr)
        self.assertIn("is no folder", self.armature("plot", "y", "--figure", "joints", code=2).stderr)
        done = self.armature("plot", "x", "--figure", "joints", "-o", "x/trace.csv", code=2)
        self.assertIn("trace.csv", done.stderr)
        (self.folder / "x/summary.json").unlink()
        self.assertIn("summary.json", self.armature("plot", "x", "--figure", "joints", code=2).stderr)


if __name__ == "__main__":
    main()
