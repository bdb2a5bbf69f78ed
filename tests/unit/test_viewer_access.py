"""Who may connect to the page of the viewer."""

import asyncio
import http.client
import logging
from contextlib import closing

import pytest
from hypothesis import given
from hypothesis import strategies as st
from websockets.asyncio.client import connect
from websockets.exceptions import InvalidStatus

from manipplan.viz.viewer.server import Page, refusal

HOSTS = st.from_regex(r"[a-z0-9-]{1,12}(\.[a-z]{2,9}){1,3}", fullmatch=True)


@pytest.fixture(scope="module")
def page():
    with Page(0, "localhost", "test") as page:
        yield page


def port_of(page):
    return int(page.url.rsplit(":", 1)[1])


def status_of(page, **headers):
    """The status of a request for the page itself."""
    connection = http.client.HTTPConnection("127.0.0.1", port_of(page), timeout=10)
    connection.putrequest("GET", "/", skip_host=True)
    for name, value in headers.items():
        connection.putheader(name, value)
    connection.endheaders()
    with closing(connection), connection.getresponse() as response:
        return response.status


async def received(page, **options):
    async with connect(f"ws://127.0.0.1:{port_of(page)}", subprotocols=["viser-v1.1.1"], **options) as socket:
        return await asyncio.wait_for(socket.recv(), 10)


@pytest.mark.parametrize("name", ["localhost", "127.0.0.1", "LOCALHOST"])
def test_the_page_itself_connects(page, name):
    host = f"{name}:{port_of(page)}"
    assert status_of(page, Host=host) == 200
    assert status_of(page, Host=host, Origin=f"http://{host}") == 200
    assert asyncio.run(received(page, origin=f"http://127.0.0.1:{port_of(page)}"))


@pytest.mark.parametrize("origin", ["http://evil.example", "null", "https://127.0.0.1.evil.example", "http://localhost:1"])
def test_a_page_of_another_origin_does_not(page, origin):
    """F12 of reviews/trust.md: it could read the scene and press buttons."""
    with pytest.raises(InvalidStatus, match="403"):
        asyncio.run(received(page, origin=origin))


@pytest.mark.parametrize("host", ["evil.example", "localhost.evil.example", "", "192.0.2.7", "[::2]", "@localhost", "a@b@c"])
def test_a_name_that_points_to_this_machine_does_not(page, host):
    assert status_of(page, Host=host) == 403


@pytest.mark.slow
def test_a_message_that_is_not_understood_takes_one_line(page, caplog):
    async def send():
        async with connect(f"ws://127.0.0.1:{port_of(page)}", subprotocols=["viser-v1.1.1"]) as socket:
            await socket.send(b"\xc1not MessagePack")
            await asyncio.sleep(0.5)

    with caplog.at_level(logging.DEBUG):
        asyncio.run(send())
    assert not any(each.exc_info for each in caplog.records)
    assert status_of(page, Host="localhost") == 200


@pytest.mark.slow
@given(host=HOSTS, port=st.integers(1, 65535))
def test_no_other_name_is_this_machine(host, port):
    assert refusal([f"{host}:{port}"], [f"http://{host}:{port}"], "127.0.0.1")


@given(host=st.ip_addresses(v=4), port=st.integers(1, 65535))
def test_addresses_in_digits_are_allowed_where_the_page_is_for_other_machines(host, port):
    assert not refusal([f"{host}:{port}"], [f"http://{host}:{port}"], "0.0.0.0")
    assert bool(refusal([f"{host}:{port}"], [], "127.0.0.1")) == (not host.is_loopback)
    assert refusal([f"{host}:{port}"], [f"http://{host}:{port + 1}"], "0.0.0.0")


def test_two_hosts_are_none():
    assert refusal(["localhost", "evil.example"], [], "127.0.0.1") and refusal([], [], "127.0.0.1")


@given(host=st.text(), origin=st.text(), address=st.sampled_from(["127.0.0.1", "0.0.0.0", "::", "::1"]))
def test_any_headers_get_an_answer(host, origin, address):
    assert isinstance(refusal([host], [origin], address), str)
    assert refusal(["[::1"], [], address)
