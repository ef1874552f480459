"""Tables that a study names: only inside of its folder, bounded in size, each wrong cell with its line."""

from __future__ import annotations

import shutil
from typing import Any

import pytest

from study.core.studies import written
from tmodes.errors import InputError, InputErrors
from tmodes.study.read import read_study, study_from_data
from tmodes.study.study import Study

TEXT = "format: 1\nkind: study\nname: test\nplan: {type: grid}\nquantities: {y: {expression: x}}\nparameters:\n"
ROBOT = "format: 1\nkind: study\nname: test\nrobot: filipovic2010\nplan: {type: grid}\n"
ROBOT += "quantities: {y: {expression: x}}\nparameters:\n"
SAMPLES = "  x: {distribution: {type: empirical, file: data.csv, column: stiffness}}\n"
CATALOGUE = "  x: {catalogue: data.csv}\n"


def refused(folder, text, data):
    """The message of a study with a table that is wrong."""
    with pytest.raises((InputError, InputErrors)) as caught:
        written(folder, text, data_csv=data)
    return str(caught.value).replace(str(folder), "")


def test_a_catalogue_becomes_choices_and_the_data_need_no_file(tmp_path):
    data = "name,gear.stiffness [kN*m/rad],payload.mass,equations\nA,4,500 g,printed\nB,5,0.25,\n"
    one = written(tmp_path, ROBOT + CATALOGUE, data_csv=data)
    sets = [{"joints.joint.gear.stiffness": 4000.0, "link.payload.mass": 0.5, "equations": "printed"}]
    assert one.choice_names("x") == ("A", "B")
    assert list(one.choices["x"][0].values()) == list(sets[0].values())
    assert "equations" not in one.choices["x"][1]
    shutil.rmtree(tmp_path)
    again = Study.from_data(one.data)
    assert again.identity == one.identity
    assert again.choices == one.choices


def test_samples_of_a_column(tmp_path):
    one = written(tmp_path, TEXT + SAMPLES, data_csv="name;stiffness\na;3\nb;1\n\nc;2.5\n")
    sample: Any = one.sheet.parameters["x"].distribution
    assert sample.values == (3.0, 1.0, 2.5)
    assert one.design().values.min() == 1.0


def test_samples_take_the_unit_of_the_path(tmp_path):
    text = ROBOT + "  x: {path: payload.mass, distribution: {type: empirical, file: data.csv, column: m}}\n"
    one = written(tmp_path, text, data_csv="m [g]\n500\n510\n")
    sample: Any = one.sheet.parameters["x"].distribution
    assert sample.values == (0.5, 0.51)


def test_cases_of_a_file_by_names_of_choices(tmp_path):
    text = TEXT.replace("grid", "list, file: data.csv") + (
        "  x: {distribution: {type: uniform, low: 0, high: 9}}\n"
        "  law: {choices: [{name: soft, set: {}}, {name: hard, set: {}}]}\n"
    )
    one = written(tmp_path, text, data_csv="law,x\nhard,3\nsoft,\n")
    assert one.design().values.tolist() == [[3.0, 1.0], [4.5, 0.0]]
    message = refused(tmp_path, text, "law,x\nhrd,3\n")
    assert message == "data.csv:2: law: unknown name 'hrd'. Did you mean `hard`?"


@pytest.mark.parametrize(
    ("data", "message"),
    [
        ("name,stiffness\na,3\nb,x\n", "data.csv:3: x must be a number, got the text 'x'"),
        ("name,stiffness\na,3\nb,.nan\n", "data.csv:3: x must be a number, got .nan (not a number)"),
        ("name,stiffness\na,3\nb,1e400\n", "data.csv:3: x must be a number"),
        ("name,stifness\na,3\nb,4\n", "unknown column 'stiffness'. Did you mean `stifness`?"),
        ("name,stiffness\na,3\nb\n", "data.csv:3: the row must be 2, as in the header, got 1 cells"),
        ("name,name\na,3\n", "data.csv:1: the header must be a name for each column"),
        ("", "a file without a header"),
        ("name,stiffness\na,3\n", "values must be at least 2, got 1 value"),
        ("name,stiffness\n" + "a,3\n" * 100_001, "data.csv:100002: the file must be at most 100,000 rows"),
        ("name,stiffness\n" + "a,3.0000000000000000\n" * 1_000_000, "21,000,015 bytes"),
        ("x" * 5000 + ",stiffness\n1,2\n", "at most 1,000 characters in a cell"),
        ("a,stiffness\n\"1,2\n", "data.csv:2: the row"),
    ],
)  # fmt: skip
def test_tables_that_are_wrong(tmp_path, data, message):
    assert message in refused(tmp_path, TEXT + SAMPLES, data)


def test_a_catalogue_with_wrong_cells_reports_all(tmp_path):
    data = "name,gear.stifness,payload.mass [g],gear.damping\nA,1,500,2\nB,2,x,3 m\n"
    lines = refused(tmp_path, ROBOT + CATALOGUE, data).splitlines()
    assert lines[0] == "data.csv:1: unknown key `gear.stifness`. Did you mean `gear.stiffness`?"
    assert lines[1].startswith("data.csv:3: payload.mass must be a number in kg, got the text 'x'")
    assert lines[2].startswith("data.csv:3: gear.damping must be a number in N*m*s/rad, got the unit 'm'")


@pytest.mark.parametrize("name", ["../data.csv", "/etc/passwd", "link.csv", "none.csv", "folder", "http://a.b/c.csv"])
def test_files_outside_are_not_read(tmp_path, name):
    inside = tmp_path / "inside"
    (inside / "folder").mkdir(parents=True)
    (tmp_path / "data.csv").write_text("name\nA\n", encoding="utf-8")
    (inside / "link.csv").symlink_to(tmp_path / "data.csv")
    (inside / "study.yaml").write_text(f"{TEXT}  x: {{catalogue: '{name}'}}\n", encoding="utf-8")
    with pytest.raises(InputErrors, match=r"study\.yaml:7: parameters\.x\.catalogue must be"):
        read_study(inside / "study.yaml")
    if name == "../data.csv":  # allowed where the user says so
        assert read_study(inside / "study.yaml", roots=[tmp_path]).choice_names("x") == ("A",)
        assert read_study(inside / "study.yaml", trust_paths=True).choice_names("x") == ("A",)


def test_plain_data_name_no_files():
    data = {
        "format": 1, "kind": "study", "name": "test", "plan": {"type": "grid"},
        "quantities": {"y": {"expression": "x"}},
        "parameters": {"x": {"catalogue": "/etc/passwd"}},
    }  # fmt: skip
    with pytest.raises(InputErrors, match="no file, in a study without a folder"):
        study_from_data(data)
