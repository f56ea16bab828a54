"""Which pages the book has, in which order, and where each file of the checkout goes.

A page of the book proper is a Markdown file under chapters/. Whatever else these link to comes along: other Markdown
files as further pages, sources as listings, folders as lists of their files, and pictures as they are.
"""
import os
import re
from dataclasses import dataclass, field
from pathlib import Path
from posixpath import normpath
from urllib.parse import unquote

from syntax import markdown_to_blocks, plain_text, walk

PICTURES = {".png", ".svg", ".jpg", ".jpeg", ".gif", ".webp"}
LONGEST_LISTING = 200_000  # bytes; what is longer is copied, not shown


@dataclass
class Page:
    source: str  # path in the checkout
    blocks: list = field(repr=False)
    title: str = ""
    in_order: bool = False  # reached by next and previous


@dataclass
class Book:
    """All that is read; nothing is written here."""
    checkout: Path
    pages: dict = field(default_factory=dict)  # by source, in order
    listings: dict = field(default_factory=dict)  # source → text
    folders: dict = field(default_factory=dict)  # source → names of its files
    copies: set = field(default_factory=set)

    def __post_init__(self):
        self.in_order = self.order()
        for source in self.in_order:
            self.add_page(source, True)
        if "chapters/README.md" not in self.pages:
            self.pages = {"chapters/README.md": self.own_contents(), **self.pages}

    def order(self):
        """Contents, chapters by number, errata, glossary, references, then the reference pages."""
        chapters = self.checkout / "chapters"
        reference = sorted((chapters / "reference").glob("*.md"), key=lambda path: (path.name != "README.md", path.name))
        paths = [chapters / "README.md", *sorted(chapters.glob("[0-9][0-9]_*/README.md")), chapters / "errata.md",
                 chapters / "glossary.md", chapters / "references.md", *reference]
        return [path.relative_to(self.checkout).as_posix() for path in paths if path.exists()]

    def own_contents(self):
        """A start page where the chapters bring none."""
        lines = ["# rayscope", "", "What one ray does: the lessons, the errata, the glossary, and the reference.", ""]
        lines += [f"- [{page.title}]({os.path.relpath(page.source, 'chapters')})" for page in self.pages.values() if page.in_order]
        return Page("chapters/README.md", markdown_to_blocks("\n".join(lines)), "rayscope", True)

    def add_page(self, source, in_order=False):
        blocks = markdown_to_blocks((self.checkout / source).read_text(encoding="utf-8"))
        page = self.pages[source] = Page(source, blocks, source, in_order)
        headers = [node["c"] for node in blocks if node["t"] == "Header"]
        if headers:
            page.title = plain_text(headers[0][2])
        for node in walk(blocks):
            if node["t"] in ("Link", "Image"):
                self.reach(source, node["c"][2][0])

    def reach(self, source, address):
        """Brings along what a page points at. A dead link ends the work: it is an error of the page."""
        path = resolved(source, address)
        if path is None or path in self.pages or path in self.listings or path in self.folders or path in self.copies:
            return
        file = self.checkout / path
        if path.startswith("..") or not file.exists():
            raise ValueError(f"{source}: the link to {address} leads nowhere")
        if path in self.in_order:
            return  # its turn comes
        if file.is_dir():
            self.add_folder(path)
        elif file.suffix == ".md":
            self.add_page(path)
        elif file.suffix in PICTURES or file.stat().st_size > LONGEST_LISTING:
            self.copies.add(path)
        else:
            self.add_listing(path)

    def add_listing(self, path):
        try:
            self.listings[path] = (self.checkout / path).read_text(encoding="utf-8")
        except UnicodeDecodeError:
            self.copies.add(path)

    def add_folder(self, path):
        files = sorted(file.name for file in (self.checkout / path).iterdir() if file.is_file() and not file.name.startswith("."))
        self.folders[path] = files
        for name in files:
            self.reach(path + "/.", name)


def resolved(source, address):
    """The path in the checkout that an address in a file means; None for another site or a place on the same page."""
    if re.match(r"[a-z]+:", address) or address.startswith("#") or not address:
        return None
    return normpath(os.path.join(os.path.dirname(source), unquote(address.split("#")[0])))


def address_in_book(book, path):
    """Where a file of the checkout is in the site."""
    if path in book.copies:
        return path.removeprefix("chapters/") if path.startswith("chapters/") else "more/" + path
    if path in book.pages:
        place = path.removeprefix("chapters/") if path.startswith("chapters/") else "more/" + path
        folder, name = os.path.split(place)
        return os.path.join(folder, "index" if name == "README.md" else name.removesuffix(".md")) + ".html"
    return f"source/{path}/index.html" if path in book.folders else f"source/{path}.html"
