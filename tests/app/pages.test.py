#!/usr/bin/env python3
"""The pages of `diagnose --html` and `verify --html`, looked at by a browser.

usage: pages.test.py PLUMBLINE

A page must need nothing but itself, show the numbers of the JSON report of the same diagnosis and all of
them, be well-formed, fit a phone, and print. Needs the packages chromium, chromium-driver, python3-selenium.
"""

import base64
import json
import math
import pathlib
import random
import re
import subprocess
import sys
import tempfile
import unittest
import xml.etree.ElementTree as xml
from collections import Counter

from selenium import webdriver
from selenium.common.exceptions import WebDriverException
from selenium.webdriver.chrome.service import Service

ROOT = pathlib.Path(__file__).resolve().parents[2]
PLUMBLINE = sys.argv.pop(1)
RAISED = str.maketrans("⁰¹²³⁴⁵⁶⁷⁸⁹⁻", "0123456789-")


# --- experiments, one a verdict and one at a joint: a single link pushed aside, its end point measured


def angle(force, torque):
    """Where the spring of 1 N m/rad holds the force at the end of a link of 1 m; `torque` may add to it."""
    low, high = -1.5, 1.5
    for _ in range(60):
        q = (low + high) / 2
        if q + torque(q) < math.cos(q) * force:
            low = q
        else:
            high = q
    return q


def write_experiment(folder, name, torque, sigma=1e-3):
    """Three runs of 40 readings with normal noise; the same at every call."""
    folder.mkdir()
    noise = random.Random(name)
    runs = ""
    for number, most in enumerate((0.5, -0.5, 0.4)):
        rows = ["t,x,y,Fx,Fy"]
        for i in range(40):
            force = most * i / 39
            q = angle(force, torque)
            x, y = (part + noise.gauss(0, sigma) for part in (math.cos(q), math.sin(q)))
            rows.append(f"{i},{x},{y},0,{force}")
        (folder / f"r{number}.csv").write_text("\n".join(rows) + "\n")
        runs += (f'[[run]]\nid = "push <{number}> & back"\ncontrol = "force"\nrest = [0.0]\n'
                 f'samples = "r{number}.csv"\n')
    (folder / "experiment.toml").write_text(
        f'format = "chain-experiment/1"\nname = "{name}"\n[nominal]\nlink_length = [1.0]\njoint_stiffness = [1.0]\n'
        f'[bench]\ngravity_plane = "horizontal"\n[noise]\nx = {sigma}\ny = {sigma}\n{runs}')


TORQUES = {
    "none": lambda q: 0,
    "ambiguous": lambda q: 0.2 * q,  # a stiffer joint, or a load cell that reads too much
    "unknown": lambda q: 0.05 * math.sin(15 * q),
    "unpredicted": lambda q: 0.05 * math.sin(100 * q),  # unknown, and too fine for any law
    "stopped": lambda q: math.copysign(5 * max(0, abs(q) - 0.25), q),  # identified, at a joint
}


# --- numbers


def shown_as(text, value):
    """Whether the text is the value, rounded as it says."""
    text = text.replace("−", "-")
    if text.endswith(" to 1"):
        value = math.exp(value)
        if text.startswith("over a million"):
            return value > 1e6
        text = text[: -len(" to 1")]
    percent = text.endswith(" %")
    unit = 0.01 if percent else 1
    text = text.removesuffix(" %")
    if text.startswith("> "):
        return float(text[2:]) * unit <= value <= 1
    match = re.fullmatch(r"(< )?(?:(-?\d+(?:\.(\d+))?)(?: × )?)?(?:10([⁻⁰¹²³⁴⁵⁶⁷⁸⁹]+))?", text)
    if not match:
        return False
    below, digits, decimals, power = match.groups()
    scale = unit * 10.0 ** int(power.translate(RAISED)) if power else unit
    read = float(digits or 1) * scale
    if below:
        return 0 <= value < read
    half = 0.5 * scale * 10.0 ** -len(decimals or "")
    allowed = half if percent else min(half, 0.005 * abs(read))
    return abs(value - read) <= allowed * (1 + 1e-9) + 1e-15


