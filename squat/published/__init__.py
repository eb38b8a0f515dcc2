"""What the paper prints: tables and sentences, as text so that printed digits are kept.

Nothing else in the code or the configuration repeats a printed result.
"""

from squat.published.reader import Printed, claims, layout, table, units

__all__ = ["Printed", "claims", "layout", "table", "units"]
