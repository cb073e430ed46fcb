"""A live session does not grow: memory of the program and of the page while simulated time passes as fast as it can.

ARMATURE_LIVE_MINUTES: simulated minutes (default 1; 0.2 with ARMATURE_FEW_DRAWS).
"""

import os
import pathlib
import unittest

from live_program import LivePage, main

MINUTES = float(os.environ.get("ARMATURE_LIVE_MINUTES", "0.2" if "ARMATURE_FEW_DRAWS" in os.environ else "1"))
# The arm moves without an end, and says so.
PROGRAM = """/JOB
//NAME LOOP
//POS
///NPOS 2,0,0,0,0,0
///TOOL 0
///POSTYPE BASE
///RECTAN
///RCONF 0,0,0,0,0,0
C00000=400.000,-80.000,340.000,180.0000,0.0000,180.0000
C00001=400.000,80.000,340.000,180.0000,0.0000,180.0000
//INST
///DATE 2026/01/31 12:00
///ATTR SC,RW
///GROUP1 RB1
NOP
*AGAIN
MOVJ C00000 VJ=100.00
DOUT OT#(1) ON
MOVL C00001 V=400.0 PL=0
DOUT OT#(1) OFF
JUMP *AGAIN
END
"""


def megabytes_of(process, file, key):
    lines = pathlib.Path(f"/proc/{process}/{file}").read_text().splitlines()
    return next(int(line.split()[1]) for line in lines if line.startswith(key + ":")) / 1e3


def line_of(process):
    """A process, the one that it started, and so on: the server, the return points, the session."""
    line = []
    while process:
        line.append(process)
        process = pathlib.Path(f"/proc/{process}/task/{process}/children").read_text().strip()
    return line


class Memory(LivePage):
    def megabytes(self, process):
        """Of the server, of the session, of all of them with the return points, of the page."""
        self.page.of_page("HeapProfiler.collectGarbage")
        heap = self.page.of_page("Runtime.getHeapUsage")["usedSize"] / 1e6
        line = line_of(process.pid)
        alone = [megabytes_of(one, "status", "RssAnon") for one in (line[0], line[-1])]
        return *alone, sum(megabytes_of(one, "smaps_rollup", "Pss") for one in line), heap

    def test_a_session_does_not_grow(self):
        process = self.live("job_pick_and_place", "--pace", "10000", "--set", "input=[]")
        self.open(process)
        self.switch_on()
        self.page.run(f"live.connection.send({{ do: 'load', name: 'LOOP.JBI', text: {PROGRAM!r} }})")
        self.until("live.state.program.loaded && !live.state.program.loading")
        self.click("run")
        self.wait_for("run")
        start = self.state("t")
        shown = []
        for share in (0.2, 0.5, 1):
            self.until(f"live.state.t > {start + 60 * MINUTES * share}", lambda: self.click("resume"))
            shown.append((self.state("t"), *self.megabytes(process)))
            text = "at {:.0f} s: server {:.1f} MB, session {:.1f} MB, all with return points {:.1f} MB, page {:.1f} MB"
            print(text.format(*shown[-1]))
        # Held: the page was silent for a second, for example while it collected garbage.
        self.assertIn(self.state("program.state"), ("runs", "held"), self.page.run("JSON.stringify(live.state)"))
        first, last = shown[0], shown[-1]
        self.assertLess(last[1] - first[1], 2)
        self.assertLess(last[2] - first[2], 4)
        self.assertLess(last[3], 160, "a point has some 0.5 MB of its own, and there are at most 200")
        self.assertLess(last[4] - first[4], 4)
        self.assertEqual(self.page.problems(), [])

    @unittest.skipUnless("ARMATURE_LIVE_FRAMES" in os.environ, "measures this machine: ARMATURE_LIVE_FRAMES=1")
    def test_frames_in_a_second(self):
        self.open(self.live("pendant_jog"))
        self.switch_on()
        self.hold("0+")
        frames = """new Promise((done) => {
          const begin = performance.now(), states = live.states;
          let frames = 0;
          const count = () => {
            frames += 1;
            const s = (performance.now() - begin) / 1000;
            if (s < 5) requestAnimationFrame(count);
            else done([frames / s, (live.states - states) / s, live.state.factor]);
          };
          requestAnimationFrame(count);
        })"""
        print("frames and states in a second, simulated time per real time:", self.page.run(frames))


if __name__ == "__main__":
    main()
