"""The studio's application: robots, checks, simulations, studies and uploads, for its own page alone."""

from __future__ import annotations

import asyncio
import json
import os
from collections.abc import AsyncIterator, Callable
from contextlib import asynccontextmanager, suppress
from pathlib import Path
from typing import Annotated, Any

from fastapi import FastAPI, Query, Request, Response
from fastapi.exceptions import RequestValidationError
from starlette.concurrency import run_in_threadpool

from tmodes.errors import InputError, ResultFileError, TmodesError
from tmodes.io.sheet_check import sheet_from_data
from tmodes.io.sheet_write import robot_to_yaml
from tmodes.io.words import shown
from tmodes.robots.load import load
from tmodes.sheet import Robot
from tmodes.studio import sheets
from tmodes.studio.folder import WorkingFolder
from tmodes.studio.guard import Guard
from tmodes.studio.jobs import JobBook
from tmodes.studio.looks import Shelf, source_of
from tmodes.studio.messages import info_error, info_errors
from tmodes.studio.page import add_page
from tmodes.studio.pool import Pool
from tmodes.studio.requests import body_of, word_of
from tmodes.studio.upload import uploaded
from tmodes.studio.work import PRODUCTS

__all__ = ["application"]

LONGEST_WAIT = 5.0
Wait = Annotated[float, Query(allow_inf_nan=False)]
FILES = {"report": ("report.html", "text/html; charset=utf-8"), "data": ("result.nc", "application/x-netcdf")}


def application(
    folder: WorkingFolder, token: str, hosts: frozenset[str], place: Path, first: str = "", workers: int = 0
) -> Guard:
    """The application (ASGI) that serves the page to those who know ``token``.

    ``hosts``: what the header Host may say; ``place``: a private folder for uploads and for what workers write, which
    its owner removes at the end; ``first``: the robot or file that is shown first; ``workers``: how many processes
    simulate, 0: two to four by the machine.
    """
    pool = Pool(workers or max(2, min(4, (os.cpu_count() or 2) - 1)), place)
    book, shelf = JobBook(pool), Shelf(place)
    app = FastAPI(docs_url=None, redoc_url=None, openapi_url=None, lifespan=_lifespan(pool, book))
    app.add_exception_handler(TmodesError, _explained)
    app.add_exception_handler(404, _not_found)
    app.add_exception_handler(405, _not_found)
    app.add_exception_handler(RecursionError, _too_deep)
    app.add_exception_handler(RequestValidationError, _no_value)
    add_page(app, first)
    _add_sheets(app, shelf)
    _add_studies(app, folder, shelf)
    _add_jobs(app, book, folder, shelf)
    return Guard(app, token, hosts, f"tmodes-studio-{min(hosts, default='').rpartition(':')[2] or 'test'}")


def _lifespan(pool: Pool, book: JobBook) -> Any:
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
            await pool.stop()

    return lifespan


async def _watch(book: JobBook) -> None:
    while True:
        await asyncio.sleep(1.0)
        book.end_abandoned()


async def _explained(request: Request, error: Exception) -> Response:
    """Errors of ours as JSON: 422 for wrong input, 409 for a file that cannot be written."""
    assert isinstance(error, TmodesError)  # noqa: S101
    status = 409 if isinstance(error, ResultFileError) else 422
    return _json({"errors": info_errors(error, getattr(request.state, "sheet", None))}, status)


async def _not_found(request: Request, error: Exception) -> Response:
    del error
    return _json({"errors": [info_error("address", f"there is nothing at {request.url.path[:80]}")]}, 404)


async def _too_deep(request: Request, error: Exception) -> Response:
    del request, error
    return _json({"errors": [info_error("body", "too many levels", expected="a data sheet")]}, 422)


async def _no_value(request: Request, error: Exception) -> Response:
    """A value of the address that is none, as FastAPI finds it."""
    del request
    assert isinstance(error, RequestValidationError)  # noqa: S101
    info = [(str(one["loc"][-1]), shown(one["input"]), one["msg"]) for one in error.errors()]
    return _json({"errors": [info_error(path, why, got) for path, got, why in info]}, 422)


def _json(value: Any, status: int = 200) -> Response:
    return Response(json.dumps(value, allow_nan=False), status, media_type="application/json")


async def _checked(request: Request, data: dict[str, Any]) -> Any:
    """The checked sheet of a request; its errors lead to the places in it."""
    request.state.sheet = data.get("sheet")
    return await run_in_threadpool(sheet_from_data, data.get("sheet"))


async def _info(read: Callable[[], tuple[Robot, str]]) -> Response:
    """What the page gets of a sheet that is read, and where its looks come from."""

    def info() -> dict[str, Any]:
        sheet, looks = read()
        return sheets.info_sheet(sheet) | {"looks": looks}

    return _json(await run_in_threadpool(info))


def _add_sheets(app: FastAPI, shelf: Shelf) -> None:
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
        return await _info(lambda: (load(name), f"robot:{name}"))

    @app.get("/api/schema")
    async def schema() -> Response:
        return _json(await run_in_threadpool(sheets.schema))

    @app.post("/api/check")
    async def check(request: Request) -> Response:
        sheet = await _checked(request, await body_of(request))
        return _json(await run_in_threadpool(sheets.info_sheet, sheet))

    @app.post("/api/yaml")
    async def yaml(request: Request) -> Response:
        sheet = await _checked(request, await body_of(request))
        return _json({"yaml": await run_in_threadpool(robot_to_yaml, sheet)})

    @app.post("/api/upload")
    async def upload(request: Request) -> Response:
        data = await body_of(request)
        return await _info(lambda: uploaded(data.get("files"), shelf))


def _add_studies(app: FastAPI, folder: WorkingFolder, shelf: Shelf) -> None:
    @app.get("/api/studies")
    async def studies() -> Response:
        return _json({"folder": folder.path.name, "studies": await run_in_threadpool(folder.names)})

    @app.get("/api/studies/{name:path}")
    async def study(name: str) -> Response:
        path = folder.existing(name)
        return await _info(lambda: (load(path, roots=(folder.path,)), shelf.looks_of(name)))

    @app.put("/api/studies/{name:path}")
    async def save(name: str, request: Request) -> Response:
        data = await body_of(request)
        sheet = await _checked(request, data)
        text = await run_in_threadpool(robot_to_yaml, sheet)
        request.state.sheet = None  # what may be wrong from here on is no field of it
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
        order = {"product": product, "sheet": data.get("sheet"), "looks": source and source._asdict()}
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
