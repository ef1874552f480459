"""The benchmark of gradients runs, and the errors that it prints next to its ratios are those of right derivatives."""

from __future__ import annotations

from benchmarks.gradients import evaluation


def test_errors_of_an_evaluation() -> None:
    row = evaluation(2, 1)
    assert row["joints"] == 2
    assert max(row["jvp_error"], row["all_error"]) <= 1e-9
    assert row["duality"] <= 1e-12
    assert min(row["jvp"], row["vjp"], row["evaluation_us"], row["all_us"]) > 0
