"""The builder's own translation of formulas."""

import runpy
from pathlib import Path

import pytest
from docutils import nodes
from sphinx.errors import ExtensionError

mathml = runpy.run_path(str(Path(__file__).parents[2] / "docs" / "_ext" / "mathml.py"))["_mathml"]


def formula(text):
    node = nodes.math(text, text)
    node.source, node.line = "page.md", 3
    return mathml(node, as_block=False)


def test_fractions_keep_their_parts():
    assert "<mn>1</mn><mn>2</mn></mfrac><mi>κ</mi>" in formula(r"\tfrac{1}{2} \kappa").replace(" ", "")


def test_a_thin_space_stands_beside_a_function_without_brackets():
    space = '<mspacewidth="0.17em"></mspace>'
    applied = "<mi>log</mi><mo>&ApplyFunction;</mo>"
    assert f"<mn>2</mn>{space}{applied}{space}<mi>m</mi>" in formula(r"2 \log m").replace(" ", "")
    assert f"<mo>−</mo>{applied}<mo" in formula(r"1 - \log(m)").replace(" ", "")


@pytest.mark.parametrize("text", [r"\tfrac12 \kappa", r"\frac 12"])
def test_fractions_without_braces_are_refused(text):
    """docutils would draw 12 / κ."""
    with pytest.raises(ExtensionError, match="page.md:3: write the fraction in .* with braces"):
        formula(text)
