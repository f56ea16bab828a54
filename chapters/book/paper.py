"""The PDF: all pages of the book proper as one, printed by Chromium, which can set MathML."""
import base64
import html
import mimetypes
import subprocess
import tempfile
from pathlib import Path

from pages import resolved
from rays import command_of
from syntax import blocks_to_html, copy_of, raw, walk

HERE = Path(__file__).resolve().parent
CHROMIUM = ["chromium", "--headless", "--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run",
            "--disable-background-networking", "--disable-component-update", "--disable-sync", "--no-pdf-header-footer",
            "--generate-pdf-document-outline"]


def write_pdf(book, target):
    order = [page for page in book.pages.values() if page.in_order]
    numbers = {page.source: number for number, page in enumerate(order)}
    style = (HERE / "book.css").read_text(encoding="utf-8")
    lines = [f'<li><a href="#p{numbers[page.source]}">{html.escape(page.title)}</a></li>' for page in order]
    parts = [f'<section><h1>rayscope</h1><p>What one ray does</p><ul class="list">{"".join(lines)}</ul></section>']
    bodies = blocks_to_html([paper_blocks(book, page, numbers) for page in order])
    parts += [f'<section id="p{number}">{body}</section>' for number, body in enumerate(bodies)]
    text = (f'<!DOCTYPE html><html lang="en"><head><meta charset="utf-8"><title>rayscope</title><style>{style}</style></head>'
            f'<body class="paper"><main>{"".join(parts)}</main></body></html>')
    with tempfile.TemporaryDirectory(prefix="rayscope-book-") as folder:
        page = Path(folder) / "book.html"
        page.write_text(text, encoding="utf-8")
        subprocess.run([*CHROMIUM, f"--user-data-dir={folder}/profile", f"--print-to-pdf={target}", page.as_uri()], check=True,
                       capture_output=True, text=True, timeout=300, stdin=subprocess.DEVNULL)
    if not target.exists():
        raise ValueError("chromium printed no PDF")


def paper_blocks(book, page, numbers):
    """Links lead within the paper, or are set as text; pictures are part of the file; rays are commands."""
    blocks = copy_of(page.blocks)
    prefix = f"p{numbers[page.source]}"
    for node in walk(blocks):
        kind = node["t"]
        if kind == "Header":
            node["c"][1][0] = f"{prefix}-{node['c'][1][0]}"
        elif kind == "Image":
            file = book.checkout / resolved(page.source, node["c"][2][0])
            kind_of_file = mimetypes.guess_type(file.name)[0]
            node["c"][2][0] = f"data:{kind_of_file};base64,{base64.b64encode(file.read_bytes()).decode()}"
        elif kind == "Link":
            address = node["c"][2][0]
            path, anchor = resolved(page.source, address), address.partition("#")[2]
            if address.startswith("#"):
                node["c"][2][0] = f"#{prefix}-{anchor}"
            elif path in numbers:
                node["c"][2][0] = f"#p{numbers[path]}" + (f"-{anchor}" if anchor else "")
            elif path is not None:
                node.update({"t": "Span", "c": [["", [], []], node["c"][1]]})
        elif command_of(node):
            command = html.escape("./rayscope step " + " ".join(command_of(node)))
            node["c"] = raw(f'<p class="ray">Walk through this ray: <code>{command}</code></p>')["c"]
    return blocks