def numbers(report, at=""):
    """Every number of a JSON value by its pointer."""
    if isinstance(report, bool) or report is None or isinstance(report, str):
        return {}
    if isinstance(report, (int, float)):
        return {at: report}
    items = report.items() if isinstance(report, dict) else enumerate(report)
    found = {}
    for key, part in items:
        found.update(numbers(part, f"{at}/{key}"))
    return found


def expected_numbers(report):
    """Those that the page writes: the points of what is missing are drawn; without a gap there is no more to say. Each effect's own
    probability is told where the verdict leaves it open, a discrepancy where there is one."""
    drawn = ("/where/unexplained/points", "/law/laws", "/law/cross_validated", "/cause/effect_probabilities",
             *(() if report["cause"]["discrepancy"] > 0 else ("/cause/discrepancy",))) if report["gap"]["present"] else ("/where", "/cause", "/shrink", "/next")
    return {key: value for key, value in numbers(report).items() if not key.startswith(drawn)}


def complaints(shown, report):
    """What is wrong with the (key, value, text) of a page."""
    right = numbers(report)
    found = []
    for key, value, text in shown:
        if key not in right:
            found.append(f"{key}: not in the report")
        elif float(value) != right[key]:
            found.append(f"{key}: page has {value}, report {right[key]}")
        elif not shown_as(text, right[key]):
            found.append(f'{key}: {right[key]} is shown as "{text}"')
    missing = expected_numbers(report).keys() - {key for key, _, _ in shown}
    return found + [f"{key}: not on the page" for key in sorted(missing)]


# --- the browser


class Browser:
    def __init__(self):
        options = webdriver.ChromeOptions()
        for argument in ("--headless=new", "--no-sandbox", "--disable-gpu", "--disable-dev-shm-usage"):
            options.add_argument(argument)
        options.set_capability("goog:loggingPrefs", {"browser": "ALL", "performance": "ALL"})
        self.driver = self.started(options)

    @staticmethod
    def started(options, tries=3):
        # The first start on a busy machine can miss Selenium's deadline of half a minute.
        try:
            return webdriver.Chrome(service=Service("/usr/bin/chromedriver"), options=options)
        except WebDriverException:
            if tries == 1:
                raise
            return Browser.started(options, tries - 1)

    def close(self):
        self.driver.quit()

    def open(self, path, width=1280):
        self.driver.execute_cdp_cmd(
            "Emulation.setDeviceMetricsOverride",
            {"width": width, "height": 844, "deviceScaleFactor": 1, "mobile": width < 600})
        self.driver.get(path.as_uri())

    def run(self, script):
        return self.driver.execute_script("return " + script)

    def logged(self):
        return self.driver.get_log("browser")

    def requested(self):
        messages = (json.loads(entry["message"])["message"] for entry in self.driver.get_log("performance"))
        return [message["params"]["request"]["url"] for message in messages
                if message["method"] == "Network.requestWillBeSent"]

    def numbers(self):
        return self.run("[...document.querySelectorAll('data')].map(d => [d.dataset.key, d.value, d.textContent])")

    def visible(self, selector):
        elements = f"[...document.querySelectorAll('{selector}')]"
        return self.run(f"{elements}.filter(e => e.checkVisibility()).map(e => e.id)")


