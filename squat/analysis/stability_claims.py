"""What the energies of ship and water say about three of the paper's conclusions."""

import numpy as np

from squat.analysis import balances
from squat.analysis.claims import Finding, Sources, claim, holds
from squat.analysis.verdict import INCONSISTENT
from squat.dynamics import INTEGRATORS
from squat.fluid.rates import RATES
from squat.records import config_of


@claim("safe_speed")
def _(sources: Sources) -> Finding:
    data = sources.limits.set_index(limit="limit")
    speed, error = data["limit_speed"], data["limit_error"]
    one, two, dynamic = (float(speed.sel(limit=name)) for name in ("1D", "2D", "dynamic"))
    start = config_of(sources.limits)["start"]
    note = (
        f"a ship set free at w(0) = {start['heave']:g} m is lost above this (+- "
        f"{float(error.sel(limit='dynamic')):.0e}); 2D equilibria merge at {two:.6g} (+- "
        f"{float(error.sel(limit='2D')):.0e}), 1D at {one:.6g}: {100 * (one / two - 1):.0f} % and "
        f"{100 * (one / dynamic - 1):.0f} % too high; runs that keep their energy "
        "(energy_momentum, variational) turn and ground 0.2 % on either side of their mesh's "
        "limit; the printed scheme damps, so its ships survive somewhat more"
    )
    return Finding(dynamic, note)


@claim("operator_inertia")
def _(sources: Sources) -> Finding:
    run = sources.runs("printed")[0]
    choice = config_of(run)["coupling"]
    integrator, rate = INTEGRATORS[choice["integrator"]], RATES[choice["potential_rate"]]
    beta = integrator.s1 * rate.s2 / integrator.s3
    water = float(run["fluid_inertia"][0] / run["ship_mass"])
    added = float(run["added_mass"] / run["ship_mass"])
    text = (
        f"in ship masses: (19) has {water:.4g}, (23) {added:.4g}; the centred reading feeds back "
        f"{beta:g} of the former, {beta * water:.4g}"
    )
    note = (
        "the scheme converges because that share happens to be m_add; as the ship sinks it grows, "
        "and backward differences, which feed back 3/4, diverge; (19) is at w(0) on the mesh of "
        "the run; convergence.nc has it at w = 0, extrapolated"
    )
    apart = abs(water / added - 1) > 0.1
    return Finding(text, note, INCONSISTENT if apart else holds(condition=True))


@claim("energy_exchange")
def _(sources: Sources) -> Finding:
    runs = sources.runs("printed")
    shares = [balances.whole_gap(run) / balances.kinetic(run) for run in runs]
    text = ", ".join(
        f"{100 * share:.2g} % at {run.attrs['current']:g} m/s"
        for share, run in zip(shares, runs, strict=True)
    )
    over = ", ".join(
        f"{100 * balances.whole_gap(run) / balances.initial(run):.2g} %" for run in runs
    )
    larger = all(balances.own_gap(run) > balances.whole_gap(run) for run in runs)
    step = ", here the larger one at every speed," if larger else ""
    note = (
        f"the gap of ship, water and the channel's ends. Over E_0, as Fig. 13 has it: {over}; its "
        "share of the kinetic energy falls where that grows faster. The sum of Fig. 13 is the "
        "ship's own balance, which any force satisfies. What that leaves"
        f"{step} goes with the time step; what the water makes up does not. force=variational "
        "with coupling=energy_momentum closes both"
    )
    said = f"open by {text}, of the largest kinetic energy of ship and water in heave"
    return Finding(said, note, holds(bool(np.isfinite(shares).all() and max(shares) < 0.01)))
