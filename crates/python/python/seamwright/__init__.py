"""Plans welds of seams that curve through space.

Read a job, plan it, and take the motion as arrays::

    import seamwright

    job = seamwright.Job.load("saddle")   # a file, or the name of an example
    plan = job.plan()
    plan.set_points(1, period_s=0.01)     # NumPy array: a row an instant, a column an axis

Lengths are in mm, angles in degrees and times in s, as in files. Poses are in the work frame.
Faults are exceptions with ``code`` and ``address``: see :class:`seamwright.Error`.
"""

import numpy as _numpy  # noqa: F401  The library hands its numbers over to NumPy.

from ._errors import Cancelled, EnvironmentFailed, Error, InvalidInput, NotWeldable
from ._native import (
    LANGUAGES,
    Axis,
    Finding,
    Job,
    Machine,
    Plan,
    PlannedPass,
    Pose,
    ScheduleSummary,
    Seam,
    Solution,
    __version__,
    examples,
    machines,
    posts,
    schedule,
    study,
)

__all__ = [
    "LANGUAGES",
    "Axis",
    "Cancelled",
    "EnvironmentFailed",
    "Error",
    "Finding",
    "InvalidInput",
    "Job",
    "Machine",
    "NotWeldable",
    "Plan",
    "PlannedPass",
    "Pose",
    "ScheduleSummary",
    "Seam",
    "Solution",
    "__version__",
    "examples",
    "machines",
    "posts",
    "schedule",
    "study",
]
