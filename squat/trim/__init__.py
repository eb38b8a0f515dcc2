"""What a ship that may trim can stand: equilibria, folds, barriers and limits in several modes."""
