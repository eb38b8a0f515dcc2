"""A user's structure and force: estimates are exact where theory is, and nothing is assumed."""

import importlib.util

import numpy as np
import pytest

import squat
from squat.coupling import Load
from squat.errors import InputError

M_F = np.array([[6.0, 2.0, 0.5], [2.0, 5.0, 1.0], [0.5, 1.0, 4.0]])
C = np.diag([0.3, 0.2, 0.1])
K = np.diag([40.0, 30.0, 20.0])
DT = 0.02


def water(motion, time, memory):
    return -M_F @ motion.acceleration - C @ motion.velocity - K @ motion.position


def heavy(**options):
    structure = squat.Structure(np.eye(3), stiffness=np.diag([50.0, 60.0, 70.0]))
    q = np.array([1.0, -0.5, 0.2])
    a = -np.linalg.solve(np.eye(3) + M_F, (structure.stiffness + K) @ q)
    given = {"position": q, "acceleration": a, "dt": DT, "steps": 10, "tolerance": 1e-12}
    return squat.couple(structure, water, **{**given, **options})


@pytest.fixture(scope="module")
def example(root):
    path = root / "docs" / "examples" / "external_fluid.py"
    spec = importlib.util.spec_from_file_location("external_fluid", path)
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def test_external_process_gives_newmarks_exact_oscillation(example):
    """w_n = w_0 cos(n theta), tan(theta/2) = omega dt/2: the discrete solution, to round-off."""
    data = example.run("estimated")
    theta = 2 * np.arctan(example.OMEGA * example.DT / 2)
    exact = example.RELEASED_AT * np.cos(theta * np.arange(example.STEPS + 1))
    assert data.attrs["status"] == "completed"
    assert data["position"].squeeze().values == pytest.approx(exact, abs=1e-11)
    assert int(data["iterations"].max()) <= 3


def test_external_process_is_too_heavy_for_the_standard_coupling(example):
    data = example.run("standard")
    assert data.attrs["status"] == "diverged"
    assert float(data["failed_contraction"]) == pytest.approx(
        float(data["predicted_contraction"]), rel=1e-6
    )


def test_external_process_ends_with_the_run(example):
    with example.LineProcess() as process:
        pass
    assert process.process.returncode == 0


def test_effective_added_mass_is_mass_damping_and_stiffness_of_the_force():
    """M_f + (s1/s3) dt C + (dt^2/s3) K with Newmark's s1 = 2, s3 = 4; without the structure's."""
    data = heavy(steps=1)
    expected = M_F + DT / 2 * C + DT**2 / 4 * K
    assert data["effective_added_mass"].values == pytest.approx(expected, abs=1e-9)
    assert float(data["predicted_contraction"]) == pytest.approx(0, abs=1e-9)


@pytest.mark.parametrize("accelerator", ["none", "anderson", "iqn_ils", "monolithic"])
@pytest.mark.parametrize("scheme", ["standard", "corrected", "estimated"])
def test_all_schemes_and_accelerators_give_one_history(scheme, accelerator):
    """That of the implicit equations, solved directly."""
    options = {"added_mass": 1.5 * M_F} if scheme == "corrected" else {}
    data = heavy(scheme=scheme, accelerator=accelerator, **options)
    if (scheme, accelerator) == ("standard", "none"):
        assert data.attrs["status"] == "diverged"
        return
    assert data.attrs["status"] == "completed"
    total, stiff = np.eye(3) + M_F, np.diag([90.0, 90.0, 90.0])
    q, v, a = (data[name].values[0] for name in ("position", "velocity", "acceleration"))
    for n in range(1, 11):
        ahead = q + DT * v + DT**2 / 4 * a, v + DT / 2 * a
        left = total + DT / 2 * C + DT**2 / 4 * stiff
        a = np.linalg.solve(left, -C @ ahead[1] - stiff @ ahead[0])
        q, v = ahead[0] + DT**2 / 4 * a, ahead[1] + DT / 2 * a
        assert data["position"].values[n] == pytest.approx(q, abs=1e-10)


