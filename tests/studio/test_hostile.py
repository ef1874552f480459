"""What must not get in: other pages, other names, other folders, too much of anything."""

from __future__ import annotations

import asyncio
import base64
import json
import os
import socket
from concurrent.futures import ThreadPoolExecutor

import httpx
import pytest
import uvicorn
from uvicorn.server import ServerState

from patience import LONG, bounded
from studio.conftest import TOKEN
from tmodes.errors import InputError
from tmodes.studio import connection
from tmodes.studio.folders import WorkingFolder
from tmodes.studio.guard import MOST_BODY
from tmodes.studio.page import LONGEST_WORD, document


def asked(studio, method="GET", address="/api/robots", **headers):
    """A request with headers of its own and without the cookie."""
    return httpx.request(method, f"http://{studio.host}{address}", headers=headers, trust_env=False)


@pytest.mark.parametrize(
    "address", ["/", "/?token=", "/?token=wrong", "/api/robots", "/studio.js", "/api/robots?token=" + TOKEN]
)
def test_nothing_without_the_token(studio, address):
    answer = asked(studio, address=address)
    assert answer.status_code == 401
    assert "open the address" in answer.json()["errors"][0]["hint"]
    assert "set-cookie" not in answer.headers


def test_the_token_in_a_header_or_a_cookie(studio):
    assert asked(studio, **{"X-Tmodes-Token": TOKEN}).status_code == 200
    assert asked(studio, **{"X-Tmodes-Token": TOKEN + "x"}).status_code == 401
    assert asked(studio, Cookie=f"{studio.cookie}={TOKEN}").status_code == 200
    assert asked(studio, Cookie=f"{studio.cookie}=x;=; junk").status_code == 401
    others = f'prefs={{"x":1}}; a=b c; bare; {studio.cookie}={TOKEN}; late=,"'  # of other programs on this machine
    assert asked(studio, Cookie=others).status_code == 200
    cookie = studio.client.get(f"/?token={TOKEN}").headers["set-cookie"]
    assert "HttpOnly" in cookie
    assert "SameSite=Strict" in cookie


@pytest.mark.parametrize("host", ["evil.example", "127.0.0.1", "127.0.0.1:1", "localhost.evil.example:4242"])
def test_another_name_for_this_machine_is_refused(studio, host):
    """DNS rebinding: the browser believes that the name is its own."""
    assert asked(studio, Host=host, **{"X-Tmodes-Token": TOKEN}).status_code == 421


def test_other_pages_are_refused(studio):
    """Whatever a browser sends along for a page of another origin, or of another port of this machine."""
    for origin in ("http://evil.example", "null", "http://127.0.0.1:9999", f"https://{studio.host}"):
        answer = studio.client.post("/api/check", headers={"Origin": origin}, json={"sheet": {}})
        assert answer.status_code == 403, origin
        assert "access-control-allow-origin" not in answer.headers
    assert studio.client.post("/api/check", headers={"Sec-Fetch-Site": "cross-site"}, json={}).status_code == 403
    form = {"Content-Type": "application/x-www-form-urlencoded"}
    assert studio.client.post("/api/check", headers=form, content="sheet=1").status_code == 422


def test_headers_of_every_answer(studio):
    for answer in (studio.client.get("/"), studio.client.get("/none"), asked(studio)):
        policy = answer.headers["content-security-policy"]
        assert "default-src 'none'" in policy
        assert "unsafe-eval" not in policy.replace("'wasm-unsafe-eval'", "")
        assert "unsafe-inline" not in policy.partition("script-src")[2].partition(";")[0]
        assert answer.headers["x-content-type-options"] == "nosniff"


def names(folder):
    return sorted(path.name for path in folder.iterdir())


ELSEWHERE = ("..%2Fsecret.yaml", "%2Fetc%2Fpasswd.yaml", "..%5Csecret.yaml", ".hidden.yaml", "a%00.yaml", "C:x.yaml",
             "sub%2Fx.yaml", "con.yaml", "x.yaml%20", "x.py", "x" * 300 + ".yaml", "%2e%2e%2fsecret.yaml")  # fmt: skip


@pytest.mark.parametrize("name", ELSEWHERE)
def test_no_path_out_of_the_folder(studio, sheet, name):
    (studio.folder.parent / "secret.yaml").write_text("secret: 1", encoding="utf-8")
    before = names(studio.folder.parent), names(studio.folder)
    for answer in (studio.client.get(f"/api/studies/{name}"),
                   studio.client.put(f"/api/studies/{name}", json={"sheet": sheet, "overwrite": True})):  # fmt: skip
        assert answer.status_code in (404, 422), answer.text
        assert "secret: 1" not in answer.text
    assert before == (names(studio.folder.parent), names(studio.folder))


