"""Formulas as MathML, made when the site is built: pages need neither a script nor a font from elsewhere.

Every browser of today draws MathML. The translation from LaTeX is that of docutils.
"""

import re
from typing import Any

from docutils import nodes
from docutils.utils.math import MathError
from docutils.utils.math.latex2mathml import tex2mathml
from sphinx.errors import ExtensionError

#: Dots as an accent of their own are not drawn by every browser without a mathematical font; a letter with dots is.
DOTTED = re.compile(r'<mover accent="true">\s*<mi>(\w)</mi>\s*<mo[^>]*>([˙¨])</mo>\s*</mover>')
#: docutils takes all digits that follow for the numerator, and the next letter for the denominator.
UNBRACED = re.compile(r"\\[dt]?frac\s*\d")
#: Beside the name of a function stands a thin space, as in LaTeX, unless brackets or a sign follow; browsers leave none.
BESIDE_FUNCTION = re.compile(
    r"</(?:mi|mn|mrow|mfrac|msub|msup)>\s*(?=<mi[^>]*>[a-z]{2,}</mi>\s*<mo>&ApplyFunction;)"
    r"|<mo>&ApplyFunction;</mo>\s*(?=<m(?!o\b|space))"
)
THIN_SPACE = '<mspace width="0.17em"></mspace>'
DOTS = {"˙": "\u0307", "¨": "\u0308"}


def setup(app: Any) -> dict[str, bool]:
    """Register the renderer; `html_math_renderer = "mathml"` chooses it."""
    app.add_html_math_renderer("mathml", inline_renderers=(_inline, None), block_renderers=(_block, None))
    return {"parallel_read_safe": True, "parallel_write_safe": True}


def _inline(translator: Any, node: nodes.math) -> None:
    translator.body.append(_mathml(node, as_block=False))
    raise nodes.SkipNode


def _block(translator: Any, node: nodes.math_block) -> None:
    translator.body.append(translator.starttag(node, "div", CLASS="math"))
    if node["number"]:
        translator.body.append(f'<span class="eqno">({node["number"]})')
        translator.add_permalink_ref(node, "Link to this equation")
        translator.body.append("</span>")
    translator.body.append(_mathml(node, as_block=True) + "</div>\n")
    raise nodes.SkipNode


def _mathml(node: nodes.Element, *, as_block: bool) -> str:
    source = node.astext()
    if UNBRACED.search(source):
        raise ExtensionError(f"{node.source}:{node.line}: write the fraction in {source!r} with braces")
    try:
        mathml = tex2mathml(source, as_block=as_block)
    except MathError as error:
        raise ExtensionError(f"{node.source}:{node.line}: the formula {source!r} cannot be translated: {error}") from error
    mathml = BESIDE_FUNCTION.sub(rf"\g<0>{THIN_SPACE}", mathml)
    return DOTTED.sub(lambda found: f'<mi style="font-style: italic">{found[1]}{DOTS[found[2]]}</mi>', mathml).replace(
        "\n", " "
    )
