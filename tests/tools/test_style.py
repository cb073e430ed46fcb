"""tools/style finds each kind of bad form and nothing in good files; tools/pre-commit refuses what has it."""

import pathlib
import shutil
import subprocess
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
STYLE = ROOT / "tools" / "style"

# File name, text, what is said about it.
BAD = [
    ("tab.md", "a\tb\n", "tab.md:1: tab or carriage return"),
    ("return.md", "a\r\n", "return.md:1: tab or carriage return"),
    ("space.md", "a\nb \n", "space.md:2: space at the end of the line"),
    ("end.md", "a", "end.md: no newline at the end"),
    ("empty.md", "a\n\n", "empty.md: empty line at the end"),
    ("README.md", "text\n" * 41, "README.md: 41 lines of text, the limit is 40"),
    ("README.md", "| folder | what |\n|---|---|\n| `gone/` | a |\n", "README.md:3: there is no gone/"),
    ("wide.sv", "// " + "x" * 118 + "\n", "wide.sv:1: 121 columns, the limit is 120"),
    ("broken.toml", "a = \n", "broken.toml: Invalid value"),
    ("twice.toml", "a = 1\na = 2\n", "twice.toml: Cannot overwrite a value"),
    ("brace.cpp", "int f()\n{\n  return 0;\n}\n", "brace.cpp:1:8: error: code should be clang-formatted"),
    ("quotes.py", "a = 'b'\n", '+a = "b"'),
    ("program", "#!/usr/bin/env python3\na = 'b'\n", '+a = "b"'),
    ("script.sh", "if true\n", "script.sh: line 2: syntax error"),
    ("tool", "#!/usr/bin/env bash\nif true\n", "tool: line 3: syntax error"),
]
GOOD = {
    "good.cpp": "int f() {\n  return 0;\n}\n",
    "good.py": 'a = "b"\n',
    "good.toml": "a = 1\n",
    "good.sv": "// " + "x" * 117 + "\n",
    "tool": "#!/usr/bin/env bash\nif true; then :; fi\n",
    "README.md": "text\n" * 40 + "| folder |\n|---|\n| `here` |\n\n| file |\n| `gone` |\n\n```\nexample\n```\n",
    "data.csv": "a,b \n\n",
}


def run(*command, cwd=None):
    return subprocess.run([str(word) for word in command], cwd=cwd, capture_output=True, text=True)


class StyleTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = pathlib.Path(folder.name)
        shutil.copy(ROOT / ".clang-format", self.root)
        self.tools = self.root / "tools"
        self.tools.mkdir()

    def style(self, *names):
        return run(STYLE, "--root", self.root, *names)

    def test_good_files_have_no_problem(self):
        (self.tools / "here").mkdir()
        for name, text in GOOD.items():
            (self.tools / name).write_text(text)
        checked = self.style(*(f"tools/{name}" for name in GOOD))
        self.assertEqual(checked.stdout + checked.stderr, "")
        self.assertEqual(checked.returncode, 0)

    def test_names_the_place_of_each_problem(self):
        for name, text, message in BAD:
            with self.subTest(name):
                (self.tools / name).write_bytes(text.encode())
                checked = self.style(f"tools/{name}")
                self.assertIn(message, checked.stdout)
                self.assertEqual(checked.returncode, 1)

    def test_names_what_does_not_belong_at_the_top_level(self):
        (self.root / "NOTES.txt").write_text("a\n")
        (self.root / "scratch").mkdir()
        (self.root / "scratch" / "a.md").write_text("a\n")
        (self.root / "README.md").write_text("a\n")
        checked = self.style("NOTES.txt", "README.md", "scratch/a.md")
        self.assertEqual(
            checked.stdout.splitlines(),
            [f"{name}: does not belong at the top level, see TOP in tools/style" for name in ("NOTES.txt", "scratch")],
        )
        self.assertEqual(checked.returncode, 1)

    def test_hook_refuses_a_long_subject(self):
        for message, expected in [
            ("x" * 72, ""),
            ("x" * 72 + "\n\nWhy.\n# a comment of Git\n", ""),
            ("# a comment of Git\n" + "x" * 73, "has 73 columns, the limit is 72"),
            ("x\nWhy.\n", "the line behind the subject of the commit is not empty: Why."),
        ]:
            with self.subTest(message):
                (self.root / "message").write_text(message)
                checked = run(ROOT / "tools" / "commit-msg", self.root / "message")
                self.assertIn(expected, checked.stdout)
                self.assertEqual(checked.returncode, int(bool(expected)))

    def test_hook_refuses_bad_form_in_what_is_staged(self):
        clone = self.root / "clone"
        # The index and the files of this checkout, with a history of its own.
        listed = run("git", "ls-files", "-z", cwd=ROOT).stdout.split("\0")
        for name in filter(None, listed):
            if (ROOT / name).is_file() and not name.endswith(".csv"):
                (clone / name).parent.mkdir(parents=True, exist_ok=True)
                shutil.copy(ROOT / name, clone / name)
        run("git", "init", "--quiet", cwd=clone)
        run("git", "add", "--all", cwd=clone)
        commit = ("git", "-c", "user.name=a", "-c", "user.email=a@b", "commit", "--quiet", "-m", "x")
        self.assertEqual(run(*commit, cwd=clone).returncode, 0)
        (clone / ".git" / "hooks" / "pre-commit").symlink_to("../../tools/pre-commit")

        page = clone / "scenarios" / "TUTORIAL.md"
        page.write_text(page.read_text() + "space \n")
        run("git", "add", page, cwd=clone)
        page.write_text(page.read_text().replace("space \n", ""))  # what counts is what is staged
        refused = run(*commit, cwd=clone)
        self.assertNotEqual(refused.returncode, 0)
        self.assertIn("space at the end of the line", refused.stdout + refused.stderr)

        run("git", "checkout", "--quiet", "HEAD", "--", ".", cwd=clone)
        table = clone / "rtl" / "soc" / "soc_map.toml"
        table.write_text(table.read_text().replace("0x4120_0000", "0x4121_0000"))
        run("git", "add", table, cwd=clone)
        refused = run(*commit, cwd=clone)
        self.assertNotEqual(refused.returncode, 0)
        self.assertIn("stale: rtl/soc/soc_map_pkg.sv", refused.stdout + refused.stderr)

        run("git", "checkout", "--quiet", "HEAD", "--", ".", cwd=clone)
        page.write_text(page.read_text() + "No space.\n")
        run("git", "add", page, cwd=clone)
        accepted = run(*commit, cwd=clone)
        self.assertEqual(accepted.returncode, 0, accepted.stdout + accepted.stderr)


if __name__ == "__main__":
    unittest.main()
