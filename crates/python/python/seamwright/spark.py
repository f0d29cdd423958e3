"""Rows of a table or draws of a study on a Spark cluster.

``seamwright schedule TABLE -o DIR --spark sc://HOST:PORT`` and ``seamwright.schedule(..., spark=...)`` start this module
(``python3 -m seamwright.spark``) and talk with it over its standard input and output:

- The first line of the input is JSON with the address of the cluster and the size of the task, whose bytes follow. Then
  comes a line for each piece of work (a row or a draw), and ``end`` after the last one.
- The output has a line of JSON for each answer: the version, the number of pieces that are wanted, a result, a failure,
  the end.

Pieces go to the cluster in waves of some hundred partitions, two waves at a time, so that no worker waits for the last
row of a wave. A partition is planned by :func:`plan_pieces` on a worker, which needs this package in the same version and
nothing else: the task contains all files. A piece depends on nothing but itself and the task, so a cluster may plan it
again after a loss of its worker.
"""

import functools
import hashlib
import json
import os
import sys
import threading
from concurrent.futures import ThreadPoolExecutor

from ._native import Worker, __version__

#: Pieces in a partition: a retry plans them again; the overhead of a partition, some 50 ms, is shared by them.
PARTITION = 20
#: Partitions of a wave for each processor of the cluster.
PARTITIONS_EACH = 4
#: Waves at the same time: the next one fills the processors that the end of the other leaves idle.
WAVES = 2
#: Most processors that are counted.
MAX_PROCESSORS = 4096
#: Maximum time to cancel what runs on the cluster, s.
LEAVE_S = 5.0

_workers = {}
_workers_lock = threading.Lock()


def _worker(task):
    """The worker of a task, read once in each process."""
    key = hashlib.sha256(task).digest()
    with _workers_lock:
        if key not in _workers:
            # A process works for one run most of the time: older tasks would only take memory.
            _workers.clear()
            _workers[key] = Worker(task)
        return _workers[key]


def plan_pieces(task, batches):
    """Plans the pieces of a partition on a worker of the cluster: for ``DataFrame.mapInPandas``."""
    import pandas

    worker = _worker(task)
    for batch in batches:
        for piece in batch["piece"]:
            yield pandas.DataFrame({"result": [worker.plan(piece)]})


class _Bridge:
    """Standard input and output as pieces and answers."""

    def __init__(self, source, sink):
        self.source = source
        self.sink = sink
        self.lock = threading.Lock()

    def answer(self, **answer):
        line = json.dumps(answer if answer else "end", ensure_ascii=False).encode() + b"\n"
        with self.lock:
            self.sink.write(line)
            self.sink.flush()

    def wave(self, count):
        """The next pieces, at most ``count``; and whether they are the last ones."""
        pieces = []
        while len(pieces) < count:
            line = self.source.readline()
            if not line:
                raise EOFError
            if line == b"end\n":
                return pieces, True
            pieces.append(line.decode().rstrip("\n"))
        return pieces, False


def _processors(spark):
    """Processors of the cluster: a range without other wishes has a partition for each."""
    from pyspark.sql import functions

    numbers = spark.range(0, MAX_PROCESSORS).select(functions.spark_partition_id().alias("p"))
    return max(1, min(MAX_PROCESSORS, numbers.distinct().count()))


def _run_wave(spark, task, bridge, pieces):
    import pyarrow

    table = pyarrow.table({"piece": pieces})
    partitions = -(-len(pieces) // PARTITION)
    rows = spark.createDataFrame(table).repartition(partitions)
    planned = rows.mapInPandas(functools.partial(plan_pieces, task), "result string")
    for row in planned.toLocalIterator():
        bridge.answer(result=row.result)


def _run(spark, task, bridge):
    wave = PARTITION * PARTITIONS_EACH * _processors(spark)
    bridge.answer(want=wave * WAVES)

    def finished(future):
        if future.exception():
            _fail(spark, bridge, future.exception())
        # The next wave comes while the others run.
        bridge.answer(want=wave)

    with ThreadPoolExecutor(WAVES) as pool:
        is_last = False
        while not is_last:
            pieces, is_last = bridge.wave(wave)
            if pieces:
                pool.submit(_run_wave, spark, task, bridge, pieces).add_done_callback(finished)
        # From here on the end of the input means that nobody waits for results any more.
        threading.Thread(target=_leave_at_end, args=(spark, bridge), daemon=True).start()


def _leave_at_end(spark, bridge):
    if not bridge.source.readline():
        _leave(spark)


def _fail(spark, bridge, error):
    bridge.answer(failed=_words(error))
    _leave(spark)


def _leave(spark):
    """Cancels what runs, and ends the process: its threads may wait for results."""
    if spark is not None:
        cancel = threading.Thread(target=spark.interruptAll, daemon=True)
        cancel.start()
        cancel.join(LEAVE_S)
    os._exit(1)


def main():
    # Nothing else may write to the output.
    sink = os.fdopen(os.dup(1), "wb")
    os.dup2(2, 1)
    bridge = _Bridge(sys.stdin.buffer, sink)
    bridge.answer(version=__version__)
    line = sys.stdin.buffer.readline()
    if not line:
        return
    header = json.loads(line)
    task = sys.stdin.buffer.read(header["task_bytes"])
    try:
        import pandas  # noqa: F401
        import pyarrow  # noqa: F401
        from pyspark.sql import SparkSession
    except ImportError as error:
        bridge.answer(no_client=str(error))
        return
    spark = None
    try:
        spark = SparkSession.builder.remote(header["spark"]).getOrCreate()
        _run(spark, task, bridge)
        bridge.answer()
    except EOFError:
        _leave(spark)
    except Exception as error:
        _fail(spark, bridge, error)
    # Threads of the client may wait for the network.
    os._exit(0)


def _words(error):
    """What the cluster says, without the traceback of its own programs."""
    lines = [line for line in str(error).splitlines() if line.strip()]
    return "\n".join(lines[:1] + [line for line in lines[-4:] if line not in lines[:1]]) or type(error).__name__


if __name__ == "__main__":
    # By its name, so that workers import `plan_pieces` instead of a copy of this program.
    from seamwright import spark

    spark.main()
