"""The site: one file a page, all links relative, so that it can be opened from a folder, a stick or a server."""
import html
import os
import shutil
import string
from pathlib import Path
from posixpath import relpath

from listings import listing_pages
from pages import address_in_book, resolved
from rays import command_of, ray_name, record
from syntax import blocks_to_html, copy_of, plain_text, raw, walk

HERE = Path(__file__).resolve().parent
TEMPLATE = string.Template((HERE / "page.html").read_text(encoding="utf-8"))

UNBROKEN = 30  # characters of code that stay on one line, on a phone too


def write_site(book, folder, program):
    shutil.copy(HERE / "book.css", folder / "book.css")
    for path in sorted(book.copies):
        target = folder / address_in_book(book, path)
        target.parent.mkdir(parents=True, exist_ok=True)
        shutil.copyfile(book.checkout / path, target)
    rays = {}
    bodies = blocks_to_html([site_blocks(book, page, rays if program else None) for page in book.pages.values()])
    for page, body in zip(book.pages.values(), bodies, strict=True):
        write_page(book, folder, address_in_book(book, page.source), page.title, body, page)
    for path, body in listing_pages(book):
        write_page(book, folder, address_in_book(book, path), path, body)
    for path, names in book.folders.items():
        write_page(book, folder, address_in_book(book, path), path + "/", folder_list(book, path, names))
    record(program, book.checkout, folder / "rays", rays)


def site_blocks(book, page, rays):
    """The page with its links turned into the site's, and its marked rays embedded. rays: name → words, added to."""
    blocks = copy_of(page.blocks)
    here = address_in_book(book, page.source)
    for node in walk(blocks):
        if node["t"] in ("Link", "Image"):
            target = node["c"][2]
            path = resolved(page.source, target[0])
            if path is not None:
                anchor = target[0].partition("#")[1:]
                target[0] = link(here, address_in_book(book, path)) + "".join(anchor)
        if node["t"] == "Image":
            node["c"][0][2].append(["loading", "lazy"])
        words = command_of(node)
        if words:
            node["c"] = raw(embedded(here, words, rays))["c"]
        if node["t"] == "Code" and len(node["c"][1]) <= UNBROKEN:
            node["c"][0][1].append("short")
    return blocks


def embedded(here, words, rays):
    command = html.escape("./rayscope step " + " ".join(words))
    if rays is None:
        return f'<p class="ray">Walk through this ray: <code>{command}</code></p>'
    rays[ray_name(words)] = words
    address = html.escape(link(here, f"rays/{ray_name(words)}.html"))
    return (f'<figure class="ray"><iframe src="{address}" loading="lazy" title="A recorded ray: {command}"></iframe>'
            f'<figcaption><a href="{address}">This ray on a page of its own</a>; in a terminal: <code>{command}</code>'
            "</figcaption></figure>")


def link(here, there):
    return relpath(there, os.path.dirname(here) or ".")


def folder_list(book, path, names):
    here = address_in_book(book, path)
    lines = [f'<li><a href="{link(here, address_in_book(book, f"{path}/{name}"))}">{html.escape(name)}</a></li>' for name in names]
    return f"<h1><code>{html.escape(path)}/</code></h1><ul>{''.join(lines)}</ul>"


def contents(book, here, page):
    """The list of all pages; below the open one, its parts."""
    lines = []
    for other in book.pages.values():
        if not other.in_order:
            continue
        current = ' aria-current="page"' if other is page else ""
        lines.append(f'<li><a href="{link(here, address_in_book(book, other.source))}"{current}>{html.escape(other.title)}</a>')
        if other is page:
            parts = [node["c"] for node in other.blocks if node["t"] == "Header" and node["c"][0] == 2]
            if parts:
                items = [f'<li><a href="#{part[1][0]}">{html.escape(plain_text(part[2]))}</a></li>' for part in parts]
                lines.append(f"<ul>{''.join(items)}</ul>")
        lines.append("</li>")
    if (book.checkout / "README.md").exists() and "README.md" in book.pages:
        lines.append(f'<li><a href="{link(here, address_in_book(book, "README.md"))}">The project</a></li>')
    return "".join(lines)


def neighbours(book, here, page):
    order = [other for other in book.pages.values() if other.in_order]
    if page not in order:
        return ""
    at = order.index(page)
    parts = []
    for name, word, index in (("prev", "Previous", at - 1), ("next", "Next", at + 1)):
        if 0 <= index < len(order):
            other = order[index]
            parts.append(f'<a class="{name}" rel="{name}" href="{link(here, address_in_book(book, other.source))}">'
                         f"<span>{word}</span> {html.escape(other.title)}</a>")
    return "".join(parts)


def write_page(book, folder, here, title, body, page=None):
    target = folder / here
    target.parent.mkdir(parents=True, exist_ok=True)
    whole = title if here == "index.html" else f"{title} – rayscope"
    target.write_text(TEMPLATE.substitute(
        title=html.escape(whole), style=link(here, "book.css"), start=link(here, "index.html"), body=body,
        contents=contents(book, here, page), neighbours=neighbours(book, here, page)), encoding="utf-8")