class Pages(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.scratch = tempfile.TemporaryDirectory()
        folder = pathlib.Path(cls.scratch.name)
        cls.pages, cls.reports = {}, {}
        for verdict in (*TORQUES, "identified", "verify"):
            cls.pages[verdict], report = folder / f"{verdict}.html", folder / f"{verdict}.json"
            command = ["verify" if verdict == "verify" else "diagnose"]
            if verdict in TORQUES:
                write_experiment(folder / verdict, verdict, TORQUES[verdict])
                command.append(str(folder / verdict))
            subprocess.run([PLUMBLINE, *command, "--html", cls.pages[verdict], "--json", report], check=True,
                           stdout=subprocess.DEVNULL)
            cls.reports[verdict] = json.loads(report.read_text())
        cls.claims = cls.reports["verify"]["claims"]
        cls.browser = Browser()

    @classmethod
    def tearDownClass(cls):
        cls.browser.close()
        cls.scratch.cleanup()

    def diagnoses(self):
        return [(verdict, self.pages[verdict], self.reports[verdict]) for verdict in (*TORQUES, "identified")]

    def altered(self, verdict, old, new):
        """A copy of the page in which the first match is replaced."""
        text, count = re.subn(old, new, self.pages[verdict].read_text(), count=1)
        self.assertEqual(count, 1)
        copy = self.pages[verdict].with_name("altered.html")
        copy.write_text(text)
        return copy

    def test_experiments_have_the_verdicts_that_they_are_named_for(self):
        for verdict, _, report in self.diagnoses():
            # waves as fine as the readings scatter many times the declared noise
            expected = {"stopped": "identified", "unpredicted": "unknown"}.get(verdict, verdict)
            self.assertEqual(report["cause"]["verdict"], expected)
        self.assertEqual(self.reports["stopped"]["cause"]["effects"][0]["joint"], 1)

    def test_numbers_are_those_of_the_report_and_all_are_there(self):
        for verdict, page, report in self.diagnoses():
            with self.subTest(verdict):
                self.browser.open(page)
                self.assertEqual(complaints(self.browser.numbers(), report), [])

    def test_an_altered_page_is_found_out(self):
        digit = r'(data-key="/shrink/ratio">)(\d)'
        for old, new in (
                (r'value="[^"]*" data-key="/gap/chi2_per_dof"', 'value="7" data-key="/gap/chi2_per_dof"'),
                (digit, lambda match: match[1] + str(9 - int(match[2]))),
                (r'data-key="/gap/rms/Fx"', 'data-key="/gap/rms/Fz"')):
            self.browser.open(self.altered("identified", old, new))
            self.assertNotEqual(complaints(self.browser.numbers(), self.reports["identified"]), [])

    def test_the_console_stays_silent_and_nothing_is_fetched(self):
        for name, page in self.pages.items():
            with self.subTest(name):
                self.browser.requested()  # forget what came before
                self.browser.open(page)
                self.assertEqual(self.browser.logged(), [])
                fetched = [url for url in self.browser.requested() if not url.startswith("data:")]
                self.assertEqual(fetched, [page.as_uri()])
                self.assertEqual(self.browser.run("document.scripts.length"), 0)

    def test_a_page_that_fetches_or_complains_is_found_out(self):
        page = self.altered("none", "</main>", '<img alt="" src="other.png"/></main>')
        self.browser.requested()
        self.browser.open(page)
        self.assertNotEqual(self.browser.logged(), [])
        self.assertIn(page.with_name("other.png").as_uri(), self.browser.requested())

    def test_markup_is_well_formed_and_read_as_written(self):
        for name, page in self.pages.items():
            with self.subTest(name):
                root = xml.fromstring(page.read_text())
                written = Counter(element.tag for element in root.iter())
                self.browser.open(page)
                read = Counter(self.browser.run("[...document.querySelectorAll('*')].map(e => e.localName)"))
                self.assertEqual(written, read)
                ids = [element.get("id") for element in root.iter() if element.get("id")]
                self.assertEqual([one for one, count in Counter(ids).items() if count > 1], [])
                for element in root.iter():
                    for attribute in ("aria-labelledby", "href"):
                        if element.tag != "link" and element.get(attribute):
                            for target in element.get(attribute).split():
                                if target.startswith("https://") or (ROOT / target.partition("#")[0]).is_file():
                                    continue
                                self.assertIn(target.removeprefix("#"), ids)

    def test_everything_drawn_has_words(self):
        for name, page in self.pages.items():
            with self.subTest(name):
                root = xml.fromstring(page.read_text())
                for svg in root.iter("svg"):
                    if svg.get("aria-hidden") != "true":
                        self.assertTrue(svg.findtext("title") and svg.findtext("desc"))
                for image in root.iter("img"):
                    self.assertTrue(image.get("alt"))
                levels = [int(element.tag[1]) for element in root.iter() if re.fullmatch("h[1-6]", element.tag)]
                self.assertEqual(levels[0], 1)
                self.assertTrue(all(after <= before + 1 for before, after in zip(levels, levels[1:])), levels)

    def test_nothing_is_wider_than_a_phone(self):
        for name, page in self.pages.items():
            with self.subTest(name):
                for width in (390, 1280):
                    self.browser.open(page, width)
                    wide, screen = self.browser.run(
                        "[document.documentElement.scrollWidth, document.documentElement.clientWidth]")
                    self.assertLessEqual(wide, screen)

    def test_curves_are_drawn(self):
        for verdict, page, report in self.diagnoses():
            with self.subTest(verdict):
                self.browser.open(page)
                boxes = self.browser.run(
                    "[...document.querySelectorAll('figure svg .line, figure svg .dots')].map(e => e.getBBox())")
                self.assertGreaterEqual(len(boxes), 6)
                for box in boxes:
                    inside = 0 <= box["x"] and box["x"] + box["width"] <= 360
                    self.assertTrue(inside and box["width"] + box["height"] > 10, box)

    def test_a_page_wider_than_a_phone_is_found_out(self):
        self.browser.open(self.altered("none", "</main>", '<p style="width: 40rem">wide</p></main>'), 390)
        self.assertGreater(self.browser.run("document.documentElement.scrollWidth"), 390)

    def test_pages_are_dark_where_that_is_preferred_and_white_on_paper(self):
        colours = ("[getComputedStyle(document.documentElement).getPropertyValue('--paper').trim(), "
                   "getComputedStyle(document.body).color]")
        for name in ("identified", "verify"):
            with self.subTest(name):
                self.browser.open(self.pages[name])
                shown = {}
                for medium, scheme in (("screen", "light"), ("screen", "dark"), ("print", "dark")):
                    self.browser.driver.execute_cdp_cmd("Emulation.setEmulatedMedia", {
                        "media": medium, "features": [{"name": "prefers-color-scheme", "value": scheme}]})
                    shown[medium, scheme] = self.browser.run(colours)
                self.browser.driver.execute_cdp_cmd("Emulation.setEmulatedMedia", {"media": "", "features": []})
                self.assertEqual(shown["screen", "light"][0], "#fff")
                self.assertNotEqual(shown["screen", "dark"][0], "#fff")
                self.assertNotEqual(shown["screen", "dark"][1], shown["screen", "light"][1])
                self.assertEqual(shown["print", "dark"], shown["screen", "light"])

    def test_points_say_their_values(self):
        for verdict, page, _ in self.diagnoses():
            with self.subTest(verdict):
                root = xml.fromstring(page.read_text())
                said = [circle.findtext("title") for circle in root.iter("circle") if circle.get("class") == "value"]
                self.assertGreater(len(said), 100)
                for text in said:
                    self.assertRegex(text, r"^[^,]+ −?[0-9.e+-]+( [^,]+)?, [^,].* −?[0-9.e+-]+( .+)?$")

    @staticmethod
    def some_were_always_seen(report):
        """Whether marks would tell anything: not where every run is held out in its turn."""
        return {f"push <{number}> & back" for number in range(3)} != set(report["shrink"]["heldout"]) and \
            report["experiment"] != "four-link bench"

    def test_what_was_held_out_is_marked(self):
        for verdict, page, report in self.diagnoses():
            rings = page.read_text().count('class="ring heldout"')
            with self.subTest(verdict):
                self.assertEqual(rings > 0, report["shrink"] is not None and self.some_were_always_seen(report))

    def test_a_law_closes_the_gap_only_where_it_does(self):
        laws = [(page.read_text(), report["law"]) for _, page, report in self.diagnoses() if "law" in report]
        self.assertGreater(len(laws), 0)
        for text, law in laws:
            left = law.get("ratio", math.inf)
            near = left <= max(2 * law.get("noise_floor_ratio", 0), 0.25)
            words = "fitted to" if left >= 1 else "that closes" if near else "that narrows"
            self.assertIn(f"A torque law {words} the gap", text)

    def test_what_predicts_nothing_is_not_offered(self):
        for verdict, page, report in self.diagnoses():
            with self.subTest(verdict):
                said = "fails to predict held-out readings" in page.read_text()
                self.assertEqual(said, report["cause"]["fails_to_predict"])
                if "law" in report and "ratio" in report["law"]:
                    self.assertLess(report["law"]["ratio"], 1)

    def test_joints_have_rings_where_the_cause_sits_there(self):
        self.assertIn('class="ring share"', self.pages["stopped"].read_text())
        self.assertIn('class="ring share"', self.pages["identified"].read_text())

    def test_pages_print_on_few_sheets(self):
        self.browser.open(self.pages["identified"])
        document = base64.b64decode(self.browser.driver.print_page())
        sheets = len(re.findall(rb"/Type\s*/Page\b", document))
        self.assertTrue(1 <= sheets <= 8, sheets)

    def test_headings_stand_on_the_sheet_of_their_figures(self):
        followed = (":has(+ .charts, + .legend, + p + .charts, + p + .legend)')]"
                    ".map(h => [h.textContent, captions.find(c => h.compareDocumentPosition(c) & 4).textContent])")
        for verdict, page, _ in self.diagnoses():
            self.browser.open(page)
            pdf = page.with_suffix(".pdf")
            pdf.write_bytes(base64.b64decode(self.browser.driver.print_page()))
            sheets = subprocess.run(["pdftotext", "-layout", pdf, "-"], check=True, capture_output=True, text=True).stdout
            pairs = self.browser.driver.execute_script(
                "const captions = [...document.querySelectorAll('.charts figcaption')];"
                f"return [...document.querySelectorAll(':is(h2, h3){followed}")
            self.assertGreaterEqual(len(pairs), 2)
            for heading, caption in pairs:
                with self.subTest(verdict, heading=heading):
                    behind = sheets.split(heading + "\n", 1)[1].split("\f")[0]
                    self.assertIn(caption[:10], behind)

    def test_a_page_is_light(self):
        for verdict, page, _ in self.diagnoses():
            with self.subTest(verdict):
                self.assertLess(page.stat().st_size, 1_000_000)

    def test_claims_are_those_of_the_report(self):
        self.browser.open(self.pages["verify"])
        shown = dict(self.browser.run("[...document.querySelectorAll('.claim [data-key]')]"
                                      ".map(e => [e.dataset.key, e.textContent])"))
        expected = {}
        for claim in self.claims:
            for key in ("where", "quote", "reading", "verdict", "severity", "cause", "truth", "value"):
                if claim[key]:
                    expected[f"{claim['id']}/{key}"] = claim[key]
            for i, evidence in enumerate(claim["evidence"]):
                for key, value in evidence.items():
                    expected[f"{claim['id']}/evidence/{i}/{key}"] = ", ".join(value) if key == "coq" else value
        self.assertEqual(shown, expected)
        undrawn = "[...document.querySelectorAll('.wide img')].filter(i => !i.naturalWidth).length"
        self.assertEqual(self.browser.run(undrawn), 0)

    def test_claims_filter_by_verdict_and_answer_to_their_anchor(self):
        by_verdict = {}
        for claim in self.claims:
            by_verdict.setdefault(claim["verdict"], []).append(claim["id"])
        self.assertGreater(len(by_verdict), 2)
        self.browser.open(self.pages["verify"])
        self.assertEqual(len(self.browser.visible(".claim")), len(self.claims))
        for verdict, ids in by_verdict.items():
            self.browser.run(f"document.getElementById('show-{verdict}').click()")
            self.assertEqual(self.browser.visible(".claim"), ids)
        hidden = by_verdict["refuted"][0]
        self.browser.run("document.getElementById('show-confirmed').click()")
        self.browser.run(f"location.hash = '{hidden}'")
        self.assertIn(hidden, self.browser.visible(".claim"))


if __name__ == "__main__":
    unittest.main(verbosity=2)
