"""Tables and studies, here and through `seamwright.spark` with a client of Spark that plans in its own process.

The comparison with a real server is peers/spark.py.
"""

import json
import os
import signal
import sys
import threading
import time

import pytest

import seamwright
from seamwright._native import Worker

ROWS = 45
#: The part of pyspark, pandas and pyarrow that the package uses.
CLIENT = {
    "pandas.py": "DataFrame = dict\n",
    "pyarrow.py": "table = dict\n",
    "pyspark/__init__.py": "",
    "pyspark/sql/__init__.py": """
import os, pickle, types
from . import functions

class Frame:
    def __init__(self, rows): self.rows = rows
    def select(self, *columns): return self
    def distinct(self): return self
    def count(self): return int(os.environ.get("FAKE_PROCESSORS", "1"))
    def repartition(self, count):
        assert count == -(-len(self.rows["piece"]) // 20)
        return self
    def mapInPandas(self, function, schema):
        function = pickle.loads(pickle.dumps(function))
        if "FAKE_FAULT" in os.environ: raise RuntimeError("executor lost: " + os.environ["FAKE_FAULT"])
        # In another order, as partitions come.
        pieces = self.rows["piece"]
        return types.SimpleNamespace(toLocalIterator=lambda: (
            types.SimpleNamespace(result=result)
            for batch in (pieces[1::2], pieces[::2])
            for frame in function(iter([{"piece": batch}]))
            for result in frame["result"]))

class SparkSession:
    class builder:
        @staticmethod
        def remote(address):
            assert address == "sc://nowhere:1"
            return SparkSession.builder
        @staticmethod
        def getOrCreate(): return SparkSession()
    def range(self, low, high): return Frame(None)
    def createDataFrame(self, table): return Frame(table)
    def interruptAll(self): pass
""",
    "pyspark/sql/functions.py": """
class spark_partition_id:
    def alias(self, name): return self
""",
}


@pytest.fixture
def client(tmp_path, monkeypatch):
    for name, text in CLIENT.items():
        path = tmp_path / "client" / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)
    paths = [str(tmp_path / "client"), *filter(None, [os.environ.get("PYTHONPATH")])]
    monkeypatch.setenv("PYTHONPATH", os.pathsep.join(paths))
    return "sc://nowhere:1"


@pytest.fixture
def table(tmp_path):
    """Rows that take no time, most of them: invalid, and one that can be welded."""
    path = tmp_path / "nozzles.csv"
    rows = "".join(f"N{i},saddle,{1000 + i}\n" for i in range(ROWS - 1))
    path.write_text("name,template,seam.nozzle.radius_mm\nwelded,saddle,250\n" + rows)
    return path


def files(folder):
    found = {path.relative_to(folder): path.read_bytes() for path in folder.rglob("*") if path.is_file()}
    return {name: sorted(data.split(b"\n")) if name.suffix == ".jsonl" else data for name, data in found.items()}


def test_a_table_gives_the_same_files_on_a_cluster(client, table, tmp_path):
    here, there = tmp_path / "here", tmp_path / "there"
    summary = seamwright.schedule(table, here, post="linuxcnc")
    assert (summary.rows, summary.weldable, summary.kept) == (ROWS, 1, 0)
    assert (here / "programs/welded.ngc").read_text() == seamwright.Job.load("saddle").plan().post("linuxcnc")
    assert all(os.path.isfile(path) for path in summary.files)
    again = seamwright.schedule(table, there, post="linuxcnc", spark=client)
    assert (again.rows, again.weldable, again.kept) == (ROWS, 1, 0)
    assert files(here) == files(there)
    # A part of the journal: the rest is planned.
    journal = there / "rows.jsonl"
    journal.write_text("".join(journal.read_text().splitlines(keepends=True)[:20]))
    assert seamwright.schedule(table, there, post="linuxcnc", spark=client).kept == 20
    assert files(here) == files(there)


def test_a_study_gives_the_same_files_on_a_cluster(client, tmp_path):
    study = tmp_path / "study.toml"
    study.write_text(
        'schema = 1\njob = "saddle"\n[[quantities]]\nname = "z"\nvary.work = "z_mm"\ndraw.normal = { deviation = 30 }\n'
    )
    here, there = tmp_path / "here", tmp_path / "there"
    summary = seamwright.study(study, here, draws=4)
    assert summary["draws"] == 4 and summary == json.loads((here / "summary.json").read_text())
    assert seamwright.study(study, there, draws=4, spark=client) == summary
    assert files(here) == files(there)


def test_failures_of_the_cluster_are_exceptions(client, table, tmp_path, monkeypatch):
    monkeypatch.setenv("FAKE_FAULT", "no memory")
    with pytest.raises(seamwright.EnvironmentFailed, match="executor lost: no memory") as caught:
        seamwright.schedule(table, tmp_path / "out", spark=client)
    assert caught.value.code == "schedule-spark-failed"
    monkeypatch.delenv("FAKE_FAULT")
    (tmp_path / "client/pyspark/sql/__init__.py").write_text("raise ImportError('no pyspark here')\n")
    with pytest.raises(seamwright.EnvironmentFailed) as caught:
        seamwright.schedule(table, tmp_path / "out", spark=client)
    assert caught.value.code == "schedule-spark-no-client" and sys.executable in str(caught.value)


def test_workers_refuse_what_they_cannot_read():
    with pytest.raises(seamwright.EnvironmentFailed) as caught:
        Worker(b"no task")
    assert caught.value.code == "schedule-task-damaged"


def test_faults_of_tables_are_exceptions(tmp_path):
    table = tmp_path / "t.csv"
    table.write_text("name,template,count\nN1,saddle,2.5\n")
    with pytest.raises(seamwright.InvalidInput, match="t.csv:2: count"):
        seamwright.schedule(table, tmp_path / "out")
    with pytest.raises(ValueError, match="jobs"):
        seamwright.schedule(table, tmp_path / "out", jobs=0)


def test_ctrl_c_ends_a_table_and_keeps_what_is_done(tmp_path):
    table = tmp_path / "t.csv"
    table.write_text("name,template,weld.speed_mm_s\n" + "".join(f"N{i},saddle,{5 + i / 1000}\n" for i in range(500)))
    journal = tmp_path / "out/rows.jsonl"

    def interrupt():
        while not journal.exists() or not journal.read_bytes():
            time.sleep(0.01)
        signal.raise_signal(signal.SIGINT)

    thread = threading.Thread(target=interrupt)
    thread.start()
    with pytest.raises(KeyboardInterrupt):
        seamwright.schedule(table, tmp_path / "out", jobs=1)
    thread.join()
    assert 0 < journal.read_bytes().count(b"\n") < 500
