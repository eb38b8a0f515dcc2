"""Picture of a recording, without a screen: screenshot.py RECORDING PNG TIME.

Needs a Vulkan driver; Debian's mesa-vulkan-drivers draws on the processor.
"""

import socket
import subprocess
import sys
import time
from pathlib import Path

import matplotlib.image as images
import rerun_cli
from rerun.experimental import ViewerClient

_VIEWER = Path(rerun_cli.__file__).parent / "rerun"  # the wrapper on the path leaves it running
_SIZE = "1600x1000"
_BAR = 36  # pixels of the window's own bar, which tells of the machine
_PATIENCE = 60.0  # s
_SETTLING = 6.0  # s that the viewer takes to load and to draw


def main(recording: Path, picture: Path, moment: float) -> None:
    """Write what the viewer shows at `moment` [s]; exit 1 where a view reports an error."""
    with socket.socket() as free:
        free.bind(("127.0.0.1", 0))
        port = free.getsockname()[1]
    command = [str(_VIEWER), "--headless", "--bind", "127.0.0.1", "--port", str(port)]
    with subprocess.Popen([*command, "--window-size", _SIZE]) as viewer:
        try:
            client = _connect(port)
            client.open(str(recording.absolute()))
            time.sleep(_SETTLING)
            client.set_time("sim_time", duration=moment, play_state="paused")
            time.sleep(_SETTLING)
            failed = [view for view in client.get_state().views if view.reports]
            client.save_screenshot(str(picture.absolute()))
        finally:
            viewer.terminate()
    images.imsave(picture, images.imread(picture)[_BAR:])
    if failed:
        sys.exit(f"{recording}: {failed[0].name}: {failed[0].reports[0]}")


def _connect(port: int) -> ViewerClient:
    until = time.monotonic() + _PATIENCE
    while True:
        try:
            client = ViewerClient.connect(f"rerun+http://127.0.0.1:{port}/proxy")
            client.get_state()
        except ConnectionError:
            if time.monotonic() > until:
                raise
            time.sleep(0.5)
        else:
            return client


if __name__ == "__main__":
    main(Path(sys.argv[1]), Path(sys.argv[2]), float(sys.argv[3]))
