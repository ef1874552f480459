"""The studio's page in a real browser, as a new user meets it."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
from itertools import product
from pathlib import Path

import numpy as np
import pytest

import tmodes
from command import started
from patience import steady, until
from studio.tabs import Tab, drag, opened
from studio.test_looks import ELASTICITY, stl
from studio.test_looks import URDF as MESHED
from tmodes.studio.folders import door

pytestmark = pytest.mark.nightly

STILL = "Promise.all(document.getAnimations().map((one) => one.finished))"
"""Colours that change by and by have changed."""
MASS = "links.0.bodies.0.mass"
"""Where the payload of the robot stands in its sheet."""

SLOW_URDF = """<robot name="two">
  <link name="base"/>
  <link name="arm"><inertial><mass value="-2"/>
    <inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0" iyz="0"/></inertial></link>
  <joint name="hinge" type="revolute"><parent link="base"/><child link="arm"/><axis xyz="0 0 1"/>
    <limit lower="-1" upper="1" effort="10" velocity="2"/></joint>
</robot>
"""


def test_the_page_that_leads_there(browser, address):
    """What the command opens, instead of the address itself: the studio, with its token kept."""
    with door(address) as page:
        assert page is not None
        for tab in opened(browser, page.as_uri()):
            tab.info("New curves")
            assert tab.page.url == address.partition("?")[0]


def test_a_dragged_slider_gives_new_curves_and_a_ghost(tab):
    """The largest deviation is that of the command line for the payload that the slider shows."""
    assert "token" not in tab.page.url
    before = tab.fact("deviation.max")
    tab.fresh(lambda: drag(tab, MASS, 0.9))
    mass = float(tab.page.input_value("[data-slider='links.0.bodies.0.mass'] input.number"))
    own = tmodes.run(tmodes.load("filipovic2010").with_({"payload.mass": mass})).data
    shown = tab.fact("deviation.max")
    assert shown != before
    assert float(shown.split()[0]) == pytest.approx(1e3 * float(own.deviation.max()), rel=2e-3)
    assert before in tab.page.inner_text("[data-fact='deviation.max'] .was")


def opened_groups(tab: Tab, *paths: str) -> None:
    """Groups of the sheet, one in the other."""
    for path in paths:
        tab.page.locator(f"details[data-path='{path}'] > summary").click()


def payload_opened(tab: Tab) -> None:
    opened_groups(tab, "links", "links.0", "links.0.bodies", "links.0.bodies.0")


MARKED = "document.querySelector('.scene-view').dataset.marked"
FOCUSED = "document.activeElement.closest('[data-path]')?.dataset.path"


def current(tab: Tab) -> str:
    return tab.page.get_attribute(".tree [aria-current=true]", "data-steps") or ""


def test_structure_picture_and_fields_show_one_part(tab):
    """A node leads to its fields and marks its joint; so does a click in the picture; a field marks its node."""
    page = tab.page
    assert page.locator(".tree button").all_inner_texts() == [
        "joint", "motor", "gear", "controller", "link", "beam", "payload", "tip", "contact",
    ]  # fmt: skip
    page.locator(".tree").get_by_role("button", name="gear").click()
    assert (page.evaluate(FOCUSED), page.evaluate(MARKED), current(tab)) == ("joints.0.gear", "joint", "joints.0.gear")
    payload_opened(tab)
    page.locator("details[data-path='links.0.bodies.0']").get_by_label("Mass").focus()
    assert (page.evaluate(MARKED), current(tab)) == ("link", "links.0.bodies.0")
    page.locator(".tree").get_by_role("button", name="contact").click()
    page.locator(".scene-view").evaluate("one => one.scrollIntoView({ block: 'center' })")
    box = page.locator(".scene-view").bounding_box()
    wanted = {("joint", "joints.0", "joints.0"), ("link", "links.0", "links.0")}
    for x, y in product(np.linspace(0.05, 0.6, 20), np.linspace(0.3, 0.9, 16)):
        if wanted:
            page.mouse.click(box["x"] + x * box["width"], box["y"] + y * box["height"])
            wanted.discard((page.evaluate(MARKED), current(tab), page.evaluate(FOCUSED)))
    assert not wanted


def test_the_verdict_is_of_the_newest_run(tab):
    payload_opened(tab)
    before = tab.page.inner_text(".verdict-sentence")
    tab.fresh(lambda: tab.type("Mass", "0.9"))
    wanted = tmodes.run(tmodes.load("filipovic2010").with_({"payload.mass": 0.9})).verdict["sentence"]
    assert wanted != before
    tab.page.locator(".verdict-sentence", has_text=wanted).wait_for()


def test_a_link_of_modes_has_the_form_of_its_model(tab):
    """Of the kinds that a link may have, the form is that of the one that it is."""
    opened_groups(tab, "links", "links.0", "links.0.beam", "links.0.beam.modes", "links.0.beam.modes.1")
    tab.fresh(lambda: tab.type("Bending stiffness", "26.7", inside="details[data-path='links.0.beam.modes.1']"))
    assert tab.page.input_value("[data-slider='links.0.beam.modes.1.bending_stiffness'] input.number") == "26.7"


def test_a_typed_number_with_its_unit(tab):
    payload_opened(tab)
    tab.fresh(lambda: tab.type("Mass", "900 g"))
    heavy = tab.fact("deviation.max")
    tab.fresh(lambda: tab.type("Mass", "0.9"))
    assert tab.fact("deviation.max") == heavy


def test_a_wrong_number_is_reported_at_its_field(tab):
    """The field is marked, the sentence stands below it and above, and a right number takes both away."""
    payload_opened(tab)
    tab.type("Mass", "-1")
    tab.page.wait_for_selector(".sheet [aria-invalid=true]")
    assert "not less than 0 [kg]" in tab.page.inner_text(".sheet .wrong")
    assert "payload.mass" in tab.page.inner_text(".errors")
    tab.fresh(lambda: tab.type("Mass", "0.4"))
    assert tab.page.locator("[aria-invalid=true], .sheet .wrong").count() == 0
    assert not tab.page.is_visible(".errors")


def test_a_wrong_urdf_is_reported_by_file_line_and_field(tab):
    tab.page.set_input_files(
        "input[type=file] >> nth=0", [{"name": "two.urdf", "mimeType": "text/xml", "buffer": SLOW_URDF.encode()}]
    )
    tab.page.wait_for_selector(".errors p")
    info = tab.page.inner_text(".errors")
    assert "two.urdf:3" in info
    assert "mass" in info


def test_meshes_that_are_chosen_with_a_urdf(tab, tmp_path):
    """A folder with all that is in it; and without the mesh a warning stands at its link, and the run is made."""
    (home := tmp_path / "two_description").mkdir()
    (home / "meshes").mkdir()
    (home / ".hidden").mkdir()
    (home / ".hidden" / "other.urdf").write_text("junk", encoding="utf-8")
    (home / "README.md").write_text("of no use", encoding="utf-8")
    (home / "two.urdf").write_text(MESHED.format(mesh="meshes/arm.stl"), encoding="utf-8")
    (home / "two.yaml").write_text(ELASTICITY.format(urdf="two.urdf"), encoding="utf-8")
    (home / "meshes" / "arm.stl").write_bytes(stl(0.25))
    chooser, folder = (tab.page.get_by_label(name, exact=True) for name in ("Upload", "Folder"))
    tab.fresh(lambda: folder.set_input_files(home))
    assert not tab.page.is_visible(".notices")
    chooser.set_input_files([home / "two.urdf", home / "two.yaml"])
    tab.page.wait_for_selector(".notices")
    assert "two.urdf:6 · links.arm" in tab.page.inner_text(".notices")
    assert "not there" in tab.page.inner_text(".sheet .notice")
    assert tab.page.locator("details[data-path='links.0']").get_attribute("aria-invalid") is None
    tab.fresh(lambda: folder.set_input_files(home))
    assert tab.page.locator(".sheet .notice").count() == 0


def test_another_robot_with_its_own_form(tab):
    """An arm: its form comes from its own schema, choices of signals and all."""
    tab.fresh(lambda: tab.page.select_option("#" + tab.page.get_attribute(".bar.top select", "id"), "spong1987"))
    tab.page.locator("details[data-path=drives] > summary").click()
    tab.page.locator("details[data-path='drives.0'] > summary").click()
    tab.page.locator("details[data-path='drives.0.signal'] > summary").click()
    kinds = tab.page.locator("details[data-path='drives.0.signal'] select").first
    kinds.wait_for()
    assert set(kinds.locator("option").all_inner_texts()) >= {"quintic", "sine", "table", "trapezoid"}
    tab.fresh(lambda: kinds.select_option("constant"))
    assert tab.page.locator("details[data-path='drives.0.signal']").get_by_label("Value").count() == 1


LONG_RUN = """async () => {
  const info = await (await fetch("api/robots/filipovic2010")).json();
  Object.assign(info.sheet.integration, { duration: 20000, output_step: 1, relative_tolerance: 1e-12 });
  info.sheet.drives[0].signal.duration = 20000;
  const headers = { "Content-Type": "application/json" };
  const body = JSON.stringify({ sheet: info.sheet, overwrite: true });
  await fetch("api/studies/long.yaml", { method: "PUT", headers, body });
}"""


def test_cancel_and_go_on(tab):
    """A run of minutes shows its progress, and ends within a second when it is not wanted any more."""
    tab.page.evaluate(LONG_RUN)
    tab.page.reload()
    tab.info("New curves")
    tab.page.get_by_label("Open a study").select_option("long.yaml")
    cancel = tab.page.get_by_role("button", name="Cancel")
    cancel.wait_for()
    assert "%" in tab.line()
    cancel.click()
    tab.info("Cancelled")
    assert not cancel.is_visible()
    tab.fresh(lambda: tab.page.get_by_label("Robot", exact=True).select_option("spong1987"))


def test_two_tabs_at_once(tab, browser, address):
    """What one changes the other does not see."""
    before = tab.fact("deviation.max")
    for other in opened(browser, address.partition("?")[0] + "?" + address.partition("?")[2]):
        other.fresh(lambda other=other: drag(other, MASS, 1.0))
        assert other.fact("deviation.max") != before
    assert tab.fact("deviation.max") == before
    tab.fresh(lambda: drag(tab, "joints.0.gear.stiffness.0", 0.3))


def test_a_study_is_kept_and_opened_again(tab):
    tab.fresh(lambda: drag(tab, MASS, 0.75))
    kept = tab.fact("deviation.max")
    name = tab.page.get_by_label("Name of the study")
    name.fill("kept")
    tab.page.get_by_role("button", name="Save", exact=True).click()
    tab.info("Saved")
    tab.fresh(lambda: drag(tab, MASS, 0.2))
    tab.fresh(lambda: tab.page.get_by_label("Open a study").select_option("kept.yaml"))
    assert tab.fact("deviation.max") == kept
    tab.page.get_by_role("button", name="Save", exact=True).click()
    replace = tab.page.get_by_role("button", name="Replace")
    replace.wait_for()
    replace.click()
    tab.info("Saved")


def test_names_that_are_none_and_what_is_typed_next_to_a_slider(tab):
    """A path that is no name is marked, and no longer once it is gone; a unit may be typed, a word is refused."""
    name, save = tab.page.get_by_label("Name of the study"), tab.page.get_by_role("button", name="Save", exact=True)
    name.fill("../x")
    save.click()
    tab.page.locator(".errors", has_text="the plain name of a file").wait_for()
    name.fill("x")
    save.click()
    tab.info("Saved")
    assert not tab.page.is_visible(".errors")
    typed = tab.page.locator("[data-slider='links.0.bodies.0.mass'] input.number")
    typed.fill("some")
    typed.press("Enter")
    tab.page.locator(".errors", has_text="payload.mass").wait_for()
    typed.fill("450 g")
    tab.fresh(lambda: typed.press("Enter"))
    assert not tab.page.is_visible(".errors")


def test_a_robot_called_script_stays_text(tab):
    tab.type("Name", "<img src=x onerror=alert(1)>")
    tab.info("New")
    assert tab.page.locator("img").count() == 0
    assert "filipovic" not in tab.page.input_value(".sheet input")


def test_accessible(tab):
    """No fault that a tool can find, in the light and the dark scheme, with a form that is open."""
    script = Path(__file__).parents[2] / "web/node_modules/axe-core/axe.min.js"
    if not script.exists():
        pytest.skip("needs axe-core: npm ci in web/")
    payload_opened(tab)
    content = script.read_text(encoding="utf-8")
    for scheme in ("light", "dark"):
        tab.page.emulate_media(color_scheme=scheme)
        tab.page.evaluate(STILL)
        tab.page.evaluate(f"() => {{ const module = undefined, define = undefined; {content} }}")
        found = tab.page.evaluate("async () => (await axe.run()).violations")
        assert [(one["id"], one["nodes"][0]["html"][:120]) for one in found] == [], scheme


def test_no_width_makes_the_page_scroll_sideways(tab):
    for width, height in ((1280, 800), (1920, 1080), (400, 800)):
        tab.page.set_viewport_size({"width": width, "height": height})
        tab.page.wait_for_function(f"() => innerWidth === {width}")
        assert steady(lambda: tab.page.evaluate("document.documentElement.scrollWidth")) <= width


def studio_of_its_own(folder: Path, *more: str) -> subprocess.Popen[str]:
    command = [sys.executable, "-m", "tmodes.cli.entry", "studio", "--no-open", "--folder", str(folder), *more]
    return started(command, stdout=subprocess.PIPE)


HASTE = """
const later = window.setTimeout, limit = AbortSignal.timeout.bind(AbortSignal);
window.setTimeout = (run, wait, ...more) => later(run, wait / 8, ...more);
AbortSignal.timeout = (wait) => limit(wait / 8);
"""
"""All that a page waits for takes an eighth of the time."""


def test_a_studio_that_goes_away_and_comes_back(browser, tmp_path):
    """The page says that nothing answers, and continues by itself; one that was started again has another address.

    Even where it is killed, and cannot say goodbye, its workers end.
    """
    if not Path("/proc").exists():
        pytest.skip("stops and continues a process by signals, and looks for processes in /proc")
    with studio_of_its_own(tmp_path) as running:
        assert running.stdout is not None
        address = running.stdout.readline().split()[1]
        port = address.partition("/?")[0].rpartition(":")[2]
        tab = Tab(browser.new_page())
        tab.page.add_init_script(HASTE)
        tab.page.goto(address)
        tab.info("New curves")
        gone = tab.page.locator(".gone")
        running.send_signal(signal.SIGSTOP)
        gone.wait_for()
        assert "start it again" in gone.inner_text()
        tab.page.evaluate("document.querySelector('.line').textContent = ''")
        running.send_signal(signal.SIGCONT)
        tab.info("New curves")
        gone.wait_for(state="hidden")
        assert tab.wrong == []
        running.terminate()
    with studio_of_its_own(tmp_path, "--port", port) as again:
        assert again.stdout is not None
        again.stdout.readline()
        tab.page.locator(".gone", has_text="open the address that it printed").wait_for()
        workers = [int(one) for one in os.listdir("/proc") if one.isdecimal() and _parent(one) == again.pid]  # noqa: PTH208
        assert len(workers) >= 2
        again.kill()
    until(lambda: not any(Path(f"/proc/{worker}").exists() and _parent(str(worker)) for worker in workers))
    tab.page.close()


def test_what_is_added_has_units_and_values_that_may_be(tab):
    """A number that nobody gave yet lies within its range, and has the unit of the joint that it moves."""
    tab.fresh(lambda: tab.page.get_by_label("Robot", exact=True).select_option("spong1987"))
    for path in ("drives", "drives.0", "drives.0.signal"):
        tab.page.locator(f"details[data-path='{path}'] > summary").click()
    kinds = tab.page.locator("details[data-path='drives.0.signal'] select").first
    tab.fresh(lambda: kinds.select_option("trapezoid"))
    kinds.select_option("noise")
    deviation = tab.page.locator("details[data-path='drives.0.signal'] .field", has_text="Deviation")
    deviation.locator(".unit", has_text="rad").wait_for()


def _parent(process: str) -> int:
    """Whose child a process is; 0 where it is no more, or a mere entry of the table."""
    try:
        fields = Path(f"/proc/{process}/stat").read_text(encoding="utf-8").rpartition(")")[2].split()
    except OSError:
        return 0
    return 0 if fields[0] == "Z" else int(fields[1])
