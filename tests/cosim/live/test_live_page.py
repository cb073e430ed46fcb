"""The live page in a browser: a person jogs, moves, clicks faults, stops, runs a program."""

import json

from live_program import SCENARIOS, LivePage, main
from mesh_files import write_part, write_scenario


class Live(LivePage):
    def test_a_jog_lasts_as_long_as_its_button_is_held(self):
        process = self.live("pendant_jog")
        self.open(process)
        self.switch_on()
        lamp = "document.getElementById('lamp-moving').classList.contains('on')"
        self.hold("1+", f"live.state.joints_deg[1] > 2 && {lamp}")
        self.mouse("mouseReleased", '[data-jog="1+"]')
        self.wait_for("ready")
        # The picture follows the arm, and the plots have what it did.
        self.until("live.state.joints_deg.every((angle, i) => Math.abs(angle - live.arm.joints[i]) < 0.01)")
        self.until("live.plots.rows.position.at(-1)[2] > 2")
        self.slide("J5", 60)  # away from the wrist singularity
        self.reach("live.state.state === 'ready' && live.state.joints_deg[4] > 59.99", lambda: self.click("go-joints"))
        self.page.run("live.jog.choose(1)")  # coordinates of the base
        before = self.state("tool.xyz_mm")
        self.hold("2-", f"live.state.tool.xyz_mm[2] < {before[2] - 3}")
        self.mouse("mouseReleased", '[data-jog="2-"]')
        self.wait_for("ready")
        after = self.state("tool.xyz_mm")
        for i in (0, 1):
            self.assertAlmostEqual(before[i], after[i], delta=0.1)
        self.assertEqual(self.page.problems(), [])
        self.assertEqual(self.page.requests(), [process.address])

    def test_moves_to_taught_points_and_to_the_shadow(self):
        self.open(self.live("pendant_jog"))
        self.switch_on()
        self.slide("J1", 20)
        self.slide("J5", 40)
        self.until("!live.hand.asked")
        self.assertEqual(self.state("joints_deg")[0], 0, "the shadow moves, not the arm")
        there = "live.state.state === 'ready' && Math.abs(live.state.joints_deg[0] - 20) < 0.01"
        self.reach(there, lambda: self.click("go-joints"))
        self.assertAlmostEqual(self.state("joints_deg")[4], 40, delta=0.01)
        self.click("teach")
        z = self.state("tool.xyz_mm")[2]
        self.slide("z", z + 30)
        self.until("!live.hand.asked")
        self.reach(
            f"live.state.state === 'ready' && live.state.tool.xyz_mm[2] > {z + 29}", lambda: self.click("go-line")
        )
        there = f"live.state.state === 'ready' && Math.abs(live.state.tool.xyz_mm[2] - {z}) < 0.05"
        self.reach(there, lambda: self.press_point(1))  # MOVL
        self.page.run("live.drive.points[0].tool.xyz_mm[1] += 20")  # a via point beside the line
        self.press_point(3)
        self.slide("z", z + 30)
        self.until("!live.hand.asked")
        self.click("teach")
        self.page.run("live.drive.points[1].tool.xyz_mm[2] += 30")
        self.page.run(
            "window.arcs = 0; setInterval(() => { window.arcs += live.state.command.startsWith('arc'); }, 10)"
        )
        there = f"live.state.state === 'ready' && Math.abs(live.state.tool.xyz_mm[2] - {z + 30}) < 0.05"
        self.reach(there, lambda: self.press_point(6))  # MOVC
        self.assertGreater(self.page.run("window.arcs"), 0)
        self.assertEqual(self.page.problems(), [])

    def test_the_emergency_stop_and_the_way_out_of_it(self):
        self.open(self.live("pendant_jog"))
        self.switch_on()
        self.hold("0-")
        self.click("estop")
        self.wait_for("estop")
        self.page.wait_until("document.getElementById('lamp-estop').classList.contains('on')")
        self.mouse("mouseReleased", '[data-jog="0-"]')
        self.assertFalse(self.state("drives"))
        self.click("reset")
        self.wait_for("idle")
        self.switch_on()

    def test_faults_and_inputs_by_a_click(self):
        self.open(self.live("pendant_jog"))
        self.switch_on()
        self.page.run("document.querySelector('[data-input=\"5\"]').click()")
        self.page.run("document.querySelector('[data-hold=\"home 2\"]').click()")
        self.until("live.state.lamps.inputs === 16 && document.querySelector('.held[data-hold=\"home 2\"]') !== null")
        self.page.run("live.faults.choose('drive_alarm')")
        self.click("cause")
        self.wait_for("alarm")
        self.until(
            "live.state.events.some(event => /^tick \\d+, warning: .* fault: drive_alarm of axis 1/.test(event))"
        )
        self.page.run("live.faults.choose('estop'); live.faults.fields[0].value = -1")
        self.click("cause")
        self.until("document.getElementById('problem').textContent.includes('duration_s')")
        self.assertEqual(self.page.problems(), [])

    def test_a_program_is_loaded_run_held_and_stepped(self):
        self.open(self.live("job_pick_and_place"))
        self.switch_on()
        self.click("load")
        self.until("live.state.program.loaded && !live.state.program.loading")
        line = self.page.run("live.program.lines.findIndex(line => /^WAIT/.test(line.textContent)) + 1")
        self.page.run(f"live.program.lines[{line - 1}].click()")  # a breakpoint
        self.until(f"live.state.program.breakpoints.includes({line})")
        self.click("run")
        self.wait_for("hold")
        self.until(f"live.state.program.line === {line} && live.program.lines[{line - 1}].matches('.current.stop')")
        self.until("live.state.t > 1.7")  # the part of the scenario has gone
        self.click("step")
        # The answer comes before the step has ended.
        self.until("live.state.events.some(event => event.endsWith('for input 1: its time is over'))")
        self.until("live.state.events.at(-1).endsWith('paused') && live.state.state === 'hold'")
        self.click("resume")
        self.until("live.state.program.state === 'ended' && live.state.state === 'ready'")
        self.until("live.state.messages.includes('message: \"no part\"')")
        self.assertEqual(self.page.problems(), [])


