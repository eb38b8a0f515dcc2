"""Remove the lock that a killed snakemake left behind, unless one is still at work here."""

import subprocess
from pathlib import Path

import psutil


def alive(folder: Path) -> bool:
    """Whether a snakemake process works in `folder`."""
    for process in psutil.process_iter():
        try:
            command, cwd = process.cmdline(), process.cwd()
        except psutil.Error:
            continue
        if Path(cwd) == folder and any(Path(part).name == "snakemake" for part in command[:2]):
            return True
    return False


def main() -> None:
    """Unlock the working directory where that is safe."""
    locks = Path(".snakemake/locks")
    if locks.is_dir() and any(locks.iterdir()) and not alive(Path.cwd()):
        subprocess.run(["snakemake", "--unlock"], check=True)


if __name__ == "__main__":
    main()
