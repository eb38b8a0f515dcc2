"""The reduced model against the full mesh: ratios within one run, and how both grow.

`make benchmark` leaves the figure of the growth in .benchmarks/reduced_scaling.png.
"""

import time
from dataclasses import replace
from pathlib import Path

import matplotlib as mpl
import numpy as np
from matplotlib.figure import Figure
from scipy.sparse.linalg import splu

from squat.channel import Channel, Rectangle
from squat.config import compose, validate
from squat.coupling import repeated
from squat.dynamics import RigidBody
from squat.dynamics.energy_momentum import Phase, advance
from squat.dynamics.one_mode import trajectory
from squat.figures.style import BLUE, GREEN, ORANGE, RED, SETTINGS
from squat.fluid.curves import Curves
from squat.fluid.energy import ShipEnergy, still_water
from squat.fluid.heave import HeaveEnergy
from squat.fluid.model import Flow
from squat.fluid.potential import PotentialFluid
from squat.fluid.variational import UnitFlows
from squat.mesh import subdivided, submesh
from squat.reduced import Simulator, Training, reduce
from squat.reduced.box import BoxSize
from squat.reduced.record import on_patch, to_record
from squat.reduced.run import make
from squat.transient.parts import prepare
from squat.transient.run import start
from squat.water import Water

STEPS, DT, CURRENT = 12, 0.2, 2.0
"""Time steps of the runs that are compared, their size [s], and V [m/s]."""
PERIOD = 70
"""Time steps of one period in the default run."""
FIGURE = Path(__file__).parents[1] / ".benchmarks" / "reduced_scaling.png"
WATER = Water(density=1000.0, gravity=9.81)
CHANNEL = Channel(depth=20.0, upstream=40.0, downstream=60.0)
TRAINING = Training(
    box=BoxSize(clearance=0.1, pitch=0.0, points=60, pitch_points=1), tolerance=1e-9, positions=6
)
"""A small model: what is shown is how the cost grows."""


class PlainFluid(PotentialFluid):
    """scikit-fem assembly on the moved mesh and a fresh scipy factorisation at each position."""

    def unit_flows(self, position):
        last = self._last
        if last is None or not np.array_equal(last.position, position):
            loads = self._loads.at(position)
            rows = np.vstack([self.inflow, loads])
            free = self._lid.free
            matrix = self.space.at(self.mesh.moved(position)).stiffness()[free][:, free].tocsc()
            found = np.zeros_like(rows)
            found[:, free] = splu(matrix).solve(rows[:, free].T).T
            theta = self._affine.theta(position)
            last = self._last = UnitFlows(np.array(position), theta, loads, found[0], found[1:])
        return last

    def flow(self, position, velocity):
        flows = self.unit_flows(position)
        potential = self.current * flows.current + velocity @ flows.unit
        return Flow(position, velocity, potential)


def seconds(work, repeat=1):
    times = []
    for _ in range(repeat):
        began = time.perf_counter()
        work()
        times.append(time.perf_counter() - began)
    return min(times)


def ship(model):
    mesh, water, body = model.mesh, model.water, RigidBody(("heave",), 400e3, 0.0, 9.81)
    return ShipEnergy(body, still_water(mesh.submesh, water), model, CURRENT)


def stepped(model):
    """Heave over STEPS energy-momentum steps on the full mesh, and the time that they took."""
    energy, phases = ship(model), [Phase(np.array([-0.1]), np.zeros(1))]

    def march():
        for _ in range(STEPS):
            phases.append(advance(energy, phases[-1], DT, np.ones(1)).phase)

    took = seconds(march)
    return np.array([phase.position[0] for phase in phases]), took


