"""Numbers that a reader takes from a recording."""

import numpy as np

from squat.replay.chart import _HANGING

NANOSECOND = 1e-9
SINGLE = 2e-7  # relative, of numbers kept in single precision


def scalars(entity):
    return np.array(entity.rows["scalars"])[:, 0]


def one_each(entity, name):
    return [np.array(row[0]) for row in entity.rows[name]]


def reader_of(found, name):
    """Numbers that a reader takes from a diagram by its labelled axes."""
    numbers = found[f"axes/{name}/numbers"].rows
    places, words = np.array(numbers["positions"][0]), numbers["labels"][0][:-2]
    values = np.array([float(word) for word in words])
    low = places[:-2, 1] == places[:-2, 1].max()
    across = np.polyfit(places[:-2][low, 0], values[low], 1)
    up = np.polyfit(places[:-2][~low, 1] + _HANGING, values[~low], 1)
    return lambda strip: (np.polyval(across, strip[:, 0]), np.polyval(up, strip[:, 1]))
