"""Pandoc's tree of a document: https://hackage.haskell.org/package/pandoc-types. Nothing here knows of the book."""
import json
import subprocess

MARKDOWN = "gfm+tex_math_dollars"
VERSION = []  # of the tree, as this pandoc writes it
CUT = "<!-- the next part -->"


def pandoc(arguments, text):
    return subprocess.run(["pandoc", *arguments], input=text, capture_output=True, text=True, check=True,
                          encoding="utf-8").stdout


def markdown_to_blocks(text):
    tree = json.loads(pandoc(["-f", MARKDOWN, "-t", "json"], text))
    VERSION[:] = tree["pandoc-api-version"]
    if any(node["t"] == "Note" for node in walk(tree["blocks"])):
        raise ValueError("footnotes are not set: what matters stands in the text")
    return tree["blocks"]


def copy_of(blocks):
    """Much faster than copy.deepcopy."""
    return json.loads(json.dumps(blocks))


def blocks_to_html(parts):
    """HTML of each list of blocks, formulas as MathML. One run of pandoc for all: to start it takes longer than a page."""
    blocks = []
    for part in parts:
        blocks += [raw(CUT), *part]
    tree = {"pandoc-api-version": VERSION, "meta": {}, "blocks": blocks}
    return pandoc(["-f", "json", "-t", "html5", "--mathml", "--wrap=preserve"], json.dumps(tree)).split(CUT)[1:]


def walk(node):
    """All elements under a node, in the order of the text."""
    waiting = [node]
    while waiting:
        at = waiting.pop()
        if isinstance(at, dict):
            if "t" in at:
                yield at
            at = at.get("c", ())
        if isinstance(at, list):
            waiting.extend(reversed(at))


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