def test_reduced_run_is_a_thousand_times_the_plain_and_fifty_times_the_fast_one(note):
    """One ship, one scheme (energy_momentum), the same steps."""
    case = validate(compose("reduced")).case
    began = time.perf_counter()
    made, mesh = make(case)
    offline = time.perf_counter() - began
    fast = PotentialFluid(mesh, WATER, "rigid_lid", CURRENT)
    plain = PlainFluid(mesh, WATER, "rigid_lid", CURRENT)
    fast.coefficients(np.zeros(1))
    w_plain, t_plain = stepped(plain)
    w_fast, t_fast = stepped(fast)
    water = on_patch(made, mesh).fluid(WATER, CURRENT)
    began = time.perf_counter()
    curves = Curves.of(water, -9.9, 4.9, 32)
    plane = HeaveEnergy(replace(ship(fast), model=curves))
    ready = time.perf_counter() - began
    track = trajectory(plane, -0.1, 0.0, DT, STEPS)
    t_reduced = seconds(lambda: trajectory(plane, -0.1, 0.0, DT, STEPS), 15)
    simulator = Simulator(on_patch(made, mesh), WATER, -0.1, CURRENT)
    t_step = seconds(lambda: [simulator.step(0.05, CURRENT) for _ in range(1000)], 7) / 1000
    size = to_record(made, len(mesh.points)).nbytes
    note("plain over reduced run, energy step", f"{t_plain / t_reduced:.0f}", "1000")
    note("fast over reduced run, energy step", f"{t_fast / t_reduced:.0f}", "50")
    note("full solves offline", f"{len(made.rounds)}", "at most 20")
    note("offline over a fast run of 210 steps", f"{offline * STEPS / t_fast / 210:.2f}")
    note("curves over offline", f"{ready / offline:.3f}")
    note("model without field basis, MB", f"{size / 1e6:.2f}", "below 1")
    note("step of the energy run, microseconds", f"{t_reduced / STEPS * 1e6:.0f}", "some 20")
    note("step of the simulator, microseconds", f"{t_step * 1e6:.0f}", "some 20")
    assert np.abs(w_plain - track.position).max() < 1e-7
    assert np.abs(w_fast - track.position).max() < 1e-7
    assert t_plain / t_reduced > 1000
    assert t_fast / t_reduced > 50
    assert len(made.rounds) <= 20
    assert size < 1e6


def coupled(model):
    """The default run, by pressure: its heave over a number of steps, and a timed march."""
    case = validate(
        compose("transient", f"model={'reduced' if model == 'reduced' else 'full'}")
    ).case
    parts = prepare(case)
    if model == "plain":
        fluid = PlainFluid(parts.fluid.mesh, case.water, case.free_surface, case.current)
        problem = replace(parts.problem, fluid=fluid)
        parts = replace(parts, problem=problem, loop=replace(parts.loop, problem=problem))
    state = start(case, parts)
    parts.advance(state)

    def heave(steps):
        found = list(repeated(parts.advance, state, steps))
        assert len(found) == steps
        return np.array([step.state.motion.position[0] for step in found])

    return heave


def test_reduced_pressure_run_is_hundreds_of_times_the_plain_and_tens_of_times_the_fast_one(note):
    """The default scheme (printed), through the coupling loop, over the same steps."""
    plain, fast, reduced = map(coupled, ("plain", "fast", "reduced"))
    t_plain = seconds(lambda: plain(STEPS), 3)
    t_fast = seconds(lambda: fast(PERIOD), 3)
    t_first = seconds(lambda: reduced(STEPS), 15)
    t_reduced = seconds(lambda: reduced(PERIOD), 15)
    note("plain over reduced run, printed scheme", f"{t_plain / t_first:.0f}", "1000")
    note("fast over reduced run, printed scheme", f"{t_fast / t_reduced:.0f}", "50")
    note("step of that run, microseconds", f"{t_reduced / PERIOD * 1e6:.0f}")
    assert np.abs(plain(STEPS) - reduced(STEPS)).max() < 1e-7
    assert np.abs(fast(PERIOD) - reduced(PERIOD)).max() < 1e-7
    assert t_plain / t_first > 400
    assert t_fast / t_reduced > 30


