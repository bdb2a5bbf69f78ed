"""Parts of the panel that all viewers share."""

from collections.abc import Mapping, Sequence
from html import escape
from typing import Any


def switches(gui: Any, layers: Mapping[str, Any]) -> None:
    """A folder with a checkbox per layer, labelled with its name, that shows and hides it."""

    def switch(name: str, handle: Any) -> None:
        box = gui.add_checkbox(name, initial_value=bool(handle.visible))
        box.on_update(lambda _: setattr(handle, "visible", box.value))

    with gui.add_folder("Show"):
        for name, handle in layers.items():
            switch(name, handle)


def table(rows: Sequence[tuple[str, str]]) -> str:
    """Names and values in two columns, as HTML."""
    cells = "".join(
        f'<tr><td style="padding:0.1em 0.8em 0.1em 0;color:#666;white-space:nowrap">{escape(name)}</td>'
        f'<td style="font-variant-numeric:tabular-nums">{escape(value)}</td></tr>'
        for name, value in rows
    )
    return f'<table style="margin:0.2em 0.75em;font:12px sans-serif;color:#222;border-collapse:collapse">{cells}</table>'
