"""Pandoc's tree of a document: https://hackage.haskell.org/package/pandoc-types. Nothing here knows of the book."""
import json
import subprocess

MARKDOWN = "gfm+tex_math_dollars"


def pandoc(arguments, text):
    return subprocess.run(["pandoc", *arguments], input=text, capture_output=True, text=True, check=True,
                          encoding="utf-8").stdout


def markdown_to_tree(text):
    return json.loads(pandoc(["-f", MARKDOWN, "-t", "json"], text))


def tree_to_html(tree):
    """A part of a page, formulas as MathML."""
    return pandoc(["-f", "json", "-t", "html5", "--mathml", "--wrap=preserve"], json.dumps(tree))


def walk(node):
    """All elements under a node, depth first."""
    if isinstance(node, list):
        for child in node:
            yield from walk(child)
    elif isinstance(node, dict):
        if "t" in node:
            yield node
        yield from walk(node.get("c", []))


def plain_text(inlines):
    words = []
    for node in walk(inlines):
        if node["t"] == "Str":
            words.append(node["c"])
        elif node["t"] in ("Space", "SoftBreak"):
            words.append(" ")
        elif node["t"] in ("Code", "Math"):
            words.append(node["c"][1])
    return "".join(words)


def raw(html):
    return {"t": "RawBlock", "c": ["html", html]}
