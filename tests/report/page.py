"""Read a page as a browser would, without one."""

from html.parser import HTMLParser
from pathlib import Path

DOI = "https://doi.org/10.1016/j.oceaneng.2022.113280"
"""The one address elsewhere: to be followed, never loaded."""
VOID = {"meta", "link", "img", "br", "hr", "input"}
OPTIONAL = {"li", "p", "dt", "dd", "tr", "td", "th", "thead", "tbody"}


class Page(HTMLParser):
    """Anchors, links, pictures and texts of a page, and tags that were not closed."""

    def __init__(self, path: Path):
        super().__init__()
        self.path = path
        self.ids, self.links, self.pictures, self.loads = [], [], [], []
        self.open_tags, self.strays, self.words = [], [], []
        self.text = path.read_text(encoding="utf-8")
        self.feed(self.text)
        self.close()

    def handle_starttag(self, tag, attrs):
        found = dict(attrs)
        if "id" in found:
            self.ids.append(found["id"])
        if tag == "a":
            self.links.append(found["href"])
        elif "href" in found:
            self.loads.append(found["href"])
        if tag == "img":
            self.pictures.append(found)
        if "src" in found:
            self.loads.append(found["src"])
        if tag not in VOID:
            self.open_tags.append(tag)

    def handle_endtag(self, tag):
        if self.open_tags and self.open_tags[-1] == tag:
            self.open_tags.pop()
        else:
            self.strays.append(tag)

    def handle_data(self, data):
        self.words.append(data)

    @property
    def faults(self) -> list[str]:
        """What a reader without a network would miss, or a validator report."""
        found = [f"loads {source[:60]}" for source in self.loads if not source.startswith("data:")]
        found += [f"style loads {word}" for word in ("url(", "@import") if word in self.text]
        found += [f"stray or unclosed <{tag}>" for tag in (*self.strays, *self.open_tags)]
        found += [f"id {name} twice" for name in {n for n in self.ids if self.ids.count(n) > 1}]
        found += [f"picture without text: {p}" for p in self.pictures if not p.get("alt")]
        for link in self.links:
            if link.startswith("#"):
                found += [] if link[1:] in self.ids else [f"no anchor for {link}"]
            elif link != DOI and not (self.path.parent / link).exists():
                found.append(f"no file for {link}")
        return found
