"""armature export: files for Foxglove and NumPy, against readers that are written here."""

import ast
import json
import math
import shutil
import struct
import subprocess
import zipfile

import jsonschema
from cli_program import BRIEF, SCENARIOS, TINY, Program, main
from mcap_file import McapFile

LASER = SCENARIOS / "gcode_laser_cut"
NUMPY = "/usr/bin/python3"  # of Debian, for which python3-numpy may be installed


def npy(data):
    """The values of a .npy file of one dimension."""
    assert data[:8] == b"\x93NUMPY\x01\x00"
    size = struct.unpack_from("<H", data, 8)[0]
    assert (10 + size) % 64 == 0
    head = ast.literal_eval(data[10 : 10 + size].decode())
    (count,) = head["shape"]
    body = data[10 + size :]
    kind, width = head["descr"][:2], int(head["descr"][2:])
    if kind == "<U":
        assert len(body) == 4 * width * count
        texts = (body[4 * width * i : 4 * width * (i + 1)].decode("utf-32-le") for i in range(count))
        return [text.rstrip("\0") for text in texts]
    return list(struct.unpack(f"<{count}{ {'<i': 'q', '<f': 'd'}[kind] }", body))


class Export(Program):
    def laser(self):
        """The run of a program with rapids, pins and messages, and its export."""
        out, _ = self.run_once(LASER)
        self.once("export", lambda: self.armature("export", out, "--mcap", out / "x.mcap", "--npz", out / "x.npz"))
        return out, self.once("mcap", lambda: McapFile(out / "x.mcap"))

    def summary(self, out):
        return json.loads((out / "summary.json").read_text())["result"]

    def test_joints_and_tool_are_those_of_the_trace(self):
        out, mcap = self.laser()
        rows = self.rows(out / "trace.csv")
        for topic, side, tool in (
            ("/joint_states", "enc", "/tool_pose"),
            ("/joint_set_points", "ref", "/tool_set_point"),
        ):
            joints, poses = mcap.of(topic), mcap.of(tool)
            self.assertEqual(len(joints), len(rows))
            self.assertEqual(len(poses), len(rows))
            for at in range(0, len(rows), 97):
                (time, message), row = joints[at], rows[at]
                self.assertEqual(time, round(float(row["time_s"]) * 1e9))
                self.assertEqual(message["timestamp"], {"sec": time // 10**9, "nsec": time % 10**9})
                for i, joint in enumerate(message["joints"]):
                    self.assertEqual(joint["name"], f"joint{i + 1}")
                    angle = math.radians(float(row[f"j{i + 1}_{side}_deg"]))
                    self.assertAlmostEqual(joint["position"], angle, places=12)
                place = poses[at][1]["pose"]["position"]
                for axis in "xyz":
                    self.assertAlmostEqual(1000 * place[axis], float(row[f"tcp_{side}_{axis}_mm"]), delta=2e-5)
                turn = poses[at][1]["pose"]["orientation"]
                self.assertAlmostEqual(math.hypot(*turn.values()), 1, places=9)
        # The laser points down: z of the tool is opposite to that of the base.
        q = mcap.of("/tool_pose")[-1][1]["pose"]["orientation"]
        self.assertAlmostEqual(1 - 2 * (q["x"] ** 2 + q["y"] ** 2), -1, places=4)
        speeds = [message["joints"][5]["velocity"] for _, message in mcap.of("/joint_set_points")]
        self.assertAlmostEqual(
            max(map(abs, speeds)), math.radians(self.summary(out)["peak_speed_deg_s"][5]), delta=0.01
        )

    def test_transforms_lead_from_the_base_to_the_tool(self):
        _, mcap = self.laser()
        pictures = mcap.of("/tf")
        self.assertAlmostEqual(len(pictures), 440, delta=2)  # every 10 ms
        frames = {one["child_frame_id"]: one for one in pictures[0][1]["transforms"]}
        self.assertEqual(frames["plate"]["translation"], {"x": 0.38, "y": 0, "z": 0.25})
        poses = dict(mcap.of("/tool_pose"))
        for time, picture in pictures[::50]:
            at, name = [0, 0, 0], "tool"
            parents = {one["child_frame_id"]: one for one in picture["transforms"]}
            while name != "base":
                one = parents[name]
                shift = one["translation"]
                at = [a + b for a, b in zip(turned(one["rotation"], at), (shift["x"], shift["y"], shift["z"]))]
                name = one["parent_frame_id"]
            wanted = poses[time]["pose"]["position"]
            for a, axis in zip(at, "xyz"):
                self.assertAlmostEqual(a, wanted[axis], places=9)

    def test_events_and_lines_of_the_program_have_their_places(self):
        out, mcap = self.laser()
        result = self.summary(out)
        log = [(time, message) for time, message in mcap.of("/events")]
        self.assertEqual([time for time, _ in log], sorted(time for time, _ in log))
        text = LASER.joinpath("plate.ngc").read_text().splitlines()
        (message,) = [one for _, one in log if "hole done" in one["message"]]
        self.assertEqual((message["file"], message["line"]), ("plate.ngc", 1 + text.index("(MSG, hole done)")))
        pins = [(time, one["message"]) for time, one in log if one["name"] == "pin"]
        wanted = [(20 * pin["cycle"], f"output {pin['pin']} becomes {pin['level']}") for pin in result["outputs"]]
        self.assertEqual(pins, wanted)
        lines = mcap.of("/program/arm")
        self.assertEqual(len(lines), sum("line" in move["command"] for move in result["moves"]))
        for _, line in lines:
            self.assertEqual(line["text"], text[line["line"] - 1])
        self.assertEqual(len(mcap.of("/program/core1")), sum(one["kind"] == "line" for one in result["program"]))
        states = [message["state"] for _, message in mcap.of("/state")]
        self.assertEqual([one for one in states if one != "idle"], ["moving", "moving"])

    def test_messages_are_as_their_schemas_say(self):
        _, mcap = self.laser()
        self.assertEqual(mcap.names["/joint_states"], "foxglove.JointStates")
        self.assertEqual(mcap.names["/events"], "foxglove.Log")
        for topic, schema in mcap.schemas.items():
            messages = mcap.of(topic)
            self.assertTrue(messages, topic)
            for _, message in messages[:: max(1, len(messages) // 20)]:
                jsonschema.validate(message, strict(schema))

    def test_arrays_are_the_columns(self):
        out, _ = self.laser()
        rows, load = self.rows(out / "trace.csv"), self.rows(out / "load.csv")
        with zipfile.ZipFile(out / "x.npz") as archive:
            self.assertIsNone(archive.testzip())
            arrays = {name.removesuffix(".npy"): npy(archive.read(name)) for name in archive.namelist()}
        columns = {**{name: load for name in load[0]}, **{name: rows for name in rows[0] if name != "digest2"}}
        self.assertEqual(set(arrays), set(columns))
        for name, table in columns.items():
            texts = [row[name] for row in table]
            if name == "state":
                self.assertEqual(arrays[name], texts)
            elif "." not in texts[0]:
                self.assertEqual(arrays[name], list(map(int, texts)), name)
            else:
                self.assertEqual(arrays[name], list(map(float, texts)), name)

    def test_numpy_reads_the_arrays(self):
        out, _ = self.laser()
        script = "import numpy, sys; f = numpy.load(sys.argv[1]); print(f['tick'].dtype, f['state'][3], f['j5_enc_deg'].max())"
        done = subprocess.run([NUMPY, "-c", script, out / "x.npz"], capture_output=True, text=True)
        if "No module named 'numpy'" in done.stderr:
            self.skipTest("python3-numpy is not installed")
        largest = max(float(row["j5_enc_deg"]) for row in self.rows(out / "trace.csv"))
        kind, state, number = done.stdout.split()
        self.assertEqual((kind, state, float(number)), ("int64", self.rows(out / "trace.csv")[3]["state"], largest))

    def test_a_run_without_a_tool_and_without_load_is_exported(self):
        out, _ = self.run_once(TINY, *BRIEF)
        shutil.copytree(out, self.folder / "x")
        summary = json.loads((self.folder / "x/summary.json").read_text())
        summary["arm"]["links"] = summary["arm"]["tool"] = None
        for key in ("frames", "program_frame"):  # as an older version wrote it
            del summary[key]
        (self.folder / "x/summary.json").write_text(json.dumps(summary))
        (self.folder / "x/load.csv").unlink()
        self.armature("export", "x", "--mcap", "x.mcap")
        mcap = McapFile(self.folder / "x.mcap")
        self.assertEqual(
            {topic for topic, _, _ in mcap.messages}, {"/joint_states", "/joint_set_points", "/state", "/events"}
        )

    def test_equal_results_give_equal_files(self):
        out, _ = self.laser()
        self.armature("export", out, "--mcap", "again.mcap", "--npz", "again.npz")
        for name in ("mcap", "npz"):
            self.assertEqual((self.folder / f"again.{name}").read_bytes(), (out / f"x.{name}").read_bytes())

    def test_bad_input_is_told(self):
        out, _ = self.run_once(TINY, *BRIEF)
        self.assertIn("needs --mcap FILE or --npz FILE", self.armature("export", out, code=2).stderr)
        self.assertIn("is no folder", self.armature("export", "y", "--npz", "z", code=2).stderr)
        self.assertIn("trace.csv", self.armature("export", out, "--npz", out / "trace.csv", code=2).stderr)


def strict(schema):
    """The same schema, in which each property must be there and no other."""
    if schema["type"] == "array":
        return {**schema, "items": strict(schema["items"])}
    if schema["type"] != "object":
        return schema
    inner = {name: strict(one) for name, one in schema["properties"].items()}
    return {"type": "object", "properties": inner, "required": list(inner), "additionalProperties": False}


def turned(q, v):
    """A vector turned by a quaternion: v + 2 u x (u x v + w v)."""
    u = (q["x"], q["y"], q["z"])

    def cross(a, b):
        return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]

    inner = [c + q["w"] * a for c, a in zip(cross(u, v), v)]
    return [a + 2 * c for a, c in zip(v, cross(u, inner))]


if __name__ == "__main__":
    main()
