"""Picture of a recording, without a screen: screenshot.py RECORDING PNG SIM_TIME.

A moment after the end of the recording is refused; one within the digits in which logs and titles
tell the end is the end.

Needs a Vulkan driver; Debian's mesa-vulkan-drivers draws on the processor.
"""

import math
import socket
import subprocess
import sys
import tempfile
import time
from argparse import ArgumentParser
from pathlib import Path

import matplotlib.image as images
import rerun_cli
from rerun.experimental import ViewerClient

_VIEWER = Path(rerun_cli.__file__).parent / "rerun"  # the wrapper on the path leaves it running
_SIZE = "1600x1000"
_BAR = 36  # pixels of the window's own bar, which tells of the machine
_PATIENCE = 60.0  # s
_DIGITS = 5e-4  # relative: rounding to the four digits of logs and titles
_SETTLING = 6.0  # s that the viewer takes to load and to draw


def main(recording: Path, picture: Path, sim_time: float) -> None:
    """Write what the viewer shows at `sim_time` [s]; exit 1 where it or a view of it fails."""
    with socket.socket() as free:
        free.bind(("127.0.0.1", 0))
        port = free.getsockname()[1]
    command = [str(_VIEWER), "--headless", "--bind", "127.0.0.1", "--port", str(port)]
    with (
        tempfile.TemporaryFile("w+") as said,
        subprocess.Popen(
            [*command, "--window-size", _SIZE], stdout=said, stderr=subprocess.STDOUT
        ) as viewer,
    ):
        try:
            faults = _draw(_connect(viewer, port), recording, picture, sim_time)
        except ConnectionError:
            said.seek(0)
            sys.exit(f"{said.read()}\n{recording}: the viewer failed; it needs a Vulkan driver")
        finally:
            viewer.terminate()
    images.imsave(picture, images.imread(picture)[_BAR:])
    if faults:
        sys.exit(f"{recording}: {faults[0]}")
    print(picture)


def _draw(client: ViewerClient, recording: Path, picture: Path, sim_time: float) -> list[str]:
    """What the views complain of; exit 1 where `sim_time` is not in the recording."""
    client.open(str(recording.absolute()))
    time.sleep(_SETTLING)
    end = _end(client)
    if math.isclose(sim_time, end, rel_tol=_DIGITS):
        sim_time = end
    if not 0 <= sim_time <= end:
        sys.exit(f"SIM_TIME={sim_time:g}: {recording} ends at {end:.6g} s; give 0 to that")
    client.set_time("sim_time", duration=sim_time, play_state="paused")
    time.sleep(_SETTLING)
    faults = [
        f"{view.name}: {view.reports[0]}" for view in client.get_state().views if view.reports
    ]
    client.save_screenshot(str(picture.absolute()))
    return faults


def _end(client: ViewerClient) -> float:
    """Last sim_time [s] of what is open."""
    timelines = (line for one in client.get_state().recordings for line in one.timelines)
    return max((line.end or 0) / 1e9 for line in timelines if line.name == "sim_time")


def _connect(viewer: subprocess.Popen[bytes], port: int) -> ViewerClient:
    until = time.monotonic() + _PATIENCE
    while True:
        try:
            client = ViewerClient.connect(f"rerun+http://127.0.0.1:{port}/proxy")
            client.get_state()
        except ConnectionError:
            if viewer.poll() is not None or time.monotonic() > until:
                raise
            time.sleep(0.5)
        else:
            return client


def _parser() -> ArgumentParser:
    parser = ArgumentParser(description="Picture of a recording, without a screen.")
    parser.add_argument("recording", type=Path, metavar="RECORDING", help="an .rrd file")
    parser.add_argument("picture", type=Path, metavar="PNG", help="file to write")
    parser.add_argument("sim_time", type=float, metavar="SIM_TIME", help="moment, sim_time in s")
    return parser


if __name__ == "__main__":
    typed = _parser().parse_args()
    if not typed.recording.is_file():
        _parser().error(f"{typed.recording}: no such file; squat task=replay makes one")
    if typed.recording.read_bytes()[:3] != b"RRF":
        _parser().error(f"{typed.recording}: no recording; squat task=replay makes one")
    if not typed.picture.absolute().parent.is_dir():
        _parser().error(f"{typed.picture}: no such folder; make it, or give another")
    main(typed.recording, typed.picture, typed.sim_time)
