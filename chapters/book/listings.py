"""Sources as pages."""
import html

from syntax import blocks_to_html

LANGUAGES = {"cpp": "cpp", "hpp": "cpp", "inl": "cpp", "cc": "cpp", "py": "python", "toml": "toml", "json": "json", "sh": "bash",
             "cmake": "cmake", "diff": "diff", "mjs": "javascript", "js": "javascript", "css": "css", "html": "html"}


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
    parts = []
    for number, path in enumerate(paths):
        attributes = [f"f{number}", [language_of(path), "numberLines"], []]
        parts.append([{"t": "CodeBlock", "c": [attributes, book.listings[path].rstrip("\n")]}])
    for path, part in zip(paths, blocks_to_html(parts), strict=True):
        yield path, f"<h1><code>{html.escape(path)}</code></h1>\n{part}"
