"""The one exception that means: what the user asked for cannot be done."""


class InputError(ValueError):
    """Impossible or unreadable input; the message is one line: key or file, value, remedy."""
