"""Sphinx configuration."""

import logging
import pydoc
import re
import sys
from pathlib import Path

import a11y_pygments  # noqa: F401  # it prints the INFO of every library; taken back below
import pinocchio as pin
from sphinx import addnodes
from sphinx.pycode import ModuleAnalyzer
from sphinx.util.nodes import make_refnode

import manipplan

logging.getLogger().handlers.clear()
for kind in (pin.SE3, pin.Model, pin.Data, pin.GeometryModel):
    kind.__module__ = "pinocchio"  # where users find them, not in the library's inner module
sys.path.insert(0, str(Path(__file__).parent / "_ext"))

project = "manipplan"
author = "the manipplan developers"
copyright = f"2026, {author}"
version = release = manipplan.__version__
language = "en"
extensions = [
    "myst_parser",
    "sphinx.ext.autodoc",
    "sphinx.ext.autosummary",
    "sphinx.ext.napoleon",
    "sphinx_gallery.gen_gallery",
    "sphinxcontrib.bibtex",
    "sphinx_copybutton",
    "mathml",
]
html_theme = "furo"
html_title = "manipplan"
html_logo = html_favicon = "_static/logo.svg"
html_static_path = ["_static"]
html_css_files = ["site.css"]
html_js_files = ["site.js"]
html_search_scorer = str(Path(__file__).parent / "_static" / "search_scores.js")
html_math_renderer = "mathml"
html_copy_source = False
html_show_sourcelink = False
# code in colours that also those see who tell few apart, and with a contrast of 7 to 1
pygments_style = "a11y-high-contrast-light"
pygments_dark_style = "a11y-high-contrast-dark"
highlight_language = "none"  # a block that names no language is no Python
exclude_patterns = ["studies/*/*", "_build", "examples", "benchmarks/*", "pictures/*", "**sg_execution_times.rst"]
myst_enable_extensions = ["colon_fence", "dollarmath"]
myst_heading_anchors = 3
autodoc_member_order = "bysource"
autodoc_inherit_docstrings = False  # a method that a class has from another is described there
autodoc_typehints_format = "short"
autosummary_context = {
    "with_all_members": {f"manipplan.results.{name}" for name in ("Completeness", "StepStatus")},
    "with_inherited_members": {
        "manipplan.Plan",
        *(f"manipplan.viz.viewer.{name}" for name in ("PlanViewer", "LiveViewer", "ServoViewer")),
    },
}
python_maximum_signature_line_length = 130  # of the names in full; one argument per line beyond that
python_use_unqualified_type_names = True
templates_path = ["_templates"]
napoleon_google_docstring = True
napoleon_attr_annotations = False
napoleon_custom_sections = [("Attributes", "params_style")]  # a list, not an entry of its own for each
bibtex_bibfiles = ["references.bib"]
default_role = "py:obj"  # `optimize_path` in a docstring leads there
nitpicky = True
sphinx_gallery_conf = {
    "examples_dirs": "examples",
    "gallery_dirs": "gallery",
    "subsection_order": [f"examples/{section}" for section in ("first_steps", "plan", "follow", "track", "measure", "deploy")],
    "within_subsection_order": "gallery_order.TaughtOrder",
    "filename_pattern": "plot_",
    "abort_on_example_error": True,
    "parallel": True,
    "show_memory": False,
    "download_all_examples": False,
    "show_signature": False,
    "write_computation_times": False,
    "remove_config_comments": True,
    "capture_repr": (),  # pages print what they show
}
html_domain_indices = False
suppress_warnings = ["config.cache"]
linkcheck_timeout = 20
linkcheck_ignore = [r"\.\./"]  # inside the site: check_site.py
#: Links that are written by hand must have a target; types that autodoc finds in signatures need none.
nitpick_ignore_regex = [
    ("py:(class|obj|exc|data|attr)", r"(?!manipplan\.((errors|formulations|measures|planar|results|viz)\.)?\w+$).*")
]

