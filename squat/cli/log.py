"""The log on stderr."""

import logging
import sys


def start_logging(level: str) -> None:
    """Log to stderr from `level` (of the key log_level) on."""
    logging.basicConfig(
        format="%(levelname)s %(message)s", level=level.upper(), stream=sys.stderr, force=True
    )
    for chatty in ("skfem", "hydra_plugins"):  # every basis, every job's overrides
        logging.getLogger(chatty).setLevel(logging.WARNING)
