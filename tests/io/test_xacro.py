"""The safe part of xacro against the URDF written out by hand, and everything else refused with its line."""

from __future__ import annotations

import math
from pathlib import Path

import pytest

from patience import bounded
from tmodes.errors import InputError, TmodesError
from tmodes.io.files import folders_of
from tmodes.io.sheet_files import read_sheet
from tmodes.io.xacro import expand_xacro, read_xacro
from tmodes.io.xacro_expression import XacroFormulaError, evaluate
from tmodes.io.xml_file import Element, parse_xml

MACROS = """<robot xmlns:xacro="http://www.ros.org/wiki/xacro">
  <xacro:property name="density" value="${500 * 2}"/>
  <xacro:macro name="bar" params="name length:=0.5 side:=${2*0.01} *place **more">
    <xacro:property name="mass" value="${density * length * side**2}"/>
    <link name="${name}_link">
      <inertial>
        <origin xyz="${length/2} 0 0" rpy="0 0 ${radians(90)}"/>
        <mass value="${mass}"/>
        <inertia ixx="${mass*side**2/6}" iyy="${mass*length**2/12}" izz="${mass*length**2/12}" ixy="0" ixz="0" iyz="0"/>
      </inertial>
      <xacro:insert_block name="more"/>
    </link>
    <joint name="${name}_joint" type="revolute">
      <xacro:insert_block name="place"/>
      <parent link="ground"/><child link="${name}_link"/>
      <axis xyz="0 0 1"/>
      <xacro:if value="${name == 'left' and length &gt; 0.1}">
        <limit lower="-1" upper="1" effort="1" velocity="1"/>
      </xacro:if>
      <xacro:unless value="${name == 'left'}"><dynamics damping="$(arg damping)"/></xacro:unless>
    </joint>
  </xacro:macro>
</robot>"""

MAIN = """<robot name="two" xmlns:xacro="http://www.ros.org/wiki/xacro">
  <xacro:arg name="damping" default="0.25"/>
  <xacro:include filename="parts/macros.xacro"/>
  <link name="ground"/>
  <xacro:bar name="left"><origin xyz="0 ${density/1000} 0"/><none/></xacro:bar>
  <xacro:bar name="right" length="1.0"><origin xyz="0 -1 0"/><none><visual/></none></xacro:bar>
</robot>"""


def written(folder: Path) -> Path:
    (folder / "parts").mkdir()
    (folder / "parts/macros.xacro").write_text(MACROS)
    path = folder / "two.xacro"
    path.write_text(MAIN)
    return path


def test_against_the_robot_written_out(tmp_path: Path) -> None:
    data, positions, source = read_sheet(written(tmp_path))
    left, right = data["joints"][1:]
    assert (left["name"], left["origin"]["position"], left["limits"]["upper"]) == ("left_joint", [0.0, 1.0, 0.0], 1.0)
    assert (right["friction"], "limits" in right) == ({"viscous": 0.25, "coulomb": 0.0}, False)
    first, second = (link["bodies"][0] for link in data["links"])
    assert (first["mass"], second["mass"]) == (pytest.approx(0.2), pytest.approx(0.4))
    assert first["inertia"]["yy"] == pytest.approx(0.2 * 0.5**2 / 12)
    assert second["center"] == [0.5, 0.0, 0.0]
    assert second["rpy"] == [0.0, 0.0, pytest.approx(math.pi / 2)]
    assert source == str(tmp_path / "two.xacro")
    assert positions["links.0"] == 5


def test_arguments_are_given_from_outside(tmp_path: Path) -> None:
    robot = read_xacro(written(tmp_path), arguments={"damping": "0.5"})
    assert robot.data["joints"][2]["friction"]["viscous"] == 0.5


@pytest.mark.parametrize(
    ("formula", "value"),
    [
        ("1 + 2 * 3", 7),
        ("7 / 2", 3.5),
        ("7 // 2 + 7 % 4 - -1", 7),
        ("2 ** 10", 1024),
        ("2 ** -1", 0.5),
        ("sin(pi / 6)", pytest.approx(0.5)),
        ("degrees(atan2(1, 1))", pytest.approx(45)),
        ("max(1, 2.5) if x > 1 and not y else 0", 2.5),
        ("'left_' + side", "left_x"),
        ("x == 3 or 1 / 0", True),
    ],
)
def test_formulas(formula: str, value: object) -> None:
    assert evaluate(formula, {"x": 3, "y": False, "side": "x"}) == value


@pytest.mark.parametrize(
    "formula",
    [
        "__import__('os').system('true')",
        "().__class__.__bases__[0].__subclasses__()",
        "open('/etc/passwd')",
        "x.real",
        "x[0]",
        "[1, 2]",
        "{1: 2}",
        "lambda: 1",
        "(y := 3)",
        "[i for i in (1,)]",
        "f'{x}'",
        "9 ** 9 ** 9",
        "'a' * 1000000000",
        "1 << 100000",
        "10 ** 400",
        "99999999999999999999",
        "1e308 * 10",
        "1 / 0",
        "sqrt(-1)",
        "factorial(100000)",
        "max()",
        "sin('a')",
        "b'bytes'",
        "None",
        "...",
        "1 if",
        "(" * 300,
        "-" * 400 + "1",
        "1 < 2 < 3 < 4 @ 5",
        "unknown",
        "",
        "1; 2",
        "x" * 501,
        "import os",
        "1\n2",
        "\0",
    ],
)
def test_formulas_that_are_none(formula: str) -> None:
    with bounded(1.0), pytest.raises(XacroFormulaError):
        evaluate(formula, {"x": 3})