def costs(n):
    """Costs [s] on a structured mesh of some 6 n^2 nodes: plain, fast, offline, one answer."""
    coarse = submesh(Rectangle(length=40.0, draft=10.0), CHANNEL, ("heave",))
    mesh = subdivided(coarse, n)
    fast, plain = (kind(mesh, WATER, "rigid_lid", 0.0) for kind in (PotentialFluid, PlainFluid))
    places = np.linspace(-0.1, -0.2, 5)
    fast.coefficients(np.zeros(1))
    began = time.perf_counter()
    made = reduce(mesh, 1000.0, "rigid_lid", TRAINING)
    offline = time.perf_counter() - began
    return {
        "nodes": len(mesh.points),
        "plain": seconds(lambda: plain.coefficients(places[:1])),
        "fast": seconds(lambda: [fast.coefficients(np.array([w])) for w in places]) / len(places),
        "offline": offline,
        "reduced": seconds(lambda: [made.model.energies(np.array([w])) for w in places], 5)
        / len(places),
    }


def test_growth_with_nodes_and_runs(note):
    table = [costs(n) for n in (13, 41, 130, 225)]
    nodes = np.array([row["nodes"] for row in table])
    kinds = ("plain", "fast", "offline", "reduced")
    times = {kind: np.array([row[kind] for row in table]) for kind in kinds}
    slopes = {kind: np.polyfit(np.log(nodes), np.log(times[kind]), 1)[0] for kind in kinds}
    FIGURE.parent.mkdir(exist_ok=True)
    with mpl.rc_context(SETTINGS):
        draw(nodes, times, slopes).savefig(FIGURE)
    for kind, slope in slopes.items():
        wanted = "ideal 0" if kind == "reduced" else "ideal 1"
        note(f"growth with nodes, {kind}: exponent", f"{slope:.2f}", wanted)
    note("figure of the growth", str(FIGURE.relative_to(FIGURE.parents[1])))
    assert nodes[-1] > 3e5
    assert abs(slopes["reduced"]) < 0.2
    assert slopes["plain"] > 0.8


def draw(nodes, times, slopes):
    """Cost of one position against nodes, and of many runs against their number."""
    figure = Figure(figsize=(9.6, 4.2), layout="constrained")
    left, right = figure.subplots(1, 2)
    marks = {"plain": "s", "fast": "o", "offline": "^", "reduced": "D"}
    names = {"plain": "full, plain", "fast": "full, kept factor", "offline": "reduced, offline"}
    for (kind, mark), color in zip(marks.items(), (RED, ORANGE, BLUE, GREEN), strict=True):
        label = f"{names.get(kind, 'reduced, online')}: exponent {slopes[kind]:.2f}"
        left.loglog(nodes, times[kind], mark + "-", color=color, label=label)
    left.loglog(
        nodes, times["plain"][0] * nodes / nodes[0], "k:", lw=1, label="ideal: exponents 1, 0"
    )
    left.loglog(nodes, np.full(len(nodes), times["reduced"][0]), "k:", lw=1)
    runs, evaluations = np.geomspace(1, 1e4, 30), 210 * 4
    for place, style in ((1, "-"), (-1, "--")):
        full = runs * evaluations * times["fast"][place]
        cheap = times["offline"][place] + runs * evaluations * times["reduced"][place]
        for name, cost, color in (("full", full, ORANGE), ("reduced", cheap, GREEN)):
            ends = [np.log(cost[i + 1] / cost[i]) / np.log(runs[1] / runs[0]) for i in (0, -2)]
            label = f"{name}, {nodes[place]} nodes: exponent {ends[0]:.2f} to {ends[1]:.2f}"
            right.loglog(runs, cost, style, color=color, label=label)
    left.set(xlabel="nodes", ylabel="time for one position [s]")
    right.set(
        xlabel="runs of 210 steps, 4 iterations each",
        ylabel="time from the costs on the left, offline included [s]",
    )
    left.legend(fontsize=8)
    right.legend(fontsize=8)
    return figure