def test_links_are_not_followed(studio, sheet):
    outside = studio.folder.parent / "outside.yaml"
    outside.write_text("secret: 1", encoding="utf-8")
    (studio.folder / "link.yaml").symlink_to(outside)
    (studio.folder / "folder.yaml").mkdir()
    for name in ("link.yaml", "folder.yaml"):
        assert name not in studio.get("/api/studies")["studies"]
        assert "secret" not in json.dumps(studio.get(f"/api/studies/{name}", code=422))
        studio.put(f"/api/studies/{name}", json={"sheet": sheet, "overwrite": True}, code=422)
    assert outside.read_text(encoding="utf-8") == "secret: 1"
    assert (studio.folder / "link.yaml").is_symlink()


def test_a_study_names_no_file_outside(studio):
    """An elasticity file whose URDF lies elsewhere."""
    (studio.folder.parent / "far.urdf").write_text("<robot name='x'/>", encoding="utf-8")
    for urdf in ("../far.urdf", str(studio.folder.parent / "far.urdf"), "http://127.0.0.1/far.urdf"):
        (studio.folder / "far.yaml").write_text(f"urdf: {urdf}\n", encoding="utf-8")
        error = studio.get("/api/studies/far.yaml", code=422)["errors"][0]
        assert error["path"] == "urdf", error
        assert error["hint"]


@pytest.mark.parametrize(
    "content",
    [b"", b"\xff\xfe\x00junk", b"\x00" * 1000, b"a: &x 1\nb: *x", b"[" * 5000, b"a: !!python/object:os.system 1"],
)
def test_files_that_are_no_sheets(studio, content):
    (studio.folder / "junk.yaml").write_bytes(content)
    assert studio.get("/api/studies/junk.yaml", code=422)["errors"][0]["hint"]


def test_what_would_never_be_read_is_refused_at_once(studio, sheet):
    """A file of a gigabyte, and a pipe that nobody writes to."""
    with (studio.folder / "huge.yaml").open("wb") as file:
        file.truncate(2**30)
    with bounded(5.0):
        assert "at most" in studio.get("/api/studies/huge.yaml", code=422)["errors"][0]["expected"]
        (studio.folder / "huge.yaml").unlink()
        if hasattr(os, "mkfifo"):
            os.mkfifo(studio.folder / "pipe.yaml")
            assert "pipe.yaml" not in studio.get("/api/studies")["studies"]
            studio.get("/api/studies/pipe.yaml", code=422)
            studio.put("/api/studies/pipe.yaml", json={"sheet": sheet, "overwrite": True}, code=422)


def test_two_that_save_under_one_name(studio, sheet):
    """One of them is the first, the others are reported; what is there is whole."""
    with ThreadPoolExecutor(8) as several:
        body = {"sheet": sheet}
        answers = [*several.map(lambda _: studio.client.put("/api/studies/race.yaml", json=body).status_code, range(8))]
    assert sorted(answers) == [200] + [409] * 7
    assert studio.get("/api/studies/race.yaml")["sheet"] == sheet


def test_a_full_disk_leaves_the_old_study(studio, sheet, monkeypatch):
    studio.put("/api/studies/full.yaml", json={"sheet": sheet})

    def full(*given: object) -> None:
        raise OSError(28, "No space left on device")

    monkeypatch.setattr("tmodes.io.atomic._flush", full)
    changed = sheet | {"gravity": 1.62}
    refused = studio.put("/api/studies/full.yaml", json={"sheet": changed, "overwrite": True}, code=409)["errors"][0]
    assert "free some space" in refused["message"]
    assert studio.get("/api/studies/full.yaml")["sheet"] == sheet
    assert not [name for name in names(studio.folder) if name.endswith(".tmp")]


