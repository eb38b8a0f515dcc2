"""The numbered points of section 3.6, and what the conclusions say of the coupled runs."""

import json
import re

import numpy as np
import xarray as xr

from squat import published
from squat.analysis import balances
from squat.analysis.claims import Finding, Sources, claim, holds
from squat.analysis.verdict import INCONSISTENT, NOT_RUN
from squat.quantities import Vector


def _stable(sources: Sources) -> list[xr.Dataset]:
    return [run for run in sources.runs("printed") if run.attrs["status"] == "completed"]


def _speed(run: xr.Dataset) -> str:
    return f"{run.attrs['current']:g} m/s"


def turning_points(time: Vector, w: Vector) -> Vector:
    """Times at which w turns, by a parabola through the three samples around each."""
    slope = np.diff(w)
    at = np.flatnonzero(slope[:-1] * slope[1:] < 0) + 1
    left, middle, right = w[at - 1], w[at], w[at + 1]
    shift = (left - right) / (2 * (left - 2 * middle + right))
    return np.asarray(time[at] + shift * (time[1] - time[0]))


def period(run: xr.Dataset) -> float:
    """Twice the mean time between turning points [s]; NaN with fewer than two."""
    turns = turning_points(run["time"].values, run["heave"].values)
    return float(2 * np.diff(turns).mean()) if turns.size > 1 else float("nan")


def mean(x: Vector, values: Vector, low: float, high: float) -> float:
    """Mean from `low` to `high` of what is linear between the ascending `x`."""
    at = np.concatenate([[low], x[(x > low) & (x < high)], [high]])
    return float(np.trapezoid(np.interp(at, x, values), at) / (high - low))


@claim("correction_required")
def _(sources: Sources) -> Finding:
    runs = sources.runs("printed_standard")
    first = [run.attrs["status"] == "diverged" and run.sizes["time"] == 1 for run in runs]
    factors = ", ".join(f"{float(run['failed_contraction']):.3g}" for run in runs)
    here = f"diverges in the first step at {sum(first)} of {len(runs)} speeds"
    return Finding(here, f"measured G = {factors}", holds(bool(first) and all(first)))


@claim("mean_sinkage")
def _(sources: Sources) -> Finding:
    found = []
    for run in _stable(sources):
        turns = turning_points(run["time"].values, run["heave"].values)
        extremes = np.interp(turns, run["time"].values, run["heave"].values)
        found.append((run, float(extremes[:2].mean()) if len(extremes) > 1 else float("nan")))
    deeper = [mean < float(run["stable_root"]) for run, mean in found]
    text = "; ".join(
        f"{mean:.3f} m against {float(run['stable_root']):.3f} m at {_speed(run)}"
        for run, mean in found
    )
    note = "mean of two extremes; 'higher' read as deeper: the 2D suction is larger"
    return Finding(text, note, holds(bool(deeper) and all(deeper)))


@claim("pressure_ends")
def _(sources: Sources) -> Finding:
    run = _stable(sources)[0]
    keel = run["hull_z"].values <= float(run["hull_z"].min()) + 1e-9
    x, p = run["hull_x"].values[keel], run["hull_pressure"].values[-1, keel]
    order = np.argsort(x)
    bow, length = float(x.min()), float(np.ptp(x))
    fore, middle, aft = (
        mean(x[order], p[order], bow + begin * length, bow + end * length)
        for begin, end in ((0, 1 / 10), (1 / 4, 3 / 4), (9 / 10, 1))
    )
    drop = middle - (fore + aft) / 2
    text = f"lower by {drop:.0f} Pa over the outer tenths than over the middle half"
    return Finding(text, f"means over the length at {_speed(run)}, end of the run", holds(drop > 0))


_ALIKE = 1.5
"""Ratio of two rates of growth up to which they count as one, as exponential growth has it."""


@claim("iterations_grow")
def _(sources: Sources) -> Finding:
    run = sources.runs("printed")[-1]
    count = run["iterations"].values[1:]
    quarter = len(count) // 4
    early, late = (
        float(np.log(count[-1 - n * quarter] / count[-1 - (n + 1) * quarter])) for n in (1, 0)
    )
    text = f"from {count[0]} to {count[-1]} a step before the run ends ({run.attrs['status']})"
    note = (
        f"{np.exp(late):.2g}-fold over the last quarter of the steps, {np.exp(early):.2g}-fold "
        "over that before, where exponential growth has equal factors: it runs away faster, since "
        "the count has a pole where |G|, which grows with the water's inertia as the ship falls, "
        f"is 1; {_speed(run)}"
    )
    return Finding(text, note, holds(bool(0 < late < _ALIKE * early)))


