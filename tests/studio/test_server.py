"""The studio's server: robots, checks, runs, studies, as the page asks for them."""

from __future__ import annotations

import errno

import numpy as np
import pytest

import tmodes
from patience import until
from studio.conftest import payload
from tmodes.robots.load import sheet_names


def test_robots_and_their_sheets(studio):
    listed = studio.get("/api/robots")["robots"]
    assert [one["name"] for one in listed] == sheet_names()
    assert all(one["title"] for one in listed)
    assert studio.get("/api/robots/spong1987")["name"] == "spong1987"
    assert "got" in studio.get("/api/robots/no_such_robot", code=422)["errors"][0]


@pytest.mark.parametrize("name", ["spong1987", "filipovic2010"])
def test_units_are_those_of_the_joints(studio, name):
    assert studio.get(f"/api/robots/{name}")["units"]["joints.0.gear.stiffness.0"] == "N*m/rad"


def test_schema_of_the_forms(studio):
    assert studio.get("/api/schema")["properties"]["integration"]


def test_sliders_stand_where_their_numbers_are(studio):
    """Also the factor of the actual robot, which an imported sheet has under the word of its own format."""
    info = studio.get("/api/robots/filipovic2010")
    steps = {one["label"]: one["targets"][0]["steps"] for one in info["sliders"]}
    assert steps["mass, payload on link"] == ["links", 0, "bodies", 0, "mass"]
    assert steps["stiffness of the gear, joint: actual / nominal"] == ["real", "gear.stiffness"]
    assert info["sheet"]["real"]["gear.stiffness"] == 0.2


def test_a_right_sheet_is_reported_with_its_notices(studio, sheet):
    assert studio.post("/api/check", json={"sheet": sheet})["warnings"] == []
    payload(sheet)["mass"] = 500.0
    assert "500 kg" in studio.post("/api/check", json={"sheet": sheet})["warnings"][0]


def test_every_wrong_value_is_reported_at_its_place(studio, sheet):
    payload(sheet)["mass"] = -1.0
    sheet["joints"][0]["gear"]["stifness"] = 3.0
    found = studio.post("/api/check", json={"sheet": sheet}, code=422)["errors"]
    by_path = {one["path"]: one for one in found}
    mass = by_path["payload.mass"]
    assert mass["steps"] == ["links", 0, "bodies", 0, "mass"]
    assert "kg" in mass["expected"]
    assert "stiffness" in by_path["gear.stifness"]["hint"]


def test_errors_of_an_arm_lead_to_steps(studio):
    sheet = studio.get("/api/robots/spong1987")["sheet"]
    sheet["joints"][0]["gear"]["stiffness"] = [-5.0]
    error = studio.post("/api/check", json={"sheet": sheet}, code=422)["errors"][0]
    assert error["path"] == "joints.joint.gear.stiffness.0"
    assert error["steps"] == ["joints", 0, "gear", "stiffness", 0]


def test_a_run_is_the_run_of_the_command_line(studio, sheet, tmp_path):
    """The bytes of the result are those that `tmodes run` writes for the same sheet."""
    payload(sheet)["mass"] = 0.7
    info = studio.ended(job := studio.begin(sheet))
    assert info["state"] == "done", info["errors"]
    assert info["info"]["success"] is True
    assert set(info["info"]["seconds"]) == {"check", "simulate", "shapes", "data", "loops"}
    content = studio.client.get(f"/api/jobs/{job}/content").content
    (tmp_path / "other.nc").write_bytes(content)
    here = tmodes.run(tmodes.load("filipovic2010").with_({"payload.mass": 0.7}))
    assert content == here.save(tmp_path / "here.nc").read_bytes()
    assert np.array_equal(tmodes.Result.load(tmp_path / "other.nc").data["tip"], here.data["tip"])


def test_a_run_that_cannot_start_says_why(studio, sheet):
    payload(sheet)["mass"] = "much"
    info = studio.ended(studio.begin(sheet))
    assert info["state"] == "error"
    assert info["errors"][0]["steps"] == ["links", 0, "bodies", 0, "mass"]
    payload(sheet)["mass"] = 0.5
    sheet["integration"] |= {"stop": ["tip.z < 5 m"]}
    info = studio.ended(studio.begin(sheet))
    assert info["state"] == "error"
    assert "holds" in info["errors"][0]["message"]


