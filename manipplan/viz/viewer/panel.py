"""Parts of a page's panel that every viewer has."""

from typing import Any


def switch(gui: Any, name: str, handle: Any) -> None:
    """A box that shows and hides a node of the scene."""
    box = gui.add_checkbox(name, initial_value=True)
    box.on_update(lambda _: setattr(handle, "visible", box.value))
