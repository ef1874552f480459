"""The studio's application: robots, checks, simulations, studies and uploads, for its own page alone."""

from __future__ import annotations

import asyncio
import json
import os
import secrets
from collections.abc import AsyncIterator, Callable
from contextlib import asynccontextmanager, suppress
from pathlib import Path
from typing import Annotated, Any

from fastapi import FastAPI, Query, Request, Response
from fastapi.exceptions import RequestValidationError
from starlette.concurrency import run_in_threadpool

from tmodes.errors import InputError, ResultFileError, TmodesError
from tmodes.io.words import shown
from tmodes.robots.load import load
from tmodes.sheet import Robot
from tmodes.studio import sheets
from tmodes.studio.folders import WorkingFolder
from tmodes.studio.guard import Guard
from tmodes.studio.jobs import JobBook
from tmodes.studio.looks import Shelf, source_of
from tmodes.studio.messages import error_record, error_records
from tmodes.studio.page import add_page, body_of, sheet_of, word_of, words_of
from tmodes.studio.pool import Pool
from tmodes.studio.upload import uploaded
from tmodes.studio.work import PRODUCTS

__all__ = ["application"]

LONGEST_WAIT = 5.0
LONGEST_CHECK = 60.0
"""Seconds after which a check is ended."""

Wait = Annotated[float, Query(allow_inf_nan=False)]
FILES = {"report": ("report.html", "text/html; charset=utf-8"), "data": ("result.nc", "application/x-netcdf")}


def application(
    folder: WorkingFolder, token: str, hosts: frozenset[str], place: Path, first: str = "", workers: int = 0
) -> Guard:
    """The application (ASGI) that serves the page to those who know ``token``.

    ``hosts``: what the header Host may say; ``place``: a private folder for uploads and for what workers write, which
    its owner removes at the end; ``first``: the robot or file that is shown first; ``workers``: how many processes
    simulate, 0: two to four by the machine; two more check sheets.
    """
    pool = Pool(workers or max(2, min(4, (os.cpu_count() or 2) - 1)), place)
    aside = Pool(2, place)  # checks wait for no simulation
    book, checks, shelf = JobBook(pool), JobBook(aside), Shelf(place)
    app = FastAPI(docs_url=None, redoc_url=None, openapi_url=None, lifespan=_lifespan(pool, aside, book))
    for kind in (TmodesError, _Refused, 404, 405, RecursionError, RequestValidationError):
        app.add_exception_handler(kind, _explained)
    add_page(app, first)
    _add_sheets(app, checks, shelf)
    _add_studies(app, checks, folder, shelf)
    _add_jobs(app, book, folder, shelf)
    return Guard(app, token, hosts, f"tmodes-studio-{min(hosts, default='').rpartition(':')[2] or 'test'}")


def _lifespan(pool: Pool, aside: Pool, book: JobBook) -> Any:
    @asynccontextmanager
    async def lifespan(app: FastAPI) -> AsyncIterator[None]:
        del app
        await pool.start()
        watch = asyncio.create_task(_watch(book))
        try:
            yield
        finally:
            watch.cancel()
            with suppress(asyncio.CancelledError):
                await watch
            await asyncio.gather(pool.stop(), aside.stop())

    return lifespan


async def _watch(book: JobBook) -> None:
    while True:
        await asyncio.sleep(1.0)
        book.end_abandoned()


async def _explained(request: Request, error: Exception) -> Response:
    """Errors as JSON: 422 for wrong input, 409 for a file that cannot be written, 404 for an unknown address."""
    status = 422
    match error:
        case TmodesError():
            status = 409 if isinstance(error, ResultFileError) else 422
            errors = error_records(error)
        case _Refused():
            errors = error.args[0]
        case RecursionError():
            errors = [error_record("body", "too many levels", expected="a data sheet")]
        case RequestValidationError():  # a value of the address that is none, as FastAPI finds it
            errors = [error_record(str(one["loc"][-1]), one["msg"], shown(one["input"])) for one in error.errors()]
        case _:
            status, errors = 404, [error_record("address", f"there is nothing at {request.url.path[:80]}")]
    return _json({"errors": errors}, status)


def _json(value: Any, status: int = 200) -> Response:
    return Response(json.dumps(value, allow_nan=False), status, media_type="application/json")


class _Refused(Exception):
    """The records of errors that a worker has found."""


