"""Which cases keep their whole motion, and how large it is: known before anything runs."""

from __future__ import annotations

from tmodes.study.study import Study

__all__ = ["kept_cases", "kept_count", "motion_bytes"]


def kept_cases(study: Study, first: int, end: int) -> tuple[int, ...]:
    """The cases from ``first`` to before ``end`` whose motion is kept."""
    keep = study.sheet.keep
    found = {case for case in keep.cases if first <= case < end}
    if keep.every:
        found |= set(range(-(-first // keep.every) * keep.every, end, keep.every))
    return tuple(sorted(found))


def kept_count(study: Study, cases: int) -> int:
    """How many of so many cases keep their motion, at most."""
    keep = study.sheet.keep
    return len(keep.cases) + (-(-cases // keep.every) if keep.every else 0)


def motion_bytes(study: Study) -> int:
    """Bytes of the motion of one case, at least: time, tip, and an angle and a rate of each joint, at each sample."""
    if study.robot is None:
        return 0
    settings = study.robot.integration
    samples = int(settings.duration / settings.output_step) + 1
    return 8 * samples * (4 + 2 * len(study.robot.joints))
