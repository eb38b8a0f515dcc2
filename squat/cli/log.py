"""The log on stderr, and the one line with which a command ends that cannot go on."""

import logging
import sys
from typing import NoReturn

BAD_INPUT = 2


def report(line: str) -> None:
    """Print one line of the command's own on stderr."""
    print(f"squat: {line}", file=sys.stderr)


def refuse(line: str) -> NoReturn:
    """Say why in one line, and end with exit code 2."""
    report(line)
    sys.exit(BAD_INPUT)


def start_logging(level: str) -> None:
    """Log to stderr from `level` (of the key log_level) on."""
    logging.basicConfig(
        format="%(levelname)s %(message)s", level=level.upper(), stream=sys.stderr, force=True
    )
    for chatty in ("skfem", "hydra_plugins"):  # every basis, every job's overrides
        logging.getLogger(chatty).setLevel(logging.WARNING)