async def _checked(checks: JobBook, data: dict[str, Any], product: str, client: str) -> bytes:
    """What a worker makes of the sheet of a request; a newer request of the same client and product ends it.

    Raises :class:`_Refused` with errors that lead to the places in the sheet, or say why there is no answer.
    """
    order = {"product": product, "sheet": data.get("sheet"), "looks": None, "series": []}
    job = checks.begin(order, client)
    await checks.wait(job, LONGEST_CHECK)
    if job.state == "done":
        return job.content
    hint = "simplify the sheet, or check it with `tmodes check`"
    late = error_record("", f"the check was ended after {LONGEST_CHECK:.0f} s; {hint}", hint=hint)
    why = error_record("", "a newer check has taken its place") if job.over else late
    checks.cancel(job)
    raise _Refused(job.errors or [why])


async def _sheet_answer(read: Callable[[], tuple[Robot, str]]) -> Response:
    """What the page gets of a sheet that is read, and where its looks come from."""

    def record() -> dict[str, Any]:
        sheet, looks = read()
        return sheets.sheet_record(sheet) | {"looks": looks}

    return _json(await run_in_threadpool(record))


def _add_sheets(app: FastAPI, checks: JobBook, shelf: Shelf) -> None:
    @app.get("/api/alive")
    async def alive() -> Response:
        return _json({})

    @app.get("/api/robots")
    async def robots() -> Response:
        return _json({"robots": await run_in_threadpool(sheets.catalogue)})

    @app.get("/api/robots/{name}")
    async def robot(name: str) -> Response:
        if name not in {one["name"] for one in await run_in_threadpool(sheets.catalogue)}:
            raise InputError("robot", repr(name[:60]), "a published robot", "choose one of the list")
        return await _sheet_answer(lambda: (load(name), f"robot:{name}"))

    @app.get("/api/schema")
    async def schema() -> Response:
        return _json(await run_in_threadpool(sheets.schema))

    @app.post("/api/check")
    async def check(request: Request) -> Response:
        data = await body_of(request)
        client = word_of(data, "client") if "client" in data else secrets.token_urlsafe()
        return Response(await _checked(checks, data, "check", client), media_type="application/json")

    @app.post("/api/yaml")
    async def yaml(request: Request) -> Response:
        text = await _checked(checks, await body_of(request), "yaml", secrets.token_urlsafe())
        return _json({"yaml": text.decode()})

    @app.post("/api/upload")
    async def upload(request: Request) -> Response:
        data = await body_of(request)
        return await _sheet_answer(lambda: uploaded(data.get("files"), shelf))


def _add_studies(app: FastAPI, checks: JobBook, folder: WorkingFolder, shelf: Shelf) -> None:
    @app.get("/api/studies")
    async def studies() -> Response:
        return _json({"folder": folder.path.name, "studies": await run_in_threadpool(folder.names)})

    @app.get("/api/studies/{name:path}")
    async def study(name: str) -> Response:
        path = folder.existing(name)
        return await _sheet_answer(lambda: (load(path, roots=(folder.path,)), shelf.looks_of(name)))

    @app.put("/api/studies/{name:path}")
    async def save(name: str, request: Request) -> Response:
        data = await body_of(request)
        text = (await _checked(checks, data, "yaml", secrets.token_urlsafe())).decode()
        overwrite = data.get("overwrite") is True
        saved = await run_in_threadpool(lambda: folder.save(name, text, overwrite=overwrite))
        shelf.note(saved.name, str(data.get("looks") or ""))
        return _json({"saved": saved.name})


def _add_jobs(app: FastAPI, book: JobBook, folder: WorkingFolder, shelf: Shelf) -> None:
    @app.post("/api/jobs")
    async def begin(request: Request) -> Response:
        data = await body_of(request)
        product = word_of(data, "product")
        if product not in PRODUCTS:
            raise InputError("product", repr(product), f"one of {', '.join(PRODUCTS)}", "ask for one of them")
        source = source_of(data.get("looks"), folder, shelf)
        order = {"product": product, "sheet": sheet_of(data), "looks": source and source._asdict()}
        order["series"] = words_of(data, "series") if product == "change" else []
        return _json(book.begin(order, word_of(data, "client")).as_info())

    @app.get("/api/jobs/{name}")
    async def look(name: str, wait: Wait = 0.0) -> Response:
        job = book.find(name)
        await book.wait(job, min(max(wait, 0.0), LONGEST_WAIT))
        return _json(job.as_info())

    @app.delete("/api/jobs/{name}")
    async def cancel(name: str) -> Response:
        job = book.find(name)
        book.cancel(job)
        await book.wait(job, LONGEST_WAIT)
        return _json(job.as_info())

    @app.get("/api/jobs/{name}/content")
    async def content(name: str) -> Response:
        job = book.find(name)
        if job.state != "done":
            raise InputError("job", job.state, "one that is done", "wait for it")
        if job.product not in FILES:
            return Response(job.content, media_type="application/octet-stream")
        file, kind = FILES[job.product]
        return Response(job.content, media_type=kind, headers={"content-disposition": f'attachment; filename="{file}"'})
