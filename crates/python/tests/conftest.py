"""What tests share."""

import os
import shutil
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[3]


@pytest.fixture(scope="session")
def program():
    """The command line of the same sources; tests that compare with it are skipped without it."""
    named = os.environ.get("SEAMWRIGHT_BIN")
    for candidate in [named, ROOT / "target/debug/seamwright", shutil.which("seamwright")]:
        if candidate and Path(candidate).is_file():
            return str(candidate)
    pytest.skip("the command line is not built: cargo build --workspace")
