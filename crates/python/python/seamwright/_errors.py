"""Exceptions of the package. The library raises them with what it knows of a fault."""


class Error(Exception):
    """A fault with a code, an address and words.

    ``str(error)`` is English; ``error.text("de")`` gives another language of ``seamwright.LANGUAGES``.
    """

    def __init__(self, fault):
        super().__init__(fault.text("en"))
        self._fault = fault
        #: Code of the message, stable for programs; see the reference of messages. None for words from outside.
        self.code = fault.code
        #: File of the fault as it was named, or None.
        self.file = fault.file
        #: Line in that file, from 1, or None.
        self.line = fault.line
        #: Column in that line, from 1, or None.
        self.column = fault.column
        #: Path of the key, such as ``seam.nozzle.radius_mm``, or None.
        self.key = fault.key

    @property
    def address(self):
        """File, line and key as far as they are known, such as ``job.toml:7: weld.speed_mm_s``; or None."""
        if self.file is None:
            return None
        line = "" if self.line is None else f":{self.line}"
        key = "" if self.key is None else f": {self.key}"
        return f"{self.file}{line}{key}"

    def text(self, language="en"):
        """The whole description in a language."""
        return self._fault.text(language)

    def allowed(self, language="en"):
        """The allowed values, or None."""
        return self._fault.allowed(language)


class InvalidInput(Error, ValueError):
    """A job, machine, table or argument is invalid."""


class NotWeldable(Error):
    """The job is understood, but the machine cannot make the weld as asked: ``findings`` say why."""

    def __init__(self, fault):
        super().__init__(fault)
        #: All findings of the plan.
        self.findings = fault.findings


class Cancelled(Error):
    """Planning was cancelled."""


class EnvironmentFailed(Error):
    """A file could not be written, a program is missing, or a cluster failed."""