class Sliders(LivePage):
    def test_five_axes_have_four_solutions_to_pick_and_reasons_when_there_is_none(self):
        self.open(self.live("arm_5r_pick_place"))
        self.switch_on()
        for axis, deg in (("J1", 15), ("J2", 30), ("J3", 40), ("J4", 20)):
            self.slide(axis, deg)
        self.until("!live.hand.asked")
        place = self.page.run("live.hand.hand.map(input => Number(input.value))")
        self.slide("z", place[2] + 1)
        self.until("!live.hand.asked && document.querySelectorAll('.solutions button').length > 1")
        count = self.page.run("document.querySelectorAll('.solutions button').length")
        self.assertLessEqual(count, 4)
        self.assertEqual(self.page.run("live.arm.ghosts.filter(ghost => ghost.links[0].visible).length"), count - 1)
        # The other way gives the same place.
        joints = self.page.run("live.hand.shadow")
        point = self.page.run(f"live.arm.run.kinematics.toolPoint({json.dumps(joints)})")
        for ours, theirs in zip(point, (place[0], place[1], place[2] + 1)):
            self.assertAlmostEqual(ours, theirs, delta=0.26)  # half a step of a slider
        self.slide("x", self.page.run("Number(document.querySelector('[data-axis=\"x\"]').max)"))
        self.page.wait_until("document.querySelector('.why').textContent.includes('out of reach by')")
        self.assertEqual(self.page.run("live.hand.shadow"), joints, "the shadow stays where it was")
        self.assertEqual(self.page.problems(), [])

    def test_the_arm_follows_the_slider_when_it_is_asked_to(self):
        self.open(self.live("arm_5r_pick_place"))
        self.switch_on()
        for axis, deg in (("J2", 20), ("J3", 40), ("J4", 20)):
            self.slide(axis, deg)
        self.click("follows")
        there = "live.state.state === 'ready' && Math.abs(live.state.joints_deg[0] - 10) < 0.02"
        self.reach(there, lambda: self.slide("J1", 10))
        self.slide("z", self.state("tool.xyz_mm")[2] + 10)
        z = self.page.run("Number(document.querySelector('[data-axis=\"z\"]').value)")
        self.until(f"live.state.state === 'ready' && Math.abs(live.state.tool.xyz_mm[2] - {z}) < 0.1")


class Meshes(LivePage):
    def test_the_parts_and_their_ghosts_have_the_shapes_of_the_files(self):
        links = ", ".join(['"part.stl"'] * 6)
        write_part(self.folder / "part.stl", [(0, 0, 0), (50, 0, 0), (0, 50, 0)])
        write_scenario(self.folder / "jog.toml", SCENARIOS / "pendant_jog", f'base = "part.stl"\nlinks = [{links}]')
        self.open(self.live("jog.toml"))
        parts = "[...live.arm.links.slice(0, 6), live.arm.base, ...live.arm.shadow.links.slice(0, 6)]"
        counts = self.page.run(
            f"{parts}.map(group => group.children.filter(child => child.isMesh).map(part => part.geometry.index.count))"
        )
        self.assertEqual(counts, [[3]] * 13)
        self.assertEqual(self.page.problems(), [])


if __name__ == "__main__":
    main()
