#!/usr/bin/env python3
"""Builds the chapters into a site that needs no network: pages, pictures, recorded rays to walk through, and a PDF."""
import argparse
import os
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

from pages import Book
from paper import write_pdf
from site_writer import write_site

CHECKOUT = Path(__file__).resolve().parents[2]


def fail(code, message):
    """1: the work failed, 2: wrong usage."""
    print(f"rayscope book: {message}", file=sys.stderr)
    sys.exit(code)


def arguments():
    parser = argparse.ArgumentParser(
        prog="rayscope book", description="make a book of the chapters: pages to open without a network",
        epilog="Example:\n  rayscope book -o book --pdf", formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("-o", metavar="DIR", default="book", help="the folder that is written (default: book); an older "
                        "book in it is replaced, any other folder that holds something is refused")
    parser.add_argument("--pdf", action="store_true", help="also write DIR/rayscope.pdf, with Chromium")
    parser.add_argument("--no-rays", action="store_true", help="leave out the recorded rays: smaller, and quicker to make")
    parser.add_argument("--program", metavar="FILE", help=argparse.SUPPRESS)  # the launcher's business
    return parser.parse_args()


def check_target(target):
    """Nothing that a person made is ever replaced."""
    if target.exists() and not target.is_dir():
        fail(2, f"-o {target}: expected a folder, found a file")
    if target.is_dir() and any(target.iterdir()) and not (target / "made-by-rayscope-book").exists():
        fail(2, f"-o {target}: expected a new or an empty folder, or an older book; this one holds other files")
    if not target.absolute().parent.is_dir():
        fail(2, f"-o {target}: there is no folder {target.absolute().parent}")


def replace(new, target):
    """Complete or not at all: the old book goes when the new one is finished."""
    old = None
    if target.exists():
        old = target.with_name(target.name + ".old")
        shutil.rmtree(old, ignore_errors=True)
        os.rename(target, old)
    os.rename(new, target)
    if old:
        shutil.rmtree(old)


def main():
    given = arguments()
    target = Path(given.o).absolute()
    check_target(target)
    if not shutil.which("pandoc"):
        fail(1, "pandoc is missing; on Debian: apt-get install pandoc")
    if given.pdf and not shutil.which("chromium"):
        fail(1, "chromium is missing, which prints the PDF; on Debian: apt-get install chromium")
    program = None if given.no_rays else given.program or CHECKOUT / "build/release/bin/rayscope"
    if program and not Path(program).exists():
        fail(1, f"{program} is not built; ./rayscope book builds it, or use --no-rays")

    new = Path(tempfile.mkdtemp(prefix=target.name + ".", dir=target.parent))
    new.chmod(0o755)
    try:
        book = Book(CHECKOUT)
        (new / "made-by-rayscope-book").write_text("This folder is replaced as a whole when the book is made again.\n")
        if given.pdf:
            write_pdf(book, new / "rayscope.pdf")
        write_site(book, new, program)
        replace(new, target)
    except (OSError, ValueError, subprocess.SubprocessError) as error:
        output = getattr(error, "stderr", None)
        fail(1, f"{error}\n{output}" if output else str(error))
    finally:
        shutil.rmtree(new, ignore_errors=True)
    print(f"rayscope book: {len(book.pages)} pages; open {target / 'index.html'}")


if __name__ == "__main__":
    main()
