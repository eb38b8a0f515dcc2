"""A Hydra launcher that puts many short runs into one job of a cluster."""
