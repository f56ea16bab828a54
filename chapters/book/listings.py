"""Sources as pages. One run of pandoc colours them all: to start it takes longer than a file."""
import html

from syntax import raw, tree_to_html

LANGUAGES = {"cpp": "cpp", "hpp": "cpp", "inl": "cpp", "cc": "cpp", "py": "python", "toml": "toml", "json": "json", "sh": "bash",
             "cmake": "cmake", "diff": "diff", "mjs": "javascript", "js": "javascript", "css": "css", "html": "html"}
CUT = "<!-- the next file -->"
PANDOC_VERSION = [1, 22]


def language_of(path):
    if path == "rayscope" or path.endswith("/run"):
        return "bash"
    if path.endswith("CMakeLists.txt"):
        return "cmake"
    return LANGUAGES.get(path.rsplit(".", 1)[-1], "default")


def listing_pages(book):
    """(path, body) of each listing."""
    paths = sorted(book.listings)
    if not paths:
        return
    blocks = []
    for number, path in enumerate(paths):
        attributes = [f"f{number}", [language_of(path), "numberLines"], []]
        blocks += [raw(CUT), {"t": "CodeBlock", "c": [attributes, book.listings[path].rstrip("\n")]}]
    parts = tree_to_html({"pandoc-api-version": PANDOC_VERSION, "meta": {}, "blocks": blocks}).split(CUT)[1:]
    for path, part in zip(paths, parts, strict=True):
        yield path, f"<h1><code>{html.escape(path)}</code></h1>\n{part}"
