"""What the tests of the live page share: `armature live` beside a browser."""

import pathlib
import re
import signal
import sys
import time
import unittest

TESTS = pathlib.Path(__file__).resolve().parents[1]
sys.path[:0] = [str(TESTS / "cli"), str(TESTS / "page")]

import browser  # noqa: E402
from cli_program import SCENARIOS, Program, main  # noqa: E402, F401

ADDRESS = re.compile(r"http://127\.0\.0\.1:(\d+)/([0-9a-f]{32})/\n$")
READY = "document.body && document.body.dataset.ready === 'yes'"


class LiveProgram(Program):
    def live(self, scenario, *options):
        """The process, with its address, port and token."""
        process, found = self.listening(ADDRESS, "live", scenario, "--out", "live", *options)
        process.address, process.port, process.token = found[0].strip(), int(found[1]), found[2]
        return process

    def end(self, process):
        """Ends it as Ctrl-C does; what it printed after its address."""
        process.send_signal(signal.SIGINT)
        out, err = process.communicate(timeout=60)
        self.assertEqual((process.returncode, err), (130, ""))
        return out


@unittest.skipIf(browser.PROGRAM is None, "Chromium is not installed")
class LivePage(LiveProgram):
    """A person at the page."""

    page = None  # of the browser, which all tests of a file share

    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        if LivePage.page is None:
            LivePage.page = unittest.enterModuleContext(browser.Browser(1500, 1400))

    def open(self, process):
        self.page.events.clear()
        self.page.of_page("Page.navigate", url=process.address)
        self.page.wait_until(READY)

    def leave(self):
        self.page.of_page("Page.navigate", url="about:blank")

    def state(self, key="state"):
        return self.page.run(f"live.state.{key}")

    def click(self, element):
        self.page.run(f"document.getElementById('{element}').click()")

    def wait_for(self, state):
        self.until(f"live.state.state === '{state}'")

    def until(self, script, again=None):
        """Until an expression in the page is true; a failure tells what the page shows.

        On a busy machine the page may be silent for a second, and then the arm stops. `again` is called when it rests.
        """
        while again and not self.page.is_true(script) and not self.page.problems():
            rests = "['ready', 'hold'].includes(live.state.state)"
            if self.soon(f"({script}) || !{rests}", 3):
                self.soon(f"({script}) || {rests}", 60)
            else:
                again()
        try:
            self.page.wait_until(script)
        except browser.PageError as error:
            raise AssertionError(f"{error}\n{self.page.run('JSON.stringify(window.live && live.state)')}") from error

    def soon(self, script, seconds):
        """Whether an expression in the page becomes true within this time."""
        end = time.monotonic() + seconds
        while not self.page.is_true(script):
            if time.monotonic() > end:
                return False
            time.sleep(0.02)
        return True

    def switch_on(self):
        self.wait_for("idle")
        self.click("servo")
        self.wait_for("ready")

    def mouse(self, kind, selector):
        x, y = self.page.run(
            f"(b => [b.x + b.width / 2, b.y + b.height / 2])(document.querySelector('{selector}').getBoundingClientRect())"
        )
        self.page.of_page("Input.dispatchMouseEvent", type=kind, x=x, y=y, button="left", clickCount=1)

    def reach(self, script, move):
        """Moves the arm until an expression is true."""
        move()
        self.until(script, move)

    def press_point(self, number):
        """A button of the list of taught points: four for each."""
        self.page.run(f"document.querySelectorAll('.points button')[{number}].click()")

    def hold(self, key, until="live.state.state === 'jog'"):
        """Presses a jog button, such as `1+`, and leaves it pressed, until an expression is true."""
        button = f'[data-jog="{key}"]'

        def again():
            self.mouse("mouseReleased", button)
            self.mouse("mousePressed", button)

        self.mouse("mousePressed", button)
        self.until(until, again)

    def slide(self, axis, value):
        self.page.run(
            f"(s => {{ s.value = {value}; s.dispatchEvent(new Event('input')); s.dispatchEvent(new Event('change')); }})"
            f"(document.querySelector('[data-axis=\"{axis}\"]'))"
        )
