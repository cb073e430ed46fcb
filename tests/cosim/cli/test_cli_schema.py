"""armature schema: what editors check files by."""

import json

from cli_program import SCENARIOS, Program, main

FILES = {"scenario": "scenario.schema.json", "robot": "robots/robot.schema.json"}


class Schema(Program):
    def test_it_is_that_beside_the_scenarios(self):
        for kind, file in FILES.items():
            with self.subTest(kind):
                text = self.armature("schema", kind).stdout
                self.assertEqual(text, (SCENARIOS / file).read_text())
                self.assertEqual(json.loads(text)["$id"], f"urn:armature:{kind}")

    def test_another_kind_is_told(self):
        self.assertIn("{scenario,robot}", self.armature("schema", "axis", code=2).stderr)


if __name__ == "__main__":
    main()
