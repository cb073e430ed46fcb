"""The shapes of an arm's parts, from STL files, in the report."""

import json

from mesh_files import write_part, write_scenario
from report_program import MOVES, TINY, ReportProgram, main

ROBOT = "abb_irb120"
JOINTS = 6
# Three points of the hand, in its frame [mm].
CORNERS = [(0, 0, 0), (60, 0, 10), (-20, 80, 40)]
# The corners of the mesh of a group, in the base [mm].
PLACES = """(group => {
  const mesh = group.children.find(child => child.isMesh && child.geometry.index.count === 3);
  group.updateMatrixWorld(true);
  const corners = mesh.geometry.attributes.position;
  return Array.from(mesh.geometry.index.array, i =>
    new THREE.Vector3().fromBufferAttribute(corners, i).applyMatrix4(mesh.matrixWorld).multiplyScalar(1000).toArray());
})"""


class Meshes(ReportProgram):
    size = (700, 700)

    def points(self, joints):
        """The three points of the hand in the base, by the kinematics of the controller."""
        poses = [
            self.armature("fk", "--robot", ROBOT, *joints, "--tool", *corner, 0, 0, 0, "--json") for corner in CORNERS
        ]
        return [json.loads(pose.stdout)["position_mm"] for pose in poses]

    def run_with(self, meshes, *options, scenario=MOVES, code=0):
        """A run of a copy of the scenario whose robot has these meshes."""
        write_scenario(self.folder / "moves.toml", scenario, meshes)
        return self.armature("run", "moves.toml", "--out", "out", "--report", *options, code=code)

    def assert_near(self, shown, expected):
        for point, place in zip(shown, expected, strict=True):
            for ours, theirs in zip(point, place, strict=True):
                self.assertAlmostEqual(ours, theirs, delta=0.01)

    def test_each_part_moves_with_its_joint(self):
        # A point of the hand that the first k joints move alone moves as if it belonged to the part of joint k.
        at_zero = self.points([0] * JOINTS)
        write_part(self.folder / "part.stl", at_zero)
        links = ", ".join(['"part.stl"'] * JOINTS)
        self.run_with(f'base = "part.stl"\nlinks = [{links}]')
        self.open("out/report.html")
        row = int(self.page.run("(i => (report.timeline.setTime(report.run.time[i]), i))(report.run.time.length - 1)"))
        joints = self.page.run(f"report.run.jointsAt(report.run.encoder, {row})")
        self.assertGreater(min(map(abs, joints)), 1)
        for link in range(JOINTS):
            with self.subTest(joint=link + 1):
                moved = self.points(joints[: link + 1] + [0] * (JOINTS - link - 1))
                self.assert_near(self.page.run(f"{PLACES}(report.arm.links[{link}])"), moved)
        self.assert_near(self.page.run(f"{PLACES}(report.arm.base)"), at_zero)

    def test_a_part_without_a_file_is_a_simple_body(self):
        write_part(self.folder / "part.stl", CORNERS)
        self.run_with('links = ["", "part.stl", "", "", "", ""]', scenario=TINY)
        self.open("out/report.html")
        kinds = "new Set(group.children.filter(child => child.isMesh).map(child => child.geometry.type))"
        bodies = self.page.run(f"report.arm.links.slice(0, 6).map(group => [...{kinds}].join())")
        self.assertEqual(bodies[1], "BufferGeometry")
        for body in bodies[:1] + bodies[2:]:
            self.assertIn("CylinderBufferGeometry", body)
        self.assertEqual(self.page.run("report.arm.base.children.length"), 0)

    def test_a_file_that_has_changed_since_the_run_is_not_shown(self):
        write_part(self.folder / "part.stl", CORNERS)
        self.run_with('base = "part.stl"', scenario=TINY)
        write_part(self.folder / "part.stl", CORNERS[::-1])
        self.armature("report", "out")
        self.open("out/report.html")
        self.assertEqual(self.page.run("report.arm.base.children.length"), 0)
        note = self.page.run("document.querySelector('#arm p').textContent")
        self.assertEqual(note, "part.stl: The file has changed since the run.")

    def test_a_mesh_is_an_input_of_the_run_and_changes_nothing_else(self):
        write_part(self.folder / "part.stl", CORNERS)
        self.run_with('base = "part.stl"', scenario=TINY)
        summary = json.loads((self.folder / "out/summary.json").read_text())
        self.assertIn("part.stl", [input["file"] for input in summary["inputs"]])
        plain = json.loads(self.armature("run", TINY, "--out", "plain", "--json").stdout)
        self.assertEqual(summary["result"]["sha256"], plain["result"]["sha256"])

    def test_a_mistake_in_a_file_is_named_before_the_run(self):
        (self.folder / "part.stl").write_text("solid\nfacet normal 0 0 1\nouter loop\nvertex 0 0 x\n")
        refused = self.run_with('base = "part.stl"', code=2)
        self.assertIn("part.stl:4: expected a number", refused.stderr)
        self.assertFalse((self.folder / "out").exists())


if __name__ == "__main__":
    main()
