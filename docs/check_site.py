"""Checks a built site: `python docs/check_site.py docs/_build/html` prints what is wrong and ends with 1 if anything is.

Every link, anchor and picture inside the site has its target, every picture its text, no setting of the gallery is in the text,
and nothing is loaded from elsewhere: no script, style, font or picture. Links that a reader may follow to other sites are for
`make links`.
"""

import re
import sys
from html.parser import HTMLParser
from pathlib import Path
from urllib.parse import unquote, urlsplit

#: What a page loads by itself, by tag and attribute; `link` counts unless it only names another page.
LOADED = {(tag, "src") for tag in ("script", "img", "source", "video", "audio", "iframe", "embed", "input")}
LOADED |= {("video", "poster"), ("object", "data"), ("track", "src"), ("body", "background")}
LOADED |= {(tag, name) for tag in ("image", "use") for name in ("href", "xlink:href")}
NAMED = {"next", "prev", "index", "search", "canonical", "license", "author", "help", "up", "top"}
STYLE_URL = re.compile(r"""url\(\s*["']?([^"')]+)|@import\s+["']([^"']+)""")
SCRIPT_URL = re.compile(
    r"""(?:import\s*\(?|\bfrom|fetch\(|importScripts\(|(?:Worker|WebSocket|EventSource)\(|\.open\(["'`]\w+["'`],|\.src\s*=)"""
    r"""\s*["'`](?:https?:|wss?:)?//[^"'`]+"""
)


class Page(HTMLParser):
    """What one page has and asks for."""

    def __init__(self, text: str) -> None:
        super().__init__(convert_charrefs=True)
        self.ids: set[str] = set()
        self.links: list[str] = []
        self.loads: list[str] = []
        self.faults: list[str] = []
        self._inside = ""
        self.feed(text)

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        values = {name: value or "" for name, value in attrs}
        self.ids |= {values[name] for name in ("id", "name") if name in values}
        self._inside = tag
        if tag in ("a", "area") and "href" in values:
            self.links.append(values["href"])
        if tag == "base":
            self.faults.append("a base, by which every link on the page is another")
        if tag == "meta" and values.get("http-equiv", "").lower() == "refresh":
            self.faults.append(f"goes elsewhere by itself: {values.get('content')}")
        if tag == "link" and not NAMED & set(values.get("rel", "").split()):
            self.loads.append(values.get("href", ""))
        self.loads += [values[name] for name in values if (tag, name) in LOADED]
        self.loads += [part.split()[0] for part in values.get("srcset", "").split(",") if part.strip()]
        self.loads += style_urls(values.get("style", ""))
        name = Path(values.get("src", "")).name
        if tag == "img" and values.get("alt", name) in (name, values.get("src")):  # an empty text marks an ornament
            self.faults.append(f"the picture {values.get('src')} has no text in its place (alt)")

    def handle_endtag(self, tag: str) -> None:  # noqa: ARG002  # as html.parser calls it
        self._inside = ""

    def handle_data(self, data: str) -> None:
        if self._inside == "style":
            self.loads += style_urls(data)
        if self._inside != "script" and "sphinx_gallery_" in data:
            self.faults.append("a setting of the gallery is in the text: its comment needs an empty line before it")
        if self._inside == "script" and (match := SCRIPT_URL.search(data)):
            self.faults.append(f"a script loads from elsewhere: {match.group()}")


def style_urls(text: str) -> list[str]:
    """What a style sheet loads."""
    return [first or second for first, second in STYLE_URL.findall(text)]


def faults(site: Path) -> list[str]:
    """What is wrong, one line each; raises FileNotFoundError where there is no site."""
    site = site.resolve()
    if not (site / "index.html").is_file():
        raise FileNotFoundError(f"{site} holds no index.html; build the site first: make docs")
    pages = {file: Page(file.read_text(encoding="utf-8")) for file in sorted(site.rglob("*.html"))}
    found = []
    for file, page in pages.items():
        name = file.relative_to(site)
        found += [f"{name}: {fault}" for fault in page.faults]
        found += [f"{name}: loads {url} from elsewhere" for url in page.loads if external(url)]
        for url in page.links + [url for url in page.loads if not external(url)]:
            parts = urlsplit(url)
            if parts.scheme == "file":
                found.append(f"{name}: {url} is a file of one machine")
            if parts.scheme or parts.netloc:
                continue
            target = (file.parent / unquote(parts.path)).resolve() if parts.path else file
            if not target.is_relative_to(site) or not target.is_file():
                found.append(f"{name}: {url} has no target")
            elif parts.fragment and target in pages and unquote(parts.fragment) not in pages[target].ids:
                found.append(f"{name}: {url} has no such anchor")
    for file in sorted(site.rglob("*.css")):
        for url in style_urls(file.read_text(encoding="utf-8")):
            parts = urlsplit(url)
            if external(url):
                found.append(f"{file.relative_to(site)}: loads {url} from elsewhere")
            elif not parts.scheme and parts.path and not (file.parent / unquote(parts.path)).is_file():
                found.append(f"{file.relative_to(site)}: {url} has no target")
    for file in sorted((*site.rglob("*.js"), *site.rglob("*.mjs"))):
        if match := SCRIPT_URL.search(file.read_text(encoding="utf-8")):
            found.append(f"{file.relative_to(site)}: loads from elsewhere: {match.group()}")
    for file in sorted(site.rglob("*.svg")):
        loads = Page(file.read_text(encoding="utf-8")).loads
        found += [f"{file.relative_to(site)}: loads {url} from elsewhere" for url in loads if external(url)]
    return found


def external(url: str) -> bool:
    """Whether a browser would ask another machine for it."""
    parts = urlsplit(url.strip())
    return parts.scheme in ("http", "https", "ftp") or bool(parts.netloc)


def main(arguments: list[str]) -> int:
    """Print the faults of the site in the folder given; 1 if there are any."""
    [folder] = arguments
    found = faults(Path(folder))
    for line in found:
        print(line)
    print(f"{folder}: {len(found)} faults in links, anchors, pictures and what is loaded")
    return bool(found)


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
