"""Couple a flow solver that runs as another process: ten times as heavy as the piston it moves.

    python docs/examples/external_fluid.py

The standard coupling diverges. `squat.couple` needs two answers of the solver to estimate the added
mass, and then converges in two iterations a step.
"""

import json
import math
import subprocess
import sys
from pathlib import Path
from types import TracebackType
from typing import Any

import xarray as xr

import squat

SOLVER = [sys.executable, str(Path(__file__).with_name("water_column.py"))]
PISTON_MASS = 10.0  # kg; the water weighs 100 kg
OMEGA = math.sqrt(2 * 1000.0 * 9.81 * 0.1 / (PISTON_MASS + 100.0))  # rad/s, of both together
RELEASED_AT = 0.01  # m
DT = 2 * math.pi / OMEGA / 70  # s
STEPS = 140


class LineProcess:
    """A process that answers each line of JSON with one."""

    def __enter__(self) -> "LineProcess":
        self.process = subprocess.Popen(
            SOLVER, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True
        )
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        at: TracebackType | None,
    ) -> None:
        self.process.communicate()  # closes its input, on which it ends

    def __call__(self, motion: Any, time: float, memory: Any) -> float:
        """The force [N] for a trial motion; the piston has one degree of freedom."""
        assert self.process.stdin is not None
        assert self.process.stdout is not None
        names = ("position", "velocity", "acceleration")
        trial = {name: float(getattr(motion, name)[0]) for name in names}
        self.process.stdin.write(json.dumps(trial) + "\n")
        self.process.stdin.flush()
        answer = json.loads(self.process.stdout.readline())
        return float(answer["force"])


def run(scheme: str) -> xr.Dataset:
    """The piston on the external water under `scheme`: standard or estimated."""
    with LineProcess() as water:
        return squat.couple(
            squat.Structure(mass=PISTON_MASS),
            water,
            position=RELEASED_AT,
            acceleration=-(OMEGA**2) * RELEASED_AT,
            dt=DT,
            steps=STEPS,
            scheme=scheme,
            modes=["piston"],
        )


if __name__ == "__main__":
    for scheme in ("standard", "estimated"):
        data = run(scheme)
        print(
            f"{scheme}: {data.attrs['status']} after {data.sizes['time'] - 1} steps, "
            f"effective added mass {float(data['effective_added_mass'].squeeze()):.6g} kg, "
            f"predicted G {float(data['predicted_contraction']):.3g}, "
            f"at most {int(data['iterations'].max())} iterations"
        )