@claim("longer_period")
def _(sources: Sources) -> Finding:
    runs = _stable(sources)
    linear = 2 * np.pi / float(runs[0]["omega"])
    share = float(runs[0]["fluid_inertia"][0] / runs[0]["ship_mass"])
    text = ", ".join(f"{period(run):.2f} s at {_speed(run)}" for run in runs)
    note = (
        f"twice the mean time between turning points; linear: {linear:.2f} s; under the lid the "
        f"water has {share:.1f} ship masses, not the m_add of (23): that, more than the "
        "nonlinearity the paper names, makes the difference"
    )
    return Finding(text, note, holds(all(period(run) > linear for run in runs)))


@claim("energy_balance")
def _(sources: Sources) -> Finding:
    runs = sources.runs("printed")
    shares = [balances.own_gap(run) / balances.initial(run) for run in runs]
    text = ", ".join(
        f"{100 * share:.2g} % at {_speed(run)}" for share, run in zip(shares, runs, strict=True)
    )
    over = ", ".join(f"{100 * balances.own_gap(run) / balances.kinetic(run):.3g} %" for run in runs)
    note = (
        "first order in dt, because w' stands a step behind w; any force history satisfies this "
        "balance: it does not show that the water keeps its energy. Over the largest kinetic "
        f"energy of ship and water in heave: {over}"
    )
    return Finding(f"closes to {text}, of E_0", note, holds(max(shares) < 5e-3))


@claim("stable_speeds")
def _(sources: Sources) -> Finding:
    runs = sources.runs("printed")
    found = [
        "stable" if run.attrs["status"] == "completed" else f"lost ({run.attrs['status']})"
        for run in runs
    ]
    here = ", ".join(f"{word} at {_speed(run)}" for word, run in zip(found, runs, strict=True))
    *stable, lost = _printed_currents()  # the fastest is lost
    run_at = {run.attrs["current"]: run.attrs["status"] == "completed" for run in runs}
    missing = [f"{current:g}" for current in (*stable, lost) if current not in run_at]
    note = f"not run: {', '.join(missing)} m/s" if missing else ""
    expected = dict.fromkeys(stable, True) | {lost: False}
    agrees = all(run_at[current] == fate for current, fate in expected.items() if current in run_at)
    return Finding(here, note, NOT_RUN if agrees and missing else holds(agrees))


def _printed_currents() -> list[float]:
    """Currents of Fig. 11 [m/s], slowest first, as the sentence has them."""
    sentence = published.claims().loc["stable_speeds", "claim"]
    return [float(number) for number in re.findall(r"[\d.]+", str(sentence))]


@claim("precision_order")
def _(sources: Sources) -> Finding:
    text = []
    changed = False
    for name in ("printed", "printed_euler", "printed_backward"):
        for run in sources.runs(name)[:1]:
            status, count = run.attrs["status"], run["iterations"].values[1:]
            mean = f", {count.mean():.1f} iterations a step" if count.size else ""
            changed |= status != "completed" or (count.size > 0 and count.mean() > 8)
            text.append(f"{name}: {status}{mean}")
    note = "the results use coupling=printed: second order, centred; second order backward diverges"
    return Finding("; ".join(text), note, holds(changed))


@claim("corrected_converges")
def _(sources: Sources) -> Finding:
    lost = [run for run in sources.runs("printed") if run.attrs["status"] != "completed"]
    if not lost:
        return Finding("converges in all runs", "", holds(condition=True))
    run = lost[0]
    text = f"does not at {_speed(run)}, below w = {float(run['heave'][-1]):.3f} m"
    note = f"the next step has G = {float(run['failed_contraction']):.3f}"
    if run.attrs["status"] == "iteration limit":
        limit = json.loads(run.attrs["config"])["coupling"]["criterion"]["iterations"]
        note += f" and meets the limit of {limit} iterations"
    note += "; |G| grows with the water's inertia and passes 1 soon after (docs/theory/coupled.md)"
    return Finding(text, note, holds(condition=False))


@claim("added_mass_run")
def _(sources: Sources) -> Finding:
    run = sources.transients[0]
    ratio = float(run["added_mass"] / run["ship_mass"])
    inertia = float(run["fluid_inertia"][0] / run["ship_mass"])
    text = f"m_add/m = {ratio:.6g}; the coupled water has {inertia:.4g} ship masses"
    note = (
        "zero pressure (23) at w = 0, extrapolated; rigid lid (19) at w(0) on the mesh of the run, "
        "convergence.nc has it at w = 0, extrapolated"
    )
    return Finding(text, note, holds(ratio > 1))


@claim("ship_tolerance")
def _(sources: Sources) -> Finding:
    run = sources.runs("printed")[0]
    used = float(json.loads(run.attrs["config"])["coupling"]["criterion"]["tolerance"])
    note = "section 3.6 states the value used here"
    for loose in sources.runs("printed_loose")[:1]:
        apart = float(abs(loose["heave"].values - run["heave"].values).max())
        mean = loose["iterations"].values[1:].mean()
        note += f"; with 1e-4 m: {mean:.1f} iterations a step, w off by up to {apart:.1e} m"
    return Finding(used, note, INCONSISTENT)
