"""The paper's checkable sentences, each computed from the datasets."""

import json
from collections.abc import Callable
from typing import NamedTuple

import numpy as np
import xarray as xr

from squat import published
from squat.analysis.piston_tables import CUT_OFF
from squat.analysis.verdict import DIFFERS, INCONSISTENT, MATCH, Verdict, judge
from squat.coupling.amplification import limit_mass_ratio
from squat.dynamics import INTEGRATORS, IntegratorName


class NotRunError(LookupError):
    """What a sentence is about is not among the datasets."""


class Sources(NamedTuple):
    """The datasets that claims are checked against."""

    iterations: xr.Dataset
    equilibria: xr.Dataset
    table4: xr.Dataset
    table5: xr.Dataset
    table6: xr.Dataset
    limits: xr.Dataset
    trim: xr.Dataset
    transients: tuple[xr.Dataset, ...]
    pitching: tuple[xr.Dataset, ...]

    def run(self, coupling: str, current: float) -> xr.Dataset | None:
        """The coupled run of that name at that current, or None."""
        for data in self.transients:
            if data.attrs["coupling"] == coupling and data.attrs["current"] == current:
                return data
        return None

    def runs(self, coupling: str) -> list[xr.Dataset]:
        """The coupled runs of that name with a current, slowest first."""
        found = [d for d in self.transients if d.attrs["coupling"] == coupling]
        return sorted((d for d in found if d.attrs["current"] > 0), key=_current)


class Finding(NamedTuple):
    """What we find: a number (judged by its digits unless `verdict` is given) or words."""

    here: float | str
    note: str = ""
    verdict: Verdict | None = None
    rounds_down: bool = False


def _current(data: xr.Dataset) -> float:
    return float(data.attrs["current"])


Check = Callable[[Sources], Finding]
CHECKS: dict[str, Check] = {}


def claim(name: str) -> Callable[[Check], Check]:
    """Register the check of the sentence `name` of published/claims.csv."""

    def register(check: Check) -> Check:
        CHECKS[name] = check
        return check

    return register


def holds(condition: bool) -> Verdict:
    """Return `match` where the sentence holds, `differs` otherwise."""
    return MATCH if condition else DIFFERS


def _limit(sources: Sources, integrator: IntegratorName) -> Finding:
    steps = json.loads(sources.iterations.attrs["config"])["time"]["steps_per_period"]
    limit = limit_mass_ratio(steps, INTEGRATORS[integrator])
    return Finding(limit, f"{steps} steps a period; tends to 1 as dt -> 0")


@claim("limit_mass_ratio")
def _(sources: Sources) -> Finding:
    return _limit(sources, "newmark")


@claim("limit_mass_ratio_centred")
def _(sources: Sources) -> Finding:
    return _limit(sources, "centred")


@claim("standard_divergence")
def _(sources: Sources) -> Finding:
    standard = sources.iterations.sel(added_mass_ratio=0)
    heavy = standard["status"].values[standard["mass_ratio"].values >= 1]
    return Finding(
        "diverges", f"{heavy.size} mass ratios run", holds(bool((heavy == "diverged").all()))
    )


@claim("unconditional")
def _(sources: Sources) -> Finding:
    corrected = sources.iterations.sel(added_mass_ratio=sources.iterations["added_mass_ratio"] > 0)
    lost = corrected["status"].values != "converged"
    if not lost.any():
        return Finding("no divergence in the cells run", "", MATCH)
    m_add, m_f = (corrected[name].values for name in ("added_mass_ratio", "mass_ratio"))
    row, column = np.argwhere(lost)[-1]
    return Finding(
        f"diverges at m_add/m_f = {m_add[row]:g}, m_f/m = {m_f[column]:g}",
        "its own amplification factor demands m_add > (m_f - m)/2 + dt^2 rho g S/4",
        INCONSISTENT,
    )


@claim("constant_iterations")
def _(sources: Sources) -> Finding:
    means = sources.iterations["mean_iterations"].sel(added_mass_ratio=1).values
    least, greatest = means.min(), means.max()
    beside = ", ".join(map(str, CUT_OFF.values()))
    note = f"the greatest of {means.size} mass ratios, {beside} beside Table 2's; "
    note += f"the least: {least:.6g}"
    return Finding(float(greatest), note, rounds_down=True)


@claim("optimum")
def _(sources: Sources) -> Finding:
    factor = sources.iterations["predicted_contraction"].sel(mass_ratio=1)
    # G is a fraction linear in m_add: its zero follows from the standard value and one other.
    at_zero, at_one = (float(factor.sel(added_mass_ratio=ratio)) for ratio in (0, 1))
    best = -at_zero / (2 * at_one - at_zero)
    return Finding(best, "G = 0 at m_add = m_f + dt^2 rho g S/2, here for m_f = m")


