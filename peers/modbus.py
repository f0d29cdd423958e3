"""A cell on a Modbus TCP device that is not ours: pymodbus as welding source, inputs and 58 registers more. A weld through it, then
polling at 100 Hz with the server killed and started again.

    python3 peers/modbus.py SEAMWRIGHT [SECONDS]
"""

import asyncio
import csv
import io
import json
import pathlib
import socket
import struct
import subprocess
import sys
import tempfile
import threading
import time

FLOATS = 27
POLL_HZ = 100
OUTAGE_S = 2.0
failed = []


def check(what, good):
    print(f"{'ok    ' if good else 'FAILED'}  {what}", flush=True)
    if not good:
        failed.append(what)


def pattern(k):
    """What the k-th measured value that belongs to nothing is."""
    return (k + 0.5) * (-1) ** k


def serve(port, log):
    """The device: it burns while it is on, its heart-beat counts the polls; a line in `log` for each change of arc."""
    from pymodbus.server import StartAsyncTcpServer
    from pymodbus.simulator import DataType, SimData, SimDevice

    state = {"on": False, "current": 0, "voltage": 0, "beat": 0}
    floats = [word for k in range(FLOATS) for word in struct.unpack(">HH", struct.pack(">f", pattern(k)))]

    async def action(function, _start, address, count, registers, values):
        if function == 2:
            # E-stop, curtain and gas as they should be, ready; burning while on; not stuck.
            registers[0] = 0b1111 | state["on"] << 4
        elif function == 4:
            state["beat"] = (state["beat"] + 1) & 0xFFFF
            lit = [state["current"], state["voltage"]] if state["on"] else [0, 0]
            registers[0:4] = [state["beat"], 0, *lit]
        elif function in (6, 16) and values:
            for k, value in enumerate(values):
                if address + k < 2:
                    state[("current", "voltage")[address + k]] = value
        elif function in (5, 15) and values:
            for k, value in enumerate(values):
                if address + k == 1 and bool(value) != state["on"]:
                    state["on"] = bool(value)
                    with open(log, "a", encoding="utf-8") as file:
                        file.write(json.dumps({"t": time.time(), **state}) + "\n")

    words = lambda values: [SimData(0, values=values, datatype=DataType.REGISTERS)]
    bits = lambda: [SimData(0, values=[False] * 16, datatype=DataType.BITS)]
    device = SimDevice(id=1, simdata=(bits(), bits(), words([0] * 4), words([0] * 4 + floats)), action=action)
    asyncio.run(StartAsyncTcpServer(context=device, address=("127.0.0.1", port)))


class Server:
    def __init__(self, port, log):
        self.command = [sys.executable, "-B", __file__, "--serve", str(port), str(log)]
        self.port = port
        self.start()

    def start(self):
        self.process = subprocess.Popen(self.command, stderr=subprocess.DEVNULL)
        for _ in range(200):
            with socket.socket() as probe:
                if probe.connect_ex(("127.0.0.1", self.port)) == 0:
                    return
            time.sleep(0.05)
        sys.exit("pymodbus does not come up")

    def kill(self):
        self.process.kill()
        self.process.wait()


def machine(port):
    actual = "".join(
        f'v{k:02} = {{ input = {4 + 2 * k}, type = "f32" }}\n' for k in range(FLOATS)
    )
    return f"""
[devices.welder.modbus]
address = "127.0.0.1:{port}"
poll_hz = {POLL_HZ}
[devices.welder.modbus.inputs]
e_stop_ok = {{ discrete = 0 }}
curtain_clear = {{ discrete = 1 }}
gas_ok = {{ discrete = 2 }}
[devices.welder.modbus.outputs]
gas = {{ coil = 0 }}
on = {{ coil = 1 }}
watchdog = {{ coil = 2 }}
[devices.welder.modbus.set]
current_a = {{ holding = 0, scale = 0.1 }}
voltage_v = {{ holding = 1, scale = 0.01 }}
[devices.welder.modbus.reports]
ready = {{ discrete = 3 }}
burning = {{ discrete = 4 }}
stuck = {{ discrete = 5 }}
heartbeat = {{ input = 0 }}
fault = {{ input = 1 }}
[devices.welder.modbus.actual]
current_a = {{ input = 2, scale = 0.1 }}
voltage_v = {{ input = 3, scale = 0.01 }}
{actual}"""


class Cell:
    """`seamwright run` under orders, with its events as they come."""

    def __init__(self, seamwright, job, out):
        self.process = subprocess.Popen(
            [seamwright, "run", str(job), "-o", str(out), "--json"],
            stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
        )
        self.events = []
        self.reader = threading.Thread(target=self.read, daemon=True)
        self.reader.start()

    def read(self):
        for line in self.process.stdout:
            self.events.append(json.loads(line))

    def order(self, *lines):
        self.process.stdin.write("".join(line + "\n" for line in lines))
        self.process.stdin.flush()

    def wait(self, since, wanted, seconds):
        """True once an event after the first `since` is `wanted`."""
        end = time.time() + seconds
        while time.time() < end and self.process.poll() is None:
            if any(wanted(event) for event in self.events[since:]):
                return True
            time.sleep(0.02)
        return False

    def mode(self, since, name, seconds):
        return self.wait(since, lambda e: e["event"] == "mode" and e["to"] == name, seconds)

    def alarms(self, since):
        return [e["alarm"] for e in self.events[since:] if e["event"] == "alarm"]


