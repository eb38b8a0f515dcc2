"""Runs in several modes against exact statements: locking, symmetry, linear theory, moments."""

from dataclasses import replace

import numpy as np
import pytest
from scipy.linalg import eig, expm

from squat.coupling import State, repeated
from squat.errors import InputError
from squat.fluid.energy import ShipEnergy
from squat.fluid.potential import PotentialFluid
from squat.fluid.ship import about_gravity, check_stability
from squat.mesh import subdivided, submesh
from squat.mesh.limits import PITCH
from squat.records import plain, read, read_group, save
from squat.records.transient_kinds import TRANSIENT
from squat.transient.parts import prepare
from squat.transient.run import run

TWO = "modes=[heave,pitch]"
THREE = "modes=[surge,heave,pitch]"
LOCKED = "held=[pitch]"


@pytest.mark.parametrize("coupling", ["printed", "printed_euler"])
def test_with_pitch_locked_the_heave_run_comes_back_bit_for_bit(ship, coupling):
    keys = "current=2", f"coupling={coupling}", "time.periods=0.3"
    alone = run(ship(*keys)).dataset
    locked = run(ship(*keys, TWO, LOCKED)).dataset
    assert alone.attrs["status"] == locked.attrs["status"] == "completed"
    for name in ("heave", "heave_velocity", "heave_acceleration", "fluid_force", "iterations"):
        assert np.array_equal(alone[name], locked[name])
    assert np.array_equal(alone["hull_pressure"], locked["hull_pressure"])
    assert np.all(locked["pitch"] == 0)


def test_with_pitch_locked_other_couplings_agree_to_what_the_flow_is_solved_to(ship):
    """They ask for the water's inertia too, so that solves start elsewhere."""
    keys = "current=2", "coupling=consistent", "time.periods=0.3"
    alone = run(ship(*keys)).dataset
    locked = run(ship(*keys, TWO, LOCKED)).dataset
    assert float(abs(alone["heave"] - locked["heave"]).max()) < 1e-9


def test_heave_alone_leaves_pitch_at_zero_where_all_is_symmetric(ship):
    """On a mesh that is its own mirror image: a bottom point amidships makes the coarse one so."""
    case = ship(
        "current=0", TWO, "free_surface=zero_pressure", "initial_heave=-1",
        "channel.downstream=40", "channel.bottom=[[20,0]]", "coupling.criterion.tolerance=1e-12",
        "accelerator@coupling.accelerator=aitken",
    )  # fmt: skip
    parts = prepare(case)
    mirrored = subdivided(submesh(case.hull, case.channel, case.modes), 6)
    mesh = about_gravity(mirrored, case.hull)
    fluid = PotentialFluid(mesh, case.water, case.free_surface, case.current)
    problem = replace(parts.problem, fluid=fluid)
    parts = replace(parts, problem=problem, loop=replace(parts.loop, problem=problem), fluid=fluid)
    motion, memory = problem.at_rest(*case.start, parts.dt)
    state = State((motion,), memory)
    steps = list(repeated(parts.advance, state, 40))
    ends = np.array([step.state.motion.position for step in steps])
    assert len(steps) == 40
    assert ends[:, 0].max() > 0.3
    assert np.abs(ends[:, 1]).max() < 1e-9


def linear_matrices(case):
    """M, Gam and K of small motion about q = 0 in still water."""
    parts = prepare(case)
    q = np.zeros(len(case.modes))
    body = parts.problem.body
    still = check_stability(parts.fluid.mesh.submesh, body, case.water)
    system = ShipEnergy(body, still, parts.fluid, 0.0)
    return system.mass(q), still.stiffness


def test_small_motion_is_that_of_the_linearised_system(ship):
    """Newmark is second order: at 280 steps a period the error is below 1e-3 of the amplitude."""
    case = ship(
        "current=0", TWO, "coupling=consistent", "initial_heave=-1e-4", "initial_pitch=1e-5",
        "time.steps_per_period=280", "time.periods=1", "coupling.criterion.tolerance=1e-12",
    )  # fmt: skip
    M, K = linear_matrices(case)
    data = run(case).dataset
    zero, one = np.zeros((2, 2)), np.eye(2)
    A = np.block([[zero, one], [-np.linalg.solve(M, K), zero]])
    start = np.array([-1e-4, 1e-5, 0, 0])
    exact = np.array([expm(A * t) @ start for t in data["time"].values])
    for name, column, size in (("heave", 0, 1e-4), ("pitch", 1, 1e-5)):
        assert np.abs(data[name].values - exact[:, column]).max() < 3e-3 * size
    frequencies = np.sqrt(np.sort(eig(K, M)[0].real))
    assert frequencies[1] > 1.2 * frequencies[0]  # two motions, told apart by the run above


