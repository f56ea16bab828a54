"""What one HTML file says: its anchors, addresses, pictures and words."""
from html.parser import HTMLParser


class PageFacts(HTMLParser):
    def __init__(self, path):
        super().__init__()
        self.path = path
        self.ids, self.links, self.loads, self.pictures, self.frames, self.math = set(), [], [], [], [], 0
        self.scripts, self.unset_math, self.repeated_ids, self.headings = 0, 0, [], 0
        self.text = path.read_text(encoding="utf-8")
        self.feed(self.text)

    def handle_starttag(self, tag, attrs):
        attributes = dict(attrs)
        name = attributes.get("id")
        if name is not None:
            if name in self.ids:
                self.repeated_ids.append(name)
            self.ids.add(name)
        if tag == "a" and "href" in attributes:
            self.links.append(attributes["href"])
        if tag in ("img", "iframe", "script", "source", "video", "audio") and attributes.get("src"):
            self.loads.append(attributes["src"])
        if tag == "link":
            self.loads.append(attributes["href"])
        if tag == "img":
            self.pictures.append((attributes.get("src"), attributes.get("alt")))
        if tag == "iframe":
            self.frames.append((attributes["src"], attributes.get("title")))
        self.math += tag == "math"
        self.scripts += tag == "script"
        self.headings += tag == "h1"
        # What pandoc could not turn into MathML stays TeX in such an element.
        self.unset_math += "math" in (attributes.get("class") or "").split()