@claim("overestimate")
def _(sources: Sources) -> Finding:
    means = sources.iterations["mean_iterations"]
    double, half = (means.sel(added_mass_ratio=ratio).values for ratio in (2, 0.5))
    ratios = sources.iterations["mass_ratio"].values
    better = ratios[double < half]
    here = f"less penalizing at m_f/m = {better.min():g} and above" if better.size else "never"
    note = "mean iterations with m_add = 2 m_f against m_f/2"
    if (double < half).all():
        return Finding(here, note, MATCH)
    against = _doubled_costs_more()
    if against:
        note += f"; the printed Table 3 itself has the former the more penalizing at {against}"
    return Finding(here, note, INCONSISTENT if against else DIFFERS)


def _doubled_costs_more() -> str:
    """Mass ratios where the printed Table 3 has more iterations at m_add = 2 m_f than at m_f/2."""
    printed = {tuple(cell.keys.values()): cell.text for cell in published.table("table3")}
    ratios = [ratio for row, ratio in printed if row == "2"]
    worse = [r for r in ratios if int(printed["2", r]) > int(printed["0.5", r])]
    return f"m_f/m = {', '.join(worse)}" if worse else ""


@claim("tolerance")
def _(sources: Sources) -> Finding:
    tolerance = json.loads(sources.iterations.attrs["config"])["criterion"]["tolerance"]
    note = "section 2.4 states the value used here; the printed tables follow it"
    return Finding(float(tolerance), note, INCONSISTENT)


def _order(sources: Sources, integrator: str) -> float:
    return float(sources.iterations["observed_order"].sel(integrator=integrator))


@claim("newmark_order")
def _(sources: Sources) -> Finding:
    return Finding(_order(sources, "newmark"), "towards Eq. (5), over the whole run")


@claim("centred_order")
def _(sources: Sources) -> Finding:
    order = _order(sources, "centred")
    note = (
        "with w'' at t_n and the force at t_{n+1}, as Eq. (17) has them and the paper's condition "
        "m > m_f needs, it is of first order, damped; the observed order rises to 1 as dt falls"
    )
    return Finding(order, note, MATCH if judge("2", order) == MATCH else INCONSISTENT)


@claim("density")
def _(sources: Sources) -> Finding:
    means = sources.iterations["density_mean_iterations"]
    gain = (
        means.sel(density_added_mass_ratio=0).values / means.sel(density_added_mass_ratio=1).values
    )
    rho, finite = sources.iterations["density"].values, np.isfinite(gain)
    here = (
        f"solves saved grow from {gain[0]:.2g}-fold at {rho[0]:g} kg/m3 "
        f"to {gain[finite][-1]:.2g}-fold at {rho[finite][-1]:g} kg/m3"
    )
    apart = (gain[finite] / gain[0]) / (rho[finite] / rho[0])
    note = (
        f"that is {apart[-1]:.2g} times what proportion to the density would give; without bound "
        "where the standard scheme diverges: its count has a pole at m_f = m"
    )
    return Finding(here, note, holds(bool(finite.all() and (abs(apart - 1) < 0.1).all())))


@claim("squat_speed")
def _(sources: Sources) -> Finding:
    data = sources.equilibria
    note = f"double root w = {float(data['squat_sinkage']):.6g} m"
    return Finding(float(data["squat_speed"]), note)


def _above(data: xr.Dataset) -> xr.Dataset:
    return data.sel(speed=data["speed"] > data["squat_speed"])


@claim("complex_roots")
def _(sources: Sources) -> Finding:
    above = _above(sources.equilibria)
    gone = above["stable"].isnull() & above["unstable"].isnull()
    return Finding("complex", f"{above.sizes['speed']} speeds", holds(bool(gone.all())))


@claim("third_root")
def _(sources: Sources) -> Finding:
    config = json.loads(sources.equilibria.attrs["config"])
    bottom = config["hull"]["draft"] - config["channel"]["depth"]
    third = sources.equilibria["unphysical"]
    note = f"highest value {float(third.max()):.6g} m; the bottom is met at w = {bottom:g} m"
    return Finding("below", note, holds(bool((third <= bottom).all())))


@claim("stability")
def _(sources: Sources) -> Finding:
    data = sources.equilibria
    below = data.sel(speed=data["speed"] < data["squat_speed"])
    signs = (below["stable_stiffness"] > 0).all() and (below["unstable_stiffness"] < 0).all()
    return Finding("stable, unstable", "sign of the restoring slope", holds(bool(signs)))
