"""Who gets the live page in a browser: one page at a time, with the token, of the same origin."""

import urllib.error
import urllib.request

from live_program import LivePage, main


class Access(LivePage):
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


if __name__ == "__main__":
    main()