KEYS = set(re.findall(r"^@\w+\{(\w+),", (Path(__file__).parent / "references.bib").read_text(encoding="utf-8"), re.MULTILINE))
ARGUMENTS = re.compile(r"<dl>\s*(?:<dd>(?:(?!<dl|</dl).)*</dd>\s*)</dl>", re.DOTALL)
CITED = re.compile(r"\[(\w+)((?:, [^\]]+)?)\]")


def _cite(match):
    key, place = match.groups()
    return f":cite:p:`{key}`{place}" if key in KEYS else match.group()


def _docstring(_app, what, _name, _obj, _options, lines):
    """A key of references.bib in brackets becomes a citation.

    Napoleon takes what stands before a colon in a property's first line for its type; ours is a sentence.
    """
    lines[:] = [CITED.sub(_cite, line) for line in lines]
    if what in ("attribute", "property"):
        lines.insert(0, "\\")  # an escaped end of line: nothing in reStructuredText, but no colon for napoleon


def _one_signature(_app, _what, _name, obj, _options, _arguments, _returned):
    """A call has one signature, with all that it may return, instead of one for each of its overloads."""
    if module := getattr(obj, "__module__", None):
        analyzer = ModuleAnalyzer.for_module(module)
        analyzer.analyze()
        analyzer.overloads.clear()


def _public_name(app, env, node, contnode):
    """What docstrings name without its namespace, and signatures by the module that makes it, leads to its public name."""
    target = node["reftarget"]
    if pydoc.locate(target):
        target = target.rsplit(".", 1)[-1]
    for space in ("", "errors.", "formulations.", "measures.", "results.", "viz.viewer."):
        name = f"manipplan.{space}{target}"
        if node["refdomain"] == "py" and (found := env.domains["py"].objects.get(name)):
            return make_refnode(app.builder, node["refdoc"], found.docname, found.node_id, contnode, name)
    return None


def _short_navigation(_app, env):
    """The navigation of every page ends at the pages of the reference: their tables lead to each class and function."""
    for page in env.tocs:
        if page.startswith("reference/") and page != "reference/index":
            for tree in list(env.tocs[page].findall(addnodes.toctree)):
                tree.parent.remove(tree)


def _arguments(_app, _page, _template, context, _doctree):
    """Arguments on lines of their own are no list of definitions, which would need terms, as screen readers know."""
    lines = (("<dl>", '<span class="sig-arguments">'), ("<dd>", "<span>"), ("</dd>", "</span>"), ("</dl>", "</span>"))

    def spans(found):
        text = found.group()
        for old, new in lines:
            text = text.replace(old, new)
        return text

    context["body"] = ARGUMENTS.sub(spans, context.get("body", ""))


def _caption_levels(_app, _page, _template, context, _doctree):
    """Sphinx calls the captions of the navigation headings and leaves their level out, which screen readers need."""
    tree = context.get("furo_navigation_tree", "")
    context["furo_navigation_tree"] = tree.replace('role="heading"', 'role="heading" aria-level="2"')


def _recording(app, failed):
    """The motion of the film as a recording, which the page of the viewer shows: too large to be kept with the sources."""
    file = Path(app.outdir) / "_static" / "recording.html"
    if failed is None and app.builder.format == "html" and not file.exists():
        problem = manipplan.demo.panda_among_boxes()
        plan = manipplan.plan(problem.robot, problem.start, problem.goal, problem.scene, clearance=problem.clearance)
        plan.record(file)


def setup(app):
    """Run before napoleon and after furo, whose priority is 500."""
    app.connect("autodoc-process-docstring", _docstring, priority=400)
    app.connect("autodoc-process-signature", _one_signature)
    app.connect("missing-reference", _public_name)
    app.connect("env-updated", _short_navigation)
    app.connect("html-page-context", _arguments)
    app.connect("html-page-context", _caption_levels, priority=600)
    app.connect("build-finished", _recording)
