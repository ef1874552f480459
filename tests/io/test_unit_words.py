"""Units as people write them mean what the unit library says of their explicit form; what is none is refused."""

from __future__ import annotations

import math

import pytest

from tmodes.io.units import NotANumber, library_factor, number

SPELLINGS = {
    ("N*m/rad", "N*m/rad"): "Nm/rad; N m/rad; N-m/rad; N.m/rad; N·m/rad; N⋅m/rad; N×m/rad; N*m*rad^-1; N m rad⁻¹; "
    "Nm rad^-1; Nm rad-1; Nm per rad; Nm; N·m; Newton-meter/radian",
    ("N*m/rad", "N*m/deg"): "Nm/deg; Nm/°; N-m/degree; Nm per deg",
    ("N*m/rad", "kN*m/rad"): "kNm/rad; kN-m/rad; kN·m",
    ("N*m/rad", "mN*m/rad"): "mNm/rad; mN-m/rad",
    ("N*m/rad", "N*mm/rad"): "Nmm/rad; N-mm/rad",
    ("N*m*s/rad", "N*m*s/rad"): "Nms/rad; N-m-s/rad; N·m·s/rad; Nm s/rad; Nm·s/rad; Nm/(rad/s); Nms; Nm*s; N.m.s/rad; "
    "N m s rad⁻¹; Nm-s/rad",
    ("N*m*s/rad", "N*mm*s/rad"): "Nmms/rad; N-mm-s/rad",
    ("N*m*s/rad", "N*m/rpm"): "Nm/rpm; Nm/RPM; N-m/(rev/min)",
    ("kg*m^2", "kg*m^2"): "kgm^2; kg·m²; kg m2; kgm2; kg-m^2; kg*m**2; kgm²; kg.m^2; kg m^(2); Nms^2",
    ("kg*m^2", "g*cm^2"): "gcm^2; g cm²; g-cm2; gcm2; g·cm²",
    ("kg*m^2", "kg*mm^2"): "kgmm^2; kg mm2; kg-mm²",
    ("rad/s", "rpm"): "rpm; RPM; rev/min; turns/min",
    ("rad/s", "deg/s"): "deg/s; °/s; degrees/s; deg s^-1; degrees per second; deg/sec",
    ("rad/s", "rad/s"): "rad/s; rad s⁻¹; rad/sec; radians/second; 1/s; s^-1",
    ("rad", "deg"): "deg; °; º; degree; degrees",
    ("rad", "revolution"): "rev; turn; revolution",
    ("-", "percent"): "%; percent",
    ("N*m", "N*m"): "Nm; N-m; N m; J",
    ("N*m", "mN*m"): "mNm; mN-m; mN·m",
    ("N*m", "kgf*cm"): "kgf·cm; kgf-cm; kgfcm",
    ("N*m", "ozf*in"): "ozf-in; ozf·in",
    ("N*m", "lbf*ft"): "lbf ft; lbf-ft; lbfft",
    ("N*m^2", "N*m^2"): "Nm^2; N·m²; N-m2; Nm2",
    ("N*m^2", "N*mm^2"): "Nmm^2; N mm²; N-mm^2",
    ("Pa", "N/mm^2"): "N/mm²; N/mm2; MPa",
    ("kg/m^3", "g/cm^3"): "g/cm³; g/cm3; g cm^-3",
    ("V*s/rad", "V/rpm"): "V/rpm; V/RPM; V/(rev/min)",
    ("V*s/rad", "mV/rpm"): "mV/rpm; V/krpm",
    ("V*s/rad", "V*s/rad"): "Vs/rad; V·s/rad; V-s/rad; V/(rad/s)",
    ("N*m/A", "mN*m/A"): "mNm/A; mN·m/A",
    ("ohm", "ohm"): "Ω; \u2126; Ohm; ohms",
    ("H", "mH"): "mH",
    ("H", "microhenry"): "µH; uH; μH",
    ("m/s^2", "m/s^2"): "m/s²; m/s2; m s⁻²; m/s/s; m·s^-2",
    ("N*s/m", "N*s/m"): "Ns/m; N/(m/s); N·s/m; N-s/m",
    ("m", "micrometer"): "µm; um; μm; micron",
}  # fmt: skip
CASES = [(unit, other, text.strip()) for (unit, other), texts in SPELLINGS.items() for text in texts.split(";")]


