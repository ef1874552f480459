"""A wrong value given from Python is named, with what it should be; robots, models and results can be copied."""

import copy
import pickle
import subprocess
import sys

import numpy as np
import pytest

import tmodes
from tmodes.errors import InputError, InputErrors

NOT_NUMBERS = {
    "NaN": [np.nan, 0.0], "infinite": [0.0, np.inf], "text": "ab", "texts": ["1", "2"], "complex": [1j, 0.0],
    "Boolean": [True, False], "nothings": [None, None], "a group": {"a": 1}, "an object": object(),
    "uneven": [[1.0], [1.0, 2.0]],
}  # fmt: skip
WRONG_SHAPES = {
    "three": [1.0, 2.0, 3.0],
    "four": np.zeros(4),
    "none": [],
    "cube": np.zeros((2, 2, 2)),
    "wide": [[1.0, 2.0, 3.0]],
}
Q = [0.1, 0.2]
CALLS = {
    "q": [
        *(lambda m, x, name=name: getattr(m, name)(x)
          for name in ("mass_matrix", "gravity", "points", "pose", "jacobian", "linearize", "stiffness")),
        *(lambda m, x, name=name: getattr(m, name)(x, Q)
          for name in ("bias", "elastic_forces", "energies", "losses", "power_lost", "momentum", "forward_dynamics",
                       "forward_dynamics_derivatives")),
    ],
    "v": [
        *(lambda m, x, name=name: getattr(m, name)(Q, x)
          for name in ("bias", "elastic_forces", "energies", "losses", "points", "linearize", "forward_dynamics",
                       "forward_dynamics_derivatives")),
    ],
    "a": [lambda m, x: m.inverse_dynamics(Q, Q, x), lambda m, x: m.points(Q, Q, x), lambda m, x: m.linearize(Q, Q, x)],
    "effort": [lambda m, x: m.forward_dynamics(Q, Q, x), lambda m, x: m.forward_dynamics_derivatives(Q, Q, x)],
    "step": [lambda m, x: m.forward_dynamics(Q, Q, step=x)],
    "wrenches": [lambda m, x: m.forward_dynamics(Q, Q, wrenches=x), lambda m, x: m.stiffness(Q, wrenches=x)],
    "base": [lambda m, x: m.forward_dynamics(Q, Q, base=x), lambda m, x: m.stiffness(Q, base=x)],
    "weights": [lambda m, x: m.forward_dynamics_vjp(Q, Q, weights=x)],
}  # fmt: skip


@pytest.fixture(scope="module")
def robot():
    return tmodes.load("spong1987")


@pytest.fixture(scope="module")
def model(robot):
    return tmodes.Model(robot.chain())


@pytest.mark.parametrize("value", [*NOT_NUMBERS.values(), *WRONG_SHAPES.values()], ids=[*NOT_NUMBERS, *WRONG_SHAPES])
@pytest.mark.parametrize("which", CALLS)
def test_functions_of_a_model_refuse_what_is_no_state(model, which, value):
    for call in CALLS[which]:
        with pytest.raises(InputError) as error:
            call(model, value)
        assert error.value.which == which
        assert "finite number" in error.value.expected


def test_nothing_in_place_of_a_state_is_refused(model):
    for call in CALLS["q"]:
        with pytest.raises(InputError, match="q"):
            call(model, None)


def test_directions_are_checked_as_the_inputs_are(model):
    for name in ("q", "v", "effort", "base", "parameters"):
        for value in ("ab", [np.nan] * 3, [1j] * 5):
            with pytest.raises(InputError) as error:
                model.forward_dynamics_jvp(Q, Q, directions={name: value})
            assert error.value.which == name


def test_numbers_of_any_real_kind_are_states(model):
    wanted = model.forward_dynamics([1.0, 2.0], [0.0, 0.0])
    for q in ((1, 2), np.array([1, 2], np.int8), np.array([1, 2], np.float32), [np.float64(1), 2]):
        assert np.array_equal(model.forward_dynamics(q, 0), wanted)
    assert np.array_equal(model.forward_dynamics([[1, 2], [1, 2]], 0), [wanted, wanted])


@pytest.mark.parametrize("value", [None, 3, 1.5, True, b"spong1987", [], {}, object()])
def test_what_names_no_robot_is_refused(value):
    with pytest.raises(InputError, match="name of a published robot, or the path of a file"):
        tmodes.load(value)


@pytest.mark.parametrize("value", [None, 3, "spong1987", {}, object()])
def test_what_is_no_robot_cannot_run(value, robot):
    for use in (tmodes.run, lambda x: tmodes.simulate_batch(x, {}), tmodes.forward_sensitivities):
        with pytest.raises(InputError, match=r"tmodes\.Robot"):
            use(value)
    with pytest.raises(InputError, match="chain of a robot"):
        tmodes.Model(value)


@pytest.mark.parametrize("value", [None, 3, [], "payload", {1: 2}, {None: 1}])
def test_changes_are_paths_and_values(robot, value):
    with pytest.raises(InputError):
        robot.with_(value)


@pytest.mark.parametrize("value", [*NOT_NUMBERS.values(), None, np.array([1.0]), np.array([np.nan, 0, 0]), 1j],
                         ids=lambda value: type(value).__name__)  # fmt: skip
def test_changes_to_what_is_no_number_are_refused(robot, value):
    with pytest.raises(InputErrors, match="gravity"):
        robot.with_({"gravity": value})


def test_changes_may_be_arrays(robot):
    assert robot.with_({"gravity": np.array([0.0, 0.0, -1.0])}) == robot.with_({"gravity": [0.0, 0.0, -1.0]})
    assert robot.with_({"integration.duration": np.float32(1)}) == robot.with_({"integration.duration": 1.0})


COPIES = {"pickle": lambda x: pickle.loads(pickle.dumps(x)), "copy": copy.copy, "deepcopy": copy.deepcopy}  # noqa: S301


@pytest.mark.parametrize("copied", COPIES.values(), ids=COPIES)
@pytest.mark.parametrize("name", ["spong1987", "filipovic2010", "flexarm1990"])
def test_robots_and_models_are_copied_without_compiled_code(name, copied):
    robot = tmodes.load(name)
    assert copied(robot) == robot
    model = tmodes.Model(robot.chain())
    model.mass_matrix(np.zeros(model.nq))
    again = copied(model)
    q = np.linspace(0.01, 0.02, model.nq)
    assert "passes" not in vars(again)
    assert np.array_equal(again.forward_dynamics(q, q), model.forward_dynamics(q, q))


def test_results_are_copied_with_their_record(robot):
    result = tmodes.run(robot.with_({"integration.duration": 0.02}))
    for copied in COPIES.values():
        again = copied(result)
        assert again.data.identical(result.data)
        assert again.summary() == result.summary()
        assert again.robot == result.robot


def test_a_pickled_robot_is_checked_when_it_is_read(robot):
    text = pickle.dumps(robot, 0).replace(b"spong1987", b"spong\\u00077")
    with pytest.raises(InputErrors):
        pickle.loads(text)  # noqa: S301


def test_the_module_is_the_command():
    done = subprocess.run([sys.executable, "-m", "tmodes", "--version"], capture_output=True, text=True, check=True)
    assert done.stdout == f"tmodes {tmodes.__version__}\n"
