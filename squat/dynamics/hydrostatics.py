"""Buoyancy of a wall-sided hull."""

from squat.water import Water


def heave_stiffness(water: Water, length: float) -> float:
    """Restoring force per unit heave, rho g L [N/m2], for a water plane of `length` [m].

    Exact while the sides at the water line are vertical, which every hull's are.
    """
    return water.density * water.gravity * length
