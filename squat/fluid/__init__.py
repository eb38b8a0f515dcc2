"""The water's answer to the ship: potential, pressure, added mass."""
