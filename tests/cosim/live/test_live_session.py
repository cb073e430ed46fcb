"""A session of the live page in a browser: it goes back and on, its page is closed or frozen, it is repeated."""

import shlex

from live_program import LivePage, main


class Session(LivePage):
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

    def test_the_page_says_that_the_program_has_ended(self):
        process = self.live("pendant_jog")
        self.open(process)
        self.switch_on()
        self.end(process)
        self.until("live.connection.status === 'lost'")
        self.page.run("live.status.show(live.state)")  # as a picture that comes late
        self.assertEqual(
            self.page.run("[live.status.state.textContent, live.status.state.dataset.state]"), ["no connection", "off"]
        )

    def test_a_slow_first_picture_does_not_stop_the_arm(self):
        slow = """const draw = window.requestAnimationFrame;
          const blocked_ms = [300, 1500];
          window.requestAnimationFrame = (show) => draw.call(window, (now) => {
            const end = performance.now() + (window.live && blocked_ms.shift() || 0);
            while (performance.now() < end);
            show(now);
          });"""
        process = self.live("pendant_jog")
        script = self.page.of_page("Page.addScriptToEvaluateOnNewDocument", source=slow)["identifier"]
        self.addCleanup(self.page.of_page, "Page.removeScriptToEvaluateOnNewDocument", identifier=script)
        self.open(process)
        self.switch_on()
        self.assertEqual(self.state("messages"), ["connected", "servo: ok"])


if __name__ == "__main__":
    main()
