"""Sphinx configuration."""

import manipplan

project = "manipplan"
author = "the manipplan developers"
copyright = f"2026, {author}"
version = release = manipplan.__version__
extensions = [
    "myst_parser",
    "sphinx.ext.autodoc",
    "sphinx.ext.napoleon",
    "sphinx_gallery.gen_gallery",
    "sphinxcontrib.bibtex",
]
html_theme = "furo"
html_title = "manipplan"
html_static_path = ["_static"]
exclude_patterns = ["studies/*/*", "_build", "examples", "benchmarks/*"]
myst_enable_extensions = ["colon_fence"]
autodoc_member_order = "bysource"
autodoc_typehints = "none"
napoleon_google_docstring = True
bibtex_bibfiles = ["references.bib"]
sphinx_gallery_conf = {
    "examples_dirs": "examples",
    "gallery_dirs": "gallery",
    "filename_pattern": "plot_",
    "abort_on_example_error": True,
    "show_memory": False,
    "download_all_examples": False,
    "show_signature": False,
    "min_reported_time": 60,
}
suppress_warnings = ["config.cache"]
