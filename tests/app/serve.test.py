#!/usr/bin/env python3
"""The page of `plumbline serve`: what a person does in a browser, and what strangers send.

usage: serve.test.py PLUMBLINE

Needs the packages chromium, chromium-driver, python3-selenium. PLUMBLINE_PICTURES names a folder for screenshots.
"""
import contextlib
import http.client
import json
import math
import os
import pathlib
import re
import signal
import socket
import subprocess
import sys
import tarfile
import tempfile
import time
import unittest
import urllib.parse

from selenium import webdriver
from selenium.webdriver.chrome.service import Service
from selenium.webdriver.common.by import By
from selenium.webdriver.common.keys import Keys
from selenium.webdriver.support.ui import Select, WebDriverWait

ROOT = pathlib.Path(__file__).resolve().parents[2]
PLUMBLINE = sys.argv.pop(1)
PICTURES = os.environ.get("PLUMBLINE_PICTURES")
PATIENCE = 120  # seconds, on a machine with other work

#: The chain of the bundled experiment as a servo arm of MuJoCo 3.
ARM = """<mujoco model="bench">
  <compiler angle="radian"/><option gravity="0 0 0"/>
  <default><joint axis="0 0 1" range="-3 3"/><geom type="capsule" size="0.01" fromto="0 0 0 0.25 0 0" mass="0.05"/></default>
  <worldbody>
    <body><joint name="j1"/><geom/><body pos="0.25 0 0"><joint name="j2"/><geom/><body pos="0.25 0 0"><joint name="j3"/><geom/>
    <body pos="0.25 0 0"><joint name="j4"/><geom/><site name="tip" pos="0.25 0 0"/></body></body></body></body>
  </worldbody>
  <actuator><position joint="j1" kp="2"/><position joint="j2" kp="2"/><position joint="j3" kp="2"/><position joint="j4" kp="2"/></actuator>
</mujoco>
"""
BENCH = ROOT / "docs/examples/experiment"


class Server:
    """The program, and the address that it says."""

    def __init__(self):
        self.process = subprocess.Popen([PLUMBLINE, "serve"], stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True)
        self.address = self.process.stdout.readline().removeprefix("Open ").strip()
        found = urllib.parse.urlsplit(self.address)
        self.port, self.path = found.port, found.path

    def ask(self, method, path, body=None, **headers):
        """Status, headers, body; the page's own origin unless another is named."""
        names = {"Origin": f"http://127.0.0.1:{self.port}", **{key.replace("_", "-"): value for key, value in headers.items()}}
        with contextlib.closing(http.client.HTTPConnection("127.0.0.1", self.port, timeout=PATIENCE)) as connection:
            connection.request(method, path, body, {key: value for key, value in names.items() if value is not None})
            answer = connection.getresponse()
            return answer.status, dict(answer.getheaders()), answer.read()

    def raw(self, text, patience=30):
        """What comes back for these bytes."""
        with contextlib.closing(socket.create_connection(("127.0.0.1", self.port), timeout=patience)) as line:
            with contextlib.suppress(OSError):
                line.sendall(text)
                return line.recv(4096)
        return b""

    def end(self):
        self.process.send_signal(signal.SIGINT)
        self.process.wait(timeout=30)
        self.process.stdout.close()


def form(*parts):
    """A form with files: (field, name, bytes)."""
    mark = "part-of-a-form"
    body = b""
    for field, name, text in parts:
        filename = f'; filename="{name}"' if name is not None else ""
        body += (f'--{mark}\r\nContent-Disposition: form-data; name="{field}"{filename}\r\n'
                 "Content-Type: application/octet-stream\r\n\r\n").encode() + text + b"\r\n"
    return body + f"--{mark}--\r\n".encode(), f"multipart/form-data; boundary={mark}"


