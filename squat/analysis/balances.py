"""What two balances of a coupled run leave over: the ship's own, and that of ship and water."""

import xarray as xr


def own_gap(run: xr.Dataset) -> float:
    """Largest |E_c + E_p + W - E_0| of the ship alone (Fig. 13) [J/m]."""
    total = run["kinetic_energy"] + run["potential_energy"] + run["fluid_work"]
    return float(abs(total - total[0]).max())


def whole_gap(run: xr.Dataset) -> float:
    """Largest gap in the balance of ship, water and the channel's ends [J/m]."""
    return float(abs(run["energy_residual"]).max())


def initial(run: xr.Dataset) -> float:
    """E_0 of Fig. 13, E_c + E_p at the start [J/m]."""
    return float(run["kinetic_energy"][0] + run["potential_energy"][0])


def kinetic(run: xr.Dataset) -> float:
    """Largest kinetic energy of ship and water in heave [J/m]."""
    inertia = run["ship_mass"] + run["fluid_inertia"]
    return float((inertia * run["heave_velocity"] ** 2).max()) / 2
