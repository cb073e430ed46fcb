"""A page in headless Chromium, over its DevTools protocol. Only the standard library is used."""

import base64
import json
import os
import select
import shutil
import subprocess
import tempfile
import time

PROGRAM = shutil.which("chromium")
OPTIONS = (
    "--headless=new",
    "--no-sandbox",  # not available to root, in containers
    "--disable-dev-shm-usage",
    "--no-first-run",
    "--disable-extensions",
    "--disable-background-networking",
    "--use-angle=swiftshader",  # WebGL without graphics hardware, and nothing else of graphics on it
    "--enable-unsafe-swiftshader",
    "--disable-gpu-compositing",
    "--disable-gpu-rasterization",
    "--disable-accelerated-2d-canvas",
    # Without graphics hardware most of the time goes into pixels: a quarter of them, and none drawn several times.
    "--force-device-scale-factor=0.5",
    "--webgl-antialiasing-mode=none",
    "--remote-debugging-pipe",
    "--hide-scrollbars",
)
PATIENCE_S = 300  # for one answer, on a slow machine
# How Chromium says that a page was left before its answer.
GONE = ("navigated or closed", "context was destroyed", "Cannot find context", "Cannot find default execution context")


class PageError(Exception):
    pass


class PageGone(PageError):
    """The page was left, for example because it reloads itself, before it had answered."""


class Browser:
    """`with Browser() as browser:` starts Chromium and ends it."""

    def __init__(self, width=1500, height=1000):
        self.size = (width, height)
        self.number = 0
        self.events = []
        self.waiting = b""

    def __enter__(self):
        self.folder = tempfile.TemporaryDirectory(ignore_cleanup_errors=True)
        to_read, self.to_browser = os.pipe()
        self.from_browser, to_write = os.pipe()
        size = "--window-size={},{}".format(*self.size)
        # Chromium reads requests from descriptor 3 and writes answers to 4.
        command = f'exec "$0" "$@" 3<&{to_read} 4>&{to_write}'
        arguments = [PROGRAM, *OPTIONS, size, f"--user-data-dir={self.folder.name}", "about:blank"]
        self.process = subprocess.Popen(
            ["bash", "-c", command, *arguments],
            pass_fds=(to_read, to_write),
            stdin=subprocess.DEVNULL,
            stdout=subprocess.DEVNULL,
            stderr=subprocess.DEVNULL,
        )
        os.close(to_read)
        os.close(to_write)
        targets = self.call("Target.getTargets")["targetInfos"]
        page = next(target for target in targets if target["type"] == "page")
        self.session = self.call("Target.attachToTarget", targetId=page["targetId"], flatten=True)["sessionId"]
        for domain in ("Page", "Runtime", "Log", "Network"):
            self.of_page(domain + ".enable")
        return self

    def __exit__(self, *_):
        self.process.terminate()
        try:
            self.process.wait(timeout=20)
        except subprocess.TimeoutExpired:
            self.process.kill()
            self.process.wait()
        os.close(self.to_browser)
        os.close(self.from_browser)
        self.folder.cleanup()

    def call(self, method, session=None, **parameters):
        self.number += 1
        request = {"id": self.number, "method": method, "params": parameters}
        if session:
            request["sessionId"] = session
        message = json.dumps(request).encode() + b"\0"
        while message:
            message = message[os.write(self.to_browser, message) :]
        deadline = time.monotonic() + PATIENCE_S
        while True:
            answer = self.receive(deadline)
            if answer.get("id") == self.number:
                if "error" in answer:
                    text = answer["error"]["message"]
                    raise (PageGone if any(words in text for words in GONE) else PageError)(f"{method}: {text}")
                return answer["result"]
            self.events.append(answer)

    def receive(self, deadline):
        while b"\0" not in self.waiting:
            if not select.select([self.from_browser], [], [], max(0, deadline - time.monotonic()))[0]:
                raise PageError("Chromium does not answer")
            part = os.read(self.from_browser, 1 << 20)
            if not part:
                raise PageError("Chromium has ended")
            self.waiting += part
        message, _, self.waiting = self.waiting.partition(b"\0")
        return json.loads(message)

    def of_page(self, method, **parameters):
        return self.call(method, self.session, **parameters)

    def open(self, path, fragment=""):
        """Opens a file and waits until its report is shown. Returns the seconds from the start of the page."""
        self.events.clear()
        self.of_page("Page.navigate", url=path.resolve().as_uri() + fragment)
        self.wait_until("document.body && document.body.dataset.ready === 'yes'")
        return self.run("performance.now()") / 1000

    def run(self, script, session=None):
        """The value of an expression in the page, or in another one by its session."""
        asked = {"expression": script, "returnByValue": True, "awaitPromise": True}
        answer = self.call("Runtime.evaluate", session or self.session, **asked)
        if "exceptionDetails" in answer:
            raise PageError(str(answer["exceptionDetails"].get("exception", {}).get("description")))
        return answer["result"].get("value")

    def wait_until(self, script):
        """Until an expression in the page is true. Meanwhile the page may reload itself."""
        deadline = time.monotonic() + PATIENCE_S
        while not self.is_true(script):
            if self.problems() or time.monotonic() > deadline:
                raise PageError(f"never true: {script}; {self.problems()}")
            time.sleep(0.02)

    def is_true(self, script, session=None):
        try:
            return self.run(script, session)
        except PageGone:
            return False

    def problems(self):
        """Errors and warnings of the console, exceptions, and requests for other files than the page."""
        found = []
        for event in self.events:
            what, values = event.get("method"), event.get("params", {})
            if what == "Runtime.exceptionThrown":
                details = values["exceptionDetails"]
                found.append(details.get("exception", {}).get("description", details["text"]))
            elif what == "Runtime.consoleAPICalled" and values["type"] in ("error", "assert"):
                found.append(" ".join(str(one.get("value")) for one in values["args"]))
            elif what == "Log.entryAdded" and values["entry"]["level"] == "error":
                found.append(values["entry"]["text"])
        return found

    def requests(self):
        """Addresses that the page has loaded, without embedded data."""
        urls = [e["params"]["request"]["url"] for e in self.events if e.get("method") == "Network.requestWillBeSent"]
        return [url for url in urls if not url.startswith(("data:", "blob:"))]

    def screenshot(self, path, whole=False):
        answer = self.of_page("Page.captureScreenshot", format="png", captureBeyondViewport=whole)
        path.write_bytes(base64.b64decode(answer["data"]))

    def drag(self, start, end):
        """The left mouse button goes down at `start`, moves to `end` and goes up there."""
        press = {"button": "left", "clickCount": 1}
        self.of_page("Input.dispatchMouseEvent", type="mousePressed", x=start[0], y=start[1], **press)
        for share in (0.25, 0.5, 0.75, 1):
            x, y = (a + (b - a) * share for a, b in zip(start, end))
            self.of_page("Input.dispatchMouseEvent", type="mouseMoved", x=x, y=y, button="left", buttons=1)
        self.of_page("Input.dispatchMouseEvent", type="mouseReleased", x=end[0], y=end[1], **press)
