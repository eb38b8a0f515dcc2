"""What the second mode settles of the paper's conclusions and prospects (section 4)."""

import numpy as np
import xarray as xr

from squat.analysis.claims import Finding, NotRunError, Sources, claim, holds

_STOPPED = ("diverged", "iteration limit")
"""How runs end whose coupling failed; a ship that is lost for its speed was coupled all the way."""


def _solves(run: xr.Dataset) -> float:
    """Structure solves a step, mean over the steps."""
    return float(run["iterations"].values[1:].mean())


def _factor(run: xr.Dataset) -> float:
    """Greatest predicted |G| of the run."""
    return float(np.nanmax(np.abs(run["predicted_contraction"].values)))


def _freed(sources: Sources, coupling: str) -> xr.Dataset:
    for run in sources.pitching:
        if run.attrs["coupling"] == coupling:
            return run
    raise NotRunError(f"coupling={coupling} in heave and pitch")


def _plunge(run: xr.Dataset) -> str:
    """Which end is lower, and by how much, on the way to the deepest point of a run."""
    pitch = run["pitch"].values[: int(run["heave"].values.argmin()) + 1]
    most = float(pitch[np.abs(pitch).argmax()])
    start, greatest = np.rad2deg([float(pitch[0]), abs(most)])
    return (
        f"set free {start:.2g} degrees bow down at {float(run.attrs['current']):g} m/s, the ship "
        f"of the printed scheme trims by the {'bow' if most > 0 else 'stern'} as it sinks, by "
        f"{greatest:.1f} degrees up to its lowest point ({run.attrs['status']})"
    )


@claim("one_freedom")
def _(sources: Sources) -> Finding:
    data = sources.trim
    alone, safe = float(data["heave_only_limit"]), float(data["safe_speed"])
    trim = np.rad2deg(abs(float(data["saddle_pitch"])))
    text = f"pitch costs {100 * (1 - safe / alone):.1f} % of the speed that is safe in heave alone"
    errors = [float(data[f"{name}_error"]) for name in ("safe_speed", "heave_only_limit")]
    note = (
        f"safe by energy up to {safe:.4g} m/s (+- {errors[0]:.1g}) against {alone:.4g} (+- "
        f"{errors[1]:.1g}); the lowest way out of the well is at w = "
        f"{float(data['saddle_heave']):.2f} m with {trim:.0f} degrees of trim, by bow or by stern "
        f"alike; {_plunge(_freed(sources, 'printed'))}"
    )
    return Finding(text, note, holds(safe > 0.995 * alone))


@claim("new_freedoms")
def _(sources: Sources) -> Finding:
    run = _freed(sources, "printed")
    current = float(run.attrs["current"])
    alone = sources.run("printed", current)
    text = f"heave and pitch: {run.attrs['status']}, {_solves(run):.1f} solves a step"
    note = f"at {current:g} m/s, with the matrix m_add, greatest predicted |G| "
    note += f"{_factor(run):.2f}"
    if alone is not None:
        note += f"; heave alone: {_solves(alone):.1f} and {_factor(alone):.2f}"
    note += ". Roll turns out of this plane"
    return Finding(text, note, holds(run.attrs["status"] not in _STOPPED))


@claim("refreshed_matrix")
def _(sources: Sources) -> Finding:
    kept, fresh = (_freed(sources, name) for name in ("printed", "consistent"))
    text = f"{_solves(fresh):.1f} solves a step in place of {_solves(kept):.1f}"
    note = (
        f"at {float(fresh.attrs['current']):g} m/s in heave and pitch, all terms at one time; "
        f"greatest predicted |G| {_factor(fresh):.2f} in place of {_factor(kept):.2f}: the matrix "
        "is what the iteration feeds back, under the lid, not that of Eq. (23) brought up to date"
    )
    return Finding(text, note, holds(_solves(fresh) < _solves(kept)))