def test_moment_balances_the_angular_acceleration(ship):
    """I_G theta'' is the moment about the centre of gravity at every level (all terms there)."""
    case = ship("current=1.5", TWO, "coupling=consistent", "initial_pitch=0.01", "time.periods=0.3")
    data = run(case).dataset
    left = float(data["ship_inertia"]) * data["pitch_acceleration"]
    apart = abs(left - data["pitch_moment"])[1:]
    assert float(apart.max()) < 1e-5 * float(abs(data["pitch_moment"]).max())


def test_restoring_moment_of_still_water_is_the_ships_own(ship):
    case = ship("current=0", TWO, "initial_heave=0", "initial_pitch=1e-4")
    parts = prepare(case)
    _, net = parts.problem.steady(*case.start)
    rho, g, L, T = 1000.0, 9.81, 40.0, 10.0
    # G at mid-draft is B: what remains is the water plane's second moment.
    assert net[1] == pytest.approx(-rho * g * L**3 / 12 * 1e-4, rel=1e-3)
    above = ship("current=0", TWO, "initial_pitch=1e-4", "initial_heave=0",
                 "hull.gravity_center=[20,-3]")  # fmt: skip
    _, lifted = prepare(above).problem.steady(*above.start)
    stiffness = rho * g * (L**3 / 12 + L * T * (-5 + 3))
    assert lifted[1] == pytest.approx(-stiffness * 1e-4, rel=1e-3)


def test_held_surge_keeps_its_speed_and_a_mooring_holds_it_back(ship):
    keys = "current=1", THREE, "time.periods=0.3", "coupling=consistent"
    towed = run(ship(*keys, "held=[surge]", "surge_velocity=0.5")).dataset
    assert towed["surge"].values == pytest.approx(0.5 * towed["time"].values, rel=1e-12)
    assert float(abs(towed["surge_force"]).max()) > 0
    soft, stiff = (
        run(ship(*keys, "surge_velocity=0.5", f"mooring={k}")).dataset for k in (0.0, 1e7)
    )
    assert float(abs(stiff["surge"]).max()) < 0.5 * float(abs(soft["surge"]).max())


def test_a_towed_ship_feels_the_current_less_its_own_speed(ship):
    """Galilei: V = 1.5 at surge velocity 0.5 is V = 1 at rest, but for the channel's ends."""
    towed = ship("current=1.5", THREE, "held=[surge]", "surge_velocity=0.5", "initial_heave=-1")
    still = ship("current=1", THREE, "held=[surge]", "initial_heave=-1")
    parts = prepare(towed)
    q, velocity = towed.start
    h = 1e-4
    ahead, behind = (parts.fluid.flow(q + s * h * velocity, velocity).potential for s in (1, -1))
    flow = parts.fluid.flow(q, velocity)
    moving = parts.fluid.force(flow, (ahead - behind) / (2 * h))
    _, net = (other := prepare(still)).problem.steady(*still.start)
    resting = net + other.problem.body.gradient(q)
    weight = towed.mass * 9.81
    # exp(-pi 40 m/20 m) is the share of the ends in the flow at bow and stern.
    assert moving[1] - weight == pytest.approx(resting[1] - weight, rel=5e-3)


def test_too_much_trim_ends_the_run_by_name(ship):
    data = run(ship("current=0", TWO, f"initial_pitch={0.99 * PITCH}", "time.periods=1")).dataset
    assert data.attrs["status"] == "overtrimmed"


def test_run_in_two_modes_round_trips_and_has_its_snapshots(ship, tmp_path):
    case = ship("current=1", TWO, "initial_pitch=0.002", "time.periods=0.1", "snapshots=3")
    result = run(case)
    path = tmp_path / "run.nc"
    save(result.dataset, path, plain(case), 0.0, {"fields": result.fields})
    back = read(path, TRANSIENT)
    assert back.attrs["modes"].split() == ["heave", "pitch"]
    assert np.array_equal(back["pitch"], result.dataset["pitch"])
    fields = read_group(path, "fields")
    keel = np.abs(fields["z"][0] - 10 + 0.1) < 0.05
    assert bool(keel.any())


@pytest.mark.parametrize(
    ("keys", "message"),
    [
        (["modes=[pitch]"], r"modes=\['pitch'\]: give heave"),
        (["modes=[pitch,heave]"], "in the order surge, heave, pitch"),
        (["initial_pitch=0.1"], "initial_pitch=0.1: pitch is not in modes"),
        (["mooring=1.0"], "mooring=1: surge is not in modes"),
        (["held=[pitch]"], "pitch is not in modes"),
    ],
)
def test_modes_that_make_no_sense_are_refused_by_name(ship, keys, message):
    with pytest.raises(InputError, match=message):
        ship(*keys)


def test_a_ship_that_would_turn_over_is_refused(ship):
    with pytest.raises(InputError, match=r"hull.gravity_center: so high"):
        prepare(ship(TWO, "hull.gravity_center=[20,12]"))
