"""The live page in a browser: a person jogs, moves, runs a program, stops; the page is closed, opened twice, reloaded."""

import json
import shlex
import urllib.error
import urllib.request

from live_program import LivePage, main


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

    def test_the_time_bar_goes_back_and_the_session_goes_on_from_there(self):
        process = self.live("pendant_jog")
        self.open(process)
        self.switch_on()
        self.hold("0+", "live.state.joints_deg[0] > 1")
        then, deg = self.page.run("[live.state.t, live.state.joints_deg[0]]")
        self.hold("0+", f"live.state.joints_deg[0] > {deg + 10}")
        self.mouse("mouseReleased", '[data-jog="0+"]')
        self.wait_for("ready")
        end = self.state("t")
        for time in (0.5 * then, 0.9 * end, then):  # of those that come fast the last one is shown
            self.page.run(
                f"(b => {{ b.value = {time}; b.dispatchEvent(new Event('input')); }})(document.getElementById('time-bar'))"
            )
        self.until(f"live.state.bar.looking && Math.abs(live.state.t - {then}) < 0.01 && !live.state.bar.on_the_way")
        self.assertTrue(self.page.run("live.plots.rows.position.every(row => row[0] <= live.state.t)"))
        self.assertAlmostEqual(self.state("joints_deg")[0], deg, delta=0.1)
        self.click("to-end")
        self.until(f"!live.state.bar.looking && live.state.t > {end} && live.state.joints_deg[0] > {deg + 10}")
        self.page.run(f"live.past.look({then})")
        self.until(f"live.state.bar.looking && live.state.t < {end}")
        self.click("go-live")  # also on the way
        self.until(f"!live.state.bar.looking && live.state.bar.end_s < {end}")
        self.wait_for("ready")
        self.assertLess(self.state("joints_deg")[0], deg + 8, "the jog that was cut off does not go on")
        self.assertEqual(self.page.problems(), [])
        self.expect_repeated(self.end(process))

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

    def test_closing_the_page_stops_the_arm_and_the_session_can_be_repeated(self):
        process = self.live("pendant_jog")
        self.open(process)
        self.switch_on()
        self.hold("0+", "live.state.joints_deg[0] > 1")
        self.leave()
        self.open(process)
        self.wait_for("ready")
        deg = self.state("joints_deg")[0]
        self.page.run("new Promise(done => setTimeout(done, 400))")
        self.assertEqual(self.state("joints_deg")[0], deg)
        self.expect_repeated(self.end(process))

    def expect_repeated(self, out):
        """The run that the session has printed has its bytes."""
        self.leave()
        command = shlex.split(next(line for line in out.splitlines() if line.startswith("to repeat it")))[3:]
        self.assertEqual(command[:2], ["armature", "run"])
        again = self.armature(*command[1:], code=None).stdout
        digest = next(line.split()[1] for line in out.splitlines() if line.startswith("sha256"))
        self.assertIn(digest, again)
        live, replay = (self.folder / "live" / name for name in ("serial.csv", "replay/serial.csv"))
        self.assertGreater(live.stat().st_size, 10_000)
        self.assertEqual(live.read_bytes(), replay.read_bytes())

    def test_a_frozen_page_stops_the_arm(self):
        self.open(self.live("pendant_jog"))
        self.switch_on()
        self.hold("0+")
        self.page.run("(() => { const end = performance.now() + 2500; while (performance.now() < end); })()")
        self.wait_for("ready")
        self.until("live.state.messages.some(text => text.includes('nobody is at the page'))")
        deg = self.state("joints_deg")[0]
        self.page.run("new Promise(done => setTimeout(done, 300))")  # the button is still held
        self.assertEqual(self.state("joints_deg")[0], deg)
        self.mouse("mouseReleased", '[data-jog="0+"]')
        self.hold("0+", f"live.state.joints_deg[0] > {deg + 0.5}")
        self.mouse("mouseReleased", '[data-jog="0+"]')

    def test_a_second_page_waits_until_the_first_is_closed(self):
        process = self.live("pendant_jog")
        self.open(process)
        self.switch_on()
        target = self.page.call("Target.createTarget", url=process.address)["targetId"]
        self.addCleanup(self.page.call, "Target.closeTarget", targetId=target)
        second = self.page.call("Target.attachToTarget", targetId=target, flatten=True)["sessionId"]

        def until(script):
            # It may not have loaded yet.
            told = "JSON.stringify({...(document.body && document.body.dataset)})"
            self.wait_until(lambda: self.page.is_true(script, second), lambda: str(self.page.is_true(told, second)))

        until("document.body && document.body.dataset.status === 'busy'")
        self.assertIn("Another page", self.page.run("document.getElementById('problem').textContent", second))
        self.assertEqual(self.state(), "ready", "the first one goes on")
        self.leave()
        until("document.body.dataset.ready === 'yes'")

    def test_a_reload_takes_the_arm_again(self):
        self.open(self.live("pendant_jog"))
        self.switch_on()
        self.page.of_page("Page.reload")
        self.page.wait_until(f"performance.getEntriesByType('navigation')[0].type === 'reload'")
        self.page.wait_until("document.body && document.body.dataset.ready === 'yes'")
        self.wait_for("ready")
        self.assertTrue(self.state("drives"))
        self.hold("0+")
        self.mouse("mouseReleased", '[data-jog="0+"]')
        self.wait_for("ready")

    def test_a_page_of_another_origin_gets_nothing(self):
        process = self.live("pendant_jog")
        evil = self.text("evil.html", "<script>window.seen = []</script>")
        self.page.of_page("Page.navigate", url=(self.folder / evil).resolve().as_uri())
        self.page.wait_until("window.seen !== undefined")
        attack = """new Promise((done) => {
          const seen = [];
          const socket = new WebSocket('ws://127.0.0.1:%d/%s/socket');
          socket.onopen = () => { seen.push('open'); socket.send('{"do":"estop"}'); };
          socket.onmessage = (event) => seen.push(event.data);
          socket.onclose = () => fetch('%s').then((r) => r.text()).then((t) => seen.push(t), () => seen.push('no fetch'))
            .then(() => done(seen));
        })"""
        attack %= (process.port, process.token, process.address)
        self.assertEqual(self.page.run(attack), ["no fetch"])
        frame = """new Promise((done) => {
          const frame = document.createElement('iframe');
          frame.onload = () => { let text; try { text = frame.contentDocument.title } catch { text = 'closed' } done(text); };
          frame.src = '%s'; document.body ? document.body.append(frame) : document.documentElement.append(frame);
        })"""
        frame %= process.address
        self.assertNotIn("live", self.page.run(frame) or "")
        self.open(process)
        self.wait_for("idle")

    def test_without_the_token_there_is_no_page(self):
        process = self.live("pendant_jog")
        root = f"http://127.0.0.1:{process.port}"
        for address in (root + "/", root + "/socket", root + "/" + process.token[:-1] + "/"):
            with self.assertRaises(urllib.error.HTTPError) as caught:
                urllib.request.urlopen(address, timeout=60)
            self.assertEqual(caught.exception.code, 403)
            self.assertIn("token", caught.exception.read().decode())
        request = urllib.request.Request(process.address, headers={"Host": f"rebound.example:{process.port}"})
        with self.assertRaises(urllib.error.HTTPError) as caught:
            urllib.request.urlopen(request, timeout=60)
        self.assertIn("host", caught.exception.read().decode())


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


if __name__ == "__main__":
    main()
