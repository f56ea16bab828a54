"""Recorded rays: <!-- ray: prism --pixel 300,260 --> in a chapter stands for the page of that ray."""
import re
import shlex
import subprocess

MARK = re.compile(r"^<!-- ray: (.+) -->\s*$")
OPTIONS = {"--pixel", "--ray", "--sample", "--stage", "--effects"}  # what tells which ray; never where to write


def command_of(node):
    """The words of a mark; None for any other element."""
    if node["t"] != "RawBlock" or node["c"][0] != "html":
        return None
    match = MARK.match(node["c"][1])
    if not match:
        return None
    words = shlex.split(match[1])
    wrong = [word for word in words if word.startswith("-") and word.split("=")[0] not in OPTIONS and not re.match(r"-[\d.]", word)]
    if wrong or words[0].startswith("-"):
        raise ValueError(f"{match[0].strip()}: expected a scene and any of {', '.join(sorted(OPTIONS))}")
    return words


def ray_name(words):
    """A file name that tells which ray it is."""
    return re.sub(r"[^A-Za-z0-9.]+", "_", "_".join(words).replace("-", "m")).replace("mm", "").strip("_")


def record(program, checkout, folder, rays):
    if not rays:
        return
    folder.mkdir()
    for name, words in rays.items():
        subprocess.run([program, "trace", *words, "-o", folder / f"{name}.html"], cwd=checkout, check=True,
                       capture_output=True, text=True, stdin=subprocess.DEVNULL)
