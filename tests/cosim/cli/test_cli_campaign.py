"""armature campaign: the same bytes for any number of jobs and shards, its files, and the runs that CI computes."""

import json
import os
import re
import xml.etree.ElementTree

from cli_program import ROOT, SCENARIOS, Program, main

RUNS = 20 if "ARMATURE_FEW_DRAWS" in os.environ else 200
RUNS = int(os.environ.get("ARMATURE_CAMPAIGN_RUNS", RUNS))
SMALL = ("--runs", 12, "--robot", "kuka_kr6_r900", "--shrink", 0)


class Campaign(Program):
    def campaign(self, *arguments, **more):
        return self.armature("campaign", *arguments, **more)

    def table(self, *arguments, **more):
        return self.campaign(*arguments, "--json", **more).stdout

    def test_jobs_and_shards_do_not_change_the_table(self):
        whole = self.table(*SMALL, "--result", "whole.json")
        self.assertEqual(json.loads(whole)["done"], 12)
        self.assertEqual(self.table(*SMALL, "--jobs", 2), whole)
        self.campaign(*SMALL, "--shard", "1/2", "--result", "b.json")
        self.campaign(*SMALL, "--result", "a.json", TEST_TOTAL_SHARDS="2", TEST_SHARD_INDEX="0")
        self.assertEqual(self.table("--merge", "b.json", "a.json", "--result", "merged.json"), whole)
        read = [(self.folder / name).read_text() for name in ("whole.json", "merged.json")]
        self.assertEqual(*read)
        done = self.campaign("--merge", "a.json", "a.json", code=2)
        self.assertIn("a.json: has the shard 0/2 again", done.stderr)

    def test_one_run_alone_is_the_same_and_its_scenario_runs(self):
        done = self.campaign("--robot", "kuka_kr6_r900", "--only", 1)
        outcome = re.search(r"run 1: (\w+)", done.stdout)[1]
        counts = json.loads(self.table(*SMALL[:-2], "--shrink", 0))["outcomes"]
        self.assertGreater(counts[outcome], 0)
        self.assertEqual(self.campaign("--robot", "kuka_kr6_r900", "--only", 1).stdout, done.stdout)
        self.armature("run", "out/campaign/run_1_whole", code=None)
        summary = json.loads((self.folder / "out/run_1_whole/summary.json").read_text())
        self.assertEqual(len(summary["result"]["injected_faults"]), 1)

    def test_a_silent_error_fails_and_is_shrunk(self):
        robot = (SCENARIOS / "robots/kuka_kr6_r900.toml").read_text()
        robot = robot.replace('name = "kuka_kr6_r900"', 'name = "weak"')
        # Two turns of a motor do not fit into the range of the axis.
        robot = re.sub(r"min_deg = \S+\nmax_deg = \S+", "min_deg = -5\nmax_deg = 5", robot, count=1)
        robots = self.folder / "scenarios/robots"
        robots.mkdir(parents=True)
        (robots / "weak.toml").write_text(robot)
        given = ("--robot", "weak", "--runs", 1, "--shrink", 1, "--html", "page.html", "--junit", "junit.xml")
        done = self.campaign(*given, code=1)
        self.assertIn("SILENT  run 0: wrong position", done.stdout)
        by_file = self.campaign("--robot", "scenarios/robots/weak.toml", "--runs", 1, "--shrink", 0, code=1)
        self.assertIn("SILENT  run 0: wrong position", by_file.stdout)
        command = re.search(r"to repeat it: armature (.*)", done.stdout)[1]
        self.assertIn("run 0: wrong position", self.armature(*command.split(), code=1).stdout)
        shrunk = re.search(r"run 0 shrunk to (\d+) of (\d+) steps, 0 of 0 faults: armature run (\S+)", done.stdout)
        self.assertLessEqual(int(shrunk[1]), int(shrunk[2]))
        self.assertIn("FAILED", self.armature("run", shrunk[3], code=1).stdout)
        self.assertIn(command, (self.folder / "page.html").read_text())
        cases = xml.etree.ElementTree.parse(self.folder / "junit.xml").iter("testcase")
        self.assertEqual([case.get("name") for case in cases if case.find("failure") is not None], ["no fault"])

    def test_the_job_array_of_slurm_merges_its_shards(self):
        # A stand-in for Slurm: executes what is submitted, one task after the other.
        (self.folder / "sbatch").write_text(
            "#!/bin/bash\n"
            "while [[ $1 == --* ]]; do [[ $1 == --array=* ]] && last=${1##*-}; shift; done\n"
            "export SLURM_JOB_ID=7\n"
            'for task in $(seq 0 ${last-}); do SLURM_ARRAY_TASK_ID=$task "$@" > /dev/null; done\n'
            '[[ -n ${last-} ]] || "$@" > merged.txt\necho 7\n'
        )
        (self.folder / "sbatch").chmod(0o755)
        path = f"{self.folder}:{os.environ['PATH']}"
        self.armature(2, "out", *SMALL, program=ROOT / "tools/campaign.sbatch", PATH=path, ARMATURE=self.path)
        self.assertIn("12 of 12 runs", (self.folder / "merged.txt").read_text())
        self.campaign(*SMALL, "--result", "whole.json")
        read = [(self.folder / name).read_text() for name in ("whole.json", "out/campaign.json")]
        self.assertEqual(*read)
        done = self.campaign("--merge", "out/shard_0.json", code=1)
        self.assertIn("6 runs are missing", done.stderr)
        self.armature(program=ROOT / "tools/campaign.sbatch", code=2)

    def test_only_the_kinds_that_are_asked_for_are_drawn(self):
        given = ("--kind", "estop", "--kind", "pulse_loss", *SMALL)
        table = json.loads(self.table(*given, "--result", "two.json"))
        self.assertEqual(set(table["kinds"]), {"estop", "pulse_loss"})
        self.assertEqual(table["campaign"]["only_kinds"], ["estop", "pulse_loss"])
        self.campaign(*SMALL, "--shard", "0/2", "--result", "all.json")
        self.assertIn("kinds of faults differ", self.campaign("--merge", "two.json", "all.json", code=2).stderr)

    def test_bad_input_is_refused(self):
        self.assertIn("flop_flip not in", self.campaign("--kind", "flop_flip", code=2).stderr)
        for shard in ("2/2", "-1/2", "1", "a/b", "/"):
            self.assertIn("expected I/N", self.campaign("--shard", shard, code=2).stderr)
        (self.folder / "x.json").write_text("{}")
        self.assertIn("no table of a campaign", self.campaign("--merge", "x.json", code=2).stderr)
        self.assertIn("x.json", self.campaign("--merge", "x.json", "--result", "x.json", code=2).stderr)
        self.campaign("--robot", "nobody", code=2)
        self.campaign("--only", 1, "--runs", 2, code=2)

    def test_no_silent_error(self):
        table = json.loads(self.table("--runs", RUNS, "--shrink", 0, "--jobs", 2, code=None))
        self.assertEqual(table["done"], RUNS)
        self.assertEqual(table["silent"], [])
        for outcome in ("finished", "stopped", "masked"):
            self.assertGreater(table["outcomes"][outcome], 0)


if __name__ == "__main__":
    main()