def test_cancel_works_within_a_second(studio, long_sheet, sheet):
    job = studio.begin(long_sheet)
    until(lambda: studio.get(f"/api/jobs/{job}")["share"])
    answer = studio.client.delete(f"/api/jobs/{job}").json()
    assert answer["state"] == "cancelled"
    assert studio.ended(studio.begin(sheet))["state"] == "done"


def test_two_tabs_do_not_know_each_other(studio, long_sheet, sheet):
    """A long run in one tab; the other simulates meanwhile; a new run ends only the older one of its own tab."""
    long = studio.begin(long_sheet, client="one")
    sheet = sheet | {"integration": {"duration": 0.2}}
    assert studio.ended(studio.begin(sheet, client="two"))["state"] == "done"
    assert studio.get(f"/api/jobs/{long}")["state"] == "running"
    newer = studio.begin(sheet, client="one")
    assert studio.ended(long)["state"] == "cancelled"
    assert studio.ended(newer)["state"] == "done"


def test_a_worker_that_does_not_hear_is_replaced(studio, long_sheet, sheet, monkeypatch):
    """An order that is cancelled before it is begun, and a process that ends in between, leave a pool that works."""
    monkeypatch.setattr("tmodes.studio.pool.PATIENCE", 0.0)
    for _ in range(2):
        job = studio.begin(long_sheet)
        studio.client.delete(f"/api/jobs/{job}")
        assert studio.ended(job)["state"] == "cancelled"
    assert studio.ended(studio.begin(sheet | {"integration": {"duration": 0.2}}))["state"] == "done"


def test_report_and_data_are_files(studio, sheet):
    sheet = sheet | {"integration": {"duration": 0.2}, "name": "<script>alert(1)</script>"}
    job = studio.begin(sheet, product="report")
    assert studio.ended(job)["state"] == "done"
    answer = studio.client.get(f"/api/jobs/{job}/content")
    assert answer.headers["content-disposition"] == 'attachment; filename="report.html"'
    assert "<script>alert(1)" not in answer.text
    assert "&lt;script&gt;alert(1)" in answer.text


def test_a_study_is_saved_and_loaded_as_it_was(studio, sheet):
    payload(sheet)["mass"] = 0.1 + 0.2
    assert studio.put("/api/studies/my study.yaml", json={"sheet": sheet}) == {"saved": "my study.yaml"}
    assert "my study.yaml" in studio.get("/api/studies")["studies"]
    assert studio.get("/api/studies/my study.yaml")["sheet"] == sheet
    refused = studio.put("/api/studies/my study.yaml", json={"sheet": sheet}, code=409)
    [error] = refused["errors"]
    assert error["kind"] == "exists"
    assert error["message"].startswith("the study my study.yaml exists already")
    payload(sheet)["mass"] = 0.5
    studio.put("/api/studies/my study.yaml", json={"sheet": sheet, "overwrite": True})
    assert studio.get("/api/studies/my study.yaml")["sheet"] == sheet
    assert tmodes.load(studio.folder / "my study.yaml").links[0].bodies[0].mass == 0.5


def test_a_disk_that_is_full_offers_no_replacing(studio, sheet, monkeypatch):
    def full(*given: object) -> None:
        raise OSError(errno.ENOSPC, "No space left on device")

    monkeypatch.setattr("tmodes.io.atomic._flush", full)
    [error] = studio.put("/api/studies/no room.yaml", json={"sheet": sheet}, code=409)["errors"]
    assert error["kind"] == ""
    assert "No space left" in error["message"]
    assert str(studio.folder) not in error["message"]
    assert not (studio.folder / "no room.yaml").exists()


def test_a_wrong_study_is_not_saved(studio, sheet):
    payload(sheet)["mass"] = -1.0
    studio.put("/api/studies/wrong.yaml", json={"sheet": sheet}, code=422)
    assert not (studio.folder / "wrong.yaml").exists()


def test_yaml_of_a_sheet(studio):
    sheet = studio.get("/api/robots/deluca_siciliano1991")["sheet"]
    text = studio.post("/api/yaml", json={"sheet": sheet})["yaml"]
    assert "kind: arm" in text


def test_page_of_the_studio(studio):
    page = studio.client.get("/")
    assert page.headers["content-type"].startswith("text/html")
    assert 'src="studio.js"' in page.text
    assert studio.client.get("/studio.css").status_code == 200
    for absent in ("/docs", "/openapi.json", "/redoc", "/api/nothing"):
        assert studio.client.get(absent).status_code == 404