def test_predicted_factor_is_the_measured_one_of_the_corrected_scheme():
    """One freedom: m_add = 2 of m_f = 9 on m = 3, spring solved implicitly."""
    data = squat.couple(
        squat.Structure(3.0, stiffness=5.0),
        lambda motion, time, memory: -9.0 * motion.acceleration,
        position=1.0,
        acceleration=-5 / 12,
        dt=0.1,
        steps=3,
        scheme="corrected",
        added_mass=4.0,
        predictor="hold",
    )
    predicted = (4 - 9) / (3 + 4 + 0.1**2 / 4 * 5)
    assert float(data["predicted_contraction"]) == pytest.approx(predicted, rel=1e-9)
    assert data["contraction"].values[1:] == pytest.approx(predicted, rel=1e-6)


def test_memory_and_time_advance_with_accepted_steps_only():
    seen = []

    def counting(motion, time, memory):
        seen.append((memory, time))
        return Load(-2.0 * motion.acceleration - 9.0 * motion.position**3, memory + 1)

    data = squat.couple(
        squat.Structure(1.0), counting, position=1.0, acceleration=-3.0, dt=0.1, steps=4, memory=0
    )
    assert data.attrs["status"] == "completed"
    assert set(seen) == {(n, (n + 1) * 0.1) for n in range(4)}
    assert len(seen) == 2 + int(data["iterations"].sum())


@pytest.mark.parametrize(
    ("options", "line"),
    [
        ({"scheme": "corrected"}, "scheme=corrected: give added_mass"),
        ({"added_mass": M_F}, "scheme=estimated: give added_mass"),
        ({"scheme": "corrected", "added_mass": 1.0}, r"added_mass: has shape \(1, 1\)"),
        ({"accelerator": "foo"}, "foo"),
        ({"scheme": "best"}, "scheme=best: unknown"),
        ({"integrator": "euler"}, "integrator=euler: unknown"),
        ({"predictor": "cubic"}, "predictor=cubic: unknown"),
        ({"dt": 0.0}, "dt=0: must be greater than 0"),
        ({"position": np.zeros(2)}, r"position: has shape \(2,\)"),
    ],
)
def test_bad_arguments_are_one_line(options, line):
    with pytest.raises(InputError, match=line) as found:
        heavy(**options)
    assert "\n" not in str(found.value)


@pytest.mark.parametrize(
    ("arguments", "line"),
    [
        ((0.0,), "mass=.*singular"),
        ((np.eye(2), 3.0), r"damping: must be finite numbers of shape \(2, 2\)"),
        ((1.0, 0.0, np.nan), "stiffness: must be finite"),
    ],
)
def test_impossible_structures_are_one_line(arguments, line):
    with pytest.raises(InputError, match=line):
        squat.Structure(*arguments)


def test_force_of_another_shape_is_one_line():
    with pytest.raises(InputError, match=r"fluid: answered a force of shape \(2,\)"):
        squat.couple(squat.Structure(1.0), lambda *_: np.zeros(2), position=1.0, dt=0.1, steps=1)


@pytest.mark.parametrize("scheme", ["standard", "estimated"])
@pytest.mark.parametrize("good", [0, 1, 2])
@pytest.mark.parametrize("value", [np.nan, np.inf])
def test_a_force_that_is_no_number_diverges_from_the_first_call_on(scheme, good, value, capfd):
    calls = []

    def failing(motion, time, memory):
        assert np.isfinite(motion.position).all()
        calls.append(time)
        return value if len(calls) > good else -2.0 * motion.acceleration

    data = squat.couple(squat.Structure(1.0), failing, position=1.0, dt=0.1, steps=3, scheme=scheme)
    assert data.attrs["status"] == "diverged"
    assert data.sizes["time"] == 1
    assert capfd.readouterr().err == ""  # LAPACK complains there


@pytest.mark.parametrize("answer", [([-1.0], (1, 2)), "x", {}, 1j])
def test_a_force_of_another_kind_is_one_line_that_names_it(answer):
    def odd(motion, time, memory):
        return answer

    kind = type(answer).__name__
    with pytest.raises(InputError, match=rf"^fluid=odd: answered a {kind} that is no force"):
        squat.couple(squat.Structure(1.0), odd, position=1.0, dt=0.1, steps=1)


@pytest.mark.parametrize("answer", [None, Load(None, 1)])
def test_a_force_that_is_forgotten_is_one_line_with_the_name_of_the_function(answer):
    def forgetful(motion, time, memory):
        return answer

    with pytest.raises(InputError, match=r"^fluid=forgetful: answered None; return the force"):
        squat.couple(squat.Structure(1.0), forgetful, position=1.0, dt=0.1, steps=1)
