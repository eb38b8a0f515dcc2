"""Phase portrait and potential, read back: the point, its curve of energy, the separatrix."""

import numpy as np
import pytest

from squat import records
from squat.config import compose, validate
from squat.replay.landscape import Landscape
from squat.replay.runs import load
from squat.replay.style import ticked
from squat.transient.parts import prepare
from tests.replay.reading import one_each, reader_of, scalars

READ = 1e-6  # of a diagram's range: places are kept in single precision
ROUND_OFF = 1e-12  # of m g T: what a step of energy_momentum may lose


@pytest.fixture(scope="module")
def shown(record, entities, kept):
    return entities(record(kept)), records.read(kept)


@pytest.fixture(scope="module")
def energy(kept):
    """Energy of ship and water as the run's own problem has it, from new solves."""
    config = records.config_of(records.read(kept))
    keys = ("mesh=coarse", "accuracy.near=0.4", "force=variational", "model=curves")
    case = validate(compose("transient", *keys, f"current={config['current']}")).case
    problem = prepare(case).problem

    def of(w, velocity):
        q = np.array([w])
        return problem.energy.mass(q)[0, 0] * velocity**2 / 2 + problem.energy.potential(q)

    return of


def points(entity):
    return np.array(entity.rows["positions"])[:, 0]


def read_all(read, strips):
    return [np.column_stack(read(np.asarray(strip))) for strip in strips]


def test_the_point_has_heave_and_velocity_and_both_times_of_the_dataset(shown):
    found, data = shown
    ship = found["profiles/phase_portrait/ship"]
    w, velocity = reader_of(found, "phase_portrait")(points(ship))
    for here, name in ((w, "heave"), (velocity, "heave_velocity")):
        assert here == pytest.approx(data[name].values, abs=10 * READ)
    assert ship.time == pytest.approx(data["time"].values, abs=1e-9)
    assert ship.phase == pytest.approx(data["phase"].values, abs=1e-9)


def test_the_point_stays_on_the_curve_of_the_energy_that_the_run_keeps(shown, energy):
    """The curve is drawn from the record, E taken from the ship's own energies."""
    found, data = shown
    start = float(data["initial_energy"])
    weight = float(data["ship_mass"]) * 9.81 * 10
    assert float(abs(data["energy_residual"]).max()) < ROUND_OFF * weight
    read = reader_of(found, "phase_portrait")
    well = start - float(energy(float(data["stable_equilibrium"]), 0.0))
    ship = np.column_stack(read(points(found["profiles/phase_portrait/ship"])))
    curve = np.concatenate(
        read_all(read, found["profiles/phase_portrait/energy"].rows["strips"][0])
    )
    for w, velocity in (*ship, *curve[::7]):
        assert energy(w, velocity) - start == pytest.approx(0, abs=1e-4 * well)


def test_between_the_point_and_the_level_of_energy_is_what_is_kinetic(shown):
    found, data = shown
    read = reader_of(found, "potential")
    _, height = read(points(found["profiles/potential/ship"]))
    inertia = data["ship_mass"] + data["fluid_inertia"]
    kinetic = (inertia * data["heave_velocity"] ** 2 / 2).values / 1e3
    levels = np.array(
        [read(strip)[1] for strip in one_each(found["profiles/potential/energy"], "strips")]
    )
    span = np.ptp(levels) + np.ptp(height)
    assert np.ptp(levels) < 10 * READ * span
    assert levels[:, 0] - height == pytest.approx(kinetic, abs=20 * READ * span)
    bars = [read(strip)[1] for strip in one_each(found["profiles/potential/kinetic"], "strips")]
    assert np.array(bars) == pytest.approx(
        np.column_stack([height, levels[:, 0]]), abs=20 * READ * span
    )
    curve = np.concatenate(read_all(read, found["profiles/potential/potential"].rows["strips"][0]))
    chord = np.interp(data["heave"].values, *curve.T)
    assert chord == pytest.approx(height, abs=1e-4 * span)  # 400 chords, h^2 U''/8


