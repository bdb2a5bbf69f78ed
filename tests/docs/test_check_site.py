"""The check of the built site finds what is put in: a link, an anchor, a picture, a script from elsewhere."""

import sys
from pathlib import Path

import pytest

sys.path.insert(0, str(Path(__file__).parents[2] / "docs"))
import check_site

PAGE = '<html><head></head><body><h1 id="top">Site</h1><a href="other.html#part">other</a>{}</body></html>'


@pytest.fixture
def site(tmp_path):
    (tmp_path / "index.html").write_text(PAGE.format(""))
    (tmp_path / "other.html").write_text('<p id="part">Part</p><a href="index.html#top">back</a> <a href="https://a.org">a</a>')
    (tmp_path / "arm.png").write_bytes(b"")
    (tmp_path / "site.css").write_text("body { background: url(arm.png) }")
    (tmp_path / "site.js").write_text("// see https://a.org\nconst from = 'https://a.org';")
    return tmp_path


def test_a_site_without_faults(site, capsys):
    (site / "index.html").write_text(PAGE.format('<img src="arm.png" alt="an arm"><link rel="stylesheet" href="site.css">'))
    assert check_site.faults(site) == []
    assert check_site.main([str(site)]) == 0
    assert "0 faults" in capsys.readouterr().out


@pytest.mark.parametrize(
    ("put_in", "fault"),
    [
        ('<a href="nowhere.html">x</a>', "nowhere.html has no target"),
        ('<a href="other.html#nowhere">x</a>', "no such anchor"),
        ('<a href="#nowhere">x</a>', "no such anchor"),
        ('<a href="../index.html">x</a>', "has no target"),
        ('<area href="nowhere.html">', "has no target"),
        ('<a href="file:///home/me/x.html">x</a>', "a file of one machine"),
        ('<base href="https://a.org/">', "a base"),
        ('<meta http-equiv="Refresh" content="0; url=https://a.org">', "goes elsewhere by itself"),
        ('<img src="arm.png">', "no text in its place"),
        ('<img src="nowhere.png" alt="x">', "nowhere.png has no target"),
        ("<p># sphinx_gallery_thumbnail_number = 2</p>", "a setting of the gallery is in the text"),
        ('<script src="https://a.org/a.js"></script>', "loads https://a.org/a.js from elsewhere"),
        ('<script src="//a.org/a.js"></script>', "from elsewhere"),
        ('<script type="module">import a from "https://a.org/a.js"</script>', "a script loads from elsewhere"),
        ('<script>import("https://a.org/a.js")</script>', "a script loads from elsewhere"),
        ('<script>fetch("https://a.org/a")</script>', "a script loads from elsewhere"),
        ('<script>new Worker("https://a.org/a.js")</script>', "a script loads from elsewhere"),
        ('<script>new WebSocket("wss://a.org")</script>', "a script loads from elsewhere"),
        ('<script>request.open("GET", "https://a.org")</script>', "a script loads from elsewhere"),
        ('<link rel="stylesheet" href="https://a.org/a.css">', "from elsewhere"),
        ('<style>@import "https://a.org/a.css"</style>', "from elsewhere"),
        ('<p style="background: url(https://a.org/a.png)">x</p>', "from elsewhere"),
        ('<svg><image xlink:href="https://a.org/a.png"/></svg>', "from elsewhere"),
        ('<video><track src="https://a.org/a.vtt"></video>', "from elsewhere"),
    ],
)
def test_what_is_put_in_is_found(site, capsys, put_in, fault):
    (site / "index.html").write_text(PAGE.format(put_in))
    [line] = check_site.faults(site)
    assert line.startswith("index.html: ")
    assert fault in line
    assert check_site.main([str(site)]) == 1
    assert "1 faults" in capsys.readouterr().out


@pytest.mark.parametrize(
    ("name", "text"),
    [
        ("a.css", "a { background: url(nowhere.png) }"),
        ("a.css", "@import 'https://a.org/a.css';"),
        ("a.js", "importScripts('https://a.org/a.js')"),
        ("a.mjs", "export * from 'https://a.org/a.js'"),
        ("a.svg", '<svg xmlns="http://www.w3.org/2000/svg"><image href="https://a.org/a.png"/></svg>'),
    ],
)
def test_files_beside_the_pages_are_read(site, name, text):
    (site / name).write_text(text)
    [line] = check_site.faults(site)
    assert line.startswith(f"{name}: ")


def test_no_site_is_an_error(tmp_path):
    with pytest.raises(FileNotFoundError, match="build the site first"):
        check_site.faults(tmp_path)
