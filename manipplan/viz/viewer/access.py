"""Who may connect to the page: only browsers that opened the page itself, so that no other page reads or controls it."""

import ipaddress
import logging
import socket
import threading
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from http import HTTPStatus
from typing import Any
from urllib.parse import urlsplit

#: One server starts at a time, since viser takes what starts it from a module.
_starting = threading.Lock()


@contextmanager
def guarded(address: str) -> Iterator[None]:
    """Servers that viser starts in this block answer only requests that `refusal` allows.

    viser passes no options to the server of websockets, so that its function is replaced in the block.
    """
    import websockets.asyncio.server as module

    serve = module.serve

    def guarded_serve(*arguments: Any, process_request: Callable[[Any, Any], Any], **options: Any) -> Any:
        def answer(connection: Any, request: Any) -> Any:
            headers = request.headers
            refused = refusal(headers.get_all("Host"), headers.get_all("Origin"), address)
            if refused:
                return connection.respond(HTTPStatus.FORBIDDEN, f"{refused}\n")
            return process_request(connection, request)

        return serve(*arguments, process_request=answer, logger=_logger(), **options)

    with _starting:
        module.serve = guarded_serve  # type: ignore[assignment,misc]
        try:
            yield
        finally:
            module.serve = serve  # type: ignore[misc]


def refusal(hosts: list[str], origins: list[str], address: str) -> str:
    """Why a request is refused; "" if it is not.

    A page of another site names its own origin, and one that makes its name point to this machine (DNS rebinding) names itself
    as host. Programs that are no browsers send no origin.

    Args:
        hosts, origins: the values of the headers Host and Origin.
        address: where the server listens.
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