def test_the_separatrix_passes_the_unstable_equilibrium_and_encloses_the_run(shown, energy):
    found, data = shown
    read = reader_of(found, "phase_portrait")
    strips = found["profiles/phase_portrait/separatrix"].rows["strips"][0]
    edge = np.concatenate(read_all(read, strips))
    unstable = float(data["unstable_equilibrium"])
    top = energy(unstable, 0.0)
    for w, velocity in edge[::11]:
        assert energy(w, velocity) == pytest.approx(top, rel=1e-4)
    gaps = np.hypot(edge[:, 0] - unstable, edge[:, 1])
    assert gaps.min() < 1e-4
    loop = edge[edge[:, 0] > unstable]
    assert loop[:, 0].max() > float(data["heave"].max())
    assert float(data["heave"].min()) > unstable
    place = np.column_stack(
        read(np.array(found["profiles/phase_portrait/unstable"].rows["positions"][0]))
    )
    assert place[0] == pytest.approx([unstable, 0], abs=1e-4)


def test_the_trail_is_a_period_of_the_time_scale_up_to_the_point(shown):
    found, data = shown
    ship = points(found["profiles/phase_portrait/ship"])
    strips = one_each(found["profiles/phase_portrait/trail"], "strips")
    period = records.config_of(data)["time"]["steps_per_period"]
    for n, strip in enumerate(strips[1:], 1):
        assert strip == pytest.approx(ship[max(0, n - period) : n + 1], abs=1e-4)


def test_terms_of_both_balances_are_those_of_the_dataset_and_sum_up(shown):
    found, data = shown
    terms = ("kinetic_energy", "water_energy", "static_energy", "stream_energy")
    names = ("ship", "water", "static", "stream")
    sums = -data["end_work"].values / 1e6
    for name, term in zip(names, terms, strict=True):
        here = scalars(found[f"plots/energy_audit/{name}"])
        assert np.array_equal(here, ((data[term] - data[term][0]) / 1e6).values)
        sums = sums + here
    assert scalars(found["plots/energy_audit/ends"]) == pytest.approx(-data["end_work"] / 1e6)
    assert scalars(found["plots/energy_audit/sum"]) == pytest.approx(sums, abs=1e-12 * 1e3)
    assert "plots/ship_energies/work" in found


def test_levels_turn_where_the_potential_is_the_energy(kept):
    (run,) = load((str(kept),))
    land = Landscape.of(run)
    bottom = float(land.potential(land.stable))
    level = bottom + 0.3 * (land.barrier - bottom)
    low, high = run.data["curve_heave"].values[[0, -1]]
    inner = [half for half in land.level(level, low, high) if half[0, 0] > land.unstable]
    (half,) = inner
    assert half[[0, -1], 1] == pytest.approx([0, 0], abs=1e-4)
    assert half[0, 0] < land.stable < half[-1, 0]
    assert land.potential(half[[0, -1], 0]) == pytest.approx([level] * 2, rel=1e-9)


def test_a_ship_of_several_modes_has_its_audit_and_no_portrait(record, entities, written):
    keys = ("mesh=coarse", "accuracy.near=0.4", "current=1", "time.periods=0.05")
    path = written("trim", "transient", *keys, "modes=[heave,pitch]")
    data = records.read(path)
    assert "curve_heave" not in data
    assert "initial_energy" in data
    found = entities(record(path))
    assert not [name for name in found if "phase_portrait" in name]
    assert "plots/energy_audit/sum" in found


def test_the_hull_that_is_drawn_turns_with_the_mesh_of_its_snapshots(record, entities, written):
    keys = ("mesh=coarse", "accuracy.near=0.4", "current=1", "time.periods=0.05", "snapshots=2")
    path = written("trimmed", "transient", *keys, "modes=[heave,pitch]", "initial_pitch=0.05")
    data, fields = records.read(path), records.read_group(path, "fields")
    found = entities(record(path))
    pitch = np.array(found["plots/pitch/pitch"].rows["scalars"])[:, 0]
    assert pitch == pytest.approx(np.rad2deg(data["pitch"].values), rel=1e-12)
    strips = found["channel/hull"].rows["strips"]
    assert len(strips) == fields.sizes["time"]
    for k, rows in enumerate(strips):
        outline = np.array(rows[0])[:, [0, 2]]
        corners = outline[np.argsort(outline[:, 1])[:2]]  # of the keel
        nodes = np.column_stack([fields[axis].values[k] for axis in "xz"])
        for corner in corners:
            apart = np.linalg.norm(nodes - corner, axis=1).min()
            assert apart < 1e-5  # single precision of some 100 m


@pytest.mark.parametrize(
    ("low", "high", "wide"), [(-9, 9, (-10, 10)), (-0.8, 0.7, (-1, 1)), (-6, 0.1, None)]
)
def test_axes_have_three_numbers_at_least(low, high, wide):
    found = ticked(low, high)
    assert found == pytest.approx(wide or (low, high), rel=0.05)