@pytest.mark.parametrize(("unit", "explicit", "text"), CASES)
def test_a_spelling_means_what_its_explicit_form_means(unit: str, explicit: str, text: str) -> None:
    expected = 1.5 * library_factor(explicit, unit)
    assert number(f"1.5 {text}", unit) == pytest.approx(expected, rel=1e-14, abs=0)
    assert number(f"1.5{text}" if text[0] not in "1/" else f"1.5 {text}", unit) == number(f"1.5 {text}", unit)
    assert number(f"−1.5 {text}", unit) == pytest.approx(-expected, rel=1e-14, abs=0)


@pytest.mark.parametrize(
    ("text", "unit", "meant"),
    [
        ("2 NM/rad", "N*m/rad", "2 N*m/rad"), ("2 nm", "N*m", "2 N*m"), ("3 Kg", "kg", "3 kg"), ("3 KG", "kg", "3 kg"),
        ("5 DEG", "rad", "5 deg"), ("5 MM", "m", "5 mm"), ("2 Mpa", "Pa", "2 MPa"), ("2 KN", "N", "2 kN"),
        ("3 oz-in", "N*m", "3 ozf*in"), ("3 lb-ft", "N*m", "3 lbf*ft"), ("3 kg cm", "N*m", "3 kgf*cm"),
    ],
)  # fmt: skip
def test_what_was_probably_meant_is_in_the_hint_and_no_number(text: str, unit: str, meant: str) -> None:
    with pytest.raises(NotANumber) as caught:
        number(text, unit)
    assert text in caught.value.got
    assert f'"{meant}"' in caught.value.hint


@pytest.mark.parametrize(
    ("text", "unit"),
    [
        ("5 mN", "N*m"), ("5 Nmm", "N*m^2"), ("5 kgm", "kg*m^2"), ("5 Nm/rad", "N*m"), ("5 Nms/rad", "N*s/m"),
        ("5 deg", "-"), ("5 %", "rad"), ("5 Hz", "rad/s"), ("5 1/min", "rad/s"), ("5 rad/s", "Hz"), ("5 rpm", "Hz"),
        ("5 rpm/V", "V*s/rad"), ("5 mmm", "m"), ("5 N--m", "N*m"), ("5 m^^2", "m^2"), ("5 m²²", "m^2"),
        ("5 (m", "m"), ("5 m)", "m"), ("5 /m", "m"), ("5 m/", "m"), ("5*m", "m"), ("5 m2m", "m"), ("5 N..m", "N*m"),
        ("5 N;m", "N*m"), ("5 $", "m"), ("1 000 mm", "m"), ("5 m 3 mm", "m"), ("0x5 m", "m"), ("5 Nfoo", "N"),
        ("5 m,3", "m"), ("5 ½ m", "m"), ("five m", "m"), ("5 m^-", "m"), ("5 per m", "1/m"), ("5 m per", "m"),
    ],
)  # fmt: skip
def test_what_is_no_unit_of_the_place_is_refused_with_the_text(text: str, unit: str) -> None:
    with pytest.raises(NotANumber) as caught:
        number(text, unit)
    assert text in caught.value.got
    assert caught.value.hint


def test_turns_and_radians_are_not_confused() -> None:
    assert number("60 rpm", "rad/s") == pytest.approx(2 * math.pi, rel=1e-15)
    with pytest.raises(NotANumber, match="rpm"):
        number("1 Hz", "rad/s")
