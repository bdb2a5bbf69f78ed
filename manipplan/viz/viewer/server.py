"""The server of the page that a browser shows: its port, its address and its shutdown.

Who may connect to the page: only browsers that opened the page itself, so that no other page reads or controls it.
What is added to viser's page, also in recordings: style and script of page.html.
"""

import contextlib
import errno
import importlib
import ipaddress
import json
import logging
import os
import socket
import sys
import threading
import webbrowser
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from html import escape
from http import HTTPStatus
from pathlib import Path
from types import TracebackType
from typing import Any, Self
from urllib.parse import urlsplit

from manipplan.support.checks import whole_number
from manipplan.support.errors import InvalidInputError, MissingExtraError
from manipplan.viz.viewer.stage import VIEW, WIDE

#: One server starts at a time, since viser takes what starts it from a module.
_starting = threading.Lock()


@contextmanager
def guarded(address: str, title: str) -> Iterator[None]:
    """Servers that viser starts in this block answer only requests that `refusal` allows, and furnish the page.

    viser passes no options to the server of websockets, so that its function is replaced in the block.
    """
    import websockets.asyncio.server as module

    serve = module.serve

    def serve_guarded(*arguments: Any, process_request: Callable[[Any, Any], Any], **options: Any) -> Any:
        def answer(connection: Any, request: Any) -> Any:
            headers = request.headers
            refused = refusal(headers.get_all("Host"), headers.get_all("Origin"), address)
            if refused:
                return connection.respond(HTTPStatus.FORBIDDEN, f"{refused}\n")
            if "Accept-Encoding" in headers:  # the page is changed below
                del headers["Accept-Encoding"]
            response = process_request(connection, request)
            if response is not None and "html" in response.headers.get("Content-Type", ""):
                response.body = furnished(response.body.decode(), title).encode()
                del response.headers["Content-Length"]
                response.headers["Content-Length"] = str(len(response.body))
            return response

        return serve(*arguments, process_request=answer, logger=_logger(), **options)

    with _starting:
        module.serve = serve_guarded  # type: ignore[assignment,misc]
        try:
            yield
        finally:
            module.serve = serve  # type: ignore[misc]


def refusal(hosts: list[str], origins: list[str], address: str) -> str:
    """Why a request with these headers Host and Origin to a server that listens at `address` is refused; "" if it is not.

    A page of another site names its own origin, and one that makes its name point to this machine (DNS rebinding) names itself
    as host. Programs that are no browsers send no origin.
    """
    host = hosts[0] if len(hosts) == 1 and "@" not in hosts[0] else ""
    if not _is_own(_part(f"//{host}", "hostname"), address):
        return f"the host {host!r} is not this page's: open it as localhost, by an address in digits, or by the machine's name"
    if any(_part(origin, "netloc").lower() != host.lower() for origin in origins):
        return "only the page itself may connect, not a page of another origin"
    return ""


def _part(address: str, name: str) -> str:
    """A part of an address; "" if it is none."""
    try:
        return getattr(urlsplit(address), name) or ""
    except ValueError:
        return ""


def _is_own(name: str, address: str) -> bool:
    """Whether a host's name can only mean this machine."""
    if name in ("localhost", address.lower()):
        return True
    try:
        number = ipaddress.ip_address(name)
    except ValueError:
        is_local = _is_loopback(address)
        return not is_local and name in (socket.gethostname().lower(), socket.getfqdn().lower())
    return number.is_loopback or not _is_loopback(address)


def _is_loopback(address: str) -> bool:
    try:
        return ipaddress.ip_address(address).is_loopback
    except ValueError:
        return False


def _logger() -> logging.Logger:
    """The log of the server, in which errors of a connection take one line."""
    logger = logging.getLogger(__name__)
    if not logger.filters:
        logger.addFilter(_one_line)
    return logger


def _one_line(record: logging.LogRecord) -> bool:
    if record.exc_info and record.exc_info[1] is not None:
        record.msg, record.args = f"{record.getMessage()}: {record.exc_info[1]!r:.200}", ()
        record.exc_info = None
    return True


log = logging.getLogger("manipplan")

#: Width of the panel beside the scene [px].
PANEL = 320


def furnished(html: str, title: str, panel: str = "") -> str:
    """viser's page with a title, with style and script of page.html, and with a panel as HTML beside the scene."""
    added = Path(__file__).with_name("page.html").read_text(encoding="utf-8")
    added = added.replace("CAMERA", json.dumps([VIEW, WIDE, PANEL]), 1)
    html = html.replace("<title>Viser</title>", f"<title>{escape(title)}</title>", 1)
    head, body = html.rindex("</head>"), html.rindex("</body>")
    return html[:head] + added + html[head:body] + panel + html[body:]