class Strangers(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.server = Server()

    @classmethod
    def tearDownClass(cls):
        cls.server.end()

    def ask(self, *words, **headers):
        return self.server.ask(*words, **headers)

    def test_only_this_machine_is_listened_to(self):
        listening = pathlib.Path("/proc/net/tcp").read_text()
        own = [line.split()[1] for line in listening.splitlines()[1:]
               if line.split()[1].endswith(f":{self.server.port:04X}") and line.split()[3] == "0A"]
        self.assertEqual(own, [f"0100007F:{self.server.port:04X}"])  # 127.0.0.1
        self.assertNotIn(f":{self.server.port:04X} ", pathlib.Path("/proc/net/tcp6").read_text())

    def test_nothing_without_the_token(self):
        token = self.server.path.strip("/")
        self.assertRegex(token, r"^[0-9a-f]{32}$")
        wrong = token[:-1] + ("0" if token[-1] != "0" else "1")
        for path in ("/", "/page.js", "/progress", f"/{wrong}/", f"/{token[:16]}/", f"/{token}", f"//{token}/", f"/{token.upper()}/x",
                     "/../../etc/passwd", f"/{token}/../../etc/passwd", f"/{token}/model/..%2f..%2fetc%2fpasswd"):
            status, _, body = self.ask("GET", path)
            self.assertEqual(status, 404, path)
            self.assertNotIn(b"root:", body)

    def test_no_other_host_and_no_other_page(self):
        page = self.server.path
        for host in ("evil.example", f"evil.example:{self.server.port}", "127.0.0.1", f"127.0.0.1.evil.example:{self.server.port}", ""):
            self.assertEqual(self.ask("GET", page, Host=host)[0], 403, host)
        for origin in ("http://evil.example", "null", "http://127.0.0.1", f"https://127.0.0.1:{self.server.port}"):
            self.assertEqual(self.ask("GET", page, Origin=origin)[0], 403, origin)
            self.assertEqual(self.ask("POST", page + "example", "", Origin=origin)[0], 403, origin)
        # A form that another page sends without an origin is none of ours.
        self.assertEqual(self.ask("POST", page + "example", "", Origin=None)[0], 404)
        self.assertEqual(self.ask("GET", page, Origin=None)[0], 200)

    def test_every_answer_says_what_a_page_may_do(self):
        for path in (self.server.path, self.server.path + "page.js", "/"):
            headers = self.ask("GET", path)[1]
            self.assertIn("default-src 'none'", headers["Content-Security-Policy"])
            self.assertEqual(headers["X-Content-Type-Options"], "nosniff")
            self.assertEqual(headers["Referrer-Policy"], "no-referrer")
            self.assertEqual(headers["Cache-Control"], "no-store")
            self.assertNotIn("Access-Control-Allow-Origin", headers)

    def test_sizes_are_bounded(self):
        page = self.server.path
        huge = f"POST {page}correct HTTP/1.1\r\nHost: 127.0.0.1:{self.server.port}\r\nOrigin: http://127.0.0.1:{self.server.port}\r\n" \
               f"Content-Length: {1 << 40}\r\n\r\n".encode()
        self.assertIn(b"413", self.server.raw(huge)[:20])
        self.assertIn(b"4", self.server.raw(b"GET /" + b"a" * 100000 + b" HTTP/1.1\r\n\r\n")[:12])
        self.server.raw(b"GET / HTTP/1.1\r\n" + b"".join(b"X-%d: y\r\n" % i for i in range(50000)) + b"\r\n")
        body, kind = form(*[("table", f"t{i}.csv", b"t,x\n") for i in range(300)], ("model", "arm.xml", ARM.encode()))
        status, _, answer = self.ask("POST", page + "take", body, Content_Type=kind)
        self.assertEqual(status, 422)
        self.assertIn("at most 200", json.loads(answer)["error"])
        self.still_there()

    def still_there(self):
        self.assertEqual(self.ask("GET", self.server.path)[0], 200)

    def test_broken_requests(self):
        for text in (b"", b"\r\n\r\n", b"GET\r\n\r\n", b"\x00\xff\xfe" * 1000, b"GET / HTTP/9.9\r\n\r\n",
                     b"POST / HTTP/1.1\r\nTransfer-Encoding: chunked\r\n\r\nzzz\r\n", b"PRI * HTTP/2.0\r\n\r\nSM\r\n\r\n",
                     b"GET / HTTP/1.1\r\nHost: a\r\nHost: b\r\n\r\n", b"GET /%00%ff%2e%2e HTTP/1.1\r\n\r\n"):
            self.assertNotIn(b"200 OK", self.server.raw(text, 5))
        self.still_there()

    def test_requests_that_never_end_stall_nobody(self):
        with contextlib.ExitStack() as open_lines:
            for _ in range(40):
                line = open_lines.enter_context(socket.create_connection(("127.0.0.1", self.server.port), timeout=5))
                line.sendall(b"GET / HTTP/1.1\r\nHost:")
            begin = time.monotonic()
            self.still_there()
            self.assertLess(time.monotonic() - begin, 3)  # a request that waited for one of them would take five

    def test_hostile_files_are_answered_in_a_line(self):
        page, rows = self.server.path, (BENCH / "u-press.csv").read_bytes()
        bomb = b'<!DOCTYPE x [<!ENTITY a "aaaa"><!ENTITY b "&a;&a;">]>' + ARM.encode()
        cases = [
            ([("model", "arm.xml", bomb), ("table", "a.csv", rows)], "entities"),
            ([("model", "arm.xml", b'<mujoco><include file="/etc/shadow"/></mujoco>'), ("table", "a.csv", rows)], "expected"),
            ([("model", "arm.xml", b"<a>" * 100000), ("table", "a.csv", rows)], "expected"),
            ([("model", "arm.exe", b"MZ"), ("table", "a.csv", rows)], ".exe"),
            ([("model", "../../escape.xml", ARM.encode()), ("table", "a.csv", b"\xff\xfe\x00")], "expected"),
            ([("model", ".hidden.xml", ARM.encode()), ("table", "a.csv", rows)], "plain"),
            ([("model", "arm.xml", ARM.encode()), ("table", "experiment.toml", rows)], "plain"),
            ([("model", "arm.xml", ARM.encode()), ("table", "a.csv", b"<script>alert(1)</script>\n")], "no rows of numbers"),
            ([("model", "arm.xml", ARM.encode())], "tables"),
            ([("model", "arm.xml", ARM.encode()), ("model", "b.xml", ARM.encode())], "expected one"),
        ]
        for parts, words in cases:
            body, kind = form(*parts)
            status, _, answer = self.ask("POST", page + "take", body, Content_Type=kind)
            self.assertEqual(status, 422, answer)
            error = json.loads(answer)["error"]
            self.assertIn(words, error)
            self.assertNotIn("\n", error)
        for body in ("", "[", "format = 3", "x = '" + "a" * 100000, "\x00"):
            self.assertIn(self.ask("POST", page + "correct", body)[0], (200, 422))
        self.still_there()

    def test_a_port_that_is_taken(self):
        done = subprocess.run([PLUMBLINE, "serve", "--port", str(self.server.port)], capture_output=True, text=True, check=False,
                              timeout=30)
        self.assertEqual((done.returncode, len(done.stderr.splitlines())), (2, 1))
        self.assertIn("which is taken", done.stderr)


class Person(unittest.TestCase):
    """Drops files, looks, corrects, diagnoses, downloads; by mouse and by keyboard, wide and narrow, light and dark."""

    @classmethod
    def setUpClass(cls):
        cls.server = Server()
        cls.folder = tempfile.TemporaryDirectory()
        options = webdriver.ChromeOptions()
        options.binary_location = "/usr/bin/chromium"
        for word in ("--headless=new", "--no-sandbox", "--disable-gpu", "--disable-background-networking", "--no-first-run",
                     "--disable-sync", "--disable-component-update"):
            options.add_argument(word)
        options.add_experimental_option("prefs", {"download.default_directory": cls.folder.name})
        options.set_capability("goog:loggingPrefs", {"browser": "ALL"})
        cls.browser = webdriver.Chrome(service=Service("/usr/bin/chromedriver"), options=options)
        cls.browser.set_window_size(1200, 1000)

    @classmethod
    def tearDownClass(cls):
        cls.browser.quit()
        cls.server.end()
        cls.folder.cleanup()

    def setUp(self):
        self.browser.get_log("browser")  # what another test's page said, on purpose, is not of this one
        self.browser.get(self.server.address)

    def part(self, name):
        return self.browser.find_element(By.ID, name)

    def until(self, condition):
        return WebDriverWait(self.browser, PATIENCE).until(lambda _: condition())

    def picture(self, name):
        if PICTURES:
            self.browser.save_screenshot(str(pathlib.Path(PICTURES, name + ".png")))

    def files(self):
        """The model, and the bench's tables as a spreadsheet writes them: millimetres, semicolons, decimal commas."""
        place = pathlib.Path(self.folder.name)
        (place / "arm.xml").write_text(ARM)
        for table in sorted(BENCH.glob("*.csv")):
            lines = [line.split(",") for line in table.read_text().splitlines()]
            rows = ["t;x;y;Fx;Fy"] + [";".join([t, f"{1000 * float(x):.9g}", f"{1000 * float(y):.9g}", fx, fy]).replace(".", ",")
                                      for t, x, y, fx, fy in lines[1:]]
            (place / table.name).write_text("\n".join(rows) + "\n")
        return [place / "arm.xml", *sorted(place.glob("*.csv"))]

    def no_complaints(self):
        wrong = [entry["message"] for entry in self.browser.get_log("browser") if entry["level"] == "SEVERE"]
        self.assertEqual(wrong, [])

    def test_from_dropped_files_to_the_corrected_model(self):
        self.picture("empty")
        files = self.files()
        self.part("files").send_keys("\n".join(map(str, files)))
        self.assertEqual(len(self.browser.find_elements(By.CSS_SELECTOR, "#chosen li")), len(files))
        self.part("take").click()
        self.until(lambda: self.part("read").is_displayed())
        settings = self.part("settings").get_attribute("value")
        for words in ('delimiter = ";"', 'decimal = ","', 'unit = "mm"', "joint_stiffness = [2, 2, 2, 2]"):
            self.assertIn(words, settings)
        self.assertTrue(self.browser.find_elements(By.CSS_SELECTOR, "#plots svg"))
        # No table says how the four joints rest: the page asks, the person says it.
        self.assertIn("unloaded joint angles", self.part("question").text)
        rests = dict(re.findall(r'id = "([^"]+)".*?rest = (\[[^\]]+\])', (BENCH / "experiment.toml").read_text(), re.DOTALL))
        for run, rest in rests.items():
            settings = re.sub(rf'(id = "{run}"\ncontrol = "displacement"\n)(rest = [^\n]+\n)?', rf"\1rest = {rest}\n", settings)
        self.picture("guessed")
        self.browser.execute_script("arguments[0].value = arguments[1]; document.getElementById('settings-box').open = true",
                                    self.part("settings"), settings)
        self.part("correct").click()
        self.until(lambda: "Nothing looks like" in self.part("say").text)
        self.picture("corrected")
        self.part("begin").click()
        self.until(lambda: self.browser.find_elements(By.CSS_SELECTOR, "#models a"))
        self.assertIn("joint_friction", self.part("words").get_attribute("textContent"))
        self.assertFalse(self.part("busy").is_displayed())
        self.picture("diagnosed")
        link = self.browser.find_element(By.PARTIAL_LINK_TEXT, "arm-corrected.xml")
        link.click()
        self.part("folder").click()
        place = pathlib.Path(self.folder.name)
        self.until(lambda: (place / "arm-corrected.xml").exists() and (place / "experiment.tar").exists())
        time.sleep(0.5)
        corrected = (place / "arm-corrected.xml").read_text()
        self.assertIn('<joint name="j2"', corrected)
        self.assertRegex(corrected, r'frictionloss="0\.03\d+')
        with tarfile.open(place / "experiment.tar") as archive:
            names = archive.getnames()
            self.assertIn("experiment/experiment.toml", names)
            archive.extractall(place / "out")
        done = subprocess.run([PLUMBLINE, "check-experiment", place / "out/experiment"], capture_output=True, text=True, check=False)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        # The report stands in the page as a whole: its frame has no bar of its own to scroll.
        self.until(lambda: self.browser.execute_script(
            "const page = arguments[0].contentDocument.documentElement;"
            "return page.scrollHeight > 1000 && arguments[0].clientHeight >= page.scrollHeight", self.part("report")))
        self.browser.switch_to.frame(self.part("report"))
        self.assertIn("joint_friction", self.browser.find_element(By.TAG_NAME, "body").text)
        self.browser.switch_to.default_content()
        self.no_complaints()

    def test_columns_that_no_word_tells_are_told_above_them(self):
        place = pathlib.Path(self.folder.name, "told")
        place.mkdir(exist_ok=True)
        (place / "hinge.toml").write_text('[nominal]\njoint = "revolute"\njoint_stiffness = [200.0]\n')
        turns = [0.25 * i for i in range(13)] + [3 - 0.25 * i for i in range(1, 13)]
        rows = "".join(f"{a};{-200 * math.radians(a) - (0.4 if i < 13 else -0.4):.4f}\n" for i, a in enumerate(turns))
        (place / "bench.csv").write_text("Kanal A;Kanal B\n" + rows)
        self.part("files").send_keys(f"{place / 'hinge.toml'}\n{place / 'bench.csv'}")
        self.part("take").click()
        self.until(lambda: self.part("read").is_displayed())
        self.assertIn("Kanal A", self.part("question").text)
        self.assertFalse(self.part("begin").is_enabled())

        def choose(what, value):
            Select(self.browser.find_element(By.CSS_SELECTOR, f'select[aria-label="{what}"]')).select_by_value(value)
        choose("Meaning of Kanal A", "angle")
        choose("Unit of Kanal A", "deg")
        choose("Meaning of Kanal B", "torque")
        choose("Unit of Kanal B", "N m")
        choose("Sign of Kanal B", "-1")
        self.assertEqual(self.part("columns").get_attribute("value"), "angle=Kanal A:deg,torque=-Kanal B:N m")
        self.picture("told")
        self.part("retell").click()
        self.until(lambda: "Nothing looks like" in self.part("say").text)
        self.assertEqual(self.browser.switch_to.active_element.get_attribute("id"), "read-title")
        self.assertIn("torque, N m", self.part("plots").text)
        self.picture("taken")
        self.no_complaints()

    def test_the_example_by_keyboard_alone_in_the_dark_on_a_phone(self):
        self.browser.execute_cdp_cmd("Emulation.setEmulatedMedia", {"features": [{"name": "prefers-color-scheme", "value": "dark"}]})
        self.browser.execute_cdp_cmd("Emulation.setDeviceMetricsOverride",
                                     {"width": 390, "height": 844, "deviceScaleFactor": 1, "mobile": True})
        try:
            focus = lambda: self.browser.switch_to.active_element
            press = lambda key: webdriver.ActionChains(self.browser).send_keys(key).perform()
            for _ in range(10):
                press(Keys.TAB)
                if focus().get_attribute("id") == "example":
                    break
            self.assertEqual(focus().get_attribute("id"), "example")
            press(Keys.ENTER)
            self.until(lambda: self.part("read").is_displayed())
            self.assertEqual(focus().get_attribute("id"), "read-title")
            self.picture("phone-dark")
            wide = self.browser.execute_script("return document.documentElement.scrollWidth")
            self.assertLessEqual(wide, 390)
            paper, ink = (self.browser.execute_script("return getComputedStyle(document.body)." + which) for which in
                          ("backgroundColor", "color"))
            self.assertLess(sum(map(int, re.findall(r"\d+", paper)[:3])), sum(map(int, re.findall(r"\d+", ink)[:3])))
            for _ in range(20):
                press(Keys.TAB)
                if focus().get_attribute("id") == "begin":
                    break
            press(Keys.ENTER)
            self.until(lambda: "Diagnosed." in self.part("say").text)
            self.picture("phone-dark-diagnosed")
        finally:
            self.browser.execute_cdp_cmd("Emulation.clearDeviceMetricsOverride", {})
            self.browser.execute_cdp_cmd("Emulation.setEmulatedMedia", {"features": []})

    def test_what_a_screen_reader_is_told(self):
        tree = self.browser.execute_cdp_cmd("Accessibility.getFullAXTree", {})["nodes"]
        said = {(node["role"]["value"], node.get("name", {}).get("value", "")) for node in tree if not node.get("ignored")}
        roles = {role for role, _ in said}
        self.assertTrue({"heading", "button", "main", "status"} <= roles, roles)
        for role, name in said:
            if role in ("button", "textbox", "heading", "link", "progressbar", "checkbox"):
                self.assertTrue(name.strip(), f"a {role} without a name")
        self.assertEqual(self.browser.execute_script("return document.documentElement.lang"), "en")

    def test_a_wrong_file_is_answered_beside_the_button(self):
        place = pathlib.Path(self.folder.name, "wrong")
        place.mkdir(exist_ok=True)
        (place / "arm.xml").write_text("<mujoco><worldbody><body><joint name='<b>' axis='0 0 0'/></body></worldbody></mujoco>")
        (place / "a.csv").write_text("t,x\n1,2\n2,3\n")
        self.part("files").send_keys(f"{place / 'arm.xml'}\n{place / 'a.csv'}")
        self.part("take").click()
        self.until(lambda: "axis of no length" in self.part("say").text)
        self.assertIn("wrong", self.part("say").get_attribute("class"))
        self.assertFalse(self.part("read").is_displayed())

    def test_a_diagnosis_that_is_given_up(self):
        self.part("example").click()
        self.until(lambda: self.part("read").is_displayed())
        self.part("begin").click()
        self.until(lambda: self.part("cancel").is_displayed())
        with contextlib.suppress(Exception):  # it may be done before
            self.part("cancel").click()
        self.until(lambda: re.search("Given up|Diagnosed", self.part("say").text))
        self.part("begin").click()
        self.until(lambda: "Diagnosed." in self.part("say").text)


if __name__ == "__main__":
    unittest.main()
