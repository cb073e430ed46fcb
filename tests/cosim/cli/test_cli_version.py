"""armature --version: the version at the top of the changelog."""

import re

from cli_program import ROOT, Program, main

HEADING = re.compile(r"^## (\d+\.\d+\.\d+)\b", re.MULTILINE)


class Version(Program):
    def test_is_the_newest_of_the_changelog(self):
        versions = HEADING.findall((ROOT / ".github/CHANGELOG.md").read_text())
        self.assertEqual(self.armature("--version").stdout, f"armature {versions[0]}\n")
        numbers = [tuple(map(int, version.split("."))) for version in versions]
        self.assertEqual(numbers, sorted(numbers, reverse=True))


if __name__ == "__main__":
    main()
