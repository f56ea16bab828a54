#!/usr/bin/env python3
"""site_test.py CHECKOUT PROGRAM: makes the book and follows everything in it. Ends with 77 where pandoc is missing."""
import os
import re
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path
from urllib.parse import unquote

from page_facts import PageFacts

CHECKOUT, PROGRAM = Path(sys.argv[1]), sys.argv[2]
BUILDER = CHECKOUT / "chapters/book/build.py"
HEAVIEST = 600_000  # bytes of a page with its style and pictures
OUTSIDE = re.compile(r"^[a-z][a-z+.-]*:|^//")


def build(*words, checkout=CHECKOUT):
    return subprocess.run([sys.executable, "-B", checkout / "chapters/book/build.py", *words], capture_output=True, text=True)


class Site(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = Path(tempfile.mkdtemp(prefix="rayscope-book-"))
        cls.site = cls.folder / "site"
        cls.built = build("-o", cls.site, "--program", PROGRAM)
        if cls.built.returncode:
            raise AssertionError(cls.built.stderr)
        pages = [path for path in cls.site.rglob("*.html") if "rays" not in path.relative_to(cls.site).parts]
        cls.pages = {path: PageFacts(path) for path in pages}

    @classmethod
    def tearDownClass(cls):
        shutil.rmtree(cls.folder)

    def each(self):
        return sorted(self.pages.items())

    def target(self, page, address):
        path = unquote(address.split("#")[0])
        return Path(os.path.normpath(page.parent / path)) if path else page

    def test_it_has_a_page_for_each_chapter_and_reference(self):
        self.assertTrue((self.site / "index.html").exists())
        for source in sorted(CHECKOUT.glob("chapters/*/README.md")) + sorted(CHECKOUT.glob("chapters/**/*.md")):
            place = source.relative_to(CHECKOUT / "chapters")
            name = place.with_name("index.html") if place.name == "README.md" else place.with_suffix(".html")
            self.assertIn(self.site / name, self.pages, f"the page of {source}")

    def test_links_and_anchors_lead_somewhere(self):
        for path, facts in self.each():
            for address in facts.links:
                if OUTSIDE.match(address):
                    self.assertRegex(address, r"^https?://|^mailto:", path)
                    continue
                target = self.target(path, address)
                self.assertTrue(target.is_file(), f"{path}: {address}: no such file")
                self.assertTrue(target.is_relative_to(self.site), f"{path}: {address} leaves the book")
                anchor = unquote(address.partition("#")[2])
                if anchor and target in self.pages:
                    self.assertIn(anchor, self.pages[target].ids, f"{path}: {address}: no such place")

    def test_nothing_is_fetched(self):
        for path, facts in self.each():
            for address in facts.loads:
                self.assertIsNone(OUTSIDE.match(address), f"{path}: {address}")
                self.assertTrue(self.target(path, address).is_file(), f"{path}: {address}")
            self.assertEqual(facts.scripts, 0, path)
        self.assertNotRegex((self.site / "book.css").read_text(), r"url\(|@import")

    def test_pictures_can_be_read_without_seeing_them(self):
        for path, facts in self.each():
            for address, words in facts.pictures:
                self.assertTrue(words and len(words) > 8, f"{path}: {address}: alt text {words!r}")

    def test_pages_are_light(self):
        for path, facts in self.each():
            files = {path, *(self.target(path, address) for address in facts.loads if "rays/" not in address)}
            self.assertLessEqual(sum(file.stat().st_size for file in files), HEAVIEST, path)

    def test_each_page_has_a_title_and_no_place_twice(self):
        for path, facts in self.each():
            self.assertGreaterEqual(facts.headings, 1, path)
            self.assertEqual(facts.repeated_ids, [], path)

    def test_formulas_are_mathml(self):
        for source in CHECKOUT.glob("chapters/*/README.md"):
            text = re.sub(r"```.*?```|`[^`\n]*`", "", source.read_text(encoding="utf-8"), flags=re.S)
            facts = self.pages[self.site / source.relative_to(CHECKOUT / "chapters").with_name("index.html")]
            if re.search(r"\$\$.+?\$\$", text, re.S):
                self.assertGreater(facts.math, 0, source)
        for path, facts in self.each():
            self.assertEqual(facts.unset_math, 0, f"{path}: a formula that pandoc could not read")

    def test_marked_rays_are_embedded(self):
        marks = sum(len(re.findall(r"^<!-- ray: ", path.read_text(encoding="utf-8"), re.M)) for path in CHECKOUT.glob("chapters/**/*.md"))
        frames = [frame for facts in self.pages.values() for frame in facts.frames]
        self.assertGreaterEqual(len(frames), marks)
        self.assertGreater(marks, 0)
        for _, title in frames:
            self.assertRegex(title, "recorded ray")

    def test_it_can_be_walked_from_first_to_last(self):
        page, seen = self.site / "index.html", []
        while page:
            self.assertNotIn(page, seen)
            seen.append(page)
            match = re.search(r'rel="next" href="([^"]+)"', self.pages[page].text)
            page = self.target(page, match[1]) if match else None
        self.assertGreaterEqual(len(seen), len(list(CHECKOUT.glob("chapters/**/*.md"))))

    def test_an_older_book_is_replaced_and_nothing_else(self):
        foreign = self.folder / "foreign"
        foreign.mkdir()
        (foreign / "thesis.txt").write_text("mine")
        refused = build("-o", foreign, "--no-rays")
        self.assertEqual(refused.returncode, 2, refused.stderr)
        self.assertIn("expected a new or an empty folder", refused.stderr)
        self.assertEqual([path.name for path in foreign.iterdir()], ["thesis.txt"])
        self.assertEqual(build("-o", self.folder / "no/such").returncode, 2)
        self.assertEqual(build("--pfd").returncode, 2)


class Errors(unittest.TestCase):
    """A small checkout whose page is wrong."""

    def build_with(self, text):
        with tempfile.TemporaryDirectory(prefix="rayscope-book-") as name:
            checkout = Path(name)
            shutil.copytree(CHECKOUT / "chapters/book", checkout / "chapters/book")
            (checkout / "chapters/01_x").mkdir()
            (checkout / "chapters/01_x/README.md").write_text(text)
            result = build("-o", checkout / "site", "--program", PROGRAM, checkout=checkout)
            left = sorted(path.name for path in checkout.iterdir())
            return result, left

    def test_a_small_book_gets_a_contents_page(self):
        result, left = self.build_with("# One\n\nA formula: $x^2$.\n")
        self.assertEqual((result.returncode, left), (0, ["chapters", "site"]), result.stderr)

    def test_a_dead_link_is_named_and_nothing_is_written(self):
        result, left = self.build_with("# One\n\n[here](nowhere.md)\n")
        self.assertEqual((result.returncode, left), (1, ["chapters"]))
        self.assertIn("chapters/01_x/README.md: the link to nowhere.md leads nowhere", result.stderr)

    def test_a_mark_cannot_write_elsewhere(self):
        for mark in ("prism -o /tmp/x.html", "prism --pixel 1,2 -o x", "-o x"):
            result, left = self.build_with(f"# One\n\n<!-- ray: {mark} -->\n")
            self.assertEqual((result.returncode, left), (1, ["chapters"]), mark)
            self.assertIn("expected a scene", result.stderr)

    def test_a_ray_of_no_scene_is_an_error(self):
        result, left = self.build_with("# One\n\n<!-- ray: no_such_scene -->\n")
        self.assertEqual((result.returncode, left), (1, ["chapters"]))
        self.assertIn("no_such_scene", result.stderr)


if __name__ == "__main__":
    if not shutil.which("pandoc"):
        print("not run: pandoc is missing")
        sys.exit(1 if os.environ.get("RAYSCOPE_NEED_BOOK") else 77)
    unittest.main(argv=sys.argv[:1])
