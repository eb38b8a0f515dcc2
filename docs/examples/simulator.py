"""A ship enters a faster current, live.

    python docs/examples/simulator.py model.nc [--viewer] [--save run.rrd]

Make the model first: `squat task=reduced out=model.nc` (a few seconds). The ship is stepped as a
simulator would, 50 steps a second of its own time; `--viewer` opens rerun's viewer and streams to
it in real time, `--save FILE.rrd` keeps the recording.
"""

import argparse
import math
import time

import rerun as rr

from squat import InputError
from squat.reduced import Simulator, State

STEP = 0.02  # s
DURATION = 120.0  # s
RAMP = 60.0  # s: slow against L/V, in which the water passes the ship


def current(t: float) -> float:
    """V [m/s]: from 1.0 to 1.8 within a minute."""
    return 1.4 - 0.4 * math.cos(math.pi * min(t, RAMP) / RAMP)


def name(stream: rr.RecordingStream) -> None:
    """Names and units of the curves, in their legends."""
    for path, unit in (("ship/heave", "m"), ("ship/clearance", "m"), ("water/current", "m/s")):
        named = f"{path.partition('/')[2]} [{unit}]"
        stream.log(path, rr.SeriesLines(names=named), static=True)


def log(stream: rr.RecordingStream, state: State) -> None:
    """Heave, clearance and current of one instant."""
    stream.set_time("sim_time", duration=state.time)
    stream.log("ship/heave", rr.Scalars(state.heave))
    stream.log("ship/clearance", rr.Scalars(state.clearance))
    stream.log("water/current", rr.Scalars(state.current))


def run(model: str, stream: rr.RecordingStream | None, *, live: bool) -> tuple[State, float]:
    """The last state, and how much faster than real time the steps alone were."""
    ship = Simulator.load(model, position=-0.1, current=current(0.0))
    if stream is not None:
        name(stream)
    began, stepping = time.perf_counter(), 0.0
    for n in range(1, round(DURATION / STEP) + 1):
        before = time.perf_counter()
        state = ship.step(STEP, current(n * STEP))
        stepping += time.perf_counter() - before
        if stream is not None and n % 5 == 0:
            log(stream, state)
        if live:
            time.sleep(max(0.0, began + state.time - time.perf_counter()))
    return state, DURATION / stepping


def main() -> None:
    """Read the arguments, run, say how fast it was."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("model", help="file of squat task=reduced")
    parser.add_argument("--viewer", action="store_true", help="open the viewer and stream to it")
    parser.add_argument("--save", metavar="FILE.rrd", help="keep the recording")
    given = parser.parse_args()
    stream = None
    if given.viewer or given.save:
        stream = rr.RecordingStream("squat_simulator")
        stream.spawn() if given.viewer else stream.save(given.save)
    try:
        state, factor = run(given.model, stream, live=given.viewer)
    except InputError as error:
        parser.exit(2, f"{error}\n")
    if stream is not None:
        stream.flush()
    print(f"heave {state.heave:.3f} m, clearance {state.clearance:.3f} m after {state.time:.0f} s")
    print(f"stepped {factor:.0f} times faster than real time")


if __name__ == "__main__":
    main()
