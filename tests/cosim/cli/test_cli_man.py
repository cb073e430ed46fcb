"""armature man: the manual page."""

import re
import shutil
import subprocess
import unittest

from cli_program import Program, main


class Man(Program):
    def setUp(self):
        super().setUp()
        self.page = self.armature("man").stdout

    def shown(self, *options):
        """The page as text of 200 columns."""
        done = subprocess.run(
            ["groff", "-man", "-Tutf8", "-P-cbou", "-rLL=200n", "-ww", *options],
            input=self.page,
            text=True,
            capture_output=True,
        )
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        return done.stdout

    def test_it_has_the_sections_of_a_manual_page(self):
        titles = re.findall(r"(?m)^\.SH (.*)$", self.page)
        expected = ["NAME", "SYNOPSIS", "DESCRIPTION", "OPTIONS", "COMMANDS", "EXIT STATUS", "ENVIRONMENT"]
        self.assertEqual(titles, expected)
        self.assertTrue(self.page.startswith(".TH ARMATURE 1 "))
        self.assertTrue(self.page.isascii())
        requests = set(re.findall(r"(?m)^[.'](\S*)", self.page))
        self.assertLessEqual(requests, {"TH", "ad", "nh", "SH", "SS", "TP", "PP", "br", "nf", "fi", "RS", "RE"})
        self.assertEqual(self.page.count("\n.nf\n"), self.page.count("\n.fi\n"))

    @unittest.skipIf(shutil.which("groff") is None, "groff is not installed")
    def test_it_shows_all_that_the_help_shows(self):
        """Compared without blanks, since both break lines in their own way."""
        shown = "".join(self.shown().split())
        help_text = self.armature("--help").stdout
        for command in re.findall(r"(?m)^  (\w+)  ", help_text.partition("Subcommands:")[2]):
            text = self.armature(command, "--help").stdout
            options, _, details = text.partition("\nOptions:")[2].partition("\n\n")
            for name in re.findall(r"(?m)^  (?:-\w,)?(--\S+)", options):
                self.assertTrue(name in shown, name)
            for line in details.splitlines():
                with self.subTest(command=command, line=line):
                    self.assertTrue("".join(line.split()) in shown)

    @unittest.skipIf(shutil.which("man") is None, "man is not installed")
    def test_man_shows_it_without_a_warning(self):
        (self.folder / "armature.1").write_text(self.page)
        done = subprocess.run(
            ["man", "--warnings", "-E", "UTF-8", "-l", "-Tutf8", "-Z", "armature.1"],
            cwd=self.folder,
            text=True,
            capture_output=True,
        )
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertIn("armature", done.stdout)


if __name__ == "__main__":
    main()
