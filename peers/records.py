"""Recorded welds read by others: an exported trace by pandas, pyarrow and DuckDB, the library by Python's sqlite3, held against
what the command line says of them.

    python3 peers/records.py SEAMWRIGHT
"""

import hashlib
import json
import pathlib
import sqlite3
import subprocess
import sys
import tempfile

import duckdb
import pandas
import pyarrow
import pyarrow.parquet

HERE = pathlib.Path(__file__).resolve().parent.parent
failed = []


def check(what, good):
    print(f"{'ok    ' if good else 'FAILED'}  {what}")
    if not good:
        failed.append(what)


def close(a, b, part=1e-6):
    return abs(a - b) <= part * max(1.0, abs(a), abs(b))


def run(*arguments):
    result = subprocess.run([sys.argv[1], *map(str, arguments)], capture_output=True, text=True, cwd=HERE)
    if result.returncode not in (0, 1):
        sys.exit(f"{arguments}: {result.stderr}")
    return result.stdout


def trace(folder, record):
    """The exported trace against the record's JSON."""
    part = next(f for f in record["files"] if f["rows"] is not None)
    path = folder / part["name"]
    check("hash of the trace", hashlib.sha256(path.read_bytes()).hexdigest() == part["sha256"])
    schema = pyarrow.parquet.read_schema(path)
    units = {k[5:]: v for k, v in ((k.decode(), v.decode()) for k, v in schema.metadata.items()) if k.startswith("unit:")}
    check("every column has a unit", set(units) == set(schema.names) and units["t_s"] == "s" and units["s_mm"] == "mm")
    kinds = {name: str(schema.field(name).type) for name in schema.names}
    wanted = {"t_s": "double", "s_mm": "double", "arc": "uint8", "pass": "uint32", "path_error_mm": "float"}
    check("types of columns", all(kinds[name] == kind for name, kind in wanted.items()))
    rows = pandas.read_parquet(path)
    check(f"{len(rows)} rows, as recorded", len(rows) == part["rows"])
    asked = f"SELECT count(*), sum(arc), max(path_error_mm) FILTER (arc = 1) FROM '{path}'"
    [(count, arcs, error)] = duckdb.sql(asked).fetchall()
    lit = rows[rows["arc"] == 1]
    check("DuckDB reads the same", (count, arcs) == (len(rows), len(lit)) and close(error, lit["path_error_mm"].max()))
    steps = rows["t_s"].diff().dropna()
    check("rows a period apart", close(steps.min(), steps.max(), 1e-9) and rows["t_s"].iloc[0] == 0)
    welded = rows[rows["arc"] == 1]
    worst, at = record["worst_deviation_mm"]
    greatest = welded["path_error_mm"].idxmax()
    check("worst deviation", close(welded["path_error_mm"][greatest], worst) and close(rows["s_mm"][greatest], at))
    # Heat input, worked out again: energy over the way between 10 mm from either end.
    long = welded[(welded["s_mm"] > 10) & (welded["s_mm"] < welded["s_mm"].max() - 10)]
    energy = (long["current_a"].astype(float) * long["voltage_v"] * steps.mean()).sum()
    way = long["tip_s_mm"].iloc[-1] - long["tip_s_mm"].iloc[0]
    check("mean heat input", close(0.8 * energy / way / 1000, record["heat_input_kj_mm"][1], 1e-3))
    for value in (v for v in record["values"] if v["name"] in rows.columns and v["name"] != "tip_speed_mm_s"):
        low, high = welded[value["name"]].min(), welded[value["name"]].max()
        check(f"{value['name']} within {low:g} to {high:g}", value["least"] >= low * (1 - 1e-6) and value["greatest"] <= high * (1 + 1e-6))


def library(data, record):
    """The library against the record's JSON, by SQL as docs/reference/records.md has it."""
    db = sqlite3.connect(f"file:{data / 'library.sqlite'}?mode=ro", uri=True)
    db.row_factory = sqlite3.Row
    check("integrity", db.execute("PRAGMA integrity_check").fetchone()[0] == "ok")
    row = db.execute(
        "SELECT weld.*, p.name AS program_name, p.text, p.sha256, w.name AS procedure_name, welder.name AS welder_name "
        "FROM weld JOIN document p ON p.id = program LEFT JOIN document w ON w.id = procedure "
        "LEFT JOIN welder ON welder.id = weld.welder WHERE weld.part = 'N-17'"
    ).fetchone()
    check("part, result, welder", (row["part"], row["result"], row["welder_name"]) == (record["part"], record["result"], record["welder"]))
    check("procedure", row["procedure_name"] == record["procedure"][0])
    check("heat input", row["heat_input_mean_kj_mm"] == record["heat_input_kj_mm"][1])
    check("hash of the program", hashlib.sha256(row["text"].encode()).hexdigest() == row["sha256"] == record["program"][2])
    begin = pandas.Timestamp(row["begun"], unit="ms", tz="UTC").strftime("%Y-%m-%d %H:%M:%S UTC")
    check("begun", begin == record["begun"])
    # The audit log's chain, by another hand.
    before = "0" * 64
    for entry in db.execute("SELECT * FROM audit ORDER BY id"):
        data = before.encode() + entry["id"].to_bytes(8, "little") + entry["at"].to_bytes(8, "little")
        for field in ("user", "station", "command", "old", "new", "result"):
            text = entry[field].encode()
            data += len(text).to_bytes(8, "little") + text
        before = hashlib.sha256(data).hexdigest()
        check(f"audit entry {entry['id']}", before == entry["hash"])


def main():
    print(f"Records read by pandas {pandas.__version__}, pyarrow {pyarrow.__version__}, DuckDB {duckdb.__version__}, SQLite {sqlite3.sqlite_version}")
    with tempfile.TemporaryDirectory() as folder:
        folder = pathlib.Path(folder)
        data = folder / "data"
        weld = ["simulate", "examples/saddle.toml", "-o", folder / "out", "--data", data]
        run(*weld, "--part", "N-17", "--welder", "A. Welder")
        run(*weld, "--part", "N-18", "--distortion", "examples/distortions/misplaced.toml")
        found = json.loads(run("records", "list", "--data", data, "--part", "N-17", "--json"))
        check("one weld of the part", len(found) == 1)
        number = found[0]["id"]
        run("records", "export", number, "-o", folder / "exported", "--data", data)
        record = json.loads((folder / "exported" / "record.json").read_text())
        check("exported as shown", record == json.loads(run("records", "show", number, "--data", data, "--json")))
        trace(folder / "exported", record)
        library(data, record)
    sys.exit(1 if failed else 0)


main()