def expand(inside: str, folder: Path) -> Element:
    root = parse_xml(f"<robot>\n{inside}</robot>".encode(), str(folder / "r.xacro"))
    return expand_xacro(root, folders_of(folder / "r.xacro"), {})


REFUSED = {
    "unknown macro": (
        "<xacro:leg/>",
        "<xacro:leg> must be a macro, or property, arg, macro, include, if, unless, insert_block, got <xacro:leg>",
    ),
    "misspelt command": ('<xacro:proprty name="a" value="1"/>', "Did you mean <xacro:property>?"),
    "unknown name": ('<a x="${lenght}"/>', "unknown name 'lenght'"),
    "python": ('<a x="${__import__(1)}"/>', "which is not arithmetic"),
    "unfinished": ('<a x="${1 + 2"/>', "the unfinished formula"),
    "eval": ('<a x="$(eval 1+1)"/>', "got the command '$(eval 1+1)'"),
    "environment": ('<a x="$(env HOME)"/>', "got the command '$(env HOME)'"),
    "no argument": ('<a x="$(arg size)"/>', "got the argument 'size', which has no value"),
    "condition": ('<xacro:if value="maybe"><a/></xacro:if>', "got the condition 'maybe'"),
    "missing parameter": ('<xacro:macro name="m" params="a b:=1"/><xacro:m/>', "got no value for a"),
    "unknown parameter": ('<xacro:macro name="m" params="side"/><xacro:m sid="1"/>', "Did you mean `side`?"),
    "missing block": (
        '<xacro:macro name="m" params="*b"/><xacro:m/>',
        "called with 1 elements, one for each block (b), got 0 elements inside",
    ),
    "unknown block": ('<xacro:insert_block name="b"/>', "unknown block 'b'"),
    "scope": ('<xacro:property name="a" value="1" scope="global"/>', "got the attribute 'scope'"),
    "without prefix": ('<property name="a" value="1"/>', "write <xacro:property>"),
    "bad params": ('<xacro:macro name="m" params="a, b"/>', "got the parameters"),
    "macro called if": ('<xacro:macro name="if"/>', "a macro called 'if'"),
    "include outside": ('<xacro:include filename="../../other.xacro"/>', "which leads outside"),
    "include absolute": ('<xacro:include filename="/etc/passwd"/>', "got an absolute path"),
    "include absent": ('<xacro:include filename="nothing.xacro"/>', "which is not there"),
    "include package": ('<xacro:include filename="$(find other)/a.xacro"/>', "which is not there"),
    "endless macro": ('<xacro:macro name="m"><xacro:m/></xacro:macro><xacro:m/>', "more than 60 levels"),
    "doubling text": (
        '<xacro:property name="a" value="xxxxxxxxxx"/>' + '<xacro:property name="a" value="${a}${a}"/>' * 40,
        "a text of 640 characters",
    ),
}


@pytest.mark.parametrize(("inside", "words"), REFUSED.values(), ids=REFUSED)
def test_refused_with_its_line(inside: str, words: str, tmp_path: Path) -> None:
    with pytest.raises(InputError) as caught:
        expand(inside, tmp_path)
    assert words in str(caught.value)
    assert str(caught.value).startswith(f"{tmp_path}/r.xacro:2: ")


def test_an_include_of_itself_ends(tmp_path: Path) -> None:
    (tmp_path / "r.xacro").write_text('<robot><xacro:include filename="r.xacro"/></robot>')
    with pytest.raises(InputError, match="more than"):
        read_xacro(tmp_path / "r.xacro")


def test_macros_that_double_without_end_take_bounded_time(tmp_path: Path) -> None:
    macros = "".join(f'<xacro:macro name="m{i}"><xacro:m{i + 1}/><xacro:m{i + 1}/></xacro:macro>' for i in range(40))
    with bounded(20.0), pytest.raises(InputError, match="more than 200000 elements"):
        expand(f'{macros}<xacro:macro name="m40"/><xacro:m0/>', tmp_path)


def test_escapes_defaults_and_outer_names(tmp_path: Path) -> None:
    root = expand(
        '<xacro:property name="p" value="outer"/><xacro:property name="p" default="no"/>'
        '<xacro:macro name="m" params="p:=^|none q:=\'two words\' r:=${1+1}">'
        '<a x="${p}" y="${q} $${z}" z="l_${r}"/></xacro:macro>'
        '<xacro:m/><xacro:m p="given"/>',
        tmp_path,
    )
    assert [child.attributes for child in root.children] == [
        {"x": "outer", "y": "two words ${z}", "z": "l_2"},
        {"x": "given", "y": "two words ${z}", "z": "l_2"},
    ]


def test_a_xacro_is_a_urdf_after_all(tmp_path: Path) -> None:
    path = tmp_path / "bad.xacro"
    joint = '<joint name="j" type="continuous"><parent link="b"/><child link="a"/></joint><link name="b"/>'
    path.write_text(
        f'<robot name="r">{joint}\n<link name="a"><inertial>\n<mass value="${{-1}}"/></inertial></link></robot>'
    )
    with pytest.raises(TmodesError, match=r"bad\.xacro:3: link a: mass must be .*, got -1"):
        read_sheet(path)
