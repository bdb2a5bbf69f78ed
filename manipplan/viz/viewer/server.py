"""The server of the page that a browser shows: its port, its address, its end."""

import contextlib
import errno
import importlib
import logging
import os
import socket
import sys
import threading
import webbrowser
from collections.abc import Callable, Iterator
from types import TracebackType
from typing import Any, Self

from manipplan.support.checks import whole_number
from manipplan.support.errors import InvalidInputError, MissingExtraError

log = logging.getLogger("manipplan")

#: Only this machine sees the page unless another address is asked for.
HOST = "localhost"
PORT = 8080


class Page:
    """A viser server at work, usable in a `with` block, and ended by `stop`.

    Attributes:
        server: viser's server.
        url: the page's address.
    """

    def __init__(self, port: int, host: str, title: str) -> None:
        """Start the server.

        Args:
            port: where; 0 takes any free one.
            host: address of the network on which it listens.
            title: of the panel.

        Raises:
            MissingExtraError: viser is not installed.
            InvalidInputError: the port is in use, or the address is not one of this machine.
        """
        require_extra()
        import viser

        port = whole_number("port", port, least=0, most=65535)
        if not isinstance(host, str) or not host:
            raise InvalidInputError("host", host, "'localhost', or '0.0.0.0' to be seen by other machines")
        address = "127.0.0.1" if host == HOST else host  # by its name it would also be ::1, which not every machine has
        port = _free_port(port, address)
        with _quiet():
            self.server: Any = viser.ViserServer(host=address, port=port, verbose=False)
        self.server.gui.set_panel_label(title)
        self.server.gui.configure_theme(show_logo=False, show_share_button=False, control_width="medium")
        self.server.gui.main_panel.dock_right()
        shown = "localhost" if host in ("0.0.0.0", "::", "127.0.0.1") else host
        shown = f"[{shown}]" if ":" in shown else shown  # an address of IPv6
        self.url = f"http://{shown}:{self.server.get_port()}"
        self._stopped = threading.Event()
        self._threads: list[threading.Thread] = []

    @property
    def running(self) -> bool:
        """Whether the page can be seen."""
        return not self._stopped.is_set()

    def open(self) -> bool:
        """Open the page in a browser; where there is none that says so in the log, with the address, and returns False."""
        opened = False
        if has_display():
            with contextlib.suppress(webbrowser.Error):
                opened = webbrowser.open(self.url)
        if not opened:
            log.warning("no browser could be opened here; open %s in one yourself", self.url)
        return opened

    def wait(self) -> None:
        """Return once the page is stopped, or at Ctrl-C, which stops it."""
        try:
            while not self._stopped.wait(0.2):
                pass
        except KeyboardInterrupt:
            self.stop()

    def stop(self) -> None:
        """End the page; a second call does nothing."""
        if not self._stopped.is_set():
            self._stopped.set()
            for thread in self._threads:  # they draw on the server
                if thread is not threading.current_thread():
                    thread.join()
            with _quiet():
                self.server.stop()

    @contextlib.contextmanager
    def _furnishing(self) -> Iterator[None]:
        """Fill the page, which ends when that fails."""
        try:
            with self.server.atomic():
                yield
        except BaseException:
            self.stop()
            raise

    def _start(self, work: Callable[[], None]) -> None:
        """Let a thread work that ends when the page does not run any more."""
        thread = threading.Thread(target=work, name=f"manipplan {type(self).__name__}", daemon=True)
        self._threads.append(thread)
        thread.start()

    def __enter__(self) -> Self:
        return self

    def __exit__(self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None) -> None:
        self.stop()

    def __repr__(self) -> str:
        return f"{type(self).__name__}({self.url}{'' if self.running else ', stopped'})"


def has_display() -> bool:
    """Whether a browser could show something: without a screen a text browser would take the terminal."""
    if sys.platform in ("win32", "darwin"):
        return True
    return any(os.environ.get(name) for name in ("DISPLAY", "WAYLAND_DISPLAY", "BROWSER"))


def require_extra() -> None:
    """Raise MissingExtraError, before any work, when a package of the extra `viewer` is not installed."""
    for package in ("viser", "trimesh", "fast_simplification"):
        try:
            importlib.import_module(package)
        except ImportError as error:
            raise MissingExtraError(package, "viewer") from error


def _free_port(port: int, host: str) -> int:
    """`port`, or for 0 any that is free; viser would take another one than is asked for without a word."""
    try:
        found = socket.getaddrinfo(host, port, type=socket.SOCK_STREAM)
    except (OSError, UnicodeError) as error:
        raise InvalidInputError("host", host, f"an address of this machine ({error})") from error
    family, kind, protocol, _, address = found[0]
    with socket.socket(family, kind, protocol) as probe:
        if sys.platform != "win32":  # where it would take a port that is in use
            probe.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
        try:
            probe.bind(address)
        except OSError as error:
            if error.errno == errno.EADDRNOTAVAIL:
                raise InvalidInputError("host", host, "an address of this machine") from error
            allowed = f"a port that can be used ({error.strerror}); another number, or 0 for any free one"
            raise InvalidInputError("port", port, allowed) from error
        return int(probe.getsockname()[1])


@contextlib.contextmanager
def _quiet() -> Iterator[None]:
    """viser prints a banner and a farewell through rich's own console; nobody asked for them."""
    import rich

    console = rich.get_console()
    before, console.quiet = console.quiet, True
    try:
        yield
    finally:
        console.quiet = before