def outage(cell, server, number):
    """The server is killed and comes back: told once, and the cell can be used again."""
    since = len(cell.events)
    begun = time.time()
    server.kill()
    told = cell.wait(since, lambda e: e["event"] == "alarm" and e["alarm"] == "inputs silent", 5)
    delay = time.time() - begun
    check(f"outage {number}: told after {delay:.2f} s, before the server is back", told and delay < 1)
    time.sleep(OUTAGE_S)
    server.start()
    back = time.time()
    cleared = cell.wait(since, lambda e: e["event"] == "cleared" and e["alarm"] == "inputs silent", 5)
    check(f"outage {number}: heard again {time.time() - back:.2f} s after the server is back", cleared)
    time.sleep(1)
    alarms = cell.alarms(since)
    # One device that is both: the new connection is a start of either.
    wanted = ["inputs silent", "inputs restarted", "process source restarted"]
    check(f"outage {number}: each alarm once: {', '.join(alarms)}", alarms == wanted)
    cell.order("acknowledge", "reset", "on")
    check(f"outage {number}: switched on again", cell.mode(since, "idle", 10))


def look(seamwright, file):
    """The registers by name against what the device has."""
    result = subprocess.run([seamwright, "machine", "io", str(file)], capture_output=True, text=True)
    if result.returncode:
        sys.exit(result.stderr)
    rows = {row["register"]: row for row in csv.DictReader(io.StringIO(result.stdout))}
    values = all(float(rows[f"actual.v{k:02}"]["value"]) == pattern(k) for k in range(FLOATS))
    read = [name for name in rows if not name.startswith(("outputs", "set"))]
    check(f"{len(read)} registers to read, by name, as the device has them", len(read) == 37 and values)
    print(f"        that are {6 + 4 + 2 * FLOATS} bits and words", flush=True)


def weld(cell, log):
    """A whole weld; the arc was on once, with the job's current and voltage."""
    cell.order("on", "home", "wait ready", "arm", "weld", "wait ready")
    begun = cell.mode(0, "weld", 60)
    since = len(cell.events)
    check("a weld through to its end", begun and cell.mode(since, "ready", 180) and not cell.alarms(0))
    changes = [json.loads(line) for line in open(log, encoding="utf-8")]
    on = [(c["current"], c["voltage"]) for c in changes if c["on"]]
    check(f"the arc on once, with {on}", on == [(900, 1200)] and len(changes) == 2)
    cell.order("off", "wait off", "on")
    time.sleep(1)


def main():
    seamwright, seconds = sys.argv[1], float(sys.argv[2]) if len(sys.argv) > 2 else 600.0
    begun = time.time()
    with socket.socket() as free:
        free.bind(("127.0.0.1", 0))
        port = free.getsockname()[1]
    with tempfile.TemporaryDirectory() as folder:
        folder = pathlib.Path(folder)
        ask = lambda *a: subprocess.run([seamwright, *a], capture_output=True, text=True, check=True).stdout
        (folder / "cell.toml").write_text(ask("machine", "show", "ellipse-xy") + machine(port))
        job = ask("examples", "ellipse").replace('machine = "ellipse-xy"', 'machine = "cell.toml"')
        (folder / "job.toml").write_text(job)
        server = Server(port, folder / "log")
        try:
            look(seamwright, folder / "cell.toml")
            cell = Cell(seamwright, folder / "job.toml", folder / "out")
            weld(cell, folder / "log")
            for number, part in [(1, 0.5), (2, 0.8)]:
                time.sleep(max(0.0, begun + part * seconds - time.time()))
                outage(cell, server, number)
            time.sleep(max(0.0, begun + seconds - time.time()))
            cell.order("off")
            cell.process.stdin.close()
            cell.process.wait(20)
            cell.reader.join(5)
            traffic(json.loads((folder / "out" / "run.json").read_text()), time.time() - begun)
        finally:
            server.kill()
    sys.exit(1 if failed else 0)


def traffic(run, seconds):
    told = run["devices"][0]
    late = told["round_us"]
    polls = told["polls"]
    print(f"        {seconds:.0f} s: {polls} polls of 64 registers at {POLL_HZ} Hz, {told['missed']} missed, {told['failed']} failed, "
          f"{told['connections']} connections, {told['away_s']:.1f} s away")
    print(f"        a poll takes {late['median']:.0f} us (median), {late['p99_9']:.0f} us (99.9 %), {late['most']:.0f} us at most")
    check("one connection, and one more after each outage", told["connections"] == 3)
    check(f"missed less than 1 % of the polls", told["missed"] < 0.01 * polls)
    check(f"away no longer than the outages and a second each", told["away_s"] < 2 * (OUTAGE_S + 3))


if __name__ == "__main__":
    if sys.argv[1] == "--serve":
        serve(int(sys.argv[2]), sys.argv[3])
    else:
        main()