#: Default address: the page is visible to this machine only.
HOST = "localhost"
PORT = 8080


class Page:
    """A running viser server, usable in a `with` block, and shut down by `stop`.

    Attributes:
        server: viser's server.
        url: the page's address.
    """

    def __init__(self, port: int, host: str, title: str) -> None:
        """Start the server.

        Args:
            port: port of the page; 0 takes any free port.
            host: network address on which the server listens.
            title: title of the panel.

        Raises:
            MissingExtraError: viser is not installed.
            InvalidInputError: the port is in use, or the address is not one of this machine.
        """
        require_extra()
        import viser

        port = whole_number("port", port, least=0, most=65535)
        if not isinstance(host, str) or not host:
            raise InvalidInputError("host", host, "'localhost', or '0.0.0.0' for access from other machines")
        address = "127.0.0.1" if host == HOST else host  # the name also resolves to ::1, which not every machine has
        port = _free_port(port, address)
        with _quiet(), guarded(address, title):
            self.server: Any = viser.ViserServer(host=address, port=port, verbose=False)
        self.server.gui.set_panel_label(title)
        self.server.gui.configure_theme(show_logo=False, show_share_button=False, control_width="medium")
        self.server.gui.main_panel.dock_right()
        shown = "localhost" if host in ("0.0.0.0", "::", "127.0.0.1") else host
        shown = f"[{shown}]" if ":" in shown else shown  # an IPv6 address
        self.url = f"http://{shown}:{self.server.get_port()}"
        self._stopped = threading.Event()
        self._threads: list[threading.Thread] = []

    @property
    def running(self) -> bool:
        """Whether the page is being served."""
        return not self._stopped.is_set()

    def _repr_html_(self) -> str:
        """The page itself, in the cell of a notebook that runs on this machine."""
        return f'<iframe src="{escape(self.url)}" style="width:100%;height:600px;border:0"></iframe>'

    def open(self) -> bool:
        """Open the page in a browser; if none can be opened, log the address and return False."""
        opened = False
        if has_display():
            with contextlib.suppress(webbrowser.Error):
                opened = webbrowser.open(self.url)
        if not opened:
            log.warning("no browser could be opened here; open %s in one yourself", self.url)
        return opened

    def wait(self) -> None:
        """Block until the page is stopped; Ctrl-C stops it."""
        try:
            while not self._stopped.wait(0.2):
                pass
        except KeyboardInterrupt:
            self.stop()

    def stop(self) -> None:
        """Shut down the page; a second call does nothing."""
        if not self._stopped.is_set():
            self._stopped.set()
            for thread in self._threads:  # they use the server
                if thread is not threading.current_thread():
                    thread.join()
            with _quiet():
                self.server.stop()

    @contextlib.contextmanager
    def _furnishing(self) -> Iterator[None]:
        """Context that fills the page, and stops it on an error."""
        try:
            with self.server.atomic():
                yield
        except BaseException:
            self.stop()
            raise

    def _start(self, work: Callable[[], None]) -> None:
        """Run `work` in a thread; it has to return when the page stops."""
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
    """Whether a graphical browser can be opened: without a display a text browser would take over the terminal."""
    if sys.platform in ("win32", "darwin"):
        return True
    return any(os.environ.get(name) for name in ("DISPLAY", "WAYLAND_DISPLAY", "BROWSER"))


def require_extra() -> None:
    """Raise MissingExtraError before any work if a package of the extra `viewer` is not installed."""
    for package in ("viser", "trimesh"):
        try:
            importlib.import_module(package)
        except ImportError as error:
            raise MissingExtraError(package, "viewer") from error


def _free_port(port: int, host: str) -> int:
    """`port`, or any free port for 0; viser would silently take another port than the requested one."""
    try:
        found = socket.getaddrinfo(host, port, type=socket.SOCK_STREAM)
    except (OSError, UnicodeError) as error:
        raise InvalidInputError("host", host, f"an address of this machine ({error})") from error
    family, kind, protocol, _, address = found[0]
    with socket.socket(family, kind, protocol) as probe:
        if sys.platform != "win32":  # on Windows this option would allow a port that is in use
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
    """Suppress the banner and farewell that viser prints through rich's console."""
    import rich

    console = rich.get_console()
    before, console.quiet = console.quiet, True
    try:
        yield
    finally:
        console.quiet = before
