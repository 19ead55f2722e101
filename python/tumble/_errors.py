"""The errors of the package: the texts are the program's own."""


class Error(Exception):
    """An error of Tumble. ``str(error)`` names the file, the place, what was found, what was wanted and the remedy.

    ``exit_code`` is the exit status that the program `tumble` has for this kind of error.
    """

    exit_code = 4

    @property
    def message(self):
        """The text of the error."""
        return str(self.args[0]) if self.args else ""


class BadInput(Error, ValueError):
    """A file or an argument is wrong (exit status 2)."""

    exit_code = 2


class DamagedLog(Error):
    """A file was a log once and is damaged or torn (exit status 3).

    ``report``: what could be said of the intact part, where the function that raised it returns a report; else None.
    """

    exit_code = 3
    report = None


class CannotFinish(Error):
    """A step that fails, a full disk, memory, another thread of the session that failed (exit status 4)."""

    exit_code = 4


BY_EXIT_CODE = {2: BadInput, 3: DamagedLog, 4: CannotFinish}
