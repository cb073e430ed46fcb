"""cmake --install: what is installed, and that it works wherever it is moved to."""

import pathlib
import re
import subprocess

from cli_program import ROOT, SCENARIOS, SHORT, Program, main

MAN = "share/man/man1/armature.1"
COMPLETIONS = {
    "share/bash-completion/completions/armature": "bash",
    "share/zsh/site-functions/_armature": "zsh",
    "share/fish/vendor_completions.d/armature.fish": "fish",
}
# A file that a document or a help names by its path: in backticks, in a link or as a word of a command.
NAMED = re.compile(r"(?<![\w./])((?:controller|cosim|tools|scenarios)/[\w./-]+\.(?:md|gtkw|py|toml|csv|json))\b")
BUILT = "scenarios/nod/"  # what the reader of the tutorial writes
LIBRARY = re.compile(r"\.(a|so|h|hpp|cmake)$")


class Install(Program):
    def setUp(self):
        super().setUp()
        build = pathlib.Path(self.path).parent
        cmake = re.search(r"(?m)^CMAKE_COMMAND:INTERNAL=(.*)$", (build / "CMakeCache.txt").read_text()).group(1)
        subprocess.run([cmake, "--install", build, "--prefix", self.folder / "prefix"], check=True, capture_output=True)
        self.prefix = (self.folder / "prefix").rename(self.folder / "moved").resolve()
        self.data = self.prefix / "share/armature"
        (self.folder / "work").mkdir()

    def installed(self, *arguments):
        """Without any environment variable, in a folder outside the checkout."""
        done = subprocess.run(
            [self.prefix / "bin/armature", *map(str, arguments)],
            cwd=self.folder / "work",
            env={},
            text=True,
            capture_output=True,
        )
        self.assertEqual(done.returncode, 0, f"{arguments}\n{done.stdout}\n{done.stderr}")
        return done.stdout

    def test_the_moved_program_finds_its_data(self):
        listing = self.installed("list")
        self.assertTrue(listing.startswith(f"scenarios in {self.data}/scenarios (installed)\n"), listing)
        for scenario in SCENARIOS.glob("*/scenario.toml"):
            self.assertRegex(listing, rf"(?m)^{scenario.parent.name} .* s  ")
        for robot in SCENARIOS.glob("robots/*.toml"):
            self.assertRegex(listing, rf"(?m)^{robot.stem} +(six_r|five_r|joint moves only) ")
        self.assertIn("flange of abb_irb120", self.installed("fk", "--robot", "abb_irb120", 0, 0, 0, 0, 0, 0))
        self.assertIn(f"{self.data}/scenarios (installed)", self.installed("info"))
        self.assertIn(f"PASS  {SHORT}", self.installed("check", SHORT))
        self.assertIn(f"results        out/{SHORT}\n", self.installed("run", SHORT))
        self.assertEqual(
            {path.name for path in (self.folder / "work").rglob("*") if path.is_file()},
            {"trace.csv", "load.csv", "summary.json", "log.txt"},
        )

    def test_what_users_need_is_installed_and_no_library(self):
        files = {path.relative_to(self.prefix).as_posix() for path in self.prefix.rglob("*") if path.is_file()}
        data = {
            f"share/armature/scenarios/{path.relative_to(SCENARIOS).as_posix()}"
            for path in SCENARIOS.rglob("*")
            if path.is_file()
        }
        client = ROOT / "cosim/serve/client"
        data |= {f"share/armature/cosim/serve/client/{path.name}" for path in client.iterdir() if path.is_file()}
        data |= {"bin/armature", "share/armature/cosim/serve/README.md", "share/armature/tools/arm_soc.gtkw"}
        data |= {"share/armature/tools/arm_soc.sucl", "share/armature/tools/arm_soc_paper.sucl"}
        data |= {"share/armature/tools/arm_soc_paper.gtkw", "share/armature/tools/late_commit.gtkw"}
        data |= {"share/armature/controller/pendant/PROTOCOL.md", MAN, *COMPLETIONS}
        self.assertEqual(files, data)
        self.assertLessEqual(
            {"share/armature/scenarios/KEYS.md", f"share/armature/scenarios/{SHORT}/golden.csv"}, files
        )
        for file, command in {
            MAN: "man",
            **{file: f"completion {shell}" for file, shell in COMPLETIONS.items()},
        }.items():
            self.assertEqual((self.prefix / file).read_text(), self.installed(*command.split()))
        self.assertEqual([file for file in files if LIBRARY.search(file) and "serve/client" not in file], [])

    def test_the_files_that_documents_and_help_name_are_installed(self):
        # What a document says to those who add a part is about the sources.
        texts = {path: re.sub(r"(?m)^\*\*Add .*$", "", path.read_text()) for path in self.data.rglob("*.md")}
        commands = re.findall(r"(?m)^  (\w+)  ", self.installed("--help").partition("Subcommands:")[2])
        texts |= {command: self.installed(command, "--help") for command in commands}
        seen = set()
        for source, text in texts.items():
            for name in NAMED.findall(text):
                if name.startswith(BUILT):
                    continue
                seen.add(name)
                with self.subTest(name, source=source):
                    self.assertTrue((self.data / name).is_file())
        self.assertLessEqual({"controller/pendant/PROTOCOL.md", "scenarios/RESULTS.md"}, seen)


if __name__ == "__main__":
    main()