def test_too_much_is_refused(studio):
    with socket.create_connection(studio.host.split(":")) as line:
        head = f"POST /api/check HTTP/1.1\r\nHost: {studio.host}\r\nX-Tmodes-Token: {TOKEN}\r\n"
        line.sendall(f"{head}Content-Length: {MOST_BODY + 1}\r\n\r\n".encode())
        assert line.recv(100).startswith(b"HTTP/1.1 413")

    def parts():
        yield b'{"sheet": "'
        for _ in range(MOST_BODY // 2**20 + 1):
            yield b"x" * 2**20

    answer = studio.client.post("/api/check", content=parts(), headers={"Content-Type": "application/json"})
    assert answer.status_code == 413
    assert "at most" in answer.json()["errors"][0]["expected"]


DEEP = b'{"sheet": ' + b"[" * 100_000 + b"]" * 100_000 + b"}"
DEEP_SHEET = b'{"sheet": {"kind": "arm", "x": ' + b'{"a":' * 500 + b"1" + b"}" * 500 + b"}}"
WRONG = (
    DEEP,
    DEEP_SHEET,
    b"{",
    b"[]",
    b"null",
    b'{"sheet": NaN}',
    b'{"sheet": 1e999}',
    b"\xff",
    b'{"sheet": "\\ud800"}',
)


@pytest.mark.parametrize("body", WRONG, ids=range(len(WRONG)))
@pytest.mark.parametrize("address", ["/api/check", "/api/yaml", "/api/upload"])
def test_bodies_that_are_no_requests(studio, body, address):
    answer = studio.client.post(address, content=body, headers={"Content-Type": "application/json"})
    assert answer.status_code == 422, answer.text
    assert answer.json()["errors"]


def test_orders_that_are_none(studio, sheet):
    for order in ({}, {"product": "page"}, {"product": "rm -rf", "client": "x"}, {"product": 3, "client": "x"},
                  {"product": "data", "client": "x" * (LONGEST_WORD + 1)}):  # fmt: skip
        assert studio.post("/api/jobs", json={"sheet": sheet} | order, code=422)["errors"][0]["path"]
    assert studio.get("/api/jobs/guessed", code=422)["errors"]
    for odd in ({"kind": "arm"}, {"kind": {}}):
        assert studio.ended(studio.begin(odd))["state"] == "error"


@pytest.mark.parametrize("wait", ["abc", "nan", "inf", "", "<b>" * 999])
def test_seconds_that_are_none(studio, wait):
    [error] = studio.get("/api/jobs/guessed", code=422, params={"wait": wait})["errors"]
    assert error["path"] == "wait"
    assert error["message"]
    assert len(error["got"]) < 200


def test_huge_runs_are_refused_before_they_begin(studio, sheet):
    sheet["integration"] |= {"duration": 1e3, "output_step": 1e-12}
    assert "samples" in json.dumps(studio.ended(studio.begin(sheet))["errors"])
    sheet["integration"] |= {"duration": 300.0, "output_step": 1e-3}
    assert "MB in the studio" in json.dumps(studio.ended(studio.begin(sheet))["errors"])


def test_a_robot_called_script_stays_text(studio, sheet):
    name = '<script>alert(1)</script>"&'
    sheet["name"] = name
    info = studio.client.post("/api/check", json={"sheet": sheet})
    assert info.headers["content-type"] == "application/json"
    assert info.json()["name"] == name
    studio.put("/api/studies/script.yaml", json={"sheet": sheet})
    assert studio.get("/api/studies/script.yaml")["sheet"]["name"] == name


def test_what_is_shown_first_is_text():
    assert '"><script>' not in document('./"><script>.yaml')


def test_a_folder_that_cannot_be_written(studio, sheet):
    if os.geteuid() == 0:
        pytest.skip("root may write everywhere")
    studio.folder.chmod(0o500)
    try:
        assert "expected" in studio.put("/api/studies/x.yaml", json={"sheet": sheet}, code=409)["errors"][0]["message"]
    finally:
        studio.folder.chmod(0o700)


def test_a_folder_that_is_none(tmp_path):
    with pytest.raises(InputError, match="a folder that exists"):
        WorkingFolder(tmp_path / "none")


def encoded(**files):
    return {
        "files": [{"name": name, "content": base64.b64encode(text.encode()).decode()} for name, text in files.items()]
    }


@pytest.mark.parametrize(
    "name", ["../x.urdf", "/x.urdf", "a/../../x.urdf", "", ".x.urdf", "a/b/c/d/e/f/g.urdf", "x\0.urdf", 3]
)
def test_names_of_uploads(studio, name):
    files = [{"name": name, "content": ""}]
    assert studio.post("/api/upload", json={"files": files}, code=422)["errors"][0]["path"] == "files"


@pytest.mark.parametrize(("name", "info"), [("a [1].urdf", "sign '['"), ("a/b/c/d/e/f/g.urdf", "6 folders deep"),
                                            ("/x.urdf", "sign '/'"), (".x.urdf", "'.' at the start"),
                                            ("x" * 120 + ".urdf", "125 characters")])  # fmt: skip
def test_what_is_wrong_with_a_name_is_reported(studio, name, info):
    files = [{"name": name, "content": ""}]
    assert info in studio.post("/api/upload", json={"files": files}, code=422)["errors"][0]["got"]


def test_uploads_that_are_none(studio):
    for files in (None, [], [1], [{}], [{"name": "x.urdf", "content": "§"}], [{"name": "x.exe", "content": ""}],
                  [{"name": f"{k}.urdf", "content": ""} for k in range(200)]):  # fmt: skip
        assert studio.post("/api/upload", json={"files": files}, code=422)["errors"][0]["hint"]


BOMB = '<?xml version="1.0"?><!DOCTYPE r [<!ENTITY a "aaaa"><!ENTITY b "&a;&a;">]><robot name="&b;"/>'


@pytest.mark.parametrize("text", [BOMB, "", "<robot", "<robot>" * 5000, "junk"])
def test_hostile_robots_are_refused(studio, text):
    error = studio.post("/api/upload", json=encoded(**{"x.urdf": text}), code=422)["errors"][0]
    assert error["hint"]
    assert error["where"].startswith("x.urdf")


BEGUN = {
    "nothing": (b"",),
    "half a head": (b"GET /api/alive HTTP/1.1\r\nHo",),
    "half a body": (b"POST /api/check HTTP/1.1\r\n%s\r\nContent-Length: 100\r\n\r\n{",),
    "half of a second request": (b"GET /api/alive HTTP/1.1\r\n%s\r\n\r\n", b"GET /api/al"),
    "a body in parts": (b"POST /api/check HTTP/1.1\r\n%s\r\nContent-Length: 100\r\n\r\n{", b'"'),
}


@pytest.mark.parametrize("parts", BEGUN.values(), ids=BEGUN)
def test_a_request_that_does_not_end_is_given_up(studio, monkeypatch, parts):
    """Its connection is closed; the studio answers others as before."""
    monkeypatch.setattr(connection, "PATIENCE", 0.2)
    host, _, port = studio.host.rpartition(":")
    head = f"Host: {studio.host}\r\nX-Tmodes-Token: {TOKEN}".encode()
    said = b""
    with socket.create_connection((host, int(port)), timeout=LONG) as line:
        for part in parts:
            line.sendall(part % head if b"%" in part else part)
            if part.startswith(b"GET") and b"%" in part:
                said += line.recv(10_000)
        while more := line.recv(10_000):
            said += more
    assert (b" 408 " in said) == any(part.startswith(b"POST") for part in parts)
    assert studio.get("/api/alive") == {}


@pytest.mark.parametrize("reads", [False, True])
def test_an_answer_that_is_not_read_is_given_up(monkeypatch, reads):
    """A client that reads gets all of it, however long it is."""
    monkeypatch.setattr(connection, "PATIENCE", 0.1)
    body = bytes(20_000_000)

    async def app(scope, receive, send):
        await send({"type": "http.response.start", "status": 200, "headers": []})
        await send({"type": "http.response.body", "body": body})

    async def got() -> int:
        loop, lost = asyncio.get_running_loop(), asyncio.Event()
        config = uvicorn.Config(app, lifespan="off", log_config=None)
        config.load()

        class Watched(connection.Connection):
            def connection_lost(self, exc):
                super().connection_lost(exc)
                lost.set()

        server = await loop.create_server(lambda: Watched(config, ServerState(), {}, loop), "127.0.0.1", 0)
        count = 0
        with socket.create_connection(server.sockets[0].getsockname(), timeout=LONG) as line:
            line.sendall(b"GET / HTTP/1.1\r\nHost: x\r\nConnection: close\r\n\r\n")
            line.setblocking(False)
            while reads and (more := await loop.sock_recv(line, 1_000_000)):
                count += len(more)
            await asyncio.wait_for(lost.wait(), LONG)
        server.close()
        return count

    assert (asyncio.run(got()) > len(body)) == reads


@pytest.mark.parametrize(
    "sheet", [None, [], "spong1987", 1.0, True, {}, DEEP_SHEET.decode()], ids=lambda one: type(one).__name__
)
def test_a_job_without_a_sheet_is_refused(studio, sheet):
    for given in [{}] * (sheet is None) + [{"sheet": sheet}]:
        body = given | {"product": "data", "client": "tab"}
        error = studio.post("/api/jobs", json=body, code=422)["errors"][0]
        assert error["path"] == "sheet"
        assert error["got"] != ""
        assert "JSON object" in error["expected"]


@pytest.mark.parametrize("depth", [100, 900])
def test_a_job_with_a_sheet_of_many_levels_ends_with_an_error(studio, depth):
    sheet = {"joints": json.loads("[" * depth + "]" * depth)}
    body = json.dumps({"product": "data", "client": "tab", "sheet": sheet})
    answer = studio.client.post("/api/jobs", content=body, headers={"content-type": "application/json"})
    if answer.status_code == 200:
        assert studio.ended(answer.json()["job"])["errors"]
    else:
        assert answer.status_code == 422
        assert answer.json()["errors"]
